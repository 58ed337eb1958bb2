// SPDX-License-Identifier: GPL-3.0-or-later
// Grids of prepared cases, with the exact order of all their distances.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "reference/lines/closest_lines.hpp"
#include "reference/lines/grid.hpp"
#include "tests/support/prepared.hpp"

namespace fathom::testing {

/// The case in general position: both bodies turned about O by the same exact rotation.
inline Case turned(const Case& input) {
  families::Bodies bodies = families::rotated({input.a, input.b}, families::rotation(7, 2, -3, 4));
  return {input.id, std::move(bodies.a), std::move(bodies.b)};
}

/// The canonical pairs of a case, and the lines, of both hemispheres. Scenes refer to the lines.
struct PreparedGrids {
  std::unique_ptr<Prepared> prepared;
  lines::EdgeLinesOfA a;
  lines::EdgeLinesOfB b;
  std::vector<canonical::CanonicalSubsets> subsets;
  std::vector<lines::LineScene> scenes;

  explicit PreparedGrids(const Case& input, const kernels::Perturbation& perturbation = {})
      : prepared(prepare(input, perturbation)), a(prepared->a, prepared->exponent), b(prepared->b, prepared->exponent) {
    for (const chart::Charts& charts : prepared->charts) {
      subsets.push_back(canonical::canonical_subsets(prepared->context, charts));
      scenes.emplace_back(charts, a, b);
    }
  }
  PreparedGrids(const PreparedGrids&) = delete;
  PreparedGrids& operator=(const PreparedGrids&) = delete;

  /// f(grid) for each.
  template <class F>
  void for_each(F f) const {
    for (std::size_t h = 0; h < subsets.size(); ++h) {
      for (std::size_t i = 0; i < subsets[h].size(); ++i) f(lines::Grid(subsets[h][i], scenes[h]));
    }
  }
};

/// The exact squared distances of all pairs of a grid; none for parallel lines.
class GridDistances {
 public:
  explicit GridDistances(const lines::Grid& grid) : columns_(grid.columns()) {
    for (std::size_t i = 0; i < grid.rows(); ++i) {
      for (std::size_t j = 0; j < grid.columns(); ++j) {
        const Vector w = cross(grid.row_direction(i), grid.column_direction(j));
        if (is_zero(w)) {
          squared_.emplace_back();
          continue;
        }
        const mpz_class height = dot(grid.column_point(j) - grid.row_point(i), w);
        mpq_class squared(mpz_class(height * height), dot(w, w));
        squared.canonicalize();
        squared_.emplace_back(squared);
      }
    }
    rank();
  }

  [[nodiscard]] const std::optional<mpq_class>& squared(std::size_t i, std::size_t j) const {
    return squared_[i * columns_ + j];
  }
  /// Place among all distances, equal for equal ones; the greatest for parallel lines.
  [[nodiscard]] std::uint32_t rank(std::size_t i, std::size_t j) const { return ranks_[i * columns_ + j]; }
  /// The rank that a squared distance would have.
  [[nodiscard]] std::uint32_t rank_above(const mpq_class& squared) const {
    return static_cast<std::uint32_t>(std::ranges::upper_bound(sorted_, squared) - sorted_.begin());
  }
  [[nodiscard]] const mpq_class& least() const { return sorted_.front(); }
  [[nodiscard]] bool empty() const { return sorted_.empty(); }

 private:
  void rank() {
    for (const std::optional<mpq_class>& s : squared_) {
      if (s) sorted_.push_back(*s);
    }
    std::ranges::sort(sorted_);
    for (const std::optional<mpq_class>& s : squared_) {
      const auto place =
          s ? std::ranges::lower_bound(sorted_, *s) - sorted_.begin() : static_cast<std::ptrdiff_t>(squared_.size());
      ranks_.push_back(static_cast<std::uint32_t>(place));
    }
  }

  std::size_t columns_;
  std::vector<std::optional<mpq_class>> squared_;
  std::vector<mpq_class> sorted_;
  std::vector<std::uint32_t> ranks_;
};

/// A plane whose squared distance is just above, or at, a value: what a search may hold as its
/// best.
inline kernels::NearestPlanes plane_at(const mpq_class& squared) {
  // The distance's root to 200 bits, rounded up.
  const mpz_class scale = mpz_class(1) << 200;
  mpz_class square = squared.get_num() * scale * scale / squared.get_den();
  mpz_class root = sqrt(square);
  while (mpq_class(root * root, scale * scale) < squared) ++root;
  kernels::NearestPlanes nearest;
  nearest.offer({scale, 0, 0}, root);
  return nearest;
}

inline mpq_class squared_distance(const kernels::NearestPlanes& nearest) {
  mpq_class squared(nearest.numerator(), nearest.denominator());
  squared.canonicalize();
  return squared;
}

inline void expect_equal(const kernels::NearestPlanes& left, const kernels::NearestPlanes& right,
                         const std::string& where) {
  ASSERT_EQ(left.empty(), right.empty()) << where;
  if (left.empty()) return;
  EXPECT_EQ(squared_distance(left), squared_distance(right)) << where;
  EXPECT_EQ(left.directions(), right.directions()) << where;
}

}  // namespace fathom::testing
