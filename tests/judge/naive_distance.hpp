// SPDX-License-Identifier: GPL-3.0-or-later
// The distance of a point from a hull, by trying every simplex: the nearest point lies inside one
// of at most four points, where it is the foot of the perpendicular.
#pragma once

#include <optional>
#include <vector>

#include "kernels/vector.hpp"

namespace fathom::testing {

/// Solves the rows (matrix | right side) of a positive definite system; returns nullopt if it is
/// singular.
inline std::optional<std::vector<mpq_class>> solved(std::vector<std::vector<mpq_class>> rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i][i] == 0) return std::nullopt;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (k == i) continue;
      const mpq_class factor = rows[k][i] / rows[i][i];
      for (std::size_t j = 0; j < rows[k].size(); ++j) rows[k][j] -= factor * rows[i][j];
    }
  }
  std::vector<mpq_class> solution;
  for (std::size_t i = 0; i < rows.size(); ++i) solution.emplace_back(rows[i].back() / rows[i][i]);
  return solution;
}

/// The squared distance of p from the simplex if the foot of the perpendicular is in it.
inline std::optional<mpq_class> squared_distance_of_foot(const Point& p, const std::vector<Point>& simplex) {
  std::vector<std::vector<mpq_class>> rows;
  Point rest = p - simplex[0];
  for (std::size_t i = 1; i < simplex.size(); ++i) {
    const Point edge = simplex[i] - simplex[0];
    rows.emplace_back();
    for (std::size_t j = 1; j < simplex.size(); ++j) rows.back().push_back(dot(edge, simplex[j] - simplex[0]));
    rows.back().push_back(dot(edge, rest));
  }
  const auto weights = solved(rows);
  if (!weights) return std::nullopt;
  mpq_class first = 1;
  for (std::size_t i = 0; i < weights->size(); ++i) {
    const mpq_class& w = (*weights)[i];
    if (w < 0) return std::nullopt;
    first -= w;
    const Point edge = simplex[i + 1] - simplex[0];
    rest = rest - w * edge;
  }
  if (first < 0) return std::nullopt;
  return dot(rest, rest);
}

/// `simplex` and up to four points in all, the others from `body` at `next` or later.
inline void try_simplices(const Point& p, const std::vector<Point>& body, std::vector<Point>& simplex, std::size_t next,
                          std::optional<mpq_class>& least) {
  if (!simplex.empty()) {
    const auto squared = squared_distance_of_foot(p, simplex);
    if (squared && (!least || *squared < *least)) least = squared;
  }
  if (simplex.size() == 4) return;
  for (std::size_t i = next; i < body.size(); ++i) {
    simplex.push_back(body[i]);
    try_simplices(p, body, simplex, i + 1, least);
    simplex.pop_back();
  }
}

inline mpq_class squared_distance_naive(const Point& p, const std::vector<Point>& body) {
  std::optional<mpq_class> least;
  std::vector<Point> simplex;
  try_simplices(p, body, simplex, 0, least);
  return *least;
}

}  // namespace fathom::testing
