// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rounded/half_space.hpp"

#include "kernels/vector.hpp"

namespace fathom::rounded {
namespace {

// A point of the sum with the least <u,p>; in each term the first one.
Point lowest_point(std::span<const Term> terms, const Vector& u) {
  Point sum;
  for (const Term& term : terms) {
    const Point* lowest = nullptr;
    mpq_class least;
    for (const Atom& atom : term.atoms) {
      const mpq_class height = dot(u, atom.center);
      if (lowest == nullptr || height < least) (lowest = &atom.center, least = height);
    }
    sum = {sum.x + lowest->x, sum.y + lowest->y, sum.z + lowest->z};
  }
  return sum;
}

}  // namespace

PlaneSupport plane_support(const HalfSpace& half, Side side, std::span<const Term> other) {
  const Point& m = half.normal;
  const Vector outward = primitive_along(m);
  // {x : <outward,x> <= height}, as outward is a positive multiple of m.
  const mpq_class height = half.offset * (dot(outward, outward) / dot(outward, m));
  const Point p = lowest_point(other, outward);
  const mpq_class support = height - dot(outward, p), factor = support / dot(outward, outward);
  const Point foot = p + factor * outward;
  if (side == Side::b) return {outward, support, {p, foot}};
  return {-outward, support, {foot, p}};
}

}  // namespace fathom::rounded
