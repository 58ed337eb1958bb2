// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/shapes/support.hpp"

#include <optional>
#include <variant>

#include "kernels/vector.hpp"

namespace fathom::shapes {
namespace {

using kernels::RationalInterval;

/// <u,center>, and the length of the slopes of u along the axes.
RationalInterval support(const Atom& atom, const Point& u, unsigned bits) {
  mpq_class square = 0;
  for (const Point& axis : atom.axes) {
    const mpq_class slope = dot(u, axis);
    square += slope * slope;
  }
  return kernels::enclosed({dot(u, atom.center), square}, bits);
}

}  // namespace

RationalInterval support(const Shape& shape, const Point& u, unsigned bits) {
  RationalInterval height{0, 0};
  for (const Term& term : std::get<std::vector<Term>>(shape.core)) {
    std::optional<RationalInterval> highest;
    for (const Atom& atom : term.atoms) {
      const RationalInterval other = support(atom, u, bits);
      highest = highest ? greater(*highest, other) : other;
    }
    height = height + *highest;
  }
  const RationalInterval radius{shape.radius, shape.radius};
  return quotient(height, kernels::enclosed({0, dot(u, u)}, bits)) + radius;
}

}  // namespace fathom::shapes
