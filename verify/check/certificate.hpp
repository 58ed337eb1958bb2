// SPDX-License-Identifier: Apache-2.0
// A certificate as it was read: nothing in it is believed yet.                                              [FORMAT.md, sections 2 and 3]
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "integers.hpp"

namespace fathom_check {

struct Vector {
  Integer x, y, z;
};

/// In lowest terms.
struct Rational {
  Integer num;
  Integer den = Integer::one();  ///< positive
};

struct RationalPoint {
  Rational x, y, z;
};

enum class Claim { depth, bounds, touching, disjoint };

/// Indices as read; one too large for any list has become `no_index`.
constexpr std::uint32_t no_index = UINT32_MAX;
struct Pair {
  std::uint32_t j, i;
};
struct Weight {
  std::uint32_t index;
  Rational weight;
};

/// Lists of corners, one after another.
struct Facets {
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> ends;  ///< of facet f among the corners: from ends[f - 1] to ends[f]

  [[nodiscard]] std::size_t size() const { return ends.size(); }
  [[nodiscard]] std::size_t begin_of(std::size_t f) const { return f == 0 ? 0 : ends[f - 1]; }
};

/// Items of a part, and the line of each.
template <class Items>
struct Part {
  Items items;
  std::vector<std::size_t> lines;
  std::size_t line = 0;  ///< that announces the part
};

struct Certificate {
  Arena integers;  ///< where all below lie
  std::string id;  ///< percent-escaped as written; empty if none
  Part<std::vector<RationalPoint>> a, b;
  Claim claim = Claim::depth;
  std::size_t claim_line = 0;
  Rational low, high;  ///< of depth^2; equal for a claim of depth
  bool all = false;
  Part<std::vector<Vector>> directions;
  Part<std::vector<Pair>> vertices;
  Part<Facets> facets;
  Part<std::vector<Weight>> weights_a, weights_b;
  mpz_class scale = 1;  ///< the least common multiple of the denominators of all coordinates
};

}  // namespace fathom_check
