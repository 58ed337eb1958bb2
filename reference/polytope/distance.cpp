// SPDX-License-Identifier: GPL-3.0-or-later
// The method of Gilbert, Johnson and Keerthi (Wolfe's for nearest points), in exact arithmetic: keep the point z of the hull of one to
// three differences that is nearest to O; add the difference that lies farthest towards O; drop those that the new nearest point does not
// need. |z| falls strictly, so no triple occurs twice and the search ends.  [proofs/distance.md]
#include <optional>
#include <stdexcept>

#include "kernels/number/rational.hpp"
#include "reference/polytope/position.hpp"
#include "reference/polytope/position_search.hpp"

namespace fathom::polytope {
namespace {

std::vector<Weight> shares(const std::vector<SimplexCorner>& corners, const SimplexFoot& z, std::uint32_t Difference::*side) {
  std::vector<Difference> differences;
  std::vector<mpq_class> weights;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    differences.push_back(corners[i].ids);
    weights.push_back(kernels::ratio(z.weights[i], z.denominator));
  }
  return weights_of(differences, weights, side);
}

}  // namespace

NearestPoints nearest_points(const kernels::PointCloud& a, const kernels::PointCloud& b) {
  if (a.size() == 0 || b.size() == 0) throw std::invalid_argument("nearest_points: an empty body");
  if (a.exponent() != b.exponent()) throw std::invalid_argument("nearest_points: the clouds differ in their exponents");
  Differences differences{a, b};
  std::vector<SimplexCorner> corners{{{0, 0}, differences[{0, 0}]}};
  while (true) {
    const std::optional<SimplexFoot> nearest = nearest_in_simplex(corners);
    if (!nearest || is_zero(nearest->point)) throw std::invalid_argument("nearest_points: the hulls have a point in common");
    const SimplexFoot& z = *nearest;
    const Vector n = primitive(-z.point);
    const Difference ids = differences.extreme(n);
    const Vector p = differences[ids];
    if (z.denominator * dot(n, p) <= dot(n, z.point)) {
      return {n, dot(n, p), shares(corners, z, &Difference::first), shares(corners, z, &Difference::second), differences.scans};
    }
    corners.push_back({ids, p});
  }
}

kernels::Report validate(const NearestPoints& answer, std::span<const Vector> a, std::span<const Vector> b) {
  kernels::Report report;
  const Vector& n = answer.normal;
  if (!report.expect(!a.empty() && !b.empty(), "an empty body")) return report;
  if (!report.expect(!is_zero(n) && primitive(n) == n, "the normal is not a primitive vector")) return report;
  report.expect(answer.height < 0, "the normal does not separate the bodies strictly");
  report.expect(support_naive(a, b, n) == answer.height, "the height is not that of the normal");
  const auto in_a = convex_combination(a, answer.a), in_b = convex_combination(b, answer.b);
  report.expect(in_a.has_value(), "the weights of A are not convex weights of its points");
  report.expect(in_b.has_value(), "the weights of B are not convex weights of its points");
  if (!in_a || !in_b) return report;
  const mpq_class factor = kernels::ratio(answer.height, dot(n, n));
  const Vec3<mpq_class> foot_of_o{factor * n.x, factor * n.y, factor * n.z};
  report.expect(*in_b - *in_a == foot_of_o, "the weighted points do not differ by the foot of O");
  return report;
}

}  // namespace fathom::polytope
