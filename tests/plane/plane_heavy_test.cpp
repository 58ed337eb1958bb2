// SPDX-License-Identifier: GPL-3.0-or-later
// Ten thousand pairs of each kind against the naive twin; of what rays answer, a thousand.
#include <gtest/gtest.h>

#include "tests/plane/pairs.hpp"
#include "tests/plane/plane_rays.hpp"

namespace fathom::plane {
namespace {

TEST(Plane, EqualsTheNaiveTwinOnManyPairsOfEachKind) { expect_right_pairs(10'000); }

TEST(PlaneRays, EqualTheNaiveTwinsOnManyPairsOfEachKind) { expect_right_rays(1'000); }

}  // namespace
}  // namespace fathom::plane
