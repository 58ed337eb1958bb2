// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "kernels/filters/support.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"
#include "reference/lines/closest_lines.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::depth {
namespace {

/// Only extreme points of the bodies can make extreme points of P.
polytope::Polytope hull_of_differences(std::span<const Vector> a, std::span<const Vector> b) {
  const polytope::Polytope hull_a = polytope::convex_hull(a), hull_b = polytope::convex_hull(b);
  std::vector<Vector> differences;
  differences.reserve(hull_a.vertices.size() * hull_b.vertices.size());
  for (const Vector& p : hull_a.vertices)
    for (const Vector& q : hull_b.vertices) differences.push_back(q - p);
  return polytope::convex_hull(differences);
}

/// The facet lies in the plane <normal, x> = this.
mpz_class offset(const polytope::Polytope& p, const polytope::Facet& facet) {
  return dot(facet.normal, p.vertices[p.corners[facet.begin]]);
}

NaiveDepth in_solid(const polytope::Polytope& p) {
  kernels::IdVector<polytope::FacetId, mpz_class> offsets;
  offsets.reserve(p.facets.size());
  for (const polytope::Facet& facet : p.facets) offsets.push_back(offset(p, facet));
  const mpz_class least = *std::ranges::min_element(offsets);
  if (least < 0) return {Status::disjoint, 0, {}};
  if (least == 0) return {Status::touching, 0, {}};

  NaiveDepth result{Status::penetrating, 0, {}};
  for (const polytope::FacetId i : p.facets.ids()) {
    const Vector& normal = p.facets[i].normal;
    const mpq_class squared = kernels::ratio(offsets[i] * offsets[i], dot(normal, normal));
    const bool first = result.directions.empty();
    if (!first && squared > result.squared) continue;
    if (!first && squared < result.squared) result.directions.clear();
    result.squared = squared;
    result.directions.push_back(normal);
  }
  std::ranges::sort(result.directions, lexicographically_less);
  return result;
}

/// The polygon's plane passes through O, and O is not to the right of an edge on facet 0's cycle.
bool polygon_contains_origin(const polytope::Polytope& p) {
  const polytope::Facet& front = p.facets.front();
  if (offset(p, front) != 0) return false;
  return std::ranges::all_of(p.edges, [&](const polytope::Edge& edge) {
    const Vector &from = p.vertices[edge.from], &to = p.vertices[edge.to];
    return det(from, to, front.normal) >= 0;  // the sense of the triangle O, from, to, seen from the normal's side
  });
}

bool segment_contains_origin(const polytope::Polytope& p) {
  const Vector &from = p.vertices.front(), &to = p.vertices.back();
  return is_zero(cross(from, to)) && dot(from, to) <= 0;
}

bool flat_contains_origin(const polytope::Polytope& p) {
  switch (p.rank) {
    case 0: return is_zero(p.vertices.front());
    case 1: return segment_contains_origin(p);
    default: return polygon_contains_origin(p);
  }
}

// Facets of `body` against the extreme vertices of `other`, given by their extreme point in the
// facet's normal direction.
template <class ExtremePoint>
void offer_facets(const polytope::Polytope& a, const polytope::Polytope& b, ExtremePoint extreme,
                  kernels::NearestPlanes& nearest) {
  for (const polytope::Facet& facet : b.facets) {
    const Vector& n = facet.normal;
    nearest.offer(n, dot(n, b.vertices[b.corners[facet.begin]] - extreme(false, -n)));
  }
  for (const polytope::Facet& facet : a.facets) {
    const Vector n = -facet.normal;
    nearest.offer(n, dot(n, extreme(true, n) - a.vertices[a.corners[facet.begin]]));
  }
}

void offer_crossing(const kernels::UnperturbedKernel& kernel, const gaussian::GaussianDiagram& of_a,
                    const lines::EdgeLinesOfA& a, gaussian::EdgeOfA e, const gaussian::GaussianDiagram& of_b,
                    const lines::EdgeLinesOfB& b, gaussian::EdgeOfB f, kernels::NearestPlanes& nearest) {
  if (!gaussian::strict_crossings(kernel, of_a, of_a.arcs[gaussian::ArcId(e.value)], of_b,
                                  of_b.arcs[gaussian::ArcId(f.value)])
           .empty())
    lines::offer_edges(a, e, b, f, nearest);
}

kernels::ArcImages arc_images(const gaussian::GaussianDiagram& diagram) {
  kernels::ArcImages images;
  for (const gaussian::Arc& arc : diagram.arcs)
    images.push_back(diagram.nodes[arc.from].exact(), diagram.nodes[arc.to].exact());
  return images;
}

}  // namespace

NaiveDepth naive_depth(std::span<const Vector> a, std::span<const Vector> b) {
  const polytope::Polytope p = hull_of_differences(a, b);
  if (p.rank == 3) return in_solid(p);
  return {flat_contains_origin(p) ? Status::touching : Status::disjoint, 0, {}};
}

kernels::NearestPlanes nearest_facets_naive(const polytope::Polytope& a, const polytope::Polytope& b) {
  kernels::NearestPlanes nearest;
  offer_facets(
      a, b,
      [&](bool of_b, const Vector& u) {
        const std::vector<Vector>& points = (of_b ? b : a).vertices;
        return points[kernels::extreme_points_naive(points, u).front()];
      },
      nearest);
  PredicateCounts uncounted;
  const kernels::UnperturbedKernel kernel(uncounted);
  const gaussian::GaussianDiagram of_a = gaussian::gaussian_diagram_of_reflection(a),
                                  of_b = gaussian::gaussian_diagram(b);
  const lines::EdgeLinesOfA lines_a(a, 0);
  const lines::EdgeLinesOfB lines_b(b, 0);
  for (const gaussian::EdgeOfA e : lines_a.ids()) {
    for (const gaussian::EdgeOfB f : lines_b.ids()) offer_crossing(kernel, of_a, lines_a, e, of_b, lines_b, f, nearest);
  }
  return nearest;
}

kernels::NearestPlanes nearest_facets_scan(const polytope::Polytope& a, const polytope::Polytope& b, long exponent) {
  kernels::NearestPlanes nearest;
  const kernels::PointCloud cloud_a(a.vertices, exponent), cloud_b(b.vertices, exponent);
  offer_facets(
      a, b,
      [&](bool of_b, const Vector& u) {
        const kernels::PointCloud& cloud = of_b ? cloud_b : cloud_a;
        return cloud[kernels::extreme_points(cloud, u).front()];
      },
      nearest);
  PredicateCounts uncounted;
  const kernels::UnperturbedKernel kernel(uncounted);
  const gaussian::GaussianDiagram of_a = gaussian::gaussian_diagram_of_reflection(a),
                                  of_b = gaussian::gaussian_diagram(b);
  const lines::EdgeLinesOfA lines_a(a, exponent);
  const lines::EdgeLinesOfB lines_b(b, exponent);
  const bool arcs_have_ends = a.rank >= 2 && b.rank >= 2;
  const kernels::ArcImages arcs_a = arcs_have_ends ? arc_images(of_a) : kernels::ArcImages(),
                           arcs_b = arcs_have_ends ? arc_images(of_b) : kernels::ArcImages();
  std::vector<std::uint32_t> unsure;
  for (const gaussian::EdgeOfA e : lines_a.ids()) {
    const double bound =
        nearest.empty() ? HUGE_VAL : kernels::image_bound(nearest.numerator(), nearest.denominator(), exponent);
    if (arcs_have_ends) {
      kernels::crossing_and_not_farther({lines_a.images(), arcs_a}, e.value, {lines_b.images(), arcs_b}, bound, unsure);
    } else {
      kernels::not_farther(lines_a.images(), e.value, lines_b.images(), bound, unsure);
    }
    for (const std::uint32_t f : unsure)
      offer_crossing(kernel, of_a, lines_a, e, of_b, lines_b, gaussian::EdgeOfB(f), nearest);
  }
  return nearest;
}

std::optional<mpq_class> second_nearest_squared_naive(std::span<const Point> a, std::span<const Point> b) {
  const kernels::DefaultFloatEnvironment environment;
  const polytope::PlacedPair pair = polytope::place(a, b);
  const polytope::Polytope p = hull_of_differences(pair.a.points(), pair.b.points());
  std::vector<mpq_class> squares;
  for (const polytope::Facet& facet : p.facets) {
    const mpz_class height = offset(p, facet);
    if (p.rank < 3 || height <= 0) throw std::invalid_argument("only bodies that penetrate have a next nearest facet");
    squares.push_back(kernels::ratio(height * height, dot(facet.normal, facet.normal)));
  }
  if (squares.empty()) throw std::invalid_argument("only bodies that penetrate have a next nearest facet");
  std::ranges::sort(squares);
  const auto next = std::ranges::upper_bound(squares, squares.front());
  if (next == squares.end()) return std::nullopt;
  return mpq_class(*next / mpq_class(pair.denominator * pair.denominator));
}

}  // namespace fathom::depth
