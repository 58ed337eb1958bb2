// SPDX-License-Identifier: Apache-2.0
#include "combine.hpp"

#include <algorithm>
#include <array>

namespace fathom_check {
namespace {

using Row = std::array<mpz_class, most_constraints>;
using Matrix = std::array<Row, most_constraints>;
using Indices = std::array<std::size_t, most_constraints>;

Indices without(const Indices& indices, std::size_t place) {
  Indices result = indices;
  std::copy(indices.begin() + place + 1, indices.end(), result.begin() + place);
  return result;
}

/// Of the first `size` of these rows and columns, by the first row.
mpz_class determinant(const Matrix& m, const Indices& rows, const Indices& columns, std::size_t size) {
  if (size == 0) return 1;
  if (size == 1) return m[rows[0]][columns[0]];
  mpz_class result = 0;
  const Indices below = without(rows, 0);
  for (std::size_t k = 0; k < size; ++k) {
    const mpz_class term = m[rows[0]][columns[k]] * determinant(m, below, without(columns, k), size - 1);
    k % 2 == 0 ? result += term : result -= term;
  }
  return result;
}

Matrix products(const std::vector<Constraint>& constraints) {
  Matrix result;
  for (std::size_t i = 0; i < constraints.size(); ++i)
    for (std::size_t k = 0; k <= i; ++k) {
      dot(result[i][k], constraints[i].n, constraints[k].n);
      result[k][i] = result[i][k];
    }
  return result;
}

/// Row `i` of the adjugate of a symmetric matrix, which is its column too.
Row adjugate_row(const Matrix& m, std::size_t size, std::size_t i) {
  Row result;
  const Indices all{0, 1, 2, 3};
  for (std::size_t k = 0; k < size; ++k) {
    result[k] = determinant(m, without(all, i), without(all, k), size - 1);
    if ((i + k) % 2 == 1) result[k] = -result[k];
  }
  return result;
}

bool is_zero(const Row& row) {
  return std::all_of(row.begin(), row.end(), [](const mpz_class& x) { return x == 0; });
}

mpz_class level(const std::vector<Constraint>& constraints, const Row& multipliers) {
  mpz_class result = 0;
  for (std::size_t i = 0; i < constraints.size(); ++i) result += multipliers[i] * constraints[i].c;
  return result;
}

/// The column of the adjugate for four normals, less a positive factor. As G = N N^T for the matrix
/// N of the normals, whose rank is at most three, entry (i, k) of its adjugate is (-1)^(i+k) d_i
/// d_k, with the determinant d_i of the three normals besides i (Cauchy and Binet).
std::optional<Row> dependency(const std::vector<Constraint>& four) {
  MutableVector first, second;
  cross(first, four[0].n, four[1].n);
  cross(second, four[2].n, four[3].n);
  Row row;
  dot(row[0], four[1].n, second);
  dot(row[1], four[0].n, second);
  dot(row[2], first, four[3].n);
  dot(row[3], first, four[2].n);
  row[1] = -row[1];
  row[3] = -row[3];
  const auto known = std::find_if(row.begin(), row.end(), [](const mpz_class& x) { return x != 0; });
  if (known == row.end()) return std::nullopt;
  if (*known < 0)
    for (mpz_class& x : row) x = -x;
  return row;
}

/// By the adjugate of the Gram matrix.
std::optional<Row> multipliers(const std::vector<Constraint>& constraints) {
  const std::size_t size = constraints.size();
  if (size == most_constraints) return dependency(constraints);
  const Matrix gram = products(constraints);
  Row row = adjugate_row(gram, size, 0);
  mpz_class determinant = 0;
  for (std::size_t k = 0; k < size; ++k) determinant += gram[0][k] * row[k];
  if (determinant == 0) {
    for (std::size_t i = 1; is_zero(row) && i < size; ++i) row = adjugate_row(gram, size, i);
    return is_zero(row) ? std::nullopt : std::optional(row);
  }
  Row result;
  result[0] = level(constraints, row);
  for (std::size_t i = 1; i < size; ++i) result[i] = level(constraints, adjugate_row(gram, size, i));
  return result;
}

}  // namespace

std::optional<Constraint> combined(const std::vector<Constraint>& constraints) {
  const std::size_t size = constraints.size();
  if (size == 0 || size > most_constraints) return std::nullopt;
  const std::optional<Row> l = multipliers(constraints);
  if (!l || std::any_of(l->begin(), l->end(), [](const mpz_class& x) { return x < 0; })) return std::nullopt;
  Constraint result{{}, level(constraints, *l)};
  if (size == most_constraints) return result;  // the normals add up to O
  for (std::size_t i = 0; i < size; ++i) {
    result.n.x += (*l)[i] * constraints[i].n.x;
    result.n.y += (*l)[i] * constraints[i].n.y;
    result.n.z += (*l)[i] * constraints[i].n.z;
  }
  return result;
}

}  // namespace fathom_check
