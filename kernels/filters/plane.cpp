// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/filters/plane.hpp"

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/predicates/direction.hpp"
#include "kernels/predicates/kernels_cgal.hpp"

namespace fathom::kernels {
namespace {

using Interval = IntervalKernel::FT;

DoubleInterval enclosure(const Interval& i) { return {i.inf(), i.sup()}; }

/// (q - p) x (r - p).
template <class Vector_3>
Vector_3 normal_of(const Vector_3& p, const Vector_3& q, const Vector_3& r) {
  return CGAL::cross_product(Vector_3(q - p), Vector_3(r - p));
}

/// An operand of filtered predicates.
struct PointOperand {
  const BoxedPoints& points;
  std::uint32_t index;

  [[nodiscard]] const Vector& exact() const { return points.exact(index); }
  [[nodiscard]] const Vec3<DoubleInterval>& enclosure() const { return points.box(index); }
};

}  // namespace

BoxedPoints::BoxedPoints(std::span<const Vector> exact) : exact_(exact) {
  long shift = 0;
  for (const Vector& p : exact) shift = std::max(shift, bit_length(p));
  boxes_.reserve(exact.size());
  images_.reserve(exact.size());
  for (const Vector& p : exact) {
    const Vec3<DoubleInterval>& box =
        boxes_.emplace_back(Vec3<DoubleInterval>{enclose(p.x, shift), enclose(p.y, shift), enclose(p.z, shift)});
    images_.push_back(image(box));
  }
}

Plane::Plane(const BoxedPoints& points, std::uint32_t p, std::uint32_t q, std::uint32_t r)
    : points_(&points), p_(p), q_(q), r_(r) {
  const Vec3<double> u = points.rounded(q) - points.rounded(p), v = points.rounded(r) - points.rounded(p);
  image_ = cross(u, v);
  size_ = largest(image_);
  error_ = error_bound::normal(largest(u), largest(v));
}

Sign Plane::rise(std::uint32_t s, std::uint32_t t) const {
  struct Normal {
    const Plane& plane;
    [[nodiscard]] const Vector& exact() const { return plane.normal(); }
    [[nodiscard]] const Vec3<DoubleInterval>& enclosure() const { return plane.box(); }
  };
  const Vec3<double> step = points_->rounded(t) - points_->rounded(s);
  if (const auto sure = sure_sign(dot(image_, step), error_bound::height(size_, error_, largest(step)))) return *sure;
  return filtered_sign(HeightOrder<ExactKernel>{}, HeightOrder<IntervalKernel>{}, Normal{*this},
                       PointOperand{*points_, s}, PointOperand{*points_, t});
}

bool Plane::degenerate() const {
  if (size_ > error_) return false;
  for (const DoubleInterval* c : {&box().x, &box().y, &box().z}) {
    if (c->low > 0 || c->high < 0) return false;
  }
  return is_zero(normal());
}

const Vec3<DoubleInterval>& Plane::box() const {
  if (!box_) {
    const Interval::Protector upward;
    const auto n =
        normal_of(to_intervals(points_->box(p_)), to_intervals(points_->box(q_)), to_intervals(points_->box(r_)));
    box_ = {enclosure(n.x()), enclosure(n.y()), enclosure(n.z())};
  }
  return *box_;
}

const Vector& Plane::normal() const {
  if (!normal_) {
    const auto point = [&](std::uint32_t i) { return to_cgal<ExactKernel>(points_->exact(i)); };
    normal_ = from_cgal(normal_of(point(p_), point(q_), point(r_)));
  }
  return *normal_;
}

Sign turn(const BoxedPoints& points, int axis, std::uint32_t p, std::uint32_t q, std::uint32_t r) {
  return filtered_sign(ProjectedTurn<ExactKernel>{axis}, ProjectedTurn<IntervalKernel>{axis}, PointOperand{points, p},
                       PointOperand{points, q}, PointOperand{points, r});
}

// sqrt(m / n) has few roundings, each by a factor below 1 + 2^-51.
double root_from_above(const Leading& numerator, const Leading& denominator, long exponent) {
  const auto& [m, i] = numerator;
  const auto& [n, j] = denominator;
  if (m == 0) return 0;
  const long k = i - j - (i - j) % 2;  // even, and what is left is -1, 0 or 1
  const double root = std::sqrt(std::ldexp(m / n, static_cast<int>(i - j - k))) * error_bound::raised_root;
  const long shift = k / 2 - exponent;
  if (shift > 500) return std::numeric_limits<double>::infinity();
  return std::ldexp(root, static_cast<int>(std::max(shift, -500L)));
}

RoundedPlane::RoundedPlane(const Vec3<double>& p, const Vec3<double>& q, const Vec3<double>& r) : p_(p) {
  const Vec3<double> u = q - p, v = r - p;
  n_ = cross(u, v);
  error_ = error_bound::wide_plane(largest(u), largest(v));
  const double height = dot(n_, p), length = std::sqrt(dot(n_, n_));
  height_ = height - error(largest(p));
  length_ = length + 2 * error_.normal;
  distance_ = length > 0 ? height / length : 0;
  trustworthy_ = length > 0x1p20 * error_.normal;
}

std::optional<Sign> RoundedPlane::side(const Vec3<double>& s) const {
  const Vec3<double> w = s - p_;
  return sure_sign(dot(n_, w), error(largest(w)));
}

bool RoundedPlane::surely_beyond(double radius) const {
  return height_ > 0 && height_ > radius * length_ * error_bound::raised_root;
}

}  // namespace fathom::kernels
