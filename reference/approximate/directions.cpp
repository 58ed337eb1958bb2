// SPDX-License-Identifier: GPL-3.0-or-later
// A face of the cube is cut into side x side cells along the values g(t) of evenly spaced t in [-1,
// 1], with g(t) = (4 t + t^3) / 5: close enough to tan(pi t / 4) that the cells look about equally
// large from O, and a third fewer are needed than with g(t) = t.

#include "reference/approximate/directions.hpp"

#include <stdexcept>

namespace fathom::approximate {
namespace {

/// Where a cell lies: on the positive or the negative side of an axis, in a row and a column.
struct Place {
  int axis;
  bool negative;
  std::int64_t row, column;
};

Place place(std::uint64_t cell, std::uint64_t side) {
  const std::uint64_t face = cell / (side * side), rest = cell % (side * side);
  return {static_cast<int>(face % 3), face >= 3, static_cast<std::int64_t>(rest / side),
          static_cast<std::int64_t>(rest % side)};
}

/// 5 side^3 g(i / side).
mpz_class bent(std::int64_t i, std::uint64_t side) {
  const mpz_class t = static_cast<long>(i), n = static_cast<unsigned long>(side);
  return t * (4 * n * n + t * t);
}

/// The point of the face at i / side and j / side, which run from -1 to 1.
Vector on_face(const Place& p, std::int64_t i, std::int64_t j, std::uint64_t side) {
  const mpz_class n = static_cast<unsigned long>(side);
  const mpz_class height = (p.negative ? -5 : 5) * n * n * n, y = bent(i, side), z = bent(j, side);
  const Vector v = p.axis == 0 ? Vector{height, y, z} : p.axis == 1 ? Vector{z, height, y} : Vector{y, z, height};
  return primitive(v);
}

/// Cells are carried into each other by the symmetries of the cube; one of each orbit is looked at:
/// on the face of positive x, in one eighth of it. The cone of directions that a centre covers is
/// convex, so that its four corners speak for a cell.
bool all_covered(kernels::Context& context, std::uint64_t side, const mpq_class& delta) {
  const Place face{0, false, 0, 0};
  const auto n = static_cast<std::int64_t>(side);
  for (std::int64_t i = n % 2 == 0 ? 1 : 0; i < n; i += 2) {
    context.check();
    for (std::int64_t j = n % 2 == 0 ? 1 : 0; j <= i; j += 2) {
      const Vector centre = on_face(face, i, j, side);
      for (const int di : {-1, 1}) {
        for (const int dj : {-1, 1}) {
          if (!covers(centre, on_face(face, i + di, j + dj, side), delta)) return false;
        }
      }
    }
  }
  return true;
}

}  // namespace

bool covers(const Vector& p, const Vector& v, const mpq_class& delta) {
  const mpz_class along = dot(v, p);
  if (along <= 0) return false;
  const mpz_class numerator = (delta.get_num() + delta.get_den()) * along;
  const mpz_class& denominator = delta.get_den();
  return numerator * numerator >= denominator * denominator * dot(v, v) * dot(p, p);
}

// The search begins where 4/3 / side^2 is just above 2 delta + delta^2, which is a cell or two from
// its end.
DirectionGrid::DirectionGrid(kernels::Context& context, const mpq_class& delta) : side_(1) {
  if (delta < least_delta) throw std::invalid_argument("a grid of directions needs a positive delta, 1e-9 or more");
  const mpq_class squared_tangent = delta * (2 + delta);
  const mpz_class square = mpz_class(4 * squared_tangent.get_den()) / mpz_class(3 * squared_tangent.get_num()),
                  begin = sqrt(square);
  if (begin > 1) side_ = begin.get_ui();  // less than 2^20
  while (!all_covered(context, side_, delta)) ++side_;
}

Vector DirectionGrid::centre(std::uint64_t cell) const {
  const Place p = place(cell, side_);
  const auto n = static_cast<std::int64_t>(side_);
  return on_face(p, 2 * p.row + 1 - n, 2 * p.column + 1 - n, side_);
}

std::array<Vector, 4> DirectionGrid::corners(std::uint64_t cell) const {
  const Place p = place(cell, side_);
  const auto n = static_cast<std::int64_t>(side_);
  const std::int64_t i = 2 * p.row - n, j = 2 * p.column - n;
  return {on_face(p, i, j, side_), on_face(p, i + 2, j, side_), on_face(p, i + 2, j + 2, side_),
          on_face(p, i, j + 2, side_)};
}

}  // namespace fathom::approximate
