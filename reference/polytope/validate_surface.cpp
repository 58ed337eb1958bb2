// SPDX-License-Identifier: GPL-3.0-or-later
// Local laws that together make a closed surface the boundary of a convex polytope.       [proofs/polytope.md, lemma 4]
#include "reference/polytope/validate_surface.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace fathom::polytope {
namespace {

using Index = std::uint32_t;

constexpr Index no_side = std::numeric_limits<Index>::max();

/// A slot is a position in polytope.corners; it stands also for the side of the facet from this corner to the next.
struct Sides {
  explicit Sides(const Polytope& polytope) : p(polytope), facet(p.corners.size()), twin(p.corners.size(), no_side) {
    for (const FacetId f : p.facets.ids()) std::fill(facet.begin() + p.facets[f].begin, facet.begin() + p.facets[f].end, f);
    for (Index s = 0; s < p.corners.size(); ++s) by_ends.push_back({ends(s), s});
    std::ranges::sort(by_ends);
  }

  using Ends = std::pair<VertexId, VertexId>;

  [[nodiscard]] Index next(Index s) const { return s + 1 == p.facets[facet[s]].end ? p.facets[facet[s]].begin : s + 1; }
  [[nodiscard]] Index previous(Index s) const { return s == p.facets[facet[s]].begin ? p.facets[facet[s]].end - 1 : s - 1; }
  [[nodiscard]] Ends ends(Index s) const { return {p.corners[s], p.corners[next(s)]}; }
  [[nodiscard]] const Vector& normal(Index s) const { return p.facets[facet[s]].normal; }
  [[nodiscard]] Vector direction(Index s) const { return p.vertices[ends(s).second] - p.vertices[ends(s).first]; }

  /// The side with these ends in facet f, or no_side.
  [[nodiscard]] Index find(Ends wanted, FacetId f) const {
    const auto found = std::ranges::lower_bound(by_ends, wanted, {}, &std::pair<Ends, Index>::first);
    if (found == by_ends.end() || found->first != wanted || facet[found->second] != f) return no_side;
    return found->second;
  }

  const Polytope& p;
  std::vector<FacetId> facet;  ///< of each slot
  std::vector<Index> twin;     ///< the slot of the same edge in the facet beyond it
  std::vector<std::pair<Ends, Index>> by_ends;
};

bool strictly_convex(const Polytope& p, const Facet& f) {
  const auto left = [&](Index i, Index j, Index k) {
    const Vector& v = p.vertices[p.corners[i]];
    return sgn(dot(f.normal, cross(p.vertices[p.corners[j]] - v, p.vertices[p.corners[k]] - v))) > 0;
  };
  // All corners to the left of the first side and in turning order around the first corner: simple. Left turns throughout: convex.
  // At the first, second and last corner the turn is among the former.
  for (Index i = f.begin + 2; i < f.end; ++i) {
    if (!left(f.begin, f.begin + 1, i) || !left(f.begin, i - 1, i) || !left(i - 2, i - 1, i)) return false;
  }
  return true;
}

/// Pairs the sides along the edges. Returns whether every side found its one twin.
bool pair_sides(Sides& sides, kernels::Report& report) {
  const Polytope& p = sides.p;
  for (std::size_t i = 1; i < sides.by_ends.size(); ++i) {
    if (sides.by_ends[i].first == sides.by_ends[i - 1].first) report.faults.push_back("two facets have the same side");
  }
  for (std::size_t i = 0; i < p.edges.size(); ++i) {
    const Edge& e = p.edges[i];
    const Index l = sides.find({e.from, e.to}, e.left), r = sides.find({e.to, e.from}, e.right);
    if (l == no_side || r == no_side) {
      report.faults.push_back("edge " + std::to_string(i) + " is not a side of its left and, reversed, of its right facet");
    } else if (sides.twin[l] != no_side || sides.twin[r] != no_side) {
      report.faults.push_back("edge " + std::to_string(i) + " repeats an earlier edge");
    } else {
      sides.twin[l] = r;
      sides.twin[r] = l;
    }
  }
  const bool closed = std::ranges::find(sides.twin, no_side) == sides.twin.end();
  report.expect(closed, "a side of a facet belongs to no edge");
  return report.ok();
}

/// The sides that leave the vertex of `start`, in turning order until it comes round again. All sides must be paired.
std::vector<Index> star(const Sides& sides, Index start) {
  std::vector<Index> around;
  Index s = start;
  do {
    around.push_back(s);
    s = sides.twin[sides.previous(s)];
  } while (s != start);
  return around;
}

/// The facets around a vertex bound a pointed convex cone: its edges lie strictly below the first facet except for its own two, and all
/// other facets lie strictly above the first edge. At the edges convexity is known.
bool convex_cone(const Sides& sides, const std::vector<Index>& around) {
  // Facet i lies between the edges i and i + 1.
  const Vector first = sides.direction(around[0]);
  for (std::size_t i = 2; i < around.size(); ++i) {
    if (sgn(dot(sides.normal(around[0]), sides.direction(around[i]))) >= 0) return false;
  }
  for (std::size_t i = 1; i + 1 < around.size(); ++i) {
    if (sgn(dot(sides.normal(around[i]), first)) >= 0) return false;
  }
  return true;
}

}  // namespace

void validate_facets(const Polytope& polytope, kernels::Report& report) {
  for (const FacetId i : polytope.facets.ids()) {
    const Facet& f = polytope.facets[i];
    const std::string name = "facet " + std::to_string(i.value);
    report.expect(!is_zero(f.normal) && primitive(f.normal) == f.normal, name + " has a normal that is not primitive");
    const Vector& base = polytope.vertices[polytope.corners[f.begin]];
    const bool planar = std::all_of(polytope.corners.begin() + f.begin, polytope.corners.begin() + f.end,
                                    [&](VertexId v) { return dot(f.normal, polytope.vertices[v] - base) == 0; });
    report.expect(planar, name + " has a corner off its plane");
    report.expect(strictly_convex(polytope, f), name + " is not a strictly convex counter-clockwise cycle");
  }
}

void validate_surface(const Polytope& polytope, kernels::Report& report) {
  Sides sides(polytope);
  if (!pair_sides(sides, report)) return;
  for (std::size_t i = 0; i < polytope.edges.size(); ++i) {
    const Edge& e = polytope.edges[i];
    const Vector along = cross(polytope.facets[e.left].normal, polytope.facets[e.right].normal);
    const bool convex = !is_zero(along) && same_direction(along, polytope.vertices[e.to] - polytope.vertices[e.from]);
    report.expect(convex, "edge " + std::to_string(i) + " is flat or reflex");
  }
  kernels::IdVector<VertexId, Index> sides_at(polytope.vertices.size(), 0), some_side(polytope.vertices.size(), no_side);
  for (Index s = 0; s < polytope.corners.size(); ++s) {
    ++sides_at[polytope.corners[s]];
    some_side[polytope.corners[s]] = s;
  }
  for (const VertexId v : polytope.vertices.ids()) {
    const std::string name = "vertex " + std::to_string(v.value);
    if (!report.expect(sides_at[v] >= 3, name + " has fewer than three facets")) continue;
    const std::vector<Index> around = star(sides, some_side[v]);
    if (!report.expect(around.size() == sides_at[v], name + " has more than one fan of facets")) continue;
    report.expect(convex_cone(sides, around), name + " is not the apex of a convex cone");
  }
}

}  // namespace fathom::polytope
