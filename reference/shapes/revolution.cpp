// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/shapes/revolution.hpp"

#include <algorithm>

#include "kernels/vector.hpp"

namespace fathom::shapes {
namespace {

Point times(const Gram& s, const Point& v) { return {dot(s[0], v), dot(s[1], v), dot(s[2], v)}; }

bool is_multiple_of_unit(const Gram& s) {
  const mpq_class& x = s[0].x;
  return s == Gram{Point{x, 0, 0}, Point{0, x, 0}, Point{0, 0, x}};
}

/// The one direction about which an ellipsoid or disc might be of revolution: that of M M^T - x I =
/// y d d^T. It is not checked.
std::optional<Vector> direction_of(const Gram& s) {
  const mpq_class &xy = s[0].y, &xz = s[0].z, &yz = s[1].z;
  const int entries = (xy != 0 ? 1 : 0) + (xz != 0 ? 1 : 0) + (yz != 0 ? 1 : 0);
  if (entries == 3) return primitive_along({xy * xz, xy * yz, xz * yz});
  if (entries == 2) return std::nullopt;
  if (xy != 0) return primitive_along({s[0].x - s[2].z, xy, 0});
  if (xz != 0) return primitive_along({s[0].x - s[1].y, 0, xz});
  if (yz != 0) return primitive_along({0, s[1].y - s[0].x, yz});
  if (s[0].x == s[1].y) return Vector{0, 0, 1};
  if (s[0].x == s[2].z) return Vector{0, 1, 0};
  if (s[1].y == s[2].z) return Vector{1, 0, 0};
  return std::nullopt;
}

std::optional<AxisLine> axis_of_term(const Term& term) {
  AxisLine axis{term.atoms.front().center, std::nullopt};
  for (const Atom& atom : term.atoms)
    if (!axis.direction && atom.center != axis.point) axis.direction = primitive_along(atom.center - axis.point);
  for (const Atom& atom : term.atoms) {
    if (axis.direction) break;
    const Gram s = gram_of(atom);
    if (is_multiple_of_unit(s)) continue;
    axis.direction = direction_of(s);
    if (!axis.direction) return std::nullopt;
  }
  if (!axis.direction) return axis;
  const Vector& d = *axis.direction;
  const bool possible = std::all_of(term.atoms.begin(), term.atoms.end(), [&](const Atom& atom) {
    return cross(Point(atom.center - axis.point), rational(d)) == Point{} && profile_about(atom, d);
  });
  return possible ? std::optional(axis) : std::nullopt;
}

}  // namespace

Gram gram_of(const Atom& atom) {
  Gram s;
  for (const Point& m : atom.axes) {
    s[0] = s[0] + m.x * m;
    s[1] = s[1] + m.y * m;
    s[2] = s[2] + m.z * m;
  }
  return s;
}

std::optional<AtomProfile> profile_about(const Atom& atom, const Vector& d) {
  if (atom.axes.empty()) return AtomProfile{0, 0};
  const Gram s = gram_of(atom);
  const Point axis = rational(d);
  const mpq_class length = dot(axis, axis), along = dot(axis, times(s, axis)) / (length * length),
                  across = (s[0].x + s[1].y + s[2].z - along * length) / (2 * length), rest = along - across;
  for (const auto part : {&Point::x, &Point::y, &Point::z}) {
    const std::size_t row = part == &Point::x ? 0 : part == &Point::y ? 1 : 2;
    Point expected = (rest * axis.*part) * axis;
    expected.*part += across * length;
    if (s[row] != expected) return std::nullopt;
  }
  return AtomProfile{across, along};
}

std::optional<AxisLine> axis_of(std::span<const Term> terms) {
  AxisLine sum;
  for (const Term& term : terms) {
    const std::optional<AxisLine> axis = axis_of_term(term);
    if (!axis) return std::nullopt;
    if (axis->direction && sum.direction && !is_zero(cross(*axis->direction, *sum.direction))) return std::nullopt;
    if (axis->direction) sum.direction = axis->direction;
    sum.point = sum.point + axis->point;
  }
  return sum;
}

}  // namespace fathom::shapes
