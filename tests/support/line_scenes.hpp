// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that a floating-point filter finds hard, and their exact distances.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "kernels/filters/line_filter.hpp"
#include "tests/support/rounding_modes.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::testing {

using Random = std::mt19937_64;

inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double least_normal = std::numeric_limits<double>::min();

struct Line {
  Vector point, direction;
};

struct Scene {
  long exponent;
  std::vector<Line> lines;
};

inline long below(Random& random, long n) { return static_cast<long>(random() % static_cast<std::uint64_t>(n)); }

/// Squared distance as a quotient; the denominator is zero for parallel lines.
struct Squared {
  mpz_class numerator, denominator;
};

inline Squared squared_distance(const Line& l, const Line& m) {
  const Vector w = cross(l.direction, m.direction);
  const mpz_class height = dot(l.point - m.point, w);
  return {height * height, dot(w, w)};
}

/// value * 4^exponent.
inline mpq_class times_power_of_four(mpq_class value, long exponent) {
  if (exponent < 0) return mpq_class(value >> static_cast<mp_bitcnt_t>(-2 * exponent));
  return mpq_class(value << static_cast<mp_bitcnt_t>(2 * exponent));
}

inline bool strictly_farther(const Line& l, const Line& m, double bound, long exponent) {
  if (bound == infinite) return false;
  const Squared s = squared_distance(l, m);
  return s.denominator != 0 && s.numerator > times_power_of_four(mpq_class(bound), exponent) * s.denominator;
}

inline kernels::LineImages images(const Scene& scene) {
  kernels::LineImages result(scene.exponent);
  for (const Line& l : scene.lines) result.push_back(l.point, l.direction);
  return result;
}

inline kernels::WideLines wide_lines(const Scene& scene) {
  return {scene.lines.size(), [scene](std::size_t i) {
            return kernels::wide_line(scene.lines[i].point, scene.lines[i].direction, scene.exponent);
          }};
}

/// The scene turned about O, along no axis, and 78 times as large.
inline Scene turned(const Scene& scene) {
  const Vector x{-20, -68, -26}, y{44, -26, -52}, z{58, 4, 52};
  const auto turn = [&](const Vector& v) { return Vector{dot(x, v), dot(y, v), dot(z, v)}; };
  Scene result{scene.exponent + 8, {}};
  for (const Line& l : scene.lines) result.lines.push_back({turn(l.point), turn(l.direction)});
  return result;
}

inline std::vector<std::uint32_t> all_indices(std::size_t n) {
  std::vector<std::uint32_t> all(n);
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

inline std::vector<std::uint32_t> left_out(std::size_t n, const std::vector<std::uint32_t>& unsure) {
  const std::vector<std::uint32_t> all = all_indices(n);
  std::vector<std::uint32_t> result;
  std::set_difference(all.begin(), all.end(), unsure.begin(), unsure.end(), std::back_inserter(result));
  EXPECT_EQ(result.size() + unsure.size(), n) << "indices ascending, each once";
  return result;
}

inline std::size_t bits(const Vector& v) {
  const auto of = [](const mpz_class& c) { return c == 0 ? 0 : mpz_sizeinbase(c.get_mpz_t(), 2); };
  return std::max({of(v.x), of(v.y), of(v.z)});
}

inline Scene scene(std::vector<Line> lines, long more = 0) {
  std::size_t most = 0;
  for (const Line& l : lines) most = std::max(most, bits(l.point));
  return {static_cast<long>(most) + more, std::move(lines)};
}

inline Scene random_lines(Random& random, unsigned long size, int n, long more = 0) {
  std::vector<Line> lines;
  for (int i = 0; i < n; ++i) lines.push_back({random_vector(random, size), random_direction(random, size)});
  return scene(std::move(lines), more);
}

/// Directions that differ by a few units, on both sides of parallel, from points far apart or close
/// together.
inline Scene nearly_parallel_lines(Random& random, unsigned long size, int n) {
  const Vector d = random_direction(random, size), p = random_vector(random, size);
  std::vector<Line> lines;
  for (int i = 0; i < n; ++i) {
    const auto digits = static_cast<unsigned long>(below(random, static_cast<long>(size)) + 1);
    const Vector step = random_vector(random, below(random, 2) ? 2 : digits);
    const Vector e = random_integer(random, 20) * d + step;
    const Vector q = below(random, 2) ? random_vector(random, size) : p + random_vector(random, digits);
    if (!is_zero(e)) lines.push_back({q, e});
  }
  return scene(std::move(lines));
}

/// Lines that pass one point at small distances.
inline Scene nearly_meeting_lines(Random& random, unsigned long size, int n) {
  const Vector p = random_vector(random, size);
  std::vector<Line> lines;
  for (int i = 0; i < n; ++i) {
    const Vector d = random_direction(random, 30);
    const auto digits = static_cast<unsigned long>(below(random, static_cast<long>(size)) + 1);
    lines.push_back({p + random_integer(random, size - 32) * d + random_vector(random, digits), d});
  }
  return scene(std::move(lines));
}

/// Lines along the diagonals of a cube, nearly, that nearly meet in O, with points near the
/// corners: large products that cancel.
inline Scene nearly_diagonal_lines(Random& random, unsigned long size, int n) {
  const auto component = [&] {
    const mpz_class c = power_of_two(size) - abs(random_integer(random, size - 5)) - 1;
    return random() & 1 ? c : mpz_class(-c);
  };
  std::vector<Line> lines;
  for (int i = 0; i < n; ++i) {
    const Vector d{component(), component(), component()};
    const auto digits = static_cast<unsigned long>(below(random, static_cast<long>(size)) / 2 + 1);
    // Not a power of two: or else the images of point and direction would err alike, and their
    // errors cancel too.
    const mpz_class along = random() & 1 ? 125 + below(random, 3) : -125 - below(random, 3);
    lines.push_back({along * d + random_vector(random, digits), d});
  }
  return scene(std::move(lines));
}

/// Components and lines of every size.
inline Scene wild_lines(Random& random, int n, long more) {
  const auto any = [&] { return random_integer(random, static_cast<unsigned long>(below(random, 1400) + 1)); };
  std::vector<Line> lines;
  for (int i = 0; i < n; ++i) lines.push_back({{any(), any(), any()}, {any() + 1, any(), any()}});
  return scene(std::move(lines), more);
}

/// Small integers: exact ties, parallel and meeting lines.
inline Scene lattice_lines(Random& random, int n) {
  std::vector<Line> lines;
  for (int i = 0; i < n; ++i) lines.push_back({random_vector(random, 2), random_direction(random, 2)});
  return scene(std::move(lines), below(random, 3));
}

inline std::vector<Scene> adversarial_scenes(Random& random, int n) {
  std::vector<Scene> scenes{
      random_lines(random, 20, n),      random_lines(random, 53, n),         random_lines(random, 60, n),
      random_lines(random, 1000, n),    random_lines(random, 40, n, 25),     random_lines(random, 60, n, 500),
      random_lines(random, 60, n, 540), random_lines(random, 30, n, 1060),   random_lines(random, 30, n, 5000),
      wild_lines(random, n, 0),         wild_lines(random, n, 300),          nearly_parallel_lines(random, 50, n),
      lattice_lines(random, n),         nearly_parallel_lines(random, 90, n)};
  for (const unsigned long size : {40, 54, 60, 70, 200, 1200}) scenes.push_back(nearly_meeting_lines(random, size, n));
  for (const unsigned long size : {54, 60, 600}) scenes.push_back(nearly_diagonal_lines(random, size, n));
  return scenes;
}

}  // namespace fathom::testing
