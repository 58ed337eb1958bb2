// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/cdd_oracle.hpp"

#include <gmp.h>

extern "C" {
#include <cddlib/setoper.h>
// cdd.h needs the types above.
#include <cddlib/cdd.h>
}

#include <array>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>

namespace fathom::oracles {

namespace {

struct FreeMatrix {
  void operator()(dd_MatrixType* matrix) const { dd_FreeMatrix(matrix); }
};
struct FreePolyhedra {
  void operator()(dd_PolyhedraType* polyhedra) const { dd_FreePolyhedra(polyhedra); }
};
using Matrix = std::unique_ptr<dd_MatrixType, FreeMatrix>;
using Polyhedra = std::unique_ptr<dd_PolyhedraType, FreePolyhedra>;

/// One row (1, b - a) for each difference, in integer units.
Matrix generators(const IntegerBodies& bodies) {
  Directions differences;
  for (const Vector& p : bodies.a)
    for (const Vector& q : bodies.b) differences.insert(q - p);
  Matrix matrix(dd_CreateMatrix(static_cast<dd_rowrange>(differences.size()), 4));
  matrix->representation = dd_Generator;
  matrix->numbtype = dd_Rational;
  dd_rowrange row = 0;
  for (const Vector& difference : differences) {
    const std::array<mpq_class, 4> entries{1, difference.x, difference.y, difference.z};
    for (std::size_t column = 0; column < 4; ++column) dd_set(matrix->matrix[row][column], entries[column].get_mpq_t());
    ++row;
  }
  return matrix;
}

/// A row (c, -n) of the other representation says c - <n,x> >= 0, in integer units. Scaled so that
/// the normal is an integer vector. No value for a row without a normal: it says only that a
/// constant is not negative.
void add_half_space(std::vector<HalfSpace>& half_spaces, mpq_t* row, bool equation, const mpz_class& denominator) {
  const mpq_class c(row[0]), x(row[1]), y(row[2]), z(row[3]);
  const mpz_class scale = lcm(x.get_den(), lcm(y.get_den(), z.get_den()));
  const auto integer = [&scale](const mpq_class& value) {
    return mpz_class(-value.get_num() * (scale / value.get_den()));
  };
  const Vector normal{integer(x), integer(y), integer(z)};
  if (is_zero(normal)) return;
  const mpq_class offset = c * scale / denominator;
  half_spaces.push_back({normal, offset});
  if (equation) half_spaces.push_back({-normal, mpq_class(-offset)});
}

}  // namespace

OracleAnswer cdd_oracle(std::span<const Point> a, std::span<const Point> b) {
  static const bool initialised = (dd_set_global_constants(), true);
  static_cast<void>(initialised);
  const IntegerBodies bodies = integer_bodies(a, b);
  const Matrix points = generators(bodies);
  dd_ErrorType error = dd_NoError;
  const Polyhedra polyhedra(dd_DDMatrix2Poly(points.get(), &error));
  if (error != dd_NoError) throw std::runtime_error("cddlib failed with error " + std::to_string(error));
  const Matrix facets(dd_CopyInequalities(polyhedra.get()));
  std::vector<HalfSpace> half_spaces;
  for (dd_rowrange row = 0; row < facets->rowsize; ++row)
    add_half_space(half_spaces, facets->matrix[row], set_member(row + 1, facets->linset), bodies.denominator);
  return nearest_half_spaces(half_spaces);
}

}  // namespace fathom::oracles
