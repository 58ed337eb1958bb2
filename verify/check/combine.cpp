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

/// Of a symmetric matrix.
Matrix adjugate(const Matrix& m, std::size_t size) {
  Matrix result;
  const Indices all{0, 1, 2, 3};
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = 0; k <= i; ++k) {
      result[i][k] = determinant(m, without(all, i), without(all, k), size - 1);
      if ((i + k) % 2 == 1) result[i][k] = -result[i][k];
      result[k][i] = result[i][k];
    }
  return result;
}

mpz_class level(const std::vector<Constraint>& constraints, const Row& multipliers) {
  mpz_class result = 0;
  for (std::size_t i = 0; i < constraints.size(); ++i) result += multipliers[i] * constraints[i].c;
  return result;
}

/// The first column that is not zero.
std::optional<Row> kernel(const Matrix& adjugate, std::size_t size) {
  for (std::size_t k = 0; k < size; ++k)
    if (std::any_of(adjugate[k].begin(), adjugate[k].end(), [](const mpz_class& x) { return x != 0; })) return adjugate[k];
  return std::nullopt;
}

}  // namespace

std::optional<Constraint> combined(const std::vector<Constraint>& constraints) {
  const std::size_t size = constraints.size();
  if (size == 0 || size > most_constraints) return std::nullopt;
  const Matrix gram = products(constraints), adjugate = fathom_check::adjugate(gram, size);
  mpz_class determinant = 0;
  for (std::size_t k = 0; k < size; ++k) determinant += gram[0][k] * adjugate[0][k];
  std::optional<Row> l;
  if (determinant == 0) {
    l = kernel(adjugate, size);
  } else {
    l.emplace();
    for (std::size_t i = 0; i < size; ++i) (*l)[i] = level(constraints, adjugate[i]);
  }
  if (!l || std::any_of(l->begin(), l->end(), [](const mpz_class& x) { return x < 0; })) return std::nullopt;
  Constraint result{{}, level(constraints, *l)};
  for (std::size_t i = 0; i < size; ++i) {
    result.n.x += (*l)[i] * constraints[i].n.x;
    result.n.y += (*l)[i] * constraints[i].n.y;
    result.n.z += (*l)[i] * constraints[i].n.z;
  }
  return result;
}

}  // namespace fathom_check
