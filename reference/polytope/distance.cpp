// SPDX-License-Identifier: GPL-3.0-or-later
// The method of Gilbert, Johnson and Keerthi (Wolfe's for nearest points), in exact arithmetic:
// keep the point z of the hull of one to three differences that is nearest to O; add the difference
// that lies farthest towards O; drop those that the new nearest point does not
// need. |z| falls strictly, so no triple occurs twice and the search ends.  [proofs/distance.md]
#include <algorithm>
#include <bit>
#include <optional>
#include <stdexcept>
#include <utility>

#include "kernels/number/rational.hpp"
#include "reference/polytope/position.hpp"

namespace fathom::polytope {
namespace {

/// Returns the foot of O on the affine hull of one to three affinely independent points, or nullopt
/// unless all of its weights are positive.
std::optional<SimplexFoot> foot(const std::vector<SimplexCorner>& corners) {
  const Vector& p = corners[0].p;
  if (corners.size() == 1) return SimplexFoot{p, {1}, 1};
  const Vector e = corners[1].p - p;
  if (corners.size() == 2) {
    const mpz_class square = dot(e, e), w = -dot(p, e);
    if (w <= 0 || w >= square) return std::nullopt;
    return SimplexFoot{square * p + w * e, {square - w, w}, square};
  }
  // In the plane of the three, every point is p + (<(x - p) x f, n> e + <e x (x - p), n> f) / <n,
  // n>.
  const Vector f = corners[2].p - p, n = cross(e, f);
  const mpz_class square = dot(n, n), v = det(-p, f, n), w = det(e, -p, n);
  mpz_class u = square - v - w;
  if (u <= 0 || v <= 0 || w <= 0) return std::nullopt;
  return SimplexFoot{dot(n, p) * n, {std::move(u), v, w}, square};
}

bool nearest_of(const SimplexFoot& z, const std::vector<SimplexCorner>& corners) {
  const mpz_class square = dot(z.point, z.point);
  return std::all_of(corners.begin(), corners.end(),
                     [&](const SimplexCorner& c) { return z.denominator * dot(z.point, c.p) >= square; });
}

std::vector<Weight> shares(const std::vector<SimplexCorner>& corners, const SimplexFoot& z,
                           std::uint32_t Difference::*side) {
  std::vector<Difference> differences;
  std::vector<mpq_class> weights;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    differences.push_back(corners[i].ids);
    weights.push_back(kernels::ratio(z.weights[i], z.denominator));
  }
  return weights_of(differences, weights, side);
}

}  // namespace

std::optional<SimplexFoot> nearest_in_simplex(std::vector<SimplexCorner>& corners) {
  const unsigned last = 1U << (corners.size() - 1);
  for (unsigned subset = last; subset < 2 * last; ++subset) {
    if (std::popcount(subset) > 3) continue;
    std::vector<SimplexCorner> chosen;
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (subset >> i & 1U) chosen.push_back(corners[i]);
    std::optional<SimplexFoot> z = foot(chosen);
    if (!z || !nearest_of(*z, corners)) continue;
    corners = std::move(chosen);
    return z;
  }
  return std::nullopt;
}

NearestPoints nearest_points(const kernels::PointCloud& a, const kernels::PointCloud& b) {
  if (a.size() == 0 || b.size() == 0) throw std::invalid_argument("nearest_points: an empty body");
  if (a.exponent() != b.exponent()) throw std::invalid_argument("nearest_points: the clouds differ in their exponents");
  Differences differences{a, b};
  std::vector<SimplexCorner> corners{{{0, 0}, differences[{0, 0}]}};
  while (true) {
    const std::optional<SimplexFoot> nearest = nearest_in_simplex(corners);
    if (!nearest || is_zero(nearest->point))
      throw std::invalid_argument("nearest_points: the hulls have a point in common");
    const SimplexFoot& z = *nearest;
    const Vector n = primitive(-z.point);
    const Difference ids = differences.extreme(n);
    const Vector p = differences[ids];
    if (z.denominator * dot(n, p) <= dot(n, z.point)) {
      return {n, dot(n, p), shares(corners, z, &Difference::first), shares(corners, z, &Difference::second),
              differences.scans};
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
