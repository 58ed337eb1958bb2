// SPDX-License-Identifier: GPL-3.0-or-later
// The quadratic twins: all pairs, once in exact arithmetic only and once behind the double filter.
#include "reference/depth/nearest_facets_naive.hpp"

#include <cmath>

#include "kernels/filters/support.hpp"
#include "reference/gaussian/crossing.hpp"
#include "reference/lines/closest_lines.hpp"

namespace fathom {
namespace {

// Facets of `body` against the extreme vertices of `other`, given by their extreme point in the facet's normal direction.
template <class ExtremePoint>
void offer_facets(const Polytope& a, const Polytope& b, ExtremePoint extreme, NearestPlanes& nearest) {
  for (const Facet& facet : b.facets) {
    const Vector& n = facet.normal;
    nearest.offer(n, dot(n, b.vertices[b.corners[facet.begin]] - extreme(false, -n)));
  }
  for (const Facet& facet : a.facets) {
    const Vector n = -facet.normal;
    nearest.offer(n, dot(n, extreme(true, n) - a.vertices[a.corners[facet.begin]]));
  }
}

void offer_crossing(const UnperturbedKernel& kernel, const GaussianDiagram& of_a, const EdgeLinesOfA& a, EdgeOfA e,
                    const GaussianDiagram& of_b, const EdgeLinesOfB& b, EdgeOfB f, NearestPlanes& nearest) {
  if (!strict_crossings(kernel, of_a, of_a.arcs[ArcId(e.value)], of_b, of_b.arcs[ArcId(f.value)]).empty()) offer_edges(a, e, b, f, nearest);
}

ArcImages arc_images(const GaussianDiagram& diagram) {
  ArcImages images;
  for (const Arc& arc : diagram.arcs) images.push_back(diagram.nodes[arc.from].exact(), diagram.nodes[arc.to].exact());
  return images;
}

}  // namespace

NearestPlanes nearest_facets_naive(const Polytope& a, const Polytope& b) {
  NearestPlanes nearest;
  offer_facets(
      a, b,
      [&](bool of_b, const Vector& u) {
        const std::vector<Vector>& points = (of_b ? b : a).vertices;
        return points[extreme_points_naive(points, u).front()];
      },
      nearest);
  PredicateCounts uncounted;
  const UnperturbedKernel kernel(uncounted);
  const GaussianDiagram of_a = gaussian_diagram_of_reflection(a), of_b = gaussian_diagram(b);
  const EdgeLinesOfA lines_a(a, 0);
  const EdgeLinesOfB lines_b(b, 0);
  for (const EdgeOfA e : lines_a.ids()) {
    for (const EdgeOfB f : lines_b.ids()) offer_crossing(kernel, of_a, lines_a, e, of_b, lines_b, f, nearest);
  }
  return nearest;
}

NearestPlanes nearest_facets_scan(const Polytope& a, const Polytope& b, long exponent) {
  NearestPlanes nearest;
  const PointCloud cloud_a(a.vertices, exponent), cloud_b(b.vertices, exponent);
  offer_facets(
      a, b,
      [&](bool of_b, const Vector& u) {
        const PointCloud& cloud = of_b ? cloud_b : cloud_a;
        return cloud[extreme_points(cloud, u).front()];
      },
      nearest);
  PredicateCounts uncounted;
  const UnperturbedKernel kernel(uncounted);
  const GaussianDiagram of_a = gaussian_diagram_of_reflection(a), of_b = gaussian_diagram(b);
  const EdgeLinesOfA lines_a(a, exponent);
  const EdgeLinesOfB lines_b(b, exponent);
  const bool arcs_have_ends = a.rank >= 2 && b.rank >= 2;
  const ArcImages arcs_a = arcs_have_ends ? arc_images(of_a) : ArcImages(), arcs_b = arcs_have_ends ? arc_images(of_b) : ArcImages();
  std::vector<std::uint32_t> unsure;
  for (const EdgeOfA e : lines_a.ids()) {
    const double bound = nearest.empty() ? HUGE_VAL : image_bound(nearest.numerator(), nearest.denominator(), exponent);
    if (arcs_have_ends) {
      crossing_and_not_farther({lines_a.images(), arcs_a}, e.value, {lines_b.images(), arcs_b}, bound, unsure);
    } else {
      not_farther(lines_a.images(), e.value, lines_b.images(), bound, unsure);
    }
    for (const std::uint32_t f : unsure) offer_crossing(kernel, of_a, lines_a, e, of_b, lines_b, EdgeOfB(f), nearest);
  }
  return nearest;
}

}  // namespace fathom
