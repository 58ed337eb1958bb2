// SPDX-License-Identifier: GPL-3.0-or-later
// How near the n^2 near ties are, in exact arithmetic; and that nothing else of P comes near them.
#include <gtest/gtest.h>

#include "tests/support/crossing_planes.hpp"
#include "tests/support/exact_depth.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace {

using namespace fathom;
using namespace fathom::testing;
using families::find_family;
using families::ratio;

/// The spread of the distances that the family's description promises, for n edges a chain.
mpq_class promised(std::string_view family, unsigned long n) {
  if (family == "crossed_ties") return ratio(1, 8UL << 20);  // (1/32)^4 / 8
  if (family == "crossed_shrinking_ties") return ratio(1, mpz_class(n) * n * 32);
  return ratio(1, mpz_class(n) * n * n * n * 8);
}

constexpr const char* tie_families[] = {"crossed_ties", "crossed_shrinking_ties", "crossed_vanishing_ties"};

class TiePatch : public ::testing::TestWithParam<const char*> {};

TEST_P(TiePatch, TheWholeGridTiesNearlyAndNothingElseDoes) {
  for (const unsigned n : {16U, 64U, 200U}) {
    const Case input = find_family(GetParam())->make(n, n);
    const auto p = prepare(input);
    ASSERT_EQ(p->a.vertices.size(), n + 3) << input.id << ": every point of the chain is extreme";
    ASSERT_EQ(p->b.vertices.size(), n + 3) << input.id;
    Spread grid, others;
    for (const MeasuredCrossing& c : measured_crossings(*p)) {
      const bool chains = c.of_a[1] == c.of_a[0] + 1 && c.of_a[1] <= n && c.of_b[1] == c.of_b[0] + 1 && c.of_b[1] <= n;
      (chains ? grid : others).add(c.plane.squared());
    }
    EXPECT_EQ(grid.count, std::size_t{n} * n) << input.id;
    EXPECT_TRUE(grid.within(promised(GetParam(), n) * ratio(11, 10))) << input.id;
    EXPECT_FALSE(grid.within(promised(GetParam(), n) / 2)) << input.id << ": a saddle, not a plain";
    EXPECT_LT(others.count, 16 * n) << input.id;
    EXPECT_GT(others.least, 2 * grid.greatest) << input.id;
    const Depth depth = fathom::testing::exact_depth(input.a.points, input.b.points);
    EXPECT_EQ(depth.squared(), grid.least / (p->placed.denominator * p->placed.denominator)) << input.id;
    EXPECT_EQ(depth.contact()->kind, ContactKind::edge_edge) << input.id;
  }
}

// Far beyond the sizes of the other tests, from the chains' points alone: every 37th edge of
// either.
TEST_P(TiePatch, LargeChainsTieAsPromised) {
  const unsigned n = 5000;
  const Case input = find_family(GetParam())->make(1, n);
  const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
  Spread grid;
  for (unsigned i = 0; i < n; i += 37)
    for (unsigned j = 0; j < n; j += 37)
      grid.add(spanned_plane(placed.a[i], placed.a[i + 1], placed.b[j], placed.b[j + 1]).squared());
  const bool rounded = std::string_view(GetParam()) == "crossed_vanishing_ties";
  EXPECT_TRUE(grid.within(promised(GetParam(), n) * (rounded ? 4 : ratio(11, 10))));
  EXPECT_FALSE(grid.within(promised(GetParam(), n) / 2));
}

TEST_P(TiePatch, CoordinatesAreBinary64UpToTheSizeStated) {
  const unsigned log = std::string_view(GetParam()) == "crossed_ties"             ? 14
                       : std::string_view(GetParam()) == "crossed_vanishing_ties" ? 11
                                                                                  : 15;
  const Case input = find_family(GetParam())->make(1, 1U << log);
  for (const Body* body : {&input.a, &input.b})
    for (const Point& p : body->points)
      for (const mpq_class* x : {&p.x, &p.y, &p.z}) ASSERT_EQ(mpq_class(x->get_d()), *x);
}

// The noise reaches from far above the smooth ties' spread to far below it.
TEST(NoisyTies, AreAsNearAsTheNoiseAllows) {
  const unsigned n = 200;
  std::size_t above = 0, below = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const Case input = find_family("crossed_noisy_ties")->make(seed, n);
    const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
    Spread grid;
    for (unsigned i = 0; i < n; i += 7)
      for (unsigned j = 0; j < n; j += 7)
        grid.add(spanned_plane(placed.a[i], placed.a[i + 1], placed.b[j], placed.b[j + 1]).squared());
    EXPECT_TRUE(grid.within(ratio(1, mpz_class(1) << 28))) << input.id;
    // Five times a rotation by 3/5, 4/5: coordinates are multiples of the noise.
    mpz_class unit = 1;
    for (const Point& p : input.a.points) unit = std::max(unit, p.z.get_den());
    const auto bits = mpz_sizeinbase(unit.get_mpz_t(), 2) - 1;
    EXPECT_GE(bits, 46U) << input.id;
    EXPECT_LE(bits, 90U) << input.id;
    above += bits < 56;
    below += bits > 80;
    const auto p = prepare(input);
    EXPECT_EQ(p->a.vertices.size(), n + 3) << input.id << ": every point of the chain is extreme";
    EXPECT_EQ(p->b.vertices.size(), n + 3) << input.id;
  }
  EXPECT_GT(above, 0U);
  EXPECT_GT(below, 0U);
}

INSTANTIATE_TEST_SUITE_P(Families, TiePatch, ::testing::ValuesIn(tie_families),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
