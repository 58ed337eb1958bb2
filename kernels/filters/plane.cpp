// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/filters/plane.hpp"

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

using Interval = CGAL::Interval_nt<false>;  // asks its caller to round upward: a Protector in each function that computes

Interval interval(const DoubleInterval& e) { return {e.low, e.high}; }
DoubleInterval enclosure(const Interval& i) { return {i.inf(), i.sup()}; }

Vec3<Interval> interval(const Vec3<DoubleInterval>& v) { return {interval(v.x), interval(v.y), interval(v.z)}; }
Vec3<DoubleInterval> enclosure(const Vec3<Interval>& v) { return {enclosure(v.x), enclosure(v.y), enclosure(v.z)}; }

/// The sign of all numbers in i, if they agree.
std::optional<int> certain_sign(const Interval& i) {
  if (i.inf() > 0) return 1;
  if (i.sup() < 0) return -1;
  if (i.inf() == 0 && i.sup() == 0) return 0;
  return std::nullopt;
}

double largest(const Vec3<double>& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// (q - p) x (r - p).
template <class NT>
Vec3<NT> normal_of(const Vec3<NT>& p, const Vec3<NT>& q, const Vec3<NT>& r) {
  return cross(q - p, r - p);
}

/// The same, of the projections along an axis.
template <class NT>
NT turn_of(const Vec3<NT>& p, const Vec3<NT>& q, const Vec3<NT>& r, int axis) {
  const int right = (axis + 1) % 3, up = (axis + 2) % 3;
  const Vec3<NT> u = q - p, v = r - p;
  return NT(coordinate(u, right) * coordinate(v, up) - coordinate(u, up) * coordinate(v, right));
}

}  // namespace

BoxedPoints::BoxedPoints(std::span<const Vector> exact) : exact_(exact) {
  std::size_t bits = 0;
  for (const Vector& p : exact) {
    for (const mpz_class* c : {&p.x, &p.y, &p.z}) bits = std::max(bits, mpz_sizeinbase(c->get_mpz_t(), 2));
  }
  const long shift = static_cast<long>(bits);
  boxes_.reserve(exact.size());
  images_.reserve(exact.size());
  for (const Vector& p : exact) {
    const Vec3<DoubleInterval>& box =
        boxes_.emplace_back(Vec3<DoubleInterval>{enclose(p.x, shift), enclose(p.y, shift), enclose(p.z, shift)});
    images_.push_back({box.x.low, box.y.low, box.z.low});
  }
}

Plane::Plane(const BoxedPoints& points, std::uint32_t p, std::uint32_t q, std::uint32_t r) : points_(&points), p_(p), q_(q), r_(r) {
  const Vec3<double> u = points.image(q) - points.image(p), v = points.image(r) - points.image(p);
  image_ = cross(u, v);
  size_ = largest(image_);
  error_ = 0x1p-49 * (largest(u) + largest(v) + largest(u) * largest(v)) + 0x1p-98;
}

int Plane::rise(std::uint32_t s, std::uint32_t t) const {
  {
    const Vec3<double> step = points_->image(t) - points_->image(s);
    const double height = dot(image_, step), length = largest(step);
    const double error = 0x1p-48 * size_ * (1 + length) + (4 * length + 0x1p-48) * error_;
    if (height > error) return 1;
    if (height < -error) return -1;
  }
  {
    const Interval::Protector upward;
    const Interval height = dot(interval(box()), interval(points_->box(t)) - interval(points_->box(s)));
    if (const auto sign = certain_sign(height)) return *sign;
  }
  const mpz_class height = dot(normal(), points_->exact(t) - points_->exact(s));
  return sgn(height);
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
    box_ = enclosure(normal_of(interval(points_->box(p_)), interval(points_->box(q_)), interval(points_->box(r_))));
  }
  return *box_;
}

const Vector& Plane::normal() const {
  if (!normal_) normal_ = normal_of(points_->exact(p_), points_->exact(q_), points_->exact(r_));
  return *normal_;
}

int turn(const BoxedPoints& points, int axis, std::uint32_t p, std::uint32_t q, std::uint32_t r) {
  {
    const Interval::Protector upward;
    const Interval t = turn_of(interval(points.box(p)), interval(points.box(q)), interval(points.box(r)), axis);
    if (const auto sign = certain_sign(t)) return *sign;
  }
  const mpz_class t = turn_of(points.exact(p), points.exact(q), points.exact(r), axis);
  return sgn(t);
}

}  // namespace fathom
