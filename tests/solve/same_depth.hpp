// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two answers are the same in every field, those included that depend on the method.
#pragma once

#include <gtest/gtest.h>

#include "fathom/depth.hpp"
#include "tests/support/same_answer.hpp"

namespace fathom::solve {

inline void expect_equal(const Depth& x, const Depth& y) {
  testing::expect_same_answer(x, y);
  EXPECT_EQ(x.method, y.method);
  EXPECT_EQ(x.extreme_a, y.extreme_a);
  EXPECT_EQ(x.counters.expansions, y.counters.expansions);
  EXPECT_EQ(x.counters.inner_facets, y.counters.inner_facets);
  EXPECT_EQ(x.counters.pairs_evaluated, y.counters.pairs_evaluated);
  ASSERT_EQ(!x.penetration(), !y.penetration());
  if (!x.penetration()) return;
  ASSERT_EQ(!x.penetration()->inner, !y.penetration()->inner);
  if (!x.penetration()->inner) return;
  EXPECT_EQ(x.penetration()->inner->vertices, y.penetration()->inner->vertices);
  EXPECT_EQ(x.penetration()->inner->facets, y.penetration()->inner->facets);
}

}  // namespace fathom::solve
