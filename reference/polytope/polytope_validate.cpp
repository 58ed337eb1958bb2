// SPDX-License-Identifier: GPL-3.0-or-later
// Local laws that together make a closed surface the boundary of a convex polytope, checked
// exactly: of facets, edges and vertices, and of the lists that hold them.
//                                                                     [proofs/polytope.md, lemma 4]
#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "kernels/messages.hpp"
#include "reference/polytope/hull.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {

namespace {

using Index = std::uint32_t;

constexpr Index no_side = std::numeric_limits<Index>::max();

/// A slot is a position in polytope.corners; it stands also for the side of the facet from this
/// corner to the next.
struct Sides {
  explicit Sides(const Polytope& polytope) : p(polytope), facet(p.corners.size()), twin(p.corners.size(), no_side) {
    for (const FacetId f : p.facets.ids())
      std::fill(facet.begin() + p.facets[f].begin, facet.begin() + p.facets[f].end, f);
    for (Index s = 0; s < p.corners.size(); ++s) by_ends.push_back({ends(s), s});
    std::ranges::sort(by_ends);
  }

  using Ends = std::pair<VertexId, VertexId>;

  [[nodiscard]] Index next(Index s) const { return s + 1 == p.facets[facet[s]].end ? p.facets[facet[s]].begin : s + 1; }
  [[nodiscard]] Index previous(Index s) const {
    return s == p.facets[facet[s]].begin ? p.facets[facet[s]].end - 1 : s - 1;
  }
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
  // All corners to the left of the first side and in turning order around the first corner: simple.
  // Left turns throughout: convex. At the first, second and last corner the turn is among the
  // former.
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
      report.faults.push_back("edge " + std::to_string(i) +
                              " is not a side of its left and, reversed, of its right facet");
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

/// The sides that leave the vertex of `start`, in turning order until it comes round again. All
/// sides must be paired.
std::vector<Index> star(const Sides& sides, Index start) {
  std::vector<Index> around;
  Index s = start;
  do {
    around.push_back(s);
    s = sides.twin[sides.previous(s)];
  } while (s != start);
  return around;
}

/// The facets around a vertex bound a pointed convex cone: its edges lie strictly below the first
/// facet except for its own two, and all other facets lie strictly above the first edge. At the
/// edges convexity is known.
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

/// Normals primitive, corners on the plane, cycles simple, strictly convex and counter-clockwise.
/// Indices must be in range.
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

/// Rank 3 with valid facets: each side of a facet belongs to one edge and each edge to two sides,
/// left and right facets lie to the left and right, facets meet convexly at every edge and in a
/// convex cone at every vertex.
void validate_surface(const Polytope& polytope, kernels::Report& report) {
  Sides sides(polytope);
  if (!pair_sides(sides, report)) return;
  for (std::size_t i = 0; i < polytope.edges.size(); ++i) {
    const Edge& e = polytope.edges[i];
    const Vector along = cross(polytope.facets[e.left].normal, polytope.facets[e.right].normal);
    const bool convex = !is_zero(along) && same_direction(along, polytope.vertices[e.to] - polytope.vertices[e.from]);
    report.expect(convex, "edge " + std::to_string(i) + " is flat or reflex");
  }
  kernels::IdVector<VertexId, Index> sides_at(polytope.vertices.size(), 0),
      some_side(polytope.vertices.size(), no_side);
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

// Every law that polytope.hpp states, rank by rank. Nothing is assumed of the value, so shape and
// ranges of indices come first.

constexpr Index nowhere = std::numeric_limits<Index>::max();  // place of a vertex that a cycle does not have

void check_counts(const Polytope& p, kernels::Report& report) {
  const std::size_t v = p.vertices.size(), e = p.edges.size(), f = p.facets.size(), c = p.corners.size();
  switch (p.rank) {
    case 0: report.expect(v == 1 && e == 0 && f == 0 && c == 0, "a point has one vertex and nothing else"); break;
    case 1:
      report.expect(v == 2 && e == 1 && f == 0 && c == 0, "a segment has two vertices, one edge and no facet");
      break;
    case 2:
      report.expect(v >= 3 && e == v && f == 2 && c == 2 * v, "a polygon has as many edges as vertices and two facets");
      break;
    case 3:
      report.expect(v + f == e + 2 && c == 2 * e && f >= 4, "a solid has V - E + F = 2, and two facets at each edge");
      break;
    default: report.expect(false, "rank is not 0, 1, 2 or 3");
  }
  report.expect(p.input_ids.size() == v, "there are not as many input ids as vertices");
}

void check_ranges(const Polytope& p, kernels::Report& report) {
  const auto vertex = [&](VertexId v) { return v.value < p.vertices.size(); };
  const auto facet = [&](FacetId f) { return p.rank == 1 ? f.is_none() : f.value < p.facets.size(); };
  for (const Edge& e : p.edges) {
    report.expect(vertex(e.from) && vertex(e.to) && e.from != e.to,
                  "an edge has an end that is no vertex, or equal ends");
    report.expect(facet(e.left) && facet(e.right), "an edge refers to a facet that is none");
  }
  Index expected = 0;
  for (const Facet& f : p.facets) {
    const bool fits = f.begin == expected && f.end <= p.corners.size() && f.end >= f.begin && f.end - f.begin >= 3;
    if (!report.expect(fits, "a facet's corners do not follow those of the facet before, or are fewer than three"))
      return;
    expected = f.end;
  }
  report.expect(expected == p.corners.size(), "there are corners of no facet");
  report.expect(std::ranges::all_of(p.corners, vertex), "a corner is no vertex");
}

/// Vertices are input points, each under the lowest index that it has there.
void check_ids(const Polytope& p, std::span<const Vector> points, kernels::Report& report) {
  report.expect(std::ranges::adjacent_find(p.input_ids, std::greater_equal<>()) == p.input_ids.end(),
                "input ids do not ascend");
  DistinctPoints vertices = no_points_yet(points, p.vertices.size());
  for (const VertexId i : p.vertices.ids()) {
    const std::string name = "vertex " + std::to_string(i.value);
    const bool same = p.input_ids[i] < points.size() && points[p.input_ids[i]] == p.vertices[i];
    if (!report.expect(same, name + " is not the input point that it names")) continue;
    report.expect(vertices.insert(p.input_ids[i]).second, name + " repeats another vertex");
  }
  for (Index i = 0; i < points.size(); ++i) {
    const auto found = vertices.find(i);
    if (found != vertices.end())
      report.expect(*found <= i, "input point " + std::to_string(i) + " equals a vertex and has a lower index");
  }
}

void check_segment(const Polytope& p, std::span<const Vector> points, kernels::Report& report) {
  const Vector &u = p.vertices.front(), &v = p.vertices.back();
  const auto inside = [&](const Vector& q) { return is_zero(cross(v - u, q - u)) && dot(q - u, q - v) <= 0; };
  report.expect(std::ranges::all_of(points, inside), "an input point lies outside the segment");
}

/// Facet 1 is facet 0 seen from behind, and the edges are facet 0's sides.
void check_polygon(const Polytope& p, std::span<const Vector> points, kernels::Report& report) {
  const auto n = static_cast<Index>(p.vertices.size());
  const auto slot_of = [&](Index begin) {
    kernels::IdVector<VertexId, Index> slots(n, nowhere);
    for (Index i = 0; i < n; ++i) slots[p.corners[begin + i]] = i;
    return slots;
  };
  if (!report.expect(p.facets.front().end == n, "the two facets of a polygon differ in size")) return;
  const kernels::IdVector<VertexId, Index> front = slot_of(0), back = slot_of(n);
  report.expect(p.facets.back().normal == -p.facets.front().normal,
                "the normals of a polygon's facets are not opposite");
  for (Index i = 0; i < n; ++i) {
    const VertexId u = p.corners[i], v = p.corners[(i + 1) % n];
    const bool reversed = back[u] != nowhere && back[v] != nowhere && (back[v] + 1) % n == back[u];
    report.expect(reversed, "a side of a polygon's facet 0 is not, reversed, one of facet 1");
  }
  kernels::IdVector<VertexId, bool> used(n);
  for (const Edge& e : p.edges) {
    const bool side = front[e.from] != nowhere && p.corners[(front[e.from] + 1) % n] == e.to && e.left == FacetId(0) &&
                      e.right == FacetId(1);
    if (report.expect(side, "a polygon's edge does not run along facet 0 with facet 0 to its left")) {
      report.expect(!used[e.from], "a polygon's edge occurs twice");
      used[e.from] = true;
    }
  }
  const Facet& f = p.facets.front();
  const bool planar =
      std::ranges::all_of(points, [&](const Vector& q) { return dot(f.normal, q - p.vertices.front()) == 0; });
  report.expect(planar, "an input point lies off the polygon's plane");
}

/// Whether the half-space or, for a polygon, the half-plane of any facet or side leaves an input
/// point outside.
void check_containment(const Polytope& p, std::span<const Vector> points, kernels::Report& report) {
  const auto expect_none_beyond = [&](const Vector& n, const Vector& base, const std::string& name) {
    const mpz_class height = dot(n, base);
    const bool none = std::ranges::none_of(points, [&](const Vector& q) { return dot(n, q) > height; });
    report.expect(none, "an input point lies beyond " + name);
  };
  if (p.rank == 2) {
    for (std::size_t i = 0; i < p.edges.size(); ++i) {
      const Vector& from = p.vertices[p.edges[i].from];
      expect_none_beyond(cross(p.vertices[p.edges[i].to] - from, p.facets.front().normal), from,
                         "side " + std::to_string(i));
    }
  } else if (p.rank == 3) {
    for (const FacetId i : p.facets.ids()) {
      expect_none_beyond(p.facets[i].normal, p.vertices[p.corners[p.facets[i].begin]],
                         "facet " + std::to_string(i.value));
    }
  }
}

}  // namespace

kernels::Report validate(const Polytope& polytope, std::span<const Vector> points, bool thorough) {
  kernels::Report report;
  check_counts(polytope, report);
  if (report.ok()) check_ranges(polytope, report);
  if (!report.ok()) return report;
  check_ids(polytope, points, report);
  validate_facets(polytope, report);
  if (polytope.rank == 0) {
    report.expect(std::ranges::all_of(points, [&](const Vector& q) { return q == polytope.vertices.front(); }),
                  "input points differ from the one vertex");
  }
  if (polytope.rank == 1) check_segment(polytope, points, report);
  if (polytope.rank == 2) check_polygon(polytope, points, report);
  if (polytope.rank == 3) validate_surface(polytope, report);
  if (thorough) check_containment(polytope, points, report);
  return report;
}

}  // namespace fathom::polytope
