// SPDX-License-Identifier: GPL-3.0-or-later
// A face lies in a plane with normal n. Dropping a coordinate in which n is not 0 maps it
// one-to-one into a coordinate plane, and there a monotone chain finds the corners.

#include "verify/golden/records/faces.hpp"

#include <algorithm>

namespace fathom::golden {
namespace {

/// The two coordinates that remain.
struct Shadow {
  mpz_class Vector::*u;
  mpz_class Vector::*v;

  explicit Shadow(const Vector& n) : u(&Vector::x), v(&Vector::y) {
    if (n.z != 0) return;
    v = &Vector::z;
    if (n.y == 0) u = &Vector::y;
  }

  /// Positive when p, q, r turn left.
  [[nodiscard]] int turn(const Vector& p, const Vector& q, const Vector& r) const {
    const mpz_class left = (q.*u - p.*u) * (r.*v - p.*v), right = (q.*v - p.*v) * (r.*u - p.*u);
    return cmp(left, right);
  }
  [[nodiscard]] int order(const Vector& p, const Vector& q) const {
    const int first = cmp(p.*u, q.*u);
    return first != 0 ? first : cmp(p.*v, q.*v);
  }
};

using Ids = std::vector<std::uint32_t>;

/// Appends the lower chain of `sorted`, its last point left out.
template <class Iterator>
void append_chain(Iterator first, Iterator last, std::span<const Vector> points, const Shadow& shadow, Ids& cycle) {
  const std::size_t begin = cycle.size();
  for (; first != last; ++first) {
    while (cycle.size() >= begin + 2 &&
           shadow.turn(points[cycle[cycle.size() - 2]], points[cycle.back()], points[*first]) <= 0)
      cycle.pop_back();
    cycle.push_back(*first);
  }
  cycle.pop_back();
}

/// The corners of coplanar points in cyclic order.
Ids corner_cycle(Ids ids, std::span<const Vector> points, const Shadow& shadow) {
  std::ranges::sort(ids, [&](std::uint32_t i, std::uint32_t j) {
    const int order = shadow.order(points[i], points[j]);
    return order != 0 ? order < 0 : i < j;
  });
  const auto equal = [&](std::uint32_t i, std::uint32_t j) { return shadow.order(points[i], points[j]) == 0; };
  ids.erase(std::unique(ids.begin(), ids.end(), equal), ids.end());
  if (ids.size() == 1) return ids;
  Ids cycle;
  append_chain(ids.begin(), ids.end(), points, shadow, cycle);
  append_chain(ids.rbegin(), ids.rend(), points, shadow, cycle);
  return cycle;
}

void take_denominator(const mpq_class& value, mpz_class& common) {
  mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), value.get_den_mpz_t());
}

std::vector<Vector> scaled(std::span<const Point> points, const mpz_class& denominator) {
  const auto times = [&denominator](const mpq_class& value) {
    return mpz_class(denominator / value.get_den() * value.get_num());
  };
  std::vector<Vector> result;
  result.reserve(points.size());
  for (const Point& p : points) result.push_back({times(p.x), times(p.y), times(p.z)});
  return result;
}

}  // namespace

Integers integers_of(std::span<const Point> a, std::span<const Point> b) {
  Integers result;
  for (const std::span<const Point> points : {a, b}) {
    for (const Point& p : points) {
      for (const mpq_class* c : {&p.x, &p.y, &p.z}) take_denominator(*c, result.denominator);
    }
  }
  result.a = scaled(a, result.denominator);
  result.b = scaled(b, result.denominator);
  return result;
}

SupportingFace face_in_direction(std::span<const Vector> points, const Vector& n) {
  SupportingFace face;
  Ids highest;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const mpz_class height = dot(n, points[i]);
    const int above = highest.empty() ? 1 : cmp(height, face.height);
    if (above > 0) {
      highest.clear();
      face.height = height;
    }
    if (above >= 0) highest.push_back(i);
  }
  face.corners = corner_cycle(std::move(highest), points, Shadow(n));
  for (const std::uint32_t i : face.corners) face.cycle.push_back(points[i]);
  std::ranges::sort(face.corners);
  return face;
}

bool contains(const SupportingFace& face, const Vector& n, const mpz_class& denominator, const Point& p) {
  // In the unit 1 / (denominator * own) everything is an integer.
  mpz_class own = 1;
  for (const mpq_class* c : {&p.x, &p.y, &p.z}) take_denominator(*c, own);
  const mpz_class unit = own * denominator;
  const Vector at = scaled(std::span(&p, 1), unit).front();
  if (dot(n, at) != face.height * own) return false;
  std::vector<Vector> cycle;
  for (const Vector& corner : face.cycle) cycle.push_back({corner.x * own, corner.y * own, corner.z * own});
  const Shadow shadow(n);
  if (cycle.size() == 1) return shadow.order(at, cycle[0]) == 0;
  if (cycle.size() == 2) {
    return shadow.turn(cycle[0], cycle[1], at) == 0 && shadow.order(cycle[0], at) * shadow.order(at, cycle[1]) >= 0;
  }
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    if (shadow.turn(cycle[i], cycle[(i + 1) % cycle.size()], at) < 0) return false;
  }
  return true;
}

}  // namespace fathom::golden
