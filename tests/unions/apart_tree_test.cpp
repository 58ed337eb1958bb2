// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of pairs that are apart: by their definition, against the naive twin that asks each pair;
// and how few they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "kernels/number/rational.hpp"
#include "reference/unions/pair_table.hpp"
#include "reference/unions/union_prover.hpp"
#include "tests/unions/pieces.hpp"

namespace fathom::unions {
namespace {

/// What blocks say, by the definition, in rationals and over all corners.
class BlocksCheck {
 public:
  /// `squared` is that of the distance, or 0: then all pairs keep t free.
  BlocksCheck(const Pieces& a, const Pieces& b, const Point& t, const mpq_class& squared)
      : a_(a), b_(b), t_(t), squared_(squared) {}

  std::string run(const std::vector<ApartBlock>& blocks) {
    next_ = 0;
    pairs_.clear();
    check(blocks, 0, a_.size(), 0, b_.size());
    expect(next_ == blocks.size(), "blocks are left over");
    expect(pairs_.size() == a_.size() * b_.size(), "a pair is in no block");
    return fault_;
  }

 private:
  void expect(bool holds, const char* law) {
    if (!holds && fault_.empty()) fault_ = law;
  }

  void check(const std::vector<ApartBlock>& blocks, std::size_t low_a, std::size_t high_a, std::size_t low_b,
             std::size_t high_b) {
    if (next_ >= blocks.size()) return expect(false, "blocks are missing");
    const ApartBlock& block = blocks[next_++];
    if (block.kind == ApartBlock::Kind::apart) {
      expect(keeps_apart(block.direction, low_a, high_a, low_b, high_b), "a direction does not show its block");
      for (std::size_t i = low_a; i < high_a; ++i)
        for (std::size_t j = low_b; j < high_b; ++j) expect(pairs_.emplace(i, j).second, "a pair is in two blocks");
      return;
    }
    const bool of_a = block.kind == ApartBlock::Kind::halves_of_a;
    const std::size_t low = of_a ? low_a : low_b, high = of_a ? high_a : high_b, middle = (low + high) / 2;
    if (high - low < 2) return expect(false, "one piece is halved");
    check(blocks, low_a, of_a ? middle : high_a, low_b, of_a ? high_b : middle);
    check(blocks, of_a ? middle : low_a, high_a, of_a ? low_b : middle, high_b);
  }

  [[nodiscard]] bool keeps_apart(const Vector& u, std::size_t low_a, std::size_t high_a, std::size_t low_b,
                                 std::size_t high_b) const {
    const Point n = rational(u);
    std::optional<mpq_class> h;
    for (std::size_t i = low_a; i < high_a; ++i)
      for (std::size_t j = low_b; j < high_b; ++j)
        for (const Point& p : a_[i])
          for (const Point& q : b_[j])
            if (const mpq_class height = dot(n, q - p); !h || height > *h) h = height;
    if (is_zero(u)) return false;
    if (squared_ == 0) return dot(n, t_) >= *h;
    return *h < 0 && *h * *h >= squared_ * dot(n, n);
  }

  const Pieces &a_, &b_;
  Point t_;
  mpq_class squared_;
  std::size_t next_ = 0;
  std::set<std::pair<std::size_t, std::size_t>> pairs_;
  std::string fault_;
};

std::vector<Vector> directions_of(const UnionOptimum& optimum) {
  std::vector<Vector> known;
  for (const PieceContact& contact : optimum.contacts) known.push_back(contact.direction);
  return known;
}

/// Checks the blocks of every optimum, or of the distance; returns how many there are, if there are
/// contacts to begin with.
std::size_t expect_blocks(const Pieces& a, const Pieces& b, Lattices lattices = Lattices::fitting) {
  const UnionDepth depth = union_depth(a, b);
  const PlacedPieces pieces = place_pieces(a, b, lattices);
  kernels::Context context;
  std::size_t count = 0;
  for (const UnionOptimum& o : depth.optima) {
    const std::vector<Vector> known = directions_of(o), none;
    for (const std::vector<Vector>* directions : {&none, &known}) {
      const std::vector<ApartBlock> blocks = apart_tree(context, pieces, pieces.point(o.translation), *directions);
      EXPECT_EQ(BlocksCheck(a, b, o.translation, 0).run(blocks), "");
      if (directions == &known) count += blocks.size();
      if (a.size() * b.size() == 1) continue;
      std::vector<ApartBlock> forged = blocks;
      forged.pop_back();
      EXPECT_NE(BlocksCheck(a, b, o.translation, 0).run(forged), "") << "a block is missing";
    }
    // The twin: a direction for each pair.
    const std::vector<Vector> all = separations(context, pieces, pieces.point(o.translation));
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Pieces one{a[k / b.size()]}, other{b[k % b.size()]};
      EXPECT_EQ(BlocksCheck(one, other, o.translation, 0).run({{ApartBlock::Kind::apart, all[k]}}), "");
    }
  }
  if (depth.apart) {
    const mpq_class& squared = depth.apart->distance.squared;
    const mpq_class more = squared + squared / (mpz_class(1) << 80);
    const std::vector<ApartBlock> blocks = distance_tree(context, pieces, squared, {});
    EXPECT_EQ(BlocksCheck(a, b, {}, squared).run(blocks), "");
    EXPECT_NE(BlocksCheck(a, b, {}, more).run(blocks), "") << "a larger distance";
    EXPECT_THROW(distance_tree(context, pieces, more, {}), std::logic_error) << "larger by a 2^-80th";
    count += blocks.size();
  }
  return count;
}

TEST(ApartTree, ShowsEachPairOnceWhateverThePieces) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    std::mt19937_64 random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Lattices lattices = seed % 2 == 0 ? Lattices::own : Lattices::fitting;
    expect_blocks(random_boxes(random, 1 + seed % 6, 6), random_boxes(random, 1 + seed % 5, 6), lattices);
    expect_blocks(random_pieces(random, 1 + seed % 4, 6, 60, 25), random_pieces(random, 1 + seed % 3, 6, 60, 25),
                  lattices);
    const Pieces a = random_pieces(random, 1 + seed % 7, 6, 9, 4);
    expect_blocks(a, moved(random_pieces(random, 1 + seed % 5, 6, 9, 4), {40, kernels::ratio(seed, 7), 3}), lattices);
  }
}

TEST(ApartTree, ShowsSeamsAndExactFits) {
  const Pieces cubes = grid({0, 0, 0}, {3, 3, 3}, 3);
  for (const Point& t : {Point{0, 0, 0}, Point{mpq_class(1, 2), mpq_class(1, 2), mpq_class(1, 2)}, Point{3, 0, 0},
                         Point{3, 3, 3}, Point{3, mpq_class(1, 3), 0}, Point{7, 0, 0}, Point{5, mpq_class(22, 7), 4}})
    expect_blocks(cubes, moved(cubes, t));
  expect_blocks(scaled(ring(12, false, 0), 10), scaled(ring(12, true, 26), 10));
  expect_blocks(ring(12, false, 0), ring(6, true, mpq_class(261, 10)));
}

TEST(ApartTree, RefusesAPointInside) {
  const Pieces cube = grid({0, 0, 0}, {2, 2, 2}, 2);
  const PlacedPieces pieces = place_pieces(cube, cube);
  kernels::Context context;
  EXPECT_THROW(apart_tree(context, pieces, {}, {}), std::logic_error);
  const Point almost{2 - kernels::ratio(1, mpz_class(1) << 200), 0, 0};
  EXPECT_THROW(apart_tree(context, pieces, pieces.point(almost), {}), std::logic_error);
  EXPECT_EQ(apart_tree(context, pieces, pieces.point({2, 0, 0}), {}).size(), 1U);
}

// In the order of space, whatever the order was before.
Pieces in_order(const Pieces& pieces) {
  Pieces result;
  for (const std::uint32_t i : BoxTree(place_pieces(pieces, pieces).a).order()) result.push_back(pieces[i]);
  return result;
}

TEST(ApartTree, HasFewBlocksForManyPairs) {
  const Pieces cubes = in_order(grid({0, 0, 0}, {10, 10, 10}, 10));
  const PlacedPieces pieces = place_pieces(cubes, cubes);
  kernels::Context context;
  EXPECT_EQ(apart_tree(context, pieces, pieces.point({10, 0, 0}), {}).size(), 1U) << "of a million pairs";
  Pieces dented = cubes;  // without what of it lies in a corner
  std::erase_if(dented, [](const std::vector<Point>& p) { return p[0].x >= 5 && p[0].y >= 5 && p[0].z >= 5; });
  const Pieces corner = moved(in_order(grid({0, 0, 0}, {5, 5, 5}, 5)), {5, 5, 5});
  const PlacedPieces fit = place_pieces(in_order(dented), corner);
  EXPECT_LE(apart_tree(context, fit, {}, {}).size(), 100U) << "of 109375 pairs";
  std::mt19937_64 random(1);
  Pieces mixed = dented;
  std::shuffle(mixed.begin(), mixed.end(), random);
  EXPECT_GT(apart_tree(context, place_pieces(mixed, corner), {}, {}).size(), 1000U) << "law: the order counts";
}

}  // namespace
}  // namespace fathom::unions
