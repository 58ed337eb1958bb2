// SPDX-License-Identifier: GPL-3.0-or-later
// An atom is one of revolution about a line in direction d if its centre is on the line, and M M^T = x I + y d d^T.
#include <algorithm>

#include "verify/study/solid.hpp"

namespace fathom::studies {
namespace {

RationalVector times(const Gram& s, const RationalVector& v) { return {dot(s[0], v), dot(s[1], v), dot(s[2], v)}; }

/// Whether S maps d to a multiple of itself, and all vectors orthogonal to d to the same multiple of themselves.
bool turns_about(const Gram& s, const RationalVector& d) {
  const RationalVector image = times(s, d);
  if (!is_zero(cross(image, d))) return false;
  const RationalVector e = d.x != 0 || d.y != 0 ? RationalVector{-d.y, d.x, 0} : RationalVector{1, 0, 0}, f = cross(d, e);
  const RationalVector of_e = times(s, e), of_f = times(s, f);
  return is_zero(cross(of_e, e)) && is_zero(cross(of_f, f)) && dot(of_e, e) * dot(f, f) == dot(of_f, f) * dot(e, e);
}

bool is_multiple_of_unit(const Gram& s) { return turns_about(s, {1, 0, 0}) && turns_about(s, {0, 1, 0}); }

/// The one direction about which an ellipsoid or disc might be of revolution: that of M M^T - x I = y d d^T. It is not checked.
std::optional<RationalVector> direction_of(const Gram& s) {
  const mpq_class &xy = s[0].y, &xz = s[0].z, &yz = s[1].z;
  const int entries = (xy != 0 ? 1 : 0) + (xz != 0 ? 1 : 0) + (yz != 0 ? 1 : 0);
  if (entries == 3) return RationalVector{xy * xz, xy * yz, xz * yz};
  if (entries == 2) return std::nullopt;
  if (xy != 0) return RationalVector{s[0].x - s[2].z, xy, 0};
  if (xz != 0) return RationalVector{s[0].x - s[1].y, 0, xz};
  if (yz != 0) return RationalVector{0, s[1].y - s[0].x, yz};
  if (s[0].x == s[1].y) return RationalVector{0, 0, 1};
  if (s[0].x == s[2].z) return RationalVector{0, 1, 0};
  if (s[1].y == s[2].z) return RationalVector{1, 0, 0};
  return std::nullopt;
}

/// What a term says about the axis of a sum.
struct TermAxis {
  bool possible = true;
  RationalVector point;
  std::optional<RationalVector> direction;  ///< nullopt: every one, it is a ball or a point
};

TermAxis axis_of_term(const Term& term) {
  TermAxis axis{true, rational(term.atoms.front().center), std::nullopt};
  for (const Atom& atom : term.atoms)
    if (const RationalVector d = rational(atom.center) - axis.point; !is_zero(d) && !axis.direction) axis.direction = d;
  for (const Atom& atom : term.atoms) {
    const Gram s = gram_of(atom);
    if (axis.direction || is_multiple_of_unit(s)) continue;
    axis.direction = direction_of(s);
    if (!axis.direction) return {false, {}, {}};
  }
  if (!axis.direction) return axis;
  axis.possible = std::all_of(term.atoms.begin(), term.atoms.end(), [&](const Atom& atom) {
    return is_zero(cross(RationalVector(rational(atom.center) - axis.point), *axis.direction)) &&
           turns_about(gram_of(atom), *axis.direction);
  });
  return axis;
}

}  // namespace

Gram gram_of(const Atom& atom) {
  Gram s;
  for (const Point& p : atom.axes) {
    const RationalVector m = rational(p);
    s[0] = s[0] + scaled(m.x, m);
    s[1] = s[1] + scaled(m.y, m);
    s[2] = s[2] + scaled(m.z, m);
  }
  return s;
}

std::optional<mpq_class> round_square(const Atom& atom) {
  if (atom.axes.empty()) return std::nullopt;
  const mpq_class square = dot(rational(atom.axes[0]), rational(atom.axes[0]));
  for (std::size_t i = 0; i < atom.axes.size(); ++i) {
    if (dot(rational(atom.axes[i]), rational(atom.axes[i])) != square) return std::nullopt;
    for (std::size_t j = 0; j < i; ++j)
      if (dot(rational(atom.axes[i]), rational(atom.axes[j])) != 0) return std::nullopt;
  }
  return square;
}

std::optional<Line> axis_of(std::span<const Term> terms) {
  RationalVector point;
  std::optional<RationalVector> direction;
  for (const Term& term : terms) {
    const TermAxis axis = axis_of_term(term);
    if (!axis.possible) return std::nullopt;
    if (axis.direction && direction && !is_zero(cross(*axis.direction, *direction))) return std::nullopt;
    if (axis.direction) direction = axis.direction;
    point = point + axis.point;
  }
  if (!direction) return std::nullopt;
  return Line{point, primitive_along(*direction)};
}

}  // namespace fathom::studies
