// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes about the pieces of a body, about halves of them, about halves of those and so on.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "kernels/vector.hpp"
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

// Directions that keep a point apart from the P_ij of many pairs of pieces at once, by images: what
// they say is certain.                      [proofs/unions.md, "Pairs on demand" and "Blocks"]

/// All pairs of a piece of A and a piece of B. Their support function h(u) is the largest h_ij(u).
struct PairBlock {
  std::span<const PlacedPiece> a, b;
};

/// A bound on the error of a margin of boxes, for a point with this image, in any rounding mode.
double margin_error(const Vec3<double>& at);

/// Whether <u, p> - h(u) >= d |u|, for the image `at` of p and that of a direction, which may be
/// off by a rounding in each component. `d`: in units of 2^exponent, an upper bound, within 2^-37
/// of itself from 2^-400 on. Returns nullopt where images leave it open.
std::optional<bool> keeps_apart(const PairBlock& block, const Vec3<double>& at, double d, const Vec3<double>& u);

/// Whether a direction u is found for which keeps_apart is true. `u` is the direction to begin
/// with, or O, and in the end the last that was tried: reflected in the way to the farthest point
/// until it points away from it.
bool surely_apart(const PairBlock& block, const Vec3<double>& at, double d, Vec3<double>& u);

// Input   the pieces of two unions, and points.
// Output  the pairs of pieces, those first in which a point may lie deepest, by boxes; and P_ij of
//         a pair, made when a point that may lie in it is asked about for the first time.
//         [proofs/unions.md, "Pairs on demand"]

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
