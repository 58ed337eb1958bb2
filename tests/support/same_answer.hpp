// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two methods gave the same answer.
#pragma once

#include <gtest/gtest.h>

#include "reference/solve/depth.hpp"

namespace fathom::testing {

/// Expects that all fields are equal that do not depend on the method.
inline void expect_same_answer(const Depth& x, const Depth& y) {
  EXPECT_EQ(solve::disagreement(x, y).value_or(""), "");
}

}  // namespace fathom::testing
