// SPDX-License-Identifier: GPL-3.0-or-later
// Looking up equal points by hashing, for hulls and validate.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <unordered_set>

#include "kernels/vector.hpp"

namespace fathom::polytope {

/// A hash of all limbs: in a scaled integer the lowest ones are often zero.
inline std::size_t hash_value(const mpz_class& n) {
  const char* limbs = reinterpret_cast<const char*>(mpz_limbs_read(n.get_mpz_t()));
  const std::size_t hash = std::hash<std::string_view>{}({limbs, mpz_size(n.get_mpz_t()) * sizeof(mp_limb_t)});
  return sgn(n) < 0 ? ~hash : hash;
}

inline std::size_t hash_value(const Vector& v) {
  constexpr std::size_t odd = 0x9e3779b97f4a7c15;
  return (hash_value(v.x) * odd + hash_value(v.y)) * odd + hash_value(v.z);
}

struct HashOfPoint {
  std::span<const Vector> points;
  std::size_t operator()(std::uint32_t i) const { return hash_value(points[i]); }
};

struct SamePoint {
  std::span<const Vector> points;
  bool operator()(std::uint32_t i, std::uint32_t j) const { return points[i] == points[j]; }
};

/// Indices of points, no two of equal points.
using DistinctPoints = std::unordered_set<std::uint32_t, HashOfPoint, SamePoint>;

inline DistinctPoints no_points_yet(std::span<const Vector> points, std::size_t expected) {
  return DistinctPoints(expected, HashOfPoint{points}, SamePoint{points});
}

}  // namespace fathom::polytope
