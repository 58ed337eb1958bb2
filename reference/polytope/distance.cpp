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
template <class Integer>
std::optional<SimplexFoot<Integer>> foot(const std::vector<SimplexCorner<Integer>>& corners) {
  const Vec3<Integer>& p = corners[0].p;
  if (corners.size() == 1) return SimplexFoot<Integer>{p, {1}, 1};
  const Vec3<Integer> e = corners[1].p - p;
  if (corners.size() == 2) {
    const Integer square = dot(e, e), w = -dot(p, e), rest = square - w;
    if (sgn(w) <= 0 || sgn(rest) <= 0) return std::nullopt;
    return SimplexFoot<Integer>{square * p + w * e, {rest, w}, square};
  }
  // In the plane of the three, every point is p + (<(x - p) x f, n> e + <e x (x - p), n> f) / <n,
  // n>.
  const Vec3<Integer> f = corners[2].p - p, n = cross(e, f);
  const Integer square = dot(n, n), v = det(Vec3<Integer>(-p), f, n), w = det(e, Vec3<Integer>(-p), n),
                u = square - v - w;
  if (sgn(u) <= 0 || sgn(v) <= 0 || sgn(w) <= 0) return std::nullopt;
  return SimplexFoot<Integer>{dot(n, p) * n, {u, v, w}, square};
}

template <class Integer>
bool nearest_of(const SimplexFoot<Integer>& z, const std::vector<SimplexCorner<Integer>>& corners) {
  const Integer square = dot(z.point, z.point);
  return std::ranges::all_of(corners, [&](const SimplexCorner<Integer>& c) {
    return cmp(Integer(z.denominator * dot(z.point, c.p)), square) >= 0;
  });
}

// Short directions make scans in integers of any size faster; those of fixed size are long enough.
Vector shortened(const Vector& n) { return primitive(n); }
template <class Integer>
const Vec3<Integer>& shortened(const Vec3<Integer>& n) {
  return n;
}

template <class Integer>
std::vector<Weight> shares(const std::vector<SimplexCorner<Integer>>& corners, const SimplexFoot<Integer>& z,
                           std::uint32_t Difference::*side) {
  std::vector<Difference> differences;
  for (const SimplexCorner<Integer>& corner : corners) differences.push_back(corner.ids);
  return weights_of(differences, z.weights, z.denominator, side);
}

}  // namespace

template <class Integer>
std::optional<SimplexFoot<Integer>> nearest_in_simplex(std::vector<SimplexCorner<Integer>>& corners) {
  const unsigned last = 1U << (corners.size() - 1);
  for (unsigned subset = last; subset < 2 * last; ++subset) {
    if (std::popcount(subset) > 3) continue;
    std::vector<SimplexCorner<Integer>> chosen;
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (subset >> i & 1U) chosen.push_back(corners[i]);
    std::optional<SimplexFoot<Integer>> z = foot(chosen);
    if (!z || !nearest_of(*z, corners)) continue;
    corners = std::move(chosen);
    return z;
  }
  return std::nullopt;
}
template std::optional<SimplexFoot<mpz_class>> nearest_in_simplex(std::vector<SimplexCorner<mpz_class>>&);

template <class Body>
std::optional<NearestPoints> nearest_points_if_apart(DifferencesOf<Body> differences) {
  using Integer = IntegerOf<Body>;
  require_bodies(differences, "nearest_points");
  std::vector<SimplexCorner<Integer>> corners{{{0, 0}, differences[{0, 0}]}};
  while (true) {
    const std::optional<SimplexFoot<Integer>> nearest = nearest_in_simplex(corners);
    if (!nearest || is_zero(nearest->point)) return std::nullopt;
    const SimplexFoot<Integer>& z = *nearest;
    const Vec3<Integer> n = shortened(-z.point);
    const Difference ids = differences.extreme(n);
    const Vec3<Integer> p = differences[ids];
    if (cmp(Integer(z.denominator * dot(n, p)), dot(n, z.point)) <= 0) {
      const Vector normal = primitive(to_vector(n));
      return NearestPoints{normal, dot(normal, to_vector(p)), shares(corners, z, &Difference::first),
                           shares(corners, z, &Difference::second), differences.scans};
    }
    corners.push_back({ids, p});
  }
}
template std::optional<NearestPoints> nearest_points_if_apart(Differences);
template std::optional<NearestPoints> nearest_points_if_apart(DifferencesIn<NarrowInteger>);

template <class Body>
NearestPoints nearest_points(DifferencesOf<Body> differences) {
  std::optional<NearestPoints> nearest = nearest_points_if_apart(std::move(differences));
  if (!nearest) throw std::invalid_argument("nearest_points: the hulls have a point in common");
  return *std::move(nearest);
}
template NearestPoints nearest_points(Differences);
template NearestPoints nearest_points(DifferencesIn<NarrowInteger>);

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
