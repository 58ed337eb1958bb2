// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/filters/plane.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/predicates/direction.hpp"

namespace fathom::kernels {
namespace {

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
  image_ = image(enclose({shifted(u.x, axes.x), shifted(u.y, axes.y), shifted(u.z, axes.z)}));
  const int up = axis_of_greatest(u);
  right_ = (up + 1) % 3;
  far_ = (up + 2) % 3;
}

double PlanarView::height(std::uint32_t p, std::uint32_t q) const {
  const PointCloud& c = *cloud_;
  return image_.x * (c.xs()[q] - c.xs()[p]) + image_.y * (c.ys()[q] - c.ys()[p]) + image_.z * (c.zs()[q] - c.zs()[p]);
}

Sign PlanarView::rise(std::uint32_t p, std::uint32_t q) const {
  if (const auto sure = sure_sign(height(p, q), error_bound::rise)) return *sure;
  return sign_of(dot(u_, (*cloud_)[q] - (*cloud_)[p]));
}

Sign PlanarView::turn(std::uint32_t o, std::uint32_t p, std::uint32_t q) const {
  const std::span<const double> rights = right_ == 0 ? cloud_->xs() : right_ == 1 ? cloud_->ys() : cloud_->zs();
  const double t = (rights[p] - rights[o]) * height(o, q) - height(o, p) * (rights[q] - rights[o]);
  if (const auto sure = sure_sign(t, error_bound::turn)) return *sure;
  const Vector op = (*cloud_)[p] - (*cloud_)[o], oq = (*cloud_)[q] - (*cloud_)[o];
  const mpz_class up_p = dot(u_, op), up_q = dot(u_, oq);
  for (const int axis : {right_, far_}) {
    const mpz_class exact = coordinate(op, axis) * up_q - up_p * coordinate(oq, axis);
    if (exact != 0) return sign_of(exact);
  }
  return Sign::zero;
}

}  // namespace fathom::kernels
