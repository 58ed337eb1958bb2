// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest point of half-spaces: against every choice of at most three planes; and what is named
// as contradictory is.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "fathom/certificate.hpp"
#include "fathom/files.hpp"
#include "kernels/number/rational.hpp"
#include "reference/unions/pieces.hpp"
#include "reference/unions/union_search.hpp"
#include "tests/unions/pieces.hpp"
#include "tests/unions/same_union.hpp"
#include "verify/check/check.hpp"
#include "verify/families/families.hpp"
#include "verify/families/union_pairs.hpp"

namespace fathom::unions {
namespace {

using Planes = std::vector<kernels::OrientedPlane>;

Planes random_planes(std::mt19937_64& random, std::size_t count, long size) {
  Planes planes;
  while (planes.size() < count) {
    const auto number = [&] {
      return mpz_class(static_cast<long>(random() % static_cast<unsigned long>(2 * size + 1)) - size);
    };
    const Vector n{number(), number(), number()}, p{number(), number(), number()};
    if (!is_zero(n)) planes.push_back(kernels::oriented_plane(n, dot(n, p) - size * size / 2, 4));
  }
  return planes;
}

std::vector<Barrier> barriers_of(const Planes& planes) {
  std::vector<Barrier> barriers;
  for (const kernels::OrientedPlane& plane : planes) barriers.push_back(&plane);
  return barriers;
}

// |x|^2 of the nearest point, by all choices of planes that it may lie in.
class Naive {
 public:
  explicit Naive(const Planes& planes) : planes_(planes) {
    consider({0, 0, 0}, 1);
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const auto& [f, a, unused1] = planes[i];
      consider(a * f, dot(f, f));
      for (std::size_t j = 0; j < i; ++j) {
        const auto& [g, b, unused2] = planes[j];
        const Vector d = cross(f, g);
        if (is_zero(d)) continue;
        consider(a * cross(g, d) + b * cross(d, f), dot(d, d));
        for (std::size_t k = 0; k < j; ++k) {
          const auto& [e, c, unused3] = planes[k];
          if (dot(d, e) != 0) consider(a * cross(g, e) + b * cross(e, f) + c * d, dot(d, e));
        }
      }
    }
  }
  std::optional<mpq_class> squared;

 private:
  void consider(Vector v, mpz_class w) {
    if (w < 0) {
      v = -v;
      w = -w;
    }
    for (const kernels::OrientedPlane& f : planes_)
      if (dot(f.normal, v) < f.height * w) return;
    const mpq_class q = kernels::ratio(dot(v, v), w * w);
    if (!squared || q < *squared) squared = q;
  }
  const Planes& planes_;
};

TEST(LeastNorm, IsThatOfAllChoicesOfPlanes) {
  std::size_t found = 0, infeasible = 0, conflicts = 0;
  for (unsigned seed = 1; seed <= 600; ++seed) {
    std::mt19937_64 random(seed);
    const Planes planes = random_planes(random, 1 + seed % 9, seed % 2 == 0 ? 2 : 30);
    kernels::RationalPoint p;
    std::vector<Barrier> barriers = barriers_of(planes);
    const Naive naive(planes);
    const CellEnd end = nearest_in_cell(barriers, 4, p);
    ASSERT_EQ(end == CellEnd::found, naive.squared.has_value()) << seed;
    if (end == CellEnd::found) {
      EXPECT_EQ(kernels::ratio(dot(p.v, p.v), p.w * p.w), *naive.squared) << seed;
      for (const Barrier f : barriers) EXPECT_GE(kernels::side(*f, p), 0);
      ++found;
      continue;
    }
    ++infeasible;
    const Barrier wall = barriers.back();
    barriers.pop_back();
    if (nearest_in_cell(barriers, 4, p) != CellEnd::found || kernels::side(*wall, p) >= 0) continue;
    std::vector<Barrier> conflict;
    ASSERT_EQ(nearest_on_wall(wall, barriers, nullptr, 4, p, &conflict), CellEnd::infeasible);
    EXPECT_LE(conflict.size(), 4U);
    EXPECT_EQ(nearest_in_cell(conflict, 4, p), CellEnd::infeasible) << "law: the conflict alone leaves nothing";
    ++conflicts;
  }
  EXPECT_GT(found, 200U);
  EXPECT_GT(infeasible, 60U);
  EXPECT_GT(conflicts, 20U);
}

TEST(LeastNorm, EndsBeyondTheLimitExactly) {
  std::size_t beyond = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::mt19937_64 random(seed);
    const Planes planes = random_planes(random, 4, 9);
    std::vector<Barrier> barriers = barriers_of(planes);
    kernels::RationalPoint p;
    if (nearest_in_cell(barriers, 4, p) != CellEnd::found || is_zero(p.v)) continue;
    const Barrier wall = barriers.back();
    barriers.pop_back();
    kernels::RationalPoint before, again;
    if (nearest_in_cell(barriers, 4, before) != CellEnd::found || kernels::side(*wall, before) >= 0) continue;
    kernels::SquaredDistance limit = kernels::squared_distance(p);
    EXPECT_EQ(nearest_on_wall(wall, barriers, &limit, 4, again), CellEnd::found) << "law: not beyond if equal";
    limit.numerator = limit.numerator * 1000000 - 1;
    limit.denominator *= 1000000;
    EXPECT_EQ(nearest_on_wall(wall, barriers, &limit, 4, again), CellEnd::beyond);
    ++beyond;
  }
  EXPECT_GT(beyond, 30U);
}

// The search of unions with integers of fixed size against its twin in mpz_class: the same steps,
// hence the same in every field. On every family, and at the limit of the width: coordinates as
// long as they may be, nearly degenerate, so that images decide little.

constexpr long most_bits = kernels::FixedNumbers::most_bits;

UnionDepth expect_twins(const Pieces& a, const Pieces& b) {
  UnionDepth fixed = union_depth(a, b);
  const UnionDepth any = union_depth_twin({.any_size = true}, a, b);
  expect_same(fixed, any);
  EXPECT_EQ(fixed.counters.nodes, any.counters.nodes);
  EXPECT_EQ(fixed.counters.nearest_points, any.counters.nearest_points);
  EXPECT_EQ(fixed.counters.pairs, any.counters.pairs);
  EXPECT_EQ(fixed.counters.pairs_touched, any.counters.pairs_touched);
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

// Files as tools for convex decomposition write them: read, answered and proved.
//                                                                       [tests/data/decompositions]

const std::string folder = FATHOM_TEST_DATA "/decompositions/";

Pieces mug() { return read_pieces(folder + "mug.obj"); }
Pieces spanner() { return read_pieces(folder + "spanner.obj"); }

/// The answer, whose proof the checker accepts, and whose optima leave nothing that overlaps.
UnionDepth proved(const Pieces& a, const Pieces& b) {
  const UnionDepth depth = union_depth(a, b);
  const fathom_check::Verdict verdict = fathom_check::verify(certificate_text(a, b, depth));
  EXPECT_TRUE(verdict.accepted()) << verdict.line << ": " << verdict.reason;
  for (const UnionOptimum& optimum : depth.optima)
    EXPECT_EQ(union_depth(moved(a, optimum.translation), b).status, Status::touching);
  return depth;
}

TEST(Decompositions, AreReadPieceByPiece) {
  EXPECT_EQ(mug().size(), 16U);
  EXPECT_EQ(spanner().size(), 12U);
  EXPECT_EQ(read_pieces(folder + "mug"), mug()) << "law: a file a piece, or all in one";
  for (const Pieces& pieces : {mug(), spanner()})
    for (const std::vector<Point>& piece : pieces) {
      EXPECT_FALSE(families::is_flat(piece));
      EXPECT_LE(piece.size(), 24U);
    }
  EXPECT_EQ(mug()[0][0].x.get_d(), 4.646140) << "the nearest double of the text";
}

TEST(Decompositions, AMugAgainstItself) {
  // Aside: the handle of B is in the hollow of A.
  const UnionDepth same = proved(mug(), mug()), aside = proved(moved(mug(), {6, 0, 3}), mug());
  EXPECT_EQ(same.optima.size(), 2U) << "what takes A out takes B out, reversed";
  for (const UnionDepth* depth : {&same, &aside}) {
    EXPECT_EQ(depth->status, Status::penetrating);
    EXPECT_GT(depth->squared(), depth->bounds->deepest_pair);
  }
  EXPECT_LT(aside.squared(), aside.bounds->hulls);
}

TEST(Decompositions, ABoxInAMug) {
  const auto box_of = [](const mpq_class& half, const mpq_class& low) {
    return Pieces{box({-half, -half, low}, {half, half, low + 2})};
  };
  const UnionDepth with_room = proved(box_of(2, 2), mug()), too_wide = proved(box_of(mpq_class(5, 2), 2), mug()),
                   in_the_ground = proved(box_of(2, mpq_class(1, 2)), mug());
  EXPECT_EQ(with_room.status, Status::disjoint);
  EXPECT_EQ(too_wide.status, Status::penetrating);
  EXPECT_EQ(in_the_ground.status, Status::penetrating);
  EXPECT_LT(in_the_ground.squared(), mpq_class(1, 4)) << "up";
  EXPECT_LT(in_the_ground.squared(), in_the_ground.bounds->hulls);
}

TEST(Decompositions, ASpannerAboutTheRimOfAMug) {
  const UnionDepth depth = proved(moved(spanner(), {mpq_class(-3, 2), 0, mpq_class(17, 2)}), mug());
  EXPECT_EQ(depth.status, Status::penetrating);
  EXPECT_LE(depth.bounds->deepest_pair, depth.squared());
  EXPECT_LE(depth.squared(), depth.bounds->hulls);
}

}  // namespace
}  // namespace fathom::unions
