// SPDX-License-Identifier: GPL-3.0-or-later
// The expanding polytope with integers of fixed size against its twin in mpz_class: the same steps,
// hence the same in every field. And where binary64 is nearly wrong: points that are coplanar
// within 2^-50, in every rounding mode.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "reference/depth/naive.hpp"
#include "reference/expanding/expanding_polytope.hpp"
#include "tests/expanding/same_expansion.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/rounding_modes.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::expanding {
namespace {

using Random = std::mt19937_64;

TEST(FixedIntegers, TakeTheStepsOfMpzOnEveryFamily) {
  Workspace workspace;
  std::size_t proved = 0, narrow = 0;
  for (const unsigned size : {5U, 12U, 30U}) {
    for (const Case& input : testing::cases_of_all_families(2, size)) {
      const auto [end, placed] = expect_same_expansions(input, workspace);
      proved += end == ExpansionEnd::proved ? 1U : 0U;
      narrow += placed ? 1U : 0U;
    }
  }
  EXPECT_GT(proved, 200U);
  EXPECT_GT(narrow, 200U);
}

/// Lattices of all widths, up to and past those of fixed integers; a third of the bodies are
/// lattice boxes, full of coplanar points.
TEST(FixedIntegers, TakeTheStepsOfMpzOnLatticesOfEveryWidth) {
  Workspace workspace;
  kernels::Context context;
  Random random(2);
  for (int i = 0; i < 1500; ++i) {
    const unsigned long bits = 1 + random() % 330;
    std::vector<Vector> a(4 + random() % 12), b(4 + random() % 12);
    for (std::vector<Vector>* body : {&a, &b}) {
      for (Vector& p : *body) {
        p = testing::random_vector(random, i % 3 == 0 ? 2 : bits);
        if (i % 3 == 0) p = {p.x << (bits - 1), p.y << (bits - 1), p.z << (bits - 1)};
      }
    }
    const polytope::PlacedPair clouds = polytope::place_integers(a, b);
    const Expansion fixed = nearest_by_expansion(context, clouds.a, clouds.b, unlimited, &workspace);
    expect_same(fixed, nearest_by_expansion_in_mpz(context, clouds.a, clouds.b, unlimited, &workspace));
    if (HasFailure()) FAIL() << i << ", " << bits << " bits";
  }
}

/// The largest coordinates that are allowed, in all signs: every bound on bits is met here.
TEST(FixedIntegers, HoldTheLargestNumbers) {
  kernels::Context context;
  Random random(3);
  const mpz_class most = testing::power_of_two(polytope::most_narrow_bits);
  for (int i = 0; i < 300; ++i) {
    std::vector<Vector> a, b;
    const auto coordinate = [&](unsigned negative) {
      const mpz_class size = random() % 3 == 0 ? mpz_class(most - 1) : most;
      return negative != 0 ? mpz_class(-size) : size;
    };
    for (unsigned corner = 0; corner < 8; ++corner) {
      a.push_back({coordinate(corner & 1U), coordinate(corner & 2U), coordinate(corner & 4U)});
      b.push_back({coordinate(corner & 1U), coordinate(corner & 2U), coordinate(corner & 4U)});
    }
    const polytope::PlacedPair clouds = polytope::place_integers(a, b);
    ASSERT_EQ(clouds.exponent(), polytope::most_narrow_bits);
    const Expansion fixed = nearest_by_expansion(context, clouds.a, clouds.b);
    ASSERT_EQ(fixed.end, ExpansionEnd::proved);
    expect_same(fixed, nearest_by_expansion_in_mpz(context, clouds.a, clouds.b));
  }
}

/// A search that ends anywhere leaves a workspace that is as good as a new one.
TEST(Workspace, IsUsableAfterAnInterruption) {
  const Case input = families::find_family("random_sphere")->make(1, 30);
  const polytope::PlacedPair clouds = polytope::place(input.a.points, input.b.points);
  kernels::Context undisturbed;
  const Expansion whole = nearest_by_expansion(undisturbed, clouds.a, clouds.b);
  ASSERT_EQ(whole.end, ExpansionEnd::proved);
  ASSERT_GT(whole.points, 3U);
  Workspace workspace;
  for (std::size_t most = 0; most < whole.points; ++most) {
    struct Stop final : Monitor {
      explicit Stop(std::size_t n) : left(n) {}
      void report(std::string_view, double) override {}
      bool stopped() override { return left-- == 0; }
      std::size_t left;
    } stop(most);
    kernels::Context context(&stop);
    EXPECT_THROW(nearest_by_expansion(context, clouds.a, clouds.b, unlimited, &workspace), Interrupted);
    EXPECT_EQ(nearest_by_expansion(undisturbed, clouds.a, clouds.b, most, &workspace).end, ExpansionEnd::spent);
    expect_same(nearest_by_expansion(undisturbed, clouds.a, clouds.b, unlimited, &workspace), whole);
  }
}

/// Points in binary64 that lie in a common plane but for a few units in the last place: facets of P
/// with many corners, which differ from a plane by 2^-50 of the size or less.
std::vector<Vector> nearly_coplanar_body(Random& random, const Vec3<double>& normal, double offset) {
  std::vector<Vector> points;
  const auto lattice = [](double c) { return mpz_class(std::ldexp(c, 53)); };
  for (int side = 0; side < 2; ++side) {
    for (int k = 0; k < 7; ++k) {
      const double angle = 0.9 * k + 0.1 * side, x = 0.5 * std::cos(angle), y = 0.5 * std::sin(angle);
      const double z = (side == 0 ? offset : offset - 0.7) - normal.x * x - normal.y * y;
      Vector p{lattice(x), lattice(y), lattice(z)};
      p.z += static_cast<long>(random() % 5) - 2;
      points.push_back(p);
    }
  }
  return points;
}

TEST(ErrorBounds, HoldWherePointsAreCoplanarWithinTheLastPlacesInEveryRoundingMode) {
  kernels::Context context;
  Random random(4);
  std::uint64_t unsure = 0;
  for (int i = 0; i < 200; ++i) {
    const auto slope = [&] { return std::ldexp(static_cast<double>(random() % 1024) - 512, -12); };
    const Vec3<double> normal{slope(), slope(), 1};
    const std::vector<Vector> a = nearly_coplanar_body(random, normal, 0.35),
                              b = nearly_coplanar_body(random, normal, 0.25);
    const polytope::PlacedPair clouds = polytope::place_integers(a, b);
    const depth::NaiveDepth truth = depth::naive_depth(a, b);  // no filter of ours
    ASSERT_EQ(truth.status, Status::penetrating);
    for (const int rounding : testing::rounding_modes) {
      const testing::RoundingMode mode(rounding);
      const Expansion found = nearest_by_expansion(context, clouds.a, clouds.b);
      ASSERT_EQ(found.end, ExpansionEnd::proved);
      const auto& directions = found.nearest.directions();
      ASSERT_EQ(std::vector<Vector>(directions.begin(), directions.end()), truth.directions)
          << i << ", rounding " << rounding;
      ASSERT_TRUE(validate(found, clouds.a, clouds.b).ok()) << i << ", rounding " << rounding;
      unsure += found.sides_exact;
    }
  }
  EXPECT_GT(unsure, 800U) << "binary64 decides too much for this test to be hard";
}

/// Work, in counts: binary64 decides nearly all sides of bodies in general position.
TEST(ErrorBounds, LeaveFewSidesToIntegers) {
  kernels::Context context;
  std::uint64_t sides = 0, exact = 0, points = 0, pairs = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Case input = families::find_family("random_sphere")->make(seed, 20);
    const polytope::PlacedPair clouds = polytope::place(input.a.points, input.b.points);
    const Expansion found = nearest_by_expansion(context, clouds.a, clouds.b);
    if (found.end != ExpansionEnd::proved) continue;
    ++pairs;
    sides += found.sides;
    exact += found.sides_exact;
    points += found.points;
  }
  EXPECT_GT(pairs, 150U);
  EXPECT_LT(sides, 300 * pairs);
  EXPECT_LT(exact, 12 * pairs)
      << "the few are: is a candidate above its plane, and which triangles of the nearest facet are coplanar";
  EXPECT_LT(points, 15 * pairs);
}

}  // namespace
}  // namespace fathom::expanding
