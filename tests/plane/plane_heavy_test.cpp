// SPDX-License-Identifier: GPL-3.0-or-later
// Ten thousand pairs of each kind against the naive twin.
#include <gtest/gtest.h>

#include "tests/plane/pairs.hpp"

namespace fathom::plane {
namespace {

TEST(Plane, EqualsTheNaiveTwinOnManyPairsOfEachKind) { expect_right_pairs(10'000); }

}  // namespace
}  // namespace fathom::plane
