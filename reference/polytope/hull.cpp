// SPDX-License-Identifier: GPL-3.0-or-later
// The hull of points of any rank: duplicates out, rank found exactly, then one method for each
// rank. Of a solid, coplanar triangles are united, corners where fewer than three facets meet are
// dropped, the rest is numbered canonically.
#include "reference/polytope/hull.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "kernels/float_environment.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {
namespace {

using Index = std::uint32_t;

/// Gives `polytope` the vertices points[id] for the ids marked in `extreme`, in ascending order.
/// Returns the vertex of each id, or none.
std::vector<VertexId> number_vertices(Polytope& polytope, std::span<const Vector> points,
                                      const std::vector<bool>& extreme) {
  std::vector<VertexId> number(points.size(), VertexId::none());
  for (Index id = 0; id < points.size(); ++id) {
    if (!extreme[id]) continue;
    number[id] = VertexId(static_cast<Index>(polytope.vertices.size()));
    polytope.vertices.push_back(points[id]);
    polytope.input_ids.push_back(id);
  }
  return number;
}

/// Turns a cycle so that it starts at its lowest vertex.
void start_at_lowest(std::vector<VertexId>& cycle) {
  std::rotate(cycle.begin(), std::ranges::min_element(cycle), cycle.end());
}

void append_facet(Polytope& polytope, Vector normal, std::span<const VertexId> cycle) {
  const auto begin = static_cast<Index>(polytope.corners.size());
  polytope.corners.insert(polytope.corners.end(), cycle.begin(), cycle.end());
  polytope.facets.push_back({std::move(normal), begin, static_cast<Index>(polytope.corners.size())});
}

/// One index, the lowest, of each group of equal points; ascending.
std::vector<Index> distinct_points(std::span<const Vector> points) {
  DistinctPoints seen = no_points_yet(points, points.size());
  std::vector<Index> ids;
  for (Index i = 0; i < points.size(); ++i) {
    if (seen.insert(i).second) ids.push_back(i);
  }
  return ids;
}

Polytope point(std::span<const Vector> points) {
  Polytope polytope;
  polytope.vertices = {points[0]};
  polytope.input_ids = {0};
  return polytope;
}

/// Lexicographic order is monotone along a line.
Polytope segment(std::span<const Vector> points, std::span<const Index> ids) {
  const auto [first, last] =
      std::ranges::minmax_element(ids, [&](Index i, Index j) { return lexicographically_less(points[i], points[j]); });
  const auto [low, high] = std::minmax(*first, *last);
  Polytope polytope;
  polytope.rank = 1;
  polytope.vertices = {points[low], points[high]};
  polytope.input_ids = {low, high};
  polytope.edges = {{VertexId(0), VertexId(1), FacetId::none(), FacetId::none()}};
  return polytope;
}

/// Of the two normals the one whose first component other than zero is positive belongs to facet 0;
/// seen along that axis nothing is lost.
Polytope polygon(std::span<const Vector> points, std::span<const Index> ids, const Vector& some_normal) {
  Vector normal = primitive(some_normal);
  const int axis = normal.x != 0 ? 0 : normal.y != 0 ? 1 : 2;
  if (lexicographically_less(normal, Vector{})) normal = -normal;
  const std::vector<Index> corners = hull_cycle(points, ids, axis);

  Polytope polytope;
  polytope.rank = 2;
  std::vector<bool> extreme(points.size());
  for (const Index id : corners) extreme[id] = true;
  const std::vector<VertexId> number = number_vertices(polytope, points, extreme);
  std::vector<VertexId> cycle;
  for (const Index id : corners) cycle.push_back(number[id]);
  start_at_lowest(cycle);
  append_facet(polytope, normal, cycle);
  std::reverse(cycle.begin() + 1, cycle.end());
  append_facet(polytope, -normal, cycle);
  const auto n = static_cast<Index>(cycle.size());
  for (Index i = 0; i < n; ++i)
    polytope.edges.push_back({polytope.corners[i], polytope.corners[(i + 1) % n], FacetId(0), FacetId(1)});
  return polytope;
}

/// Half-edge 3 t + i runs from corner i of triangle t to the next one.
struct Surface {
  std::span<const HullTriangle> triangles;
  std::vector<Vector> normals;  // of triangles, primitive
  std::vector<Index> twin;      // of half-edges
  std::vector<bool> border;     // of half-edges: whether the triangles on its two sides lie in different planes

  [[nodiscard]] Index origin(Index h) const { return triangles[h / 3][h % 3]; }
  [[nodiscard]] Index next(Index h) const { return h % 3 == 2 ? h - 2 : h + 1; }
  /// The border half-edge that follows border half-edge h around the same facet.
  [[nodiscard]] Index next_border(Index h) const {
    h = next(h);
    while (!border[h]) h = next(twin[h]);
    return h;
  }
};

std::vector<Index> twins(const Surface& s) {
  const auto count = static_cast<Index>(3 * s.triangles.size());
  std::vector<std::pair<std::uint64_t, Index>> by_ends(count);
  for (Index h = 0; h < count; ++h) {
    const auto [low, high] = std::minmax({s.origin(h), s.origin(s.next(h))});
    by_ends[h] = {std::uint64_t{low} << 32 | high, h};
  }
  std::ranges::sort(by_ends);
  std::vector<Index> twin(count);
  for (Index i = 0; i < count; i += 2) {
    twin[by_ends[i].second] = by_ends[i + 1].second;
    twin[by_ends[i + 1].second] = by_ends[i].second;
  }
  return twin;
}

/// Primitive normals of triangles, one after another, in integers that are used again: expressions
/// would take new ones at each step.
class Normals {
 public:
  /// Sets n to (q - p) x (r - p), divided by the greatest common divisor of its components.
  void find(const Vector& p, const Vector& q, const Vector& r, Vector& n) {
    subtract(q, p, u_);
    subtract(r, p, v_);
    two_by_two(u_.y, v_.z, u_.z, v_.y, n.x);
    two_by_two(u_.z, v_.x, u_.x, v_.z, n.y);
    two_by_two(u_.x, v_.y, u_.y, v_.x, n.z);
    mpz_gcd(divisor_.get_mpz_t(), n.x.get_mpz_t(), n.y.get_mpz_t());
    if (divisor_ != 1) mpz_gcd(divisor_.get_mpz_t(), divisor_.get_mpz_t(), n.z.get_mpz_t());
    if (divisor_ == 1) return;
    for (mpz_class* c : {&n.x, &n.y, &n.z}) mpz_divexact(c->get_mpz_t(), c->get_mpz_t(), divisor_.get_mpz_t());
  }

 private:
  static void subtract(const Vector& a, const Vector& b, Vector& difference) {
    mpz_sub(difference.x.get_mpz_t(), a.x.get_mpz_t(), b.x.get_mpz_t());
    mpz_sub(difference.y.get_mpz_t(), a.y.get_mpz_t(), b.y.get_mpz_t());
    mpz_sub(difference.z.get_mpz_t(), a.z.get_mpz_t(), b.z.get_mpz_t());
  }
  /// a b - c d.
  static void two_by_two(const mpz_class& a, const mpz_class& b, const mpz_class& c, const mpz_class& d,
                         mpz_class& result) {
    mpz_mul(result.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
    mpz_submul(result.get_mpz_t(), c.get_mpz_t(), d.get_mpz_t());
  }

  Vector u_, v_;
  mpz_class divisor_;
};

Surface make_surface(std::span<const Vector> points, std::span<const HullTriangle> triangles) {
  Surface s;
  s.triangles = triangles;
  s.normals.resize(triangles.size());
  Normals normals;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [p, q, r] = triangles[t];
    normals.find(points[p], points[q], points[r], s.normals[t]);
  }
  s.twin = twins(s);
  s.border.resize(s.twin.size());
  // Neighbours share an edge, so equal normals mean equal planes.
  for (Index h = 0; h < s.twin.size(); ++h) s.border[h] = s.normals[h / 3] != s.normals[s.twin[h] / 3];
  return s;
}

/// Facets meet at a point in as many border half-edges as there are facets: 0 or 2 where it lies
/// inside a facet or an edge.
std::vector<bool> extreme_points(const Surface& s, std::size_t points) {
  std::vector<Index> borders(points, 0);
  for (Index h = 0; h < s.border.size(); ++h) {
    if (s.border[h]) ++borders[s.origin(h)];
  }
  std::vector<bool> extreme(points);
  for (std::size_t i = 0; i < points; ++i) extreme[i] = borders[i] >= 3;
  return extreme;
}

struct Cycle {
  Index triangle;  // one of the facet's
  std::vector<VertexId> corners;
};

/// One cycle for each facet, in the order of the cycles.
std::vector<Cycle> facet_cycles(const Surface& s, std::span<const VertexId> number) {
  std::vector<Cycle> cycles;
  std::vector<bool> seen(s.border.size());
  for (Index start = 0; start < s.border.size(); ++start) {
    if (!s.border[start] || seen[start]) continue;
    Cycle cycle{start / 3, {}};
    for (Index h = start; !seen[h]; h = s.next_border(h)) {
      seen[h] = true;
      if (const VertexId v = number[s.origin(h)]; !v.is_none()) cycle.corners.push_back(v);
    }
    start_at_lowest(cycle.corners);
    cycles.push_back(std::move(cycle));
  }
  std::ranges::sort(cycles, {}, &Cycle::corners);
  return cycles;
}

/// Each pair of neighbouring corners occurs once in either direction: rising in the facet to the
/// left, falling in the one to the right.
std::vector<Edge> edges_of(const Polytope& polytope) {
  std::vector<Edge> halves;
  halves.reserve(polytope.corners.size());
  for (const FacetId f : polytope.facets.ids()) {
    const Facet& facet = polytope.facets[f];
    VertexId u = polytope.corners[facet.end - 1];
    for (Index c = facet.begin; c < facet.end; ++c) {
      const VertexId v = polytope.corners[c];
      halves.push_back(u < v ? Edge{u, v, f, FacetId::none()} : Edge{v, u, FacetId::none(), f});
      u = v;
    }
  }
  std::ranges::sort(halves, {}, [](const Edge& e) { return std::tuple(e.from, e.to, e.left); });
  std::vector<Edge> edges;
  edges.reserve(halves.size() / 2);
  for (std::size_t i = 0; i < halves.size(); i += 2)
    edges.push_back({halves[i].from, halves[i].to, halves[i].left, halves[i + 1].right});
  return edges;
}

}  // namespace

Polytope merge_coplanar(std::span<const Vector> points, std::span<const HullTriangle> triangles) {
  Surface surface = make_surface(points, triangles);
  Polytope polytope;
  polytope.rank = 3;
  const std::vector<VertexId> number = number_vertices(polytope, points, extreme_points(surface, points.size()));
  for (const Cycle& cycle : facet_cycles(surface, number)) {
    append_facet(polytope, std::move(surface.normals[cycle.triangle]), cycle.corners);
  }
  polytope.edges = edges_of(polytope);
  return polytope;
}

int affine_rank(std::span<const Vector> points) { return affine_span<mpz_class>(points, points.size()).rank; }

Polytope convex_hull(std::span<const Vector> points) {
  const kernels::DefaultFloatEnvironment environment;
  if (points.empty()) throw std::invalid_argument("convex_hull: no points");
  if (points.size() > std::numeric_limits<std::int32_t>::max())
    throw std::invalid_argument("convex_hull: more than 2^31 - 1 points");
  const std::vector<Index> ids = distinct_points(points);
  const Span<mpz_class> span = affine_span<mpz_class>(points, points.size());
  switch (span.rank) {
    case 0: return point(points);
    case 1: return segment(points, ids);
    case 2: return polygon(points, ids, span.normal);
    default:
      return merge_coplanar(
          points, ids.size() <= few_points ? hull_triangles_of_few(points, ids) : hull_triangles(points, ids));
  }
}

Polytope hull_of(const std::vector<Point>& points) {
  return convex_hull(place(points, std::span(points).first(std::min<std::size_t>(points.size(), 1))).a.points());
}

}  // namespace fathom::polytope
