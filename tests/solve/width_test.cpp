// SPDX-License-Identifier: GPL-3.0-or-later
// AGHRS, Proposition 2.1 against rotating calipers.
#include "fathom/width.hpp"

#include <gtest/gtest.h>

#include "tests/oracles/width_oracle.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/prepared.hpp"

namespace fathom::solve {
namespace {

TEST(Width, EqualsCgalsCalipers) {
  std::size_t solids = 0;
  for (const Case& input : testing::cases_of_all_families(2, 14)) {
    const Depth depth = width(input.a.points, {.method = Method::exact});
    const kernels::Report report = testing::check(depth, input.a.points, input.a.points);
    EXPECT_TRUE(report.ok()) << input.id << "\n" << testing::text(report);
    if (depth.flat_a) {
      EXPECT_EQ(depth.status(), Status::touching) << input.id;
      continue;
    }
    const oracles::OracleAnswer oracle = oracles::width_oracle(input.a.points);
    EXPECT_EQ(depth.squared(), oracle.squared) << input.id;
    ++solids;
  }
  EXPECT_GT(solids, 60U);
}

// Larger bodies, by both methods.
TEST(Width, EqualsCgalsCalipersUpTo400Vertices) {
  for (const char* name : {"random_sphere", "crossed_fans", "prisms_posed"}) {
    for (const unsigned size : {100U, 400U}) {
      const Case input = families::find_family(name)->make(1, size);
      const mpq_class calipers = oracles::width_oracle(input.a.points).squared;
      for (const Method method : {Method::exact, Method::automatic})
        EXPECT_EQ(width(input.a.points, {.method = method}).squared(), calipers) << input.id;
    }
  }
}

// The optima of a body against itself come in opposite pairs, with the faces exchanged.
TEST(Width, OptimaComeInOppositePairs) {
  for (const Case& input : testing::cases_of_all_families(1, 14)) {
    const Depth depth = width(input.a.points, {.method = Method::exact});
    const std::size_t n = depth.optima().size();
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_EQ(depth.optima()[i].direction, -depth.optima()[n - 1 - i].direction) << input.id;
      EXPECT_EQ(depth.optima()[i].contact.a, depth.optima()[n - 1 - i].contact.b) << input.id;
    }
  }
}

TEST(Width, OfABoxIsItsShortestSide) {
  std::vector<Point> box;
  for (int i = 0; i < 8; ++i) box.push_back({i & 1 ? mpq_class(5, 2) : mpq_class(0), i & 2 ? 3 : 0, i & 4 ? 4 : 0});
  EXPECT_EQ(width(box).squared(), mpq_class(25, 4));
}

}  // namespace
}  // namespace fathom::solve
