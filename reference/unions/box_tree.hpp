// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes about the pieces of a body, about halves of them, about halves of those and so on.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/unions/pieces.hpp"

namespace fathom::unions {

/// Lengths are those of images: in units of 2^exponent.
struct BoxTree {
  using Corner = std::array<double, 3>;
  static constexpr std::uint32_t none = UINT32_MAX;
  struct Node {
    Corner low, high;                         ///< of all its pieces; each within 2^-49 of its place
    Corner widest;                            ///< the largest extent of one piece
    std::uint32_t first = 0;                  ///< the least number of a piece
    std::uint32_t left = none, right = none;  ///< of a leaf, which has one piece, none

    [[nodiscard]] bool is_leaf() const { return left == none; }
    /// The largest extent of all together.
    [[nodiscard]] double size() const;
  };
  enum class Halves {
    of_space,   ///< cut at the median of the middles, where these spread most
    of_numbers  ///< the lower numbers, half of them or one less, and the others
  };

  /// One box for each piece, with its place in the list as its number. There is at least one.
  explicit BoxTree(const std::vector<PlacedPiece>& pieces, Halves halves = Halves::of_space);
  explicit BoxTree(std::vector<Node> leaves, Halves halves = Halves::of_space);

  /// The numbers of the pieces, so that those of each node are consecutive: in this order the two
  /// kinds of halves are the same.
  [[nodiscard]] std::vector<std::uint32_t> order() const;

  std::vector<Node> nodes;
  std::uint32_t root = 0;
};

}  // namespace fathom::unions
