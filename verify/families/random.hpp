// SPDX-License-Identifier: GPL-3.0-or-later
// Reproducible randomness. Nothing from <random>: its distributions differ between libraries.
#pragma once

#include <gmpxx.h>

#include <cstdint>

#include "kernels/number/rational.hpp"

namespace fathom::families {

/// splitmix64 (Steele, Lea, Flood 2014). The same numbers on every machine and with every compiler.
/// Two calls in one argument list run in an unspecified order: name their results, or use braces.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// Uniform in [low, high], without bias.
  std::int64_t between(std::int64_t low, std::int64_t high) {
    const std::uint64_t range = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
    if (range == 0) return static_cast<std::int64_t>(next());
    const std::uint64_t rejected = (0 - range) % range;  // 2^64 mod range
    std::uint64_t draw = next();
    while (draw < rejected) draw = next();
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + draw % range);
  }

  bool coin() { return next() >> 63; }

 private:
  std::uint64_t state_;
};

using kernels::ratio;
using kernels::times_power_of_two;

/// A multiple of 2^-bits, uniform in [low, high].
inline mpq_class random_dyadic(Random& random, std::int64_t low, std::int64_t high, unsigned bits) {
  return times_power_of_two(
      mpq_class(random.between(low * (std::int64_t{1} << bits), high * (std::int64_t{1} << bits))),
      -static_cast<long>(bits));
}

/// A member of a list that is not empty, each with the same probability.
template <class List>
const auto& any_of(const List& list, Random& random) {
  return list[static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(list.size()) - 1))];
}

}  // namespace fathom::families
