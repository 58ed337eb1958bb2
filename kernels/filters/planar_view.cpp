// SPDX-License-Identifier: GPL-3.0-or-later
// The filter's error, in units of w = 2^-52, for any rounding mode. Points and u are scaled to [-1, 1], each axis of the points by a power of two
// of its own and that of u the other way round; the image of a coordinate of a point errs by w, that of u by w/2.
//   difference of coordinates, below 2        3 w   two images, and w to round
//   one product with a coordinate of u        5 w   3 + 2 * 1/2, and w to round
//   height difference, below 6               21 w   three products, and 2 + 4 to round the sums
//   product of a width and a height, below 12 68 w   2 * 21 + 6 * 3, and 8 to round
//   turn, below 24                          152 w   two products, and 16 to round the difference
// Underflow adds less than 2^-1000. So a height beyond 32 w = 2^-47 and a turn beyond 256 w = 2^-44 have the right sign.
#include "kernels/filters/planar_view.hpp"

#include "kernels/filters/double_images.hpp"
#include "kernels/filters/plane.hpp"
#include "kernels/predicates/direction.hpp"

namespace fathom {
namespace {

constexpr double error_of_height = 0x1p-47;
constexpr double error_of_turn = 0x1p-44;

int axis_of_greatest(const Vector& u) {
  int axis = 0;
  for (const int other : {1, 2})
    if (mpz_cmpabs(coordinate(u, other).get_mpz_t(), coordinate(u, axis).get_mpz_t()) > 0) axis = other;
  return axis;
}

mpz_class shifted(const mpz_class& c, long exponent) { return c << static_cast<mp_bitcnt_t>(exponent); }

}  // namespace

PlanarView::PlanarView(const PointCloud& cloud, const Vector& u) : cloud_(&cloud), u_(u) {
  const Vec3<long>& axes = cloud.axis_exponents();
  const Vec3<DoubleInterval> e = enclose({shifted(u.x, axes.x), shifted(u.y, axes.y), shifted(u.z, axes.z)});
  image_ = {e.x.low, e.y.low, e.z.low};
  const int up = axis_of_greatest(u);
  right_ = (up + 1) % 3;
  far_ = (up + 2) % 3;
}

double PlanarView::height(std::uint32_t p, std::uint32_t q) const {
  const PointCloud& c = *cloud_;
  return image_.x * (c.xs()[q] - c.xs()[p]) + image_.y * (c.ys()[q] - c.ys()[p]) + image_.z * (c.zs()[q] - c.zs()[p]);
}

Sign PlanarView::rise(std::uint32_t p, std::uint32_t q) const {
  if (const auto sure = sure_sign(height(p, q), error_of_height)) return *sure;
  return sign_of(dot(u_, (*cloud_)[q] - (*cloud_)[p]));
}

Sign PlanarView::turn(std::uint32_t o, std::uint32_t p, std::uint32_t q) const {
  const std::span<const double> rights = right_ == 0 ? cloud_->xs() : right_ == 1 ? cloud_->ys() : cloud_->zs();
  const double t = (rights[p] - rights[o]) * height(o, q) - height(o, p) * (rights[q] - rights[o]);
  if (const auto sure = sure_sign(t, error_of_turn)) return *sure;
  const Vector op = (*cloud_)[p] - (*cloud_)[o], oq = (*cloud_)[q] - (*cloud_)[o];
  const mpz_class up_p = dot(u_, op), up_q = dot(u_, oq);
  for (const int axis : {right_, far_}) {
    const mpz_class exact = coordinate(op, axis) * up_q - up_p * coordinate(oq, axis);
    if (exact != 0) return sign_of(exact);
  }
  return Sign::zero;
}

}  // namespace fathom
