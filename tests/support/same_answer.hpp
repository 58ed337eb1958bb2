// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two methods gave the same answer.
#pragma once

#include <gtest/gtest.h>

#include "fathom/depth.hpp"

namespace fathom::testing {

/// Expects that all fields are equal that do not depend on the method.
inline void expect_same_answer(const Depth& x, const Depth& y) {
  EXPECT_EQ(x.status(), y.status());
  EXPECT_EQ(x.squared(), y.squared());
  EXPECT_EQ(x.optima(), y.optima());
  EXPECT_EQ(x.direction(), y.direction());
  EXPECT_EQ(x.translation(), y.translation());
  EXPECT_EQ(x.witness(), y.witness());
  EXPECT_EQ(x.flat_a, y.flat_a);
  EXPECT_EQ(x.flat_b, y.flat_b);
  ASSERT_EQ(!x.distance(), !y.distance());
  if (!x.distance()) return;
  EXPECT_EQ(x.distance()->squared, y.distance()->squared);
  EXPECT_EQ(x.distance()->translation, y.distance()->translation);
  EXPECT_EQ(x.distance()->witness, y.distance()->witness);
}

}  // namespace fathom::testing
