// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the pieces of two unions, and points.
// Output  the pairs of pieces, those first in which a point may lie deepest, by boxes; and P_ij of
//         a pair, made when a point that may lie in it is asked about for the first time.
//         [proofs/unions.md, "Pairs on demand"]
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "reference/unions/box_tree.hpp"
#include "reference/unions/pieces.hpp"

namespace fathom::unions {

/// A pair of pieces, and an upper bound of how far inside of P_ij a point is: its distance from the
/// boundary, or minus its distance from P_ij. In units of 2^exponent.
struct RankedPair {
  double bound;
  std::uint32_t a, b;
};

/// All pairs for one point, those with the highest bounds first, of equal ones the first; as many
/// as are asked for.
class RankedPairs {
 public:
  /// `at` is the image of the point, the trees must outlive it. If `all`, then all pairs in their
  /// order, with infinite bounds.
  RankedPairs(const BoxTree& a, const BoxTree& b, const Vec3<double>& at, bool all);
  std::optional<RankedPair> next();

 private:
  struct Block {
    double bound;
    std::uint32_t first_a, first_b;  // of its pairs
    std::uint32_t node_a, node_b;
  };
  static bool comes_after(const Block& x, const Block& y);

  void push(std::uint32_t node_a, std::uint32_t node_b);
  [[nodiscard]] double bound(const BoxTree::Node& a, const BoxTree::Node& b) const;

  const BoxTree &a_, &b_;
  BoxTree::Corner at_;
  double error_;
  bool all_;
  std::vector<Block> heap_;
};

/// The pairs that were made. Memory grows with the pairs that were looked at.
template <class Numbers>
class PairTableIn {
 public:
  using Pair = PiecePairIn<Numbers>;
  using Place = kernels::RationalPointIn<Numbers>;

  /// `pieces` must outlive it. If `all`, no pair is told apart without being made: the naive twin.
  PairTableIn(const PlacedPieces& pieces, bool all);

  [[nodiscard]] RankedPairs ranked(const Place& p) const { return {tree_a_, tree_b_, p.image, all_}; }
  /// The pair; or null if p is certain to be neither in the interior of P_ij nor on its boundary.
  Pair* find(const RankedPair& ranked, const Place& p);
  /// Whether the pair was made.
  [[nodiscard]] bool has(const RankedPair& pair) const;
  /// How many pairs there are, and how many of them were made.
  [[nodiscard]] std::uint64_t size() const { return pieces_.a.size() * pieces_.b.size(); }
  [[nodiscard]] std::uint64_t made() const { return made_; }

 private:
  struct Entry {
    std::unique_ptr<Pair> pair;
    Vec3<double> separating{};  // the last direction that told a point apart, or was tried to
  };

  const PlacedPieces& pieces_;
  BoxTree tree_a_, tree_b_;
  bool all_;
  std::uint64_t made_ = 0;
  std::unordered_map<std::uint64_t, Entry> entries_;
};

}  // namespace fathom::unions
