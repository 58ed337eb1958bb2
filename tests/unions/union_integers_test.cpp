// SPDX-License-Identifier: GPL-3.0-or-later
// The search of unions with integers of fixed size against its twin in mpz_class: the same steps,
// hence the same in every field. On every family, and at the limit of the width: coordinates as
// long as they may be, nearly degenerate, so that images decide little.
#include <gtest/gtest.h>

#include <string>

#include "reference/unions/placed_pieces.hpp"
#include "reference/unions/union_search.hpp"
#include "tests/unions/pieces.hpp"
#include "verify/families/families.hpp"

namespace fathom::unions {
namespace {

constexpr long most_bits = kernels::FixedNumbers::most_bits;

void expect_same(const std::vector<UnionOptimum>& fixed, const std::vector<UnionOptimum>& any) {
  ASSERT_EQ(fixed.size(), any.size());
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    EXPECT_EQ(fixed[i].translation, any[i].translation);
    EXPECT_EQ(fixed[i].clearance, any[i].clearance);
    ASSERT_EQ(fixed[i].contacts.size(), any[i].contacts.size());
    for (std::size_t k = 0; k < fixed[i].contacts.size(); ++k) {
      const PieceContact &x = fixed[i].contacts[k], &y = any[i].contacts[k];
      EXPECT_EQ(x.a, y.a);
      EXPECT_EQ(x.b, y.b);
      EXPECT_EQ(x.direction, y.direction);
      EXPECT_EQ(x.contact, y.contact);
    }
  }
}

void expect_same(const UnionDepth& fixed, const UnionDepth& any) {
  EXPECT_EQ(fixed.status, any.status);
  EXPECT_EQ(fixed.complete, any.complete);
  EXPECT_EQ(fixed.low, any.low);
  EXPECT_EQ(fixed.high, any.high);
  expect_same(fixed.optima, any.optima);
  ASSERT_EQ(fixed.apart.has_value(), any.apart.has_value());
  if (fixed.apart) {
    EXPECT_EQ(fixed.apart->a, any.apart->a);
    EXPECT_EQ(fixed.apart->b, any.apart->b);
    EXPECT_EQ(fixed.apart->distance.squared, any.apart->distance.squared);
    EXPECT_EQ(fixed.apart->distance.direction, any.apart->distance.direction);
    EXPECT_EQ(fixed.apart->distance.contact, any.apart->distance.contact);
  }
  ASSERT_EQ(fixed.bounds.has_value(), any.bounds.has_value());
  if (fixed.bounds) {
    EXPECT_EQ(fixed.bounds->deepest_pair, any.bounds->deepest_pair);
    EXPECT_EQ(fixed.bounds->a, any.bounds->a);
    EXPECT_EQ(fixed.bounds->b, any.bounds->b);
    EXPECT_EQ(fixed.bounds->hulls, any.bounds->hulls);
  }
  EXPECT_EQ(fixed.counters.nodes, any.counters.nodes);
  EXPECT_EQ(fixed.counters.nearest_points, any.counters.nearest_points);
  EXPECT_EQ(fixed.counters.pairs, any.counters.pairs);
  EXPECT_EQ(fixed.counters.pairs_touched, any.counters.pairs_touched);
}

UnionDepth expect_twins(const Pieces& a, const Pieces& b) {
  UnionDepth fixed = union_depth(a, b);
  expect_same(fixed, union_depth_in_mpz(a, b));
  return fixed;
}

TEST(FixedIntegersOfUnions, TakeTheStepsOfMpzOnEveryFamily) {
  std::size_t penetrating = 0, fits = 0, others = 0;
  for (const families::Family& family : families::families(families::Kind::unions)) {
    for (std::uint64_t seed = 1; seed <= 18; ++seed) {
      const Case input = family.make(seed, 2 + static_cast<unsigned>(seed % 3));
      SCOPED_TRACE(input.id);
      const UnionDepth depth = expect_twins(*input.a.pieces, *input.b.pieces);
      penetrating += depth.status == Status::penetrating ? 1U : 0U;
      others += depth.status == Status::penetrating ? 0U : 1U;
      for (const UnionOptimum& o : depth.optima) fits += o.clearance ? 0U : 1U;
    }
  }
  EXPECT_GT(penetrating, 200U);
  EXPECT_GT(others, 40U);
  EXPECT_GT(fits, 10U) << "exact fits";
}

/// Boxes on a coarse lattice, each coordinate moved by up to `noise`: their planes nearly meet, and
/// have normals with many digits.
Pieces long_boxes(std::mt19937_64& random, long bits, long noise) {
  Pieces pieces = random_boxes(random, 2, 5);
  for (std::vector<Point>& piece : pieces) {
    for (Point& p : piece) {
      for (mpq_class* c : {&p.x, &p.y, &p.z}) {
        *c -= 2;
        mpz_mul_2exp(c->get_num_mpz_t(), c->get_num_mpz_t(), static_cast<mp_bitcnt_t>(bits));
        *c += static_cast<long>(random() % static_cast<unsigned long>(2 * noise + 1)) - noise;
      }
    }
  }
  return pieces;
}

/// Lattices of many widths, up to and past those of fixed integers.
TEST(FixedIntegersOfUnions, TakeTheStepsOfMpzOnLatticesOfEveryWidth) {
  std::size_t penetrating = 0, below = 0, above = 0;
  for (unsigned seed = 1; seed <= 160; ++seed) {
    std::mt19937_64 random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const long bits =
        seed % 4 == 0 ? 5 + static_cast<long>(random() % 100) : most_bits - 4 + static_cast<long>(seed % 4);
    const Pieces a = long_boxes(random, bits, 1 + seed % 2), b = long_boxes(random, bits, 1);
    const long exponent = place_pieces(a, b).exponent();
    (exponent <= most_bits ? below : above) += 1;
    penetrating += expect_twins(a, b).status == Status::penetrating ? 1U : 0U;
  }
  EXPECT_GT(penetrating, 100U);
  EXPECT_GT(below, 50U);
  EXPECT_GT(above, 20U);
}

/// Nearly cubes whose corners have the largest coordinates that are allowed, in all signs, and
/// pairs of them: numbers of all kinds come near their bounds. One bit beyond, integers of any size
/// answer.
TEST(FixedIntegersOfUnions, HoldTheLargestNumbers) {
  for (const long bits : {most_bits, most_bits + 1}) {
    const mpz_class most = mpz_class(1) << static_cast<unsigned>(bits);
    for (unsigned seed = 1; seed <= 40; ++seed) {
      std::mt19937_64 random(seed);
      SCOPED_TRACE("seed " + std::to_string(seed));
      const auto coordinate = [&](bool negative) {
        const mpz_class size = most - static_cast<long>(random() % 3);
        return mpq_class(negative ? mpz_class(-size) : size);
      };
      const auto body = [&](unsigned pieces) {
        Pieces result;
        for (unsigned k = 0; k < pieces; ++k) {
          std::vector<Point>& piece = result.emplace_back();
          for (unsigned corner = 0; corner < 8; ++corner) {
            const mpq_class x = coordinate((corner & 1U) != 0), y = coordinate((corner & 2U) != 0),
                            z = coordinate((corner & 4U) != 0);
            piece.push_back({x, y, z});
          }
        }
        return result;
      };
      Pieces a = body(1 + seed % 3), b = body(1 + seed / 3 % 3);
      b.front().insert(b.front().begin(), Point{0, 0, 0});  // what is first is the origin of the lattice
      ASSERT_EQ(place_pieces(a, b).exponent(), bits);
      ASSERT_EQ(expect_twins(a, b).status, Status::penetrating);
    }
  }
}

}  // namespace
}  // namespace fathom::unions
