// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/float_environment.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/shapes/core.hpp"

namespace fathom {
namespace {

Vec3<mpq_class> vector(const Point& p) { return {p.x, p.y, p.z}; }

}  // namespace

bool is_flat(const Shape& shape) {
  const kernels::DefaultFloatEnvironment environment;
  shapes::require_shape(shape);
  const auto* const terms = std::get_if<std::vector<Term>>(&shape.core);
  if (!terms || shape.radius > 0) return false;
  std::vector<Vec3<mpq_class>> spanning(1);  // O, and vectors that span the space of all differences of points
  for (const Term& term : *terms) {
    for (const Atom& atom : term.atoms) {
      spanning.push_back(vector(atom.center) - vector(term.atoms.front().center));
      for (const Point& axis : atom.axes) spanning.push_back(vector(axis));
    }
  }
  return polytope::affine_span<mpq_class>(spanning, spanning.size()).rank < 3;
}

}  // namespace fathom
