// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies on a narrow lattice: one whose coordinates have so few bits that all of an expanding polytope's integers fit a fixed size.
// Whatever programs compute with (binary32, binary64 of similar sizes) lies on one.       [proofs/expanding.md, "Fixed integers"]
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fathom/point.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/number/fixed_integer.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/positions.hpp"

namespace fathom::polytope {

/// |c| <= 2^exponent for coordinates, with at most this exponent.
inline constexpr long most_narrow_bits = 305;
/// A coordinate of a point on a narrow lattice.
using NarrowCoordinate = kernels::FixedInteger<320>;
/// Holds all that is computed from them: at most 10 * 305 + 20 bits.
using NarrowInteger = kernels::FixedInteger<3072>;

/// A coordinate fits a word if |c| < 2^most_word_bits, and then a difference does too.
inline constexpr long most_word_bits = 62;

/// One body's points on a narrow lattice, with their images.
struct NarrowCloud {
  std::vector<Vec3<std::int64_t>> words;       ///< the points, if all coordinates of both clouds fit words
  std::vector<Vec3<NarrowCoordinate>> points;  ///< else
  std::vector<double> x, y, z;

  [[nodiscard]] kernels::Images images() const { return {x, y, z}; }
};

/// A point p of either cloud stands for origin + p / 2^shift, where the origin is the first point of B: the same lattice as that of
/// `place`.
struct NarrowPair {
  unsigned shift = 0;
  long exponent = 0;  ///< the least with |c| <= 2^exponent for every coordinate c of both clouds
  NarrowCloud a, b;
  std::vector<kernels::Dyadic> numbers;  ///< the coordinates that place_narrow was given, taken apart
};

/// The exact positions. Throws std::invalid_argument if a coordinate is no finite number.
std::vector<Point> exact_points(std::span<const std::array<double, 3>> body);
Point exact_point(const std::array<double, 3>& p);

/// Places both bodies if all coordinates are dyadic and their lattice is narrow: no rationals, and no allocation if `pair` has had room for
/// as many points before. Returns false otherwise, also for what `place` throws at: empty bodies, numbers not in lowest terms.
bool place_narrow(kernels::Positions a, kernels::Positions b, NarrowPair& pair);
/// The same for coordinates in binary64. Throws std::invalid_argument if one is no finite number.
bool place_narrow(std::span<const std::array<double, 3>> a, std::span<const std::array<double, 3>> b, NarrowPair& pair);

}  // namespace fathom::polytope
