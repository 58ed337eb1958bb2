// SPDX-License-Identifier: GPL-3.0-or-later
// An endless stream of cases of all families, each given by the stream's seed and its number alone: any part can be made again.
#pragma once

#include <cstdint>

#include "fathom/files.hpp"

namespace fathom::harness {

inline constexpr unsigned least_random_size = 4, most_random_size = 40;

/// Returns case `number` of the stream: the families take turns, size and seed are random. About two in three have their points rounded,
/// to binary64 or to binary32, unless a coordinate overflows that; ".b64" or ".b32" behind the id says so. The same on every machine.
Case random_case(std::uint64_t seed, std::uint64_t number);

inline constexpr unsigned most_random_pieces = 5;

/// The same of unions of convex pieces: sizes are from 1 to most_random_pieces.
Case random_unions(std::uint64_t seed, std::uint64_t number);

}  // namespace fathom::harness
