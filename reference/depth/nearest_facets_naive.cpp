// SPDX-License-Identifier: GPL-3.0-or-later
// The quadratic twins: all pairs, once in exact arithmetic only and once behind the double filter.
#include <cmath>

#include "kernels/filters/support.hpp"
#include "reference/depth/naive.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"
#include "reference/lines/closest_lines.hpp"

namespace fathom::depth {
namespace {

// Facets of `body` against the extreme vertices of `other`, given by their extreme point in the facet's normal direction.
template <class ExtremePoint>
void offer_facets(const polytope::Polytope& a, const polytope::Polytope& b, ExtremePoint extreme, kernels::NearestPlanes& nearest) {
  for (const polytope::Facet& facet : b.facets) {
    const Vector& n = facet.normal;
    nearest.offer(n, dot(n, b.vertices[b.corners[facet.begin]] - extreme(false, -n)));
  }
  for (const polytope::Facet& facet : a.facets) {
    const Vector n = -facet.normal;
    nearest.offer(n, dot(n, extreme(true, n) - a.vertices[a.corners[facet.begin]]));
  }
}

void offer_crossing(const kernels::UnperturbedKernel& kernel, const gaussian::GaussianDiagram& of_a, const lines::EdgeLinesOfA& a,
                    gaussian::EdgeOfA e, const gaussian::GaussianDiagram& of_b, const lines::EdgeLinesOfB& b, gaussian::EdgeOfB f,
                    kernels::NearestPlanes& nearest) {
  if (!gaussian::strict_crossings(kernel, of_a, of_a.arcs[gaussian::ArcId(e.value)], of_b, of_b.arcs[gaussian::ArcId(f.value)]).empty())
    lines::offer_edges(a, e, b, f, nearest);
}

kernels::ArcImages arc_images(const gaussian::GaussianDiagram& diagram) {
  kernels::ArcImages images;
  for (const gaussian::Arc& arc : diagram.arcs) images.push_back(diagram.nodes[arc.from].exact(), diagram.nodes[arc.to].exact());
  return images;
}

}  // namespace

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
  const gaussian::GaussianDiagram of_a = gaussian::gaussian_diagram_of_reflection(a), of_b = gaussian::gaussian_diagram(b);
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
  const gaussian::GaussianDiagram of_a = gaussian::gaussian_diagram_of_reflection(a), of_b = gaussian::gaussian_diagram(b);
  const lines::EdgeLinesOfA lines_a(a, exponent);
  const lines::EdgeLinesOfB lines_b(b, exponent);
  const bool arcs_have_ends = a.rank >= 2 && b.rank >= 2;
  const kernels::ArcImages arcs_a = arcs_have_ends ? arc_images(of_a) : kernels::ArcImages(),
                           arcs_b = arcs_have_ends ? arc_images(of_b) : kernels::ArcImages();
  std::vector<std::uint32_t> unsure;
  for (const gaussian::EdgeOfA e : lines_a.ids()) {
    const double bound = nearest.empty() ? HUGE_VAL : kernels::image_bound(nearest.numerator(), nearest.denominator(), exponent);
    if (arcs_have_ends) {
      kernels::crossing_and_not_farther({lines_a.images(), arcs_a}, e.value, {lines_b.images(), arcs_b}, bound, unsure);
    } else {
      kernels::not_farther(lines_a.images(), e.value, lines_b.images(), bound, unsure);
    }
    for (const std::uint32_t f : unsure) offer_crossing(kernel, of_a, lines_a, e, of_b, lines_b, gaussian::EdgeOfB(f), nearest);
  }
  return nearest;
}

}  // namespace fathom::depth
