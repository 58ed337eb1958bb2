// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of pieces on demand: against the twins that ask all pairs, in integers of any size, on
// lattices of their own; and how few are made.
#include "reference/unions/pair_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include "reference/unions/union_search.hpp"
#include "tests/unions/pieces.hpp"
#include "tests/unions/same_union.hpp"
#include "verify/families/families.hpp"

namespace fathom::unions {
namespace {

using kernels::AnyNumbers;

/// Answers as all twins do.
UnionDepth expect_all_twins(const Pieces& a, const Pieces& b) {
  UnionDepth depth = union_depth(a, b);
  for (const bool any_size : {false, true}) {
    SCOPED_TRACE(any_size ? "any size" : "fixed size");
    expect_same(depth, union_depth_twin({any_size, true, Lattices::fitting}, a, b));
  }
  for (const bool all_pairs : {false, true}) {
    SCOPED_TRACE("lattices of their own");
    expect_same(depth, union_depth_twin({true, all_pairs, Lattices::own}, a, b));
  }
  EXPECT_LE(depth.counters.pairs_touched, depth.counters.pairs);
  return depth;
}

std::vector<kernels::RationalPoint> random_points(std::mt19937_64& random, const PlacedPieces& pieces, long size) {
  std::vector<kernels::RationalPoint> result(1);
  for (int i = 0; i < 20; ++i) {
    const auto coordinate = [&] {
      return mpq_class(static_cast<long>(random() % static_cast<unsigned long>(2 * size)) - size);
    };
    const mpq_class x = coordinate(), y = coordinate(), z = coordinate();
    result.push_back(pieces.point({x, y, z}));
  }
  return result;
}

TEST(RankedPairs, AreAllInTheOrderOfTheirBounds) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    const Pieces a = random_boxes(random, 1 + seed % 7, 6), b = random_pieces(random, 1 + seed % 5, 6, 6, 3);
    const PlacedPieces pieces = place_pieces(a, b, seed % 2 == 0 ? Lattices::own : Lattices::one);
    const PairTableIn<AnyNumbers> table(pieces, false);
    for (const kernels::RationalPoint& p : random_points(random, pieces, 6)) {
      RankedPairs pairs = table.ranked(p);
      std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> found;
      while (const auto pair = pairs.next()) found.emplace_back(-pair->bound, pair->a, pair->b);
      EXPECT_EQ(found.size(), a.size() * b.size());
      EXPECT_TRUE(std::is_sorted(found.begin(), found.end())) << "law: of equal bounds the first pair comes first";
      if (!is_zero(p.v)) continue;
      for (const auto& [minus_bound, i, j] : found) {
        const mpq_class squared = pieces.squared_of_boxes(i, j);
        const double size = pieces.image_above(abs(squared));
        EXPECT_GE(-minus_bound, squared < 0 ? -size * (1 + 1e-12) : size * (1 - 1e-12)) << "law: a bound";
        EXPECT_NEAR(-minus_bound, squared < 0 ? -size : size, 1e-9) << "law: as of the exact boxes";
      }
    }
  }
}

TEST(PairTable, LeavesOutOnlyPairsThatAreApart) {
  std::size_t left_out = 0, within = 0, touching = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937_64 random(seed);
    const unsigned size = seed % 3 == 0 ? 4 : 40;
    const Pieces a = random_pieces(random, 3, 6, size, size / 2), b = random_pieces(random, 4, 5, size, size / 2);
    const PlacedPieces pieces = place_pieces(a, b, seed % 2 == 0 ? Lattices::own : Lattices::one);
    PairTableIn<AnyNumbers> table(pieces, false);
    for (const kernels::RationalPoint& p : random_points(random, pieces, size)) {
      RankedPairs pairs = table.ranked(p);
      while (const auto ranked = pairs.next()) {
        PiecePair pair(pieces, ranked->a, ranked->b);
        const bool inside = pair.contains(p), apart = !inside && pair.normals_at(p).empty();
        const bool found = table.find(*ranked, p) != nullptr;
        EXPECT_TRUE(found || apart);
        left_out += found ? 0U : 1U;
        within += inside ? 1U : 0U;
        touching += !inside && !apart ? 1U : 0U;
      }
    }
  }
  EXPECT_GT(left_out, 5000U);
  EXPECT_GT(within, 400U);
  EXPECT_GT(touching, 40U);
}

TEST(UnionTwins, AgreeOnEveryFamily) {
  std::size_t penetrating = 0, fits = 0, others = 0;
  for (const families::Family& family : families::families(families::Kind::unions)) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const Case input = family.make(seed, 2 + static_cast<unsigned>(seed % 3));
      SCOPED_TRACE(input.id);
      const UnionDepth depth = expect_all_twins(*input.a.pieces, *input.b.pieces);
      (depth.status == Status::penetrating ? penetrating : others) += 1;
      for (const UnionOptimum& o : depth.optima) fits += o.clearance ? 0U : 1U;
    }
  }
  EXPECT_GT(penetrating, 40U);
  EXPECT_GT(others, 8U);
  EXPECT_GT(fits, 2U) << "exact fits";
}

TEST(UnionTwins, AgreeOnGrids) {
  const Pieces cubes = grid({0, 0, 0}, {3, 3, 3}, 3);
  for (const Point& t : {Point{0, 0, 0}, Point{mpq_class(1, 2), mpq_class(1, 2), mpq_class(1, 2)}, Point{3, 0, 0},
                         Point{3, 3, mpq_class(1, 3)}, Point{7, 0, 0}, Point{5, mpq_class(22, 7), 4}})
    expect_all_twins(cubes, moved(cubes, t));
  const Pieces same(5, box({0, 0, 0}, {2, 2, 2}));
  expect_all_twins(same, moved(same, {1, 0, 0}));
  expect_all_twins(same, moved(same, {5, 0, 0}));
}

TEST(UnionTwins, AgreeOnOnePieceAgainstManyAndOnOneEach) {
  std::mt19937_64 random(7);
  const Pieces one = {random_piece(random, 12, 9)};
  Pieces many;
  for (int i = 0; i < 2000; ++i) many.push_back(moved(random_boxes(random, 1, 4), {i % 50, i / 50, i % 7})[0]);
  EXPECT_EQ(expect_all_twins(one, many).status, Status::penetrating);
  expect_all_twins(moved(one, {0, 0, 40}), many);
  expect_all_twins(one, moved(one, {1, 2, 3}));
  expect_all_twins(one, moved(one, {10, 2, 3}));
}

TEST(UnionTwins, AgreeAtTheEndsOfBinary64) {
  const mpq_class least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max() / 16;
  std::mt19937_64 random(11);
  const Pieces a = random_boxes(random, 3, 5), b = random_boxes(random, 3, 5);
  for (const mpq_class& unit : {least, most}) {
    const UnionDepth depth = expect_all_twins(scaled(a, unit), scaled(b, unit));
    EXPECT_EQ(depth.squared(), union_depth(a, b).squared() * unit * unit);
  }
  Pieces both = scaled(a, least);
  both.push_back(scaled(b, most)[0]);
  EXPECT_EQ(expect_all_twins(both, scaled(b, most)).status, Status::penetrating);
  expect_all_twins(both, moved(scaled(b, least), {most * 16, 0, 0}));
}

// Every coordinate over a denominator of its own: a common one has thousands of bits.
Pieces with_long_denominators(std::mt19937_64& random, Pieces pieces) {
  for (std::vector<Point>& piece : pieces)
    for (Point& p : piece)
      for (mpq_class* c : {&p.x, &p.y, &p.z}) {
        mpz_class denominator = random();
        denominator = (denominator << 30) + random();
        *c += kernels::ratio(random() >> 8U, denominator);
      }
  return pieces;
}

TEST(UnionTwins, AgreeWhereNoLatticeIsShort) {
  std::size_t penetrating = 0, others = 0;
  for (unsigned seed = 1; seed <= 9; ++seed) {
    std::mt19937_64 random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Pieces a = with_long_denominators(random, random_boxes(random, 1 + seed % 4, 5)),
                 b = with_long_denominators(random, moved(random_boxes(random, 5, 5), {seed % 3 * 4, 0, 0}));
    ASSERT_FALSE(place_pieces(a, b).on_one_lattice());
    const UnionDepth depth = expect_all_twins(a, b);
    expect_same(depth, union_depth_twin({true, false, Lattices::one}, a, b));
    (depth.status == Status::penetrating ? penetrating : others) += 1;
  }
  EXPECT_GT(penetrating, 3U);
  EXPECT_GT(others, 1U);
}

// The first pair, with the larger box, is 1/4 deep; the second deeper by a 2^-41st.
TEST(UnionDepth, FindsTheDeepestPairByTheLastBits) {
  const mpq_class two = 2, below = mpq_class(-1, 16), left = mpq_class(-3, 4);
  std::vector<Point> prism;
  for (const int z : {0, 1})
    for (const auto& [x, y] : {std::pair(two, two), std::pair(two, below), std::pair(left, two)})
      prism.push_back({x, y, z});
  const mpq_class deeper = mpq_class(1, 4) + mpq_class(1, mpz_class(1) << 43);
  const Pieces cube = grid({0, 0, 0}, {1, 1, 1}, 1);
  std::vector<Point> slab = moved(cube, {1 - deeper, 0, 0})[0];
  const UnionDepth depth = expect_all_twins(cube, {prism, slab});
  EXPECT_EQ(depth.bounds->deepest_pair, deeper * deeper);
  EXPECT_EQ(std::pair(depth.bounds->a, depth.bounds->b), std::pair(0U, 1U));
}

TEST(UnionDepth, MakesFewOfManyPairs) {
  const Pieces cubes = grid({0, 0, 0}, {10, 10, 10}, 10);
  const UnionDepth corner = union_depth(cubes, moved(cubes, {mpq_class(37, 4), mpq_class(1, 3), mpq_class(2, 7)})),
                   far = union_depth(cubes, moved(cubes, {15, mpq_class(1, 3), 0})),
                   far_in_line = union_depth(cubes, moved(cubes, {15, 0, 0}));
  EXPECT_EQ(corner.squared(), mpq_class(9, 16));
  EXPECT_EQ(corner.counters.pairs, 1000000U);
  EXPECT_LE(corner.counters.pairs_touched, 400U) << "those that touch after the way out are 361";
  EXPECT_EQ(far.apart->distance.squared, 25);
  EXPECT_EQ(std::pair(far.apart->a, far.apart->b), std::pair(900U, 0U));
  EXPECT_LE(far.counters.pairs_touched, 2U);
  EXPECT_LE(far_in_line.counters.pairs_touched, 2U) << "a hundred pairs are as near";
  const Pieces small = grid({0, 0, 0}, {5, 5, 5}, 5);
  const UnionDepth deep = union_depth(small, moved(small, {mpq_class(1, 2), mpq_class(1, 2), mpq_class(1, 2)}));
  EXPECT_EQ(deep.squared(), mpq_class(81, 4));
  EXPECT_LE(deep.counters.pairs_touched, 3000U) << "of 15625";
}

}  // namespace
}  // namespace fathom::unions
