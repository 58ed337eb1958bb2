// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "kernels/filters/support.hpp"

namespace fathom::kernels {
namespace {

std::vector<std::uint32_t> greatest_of(const std::vector<int>& values, const std::vector<std::uint32_t>& listed) {
  return greatest<mpz_class>(listed, [&](mpz_class& value, std::uint32_t i) { value = values[i]; });
}

TEST(Greatest, KeepsAllTiesInTheirOrder) {
  EXPECT_EQ(greatest_of({3, 7, 7, -1, 7}, {4, 0, 1, 3, 2}), (std::vector<std::uint32_t>{4, 1, 2}));
}

TEST(Greatest, LooksAtListedOnesAlone) { EXPECT_EQ(greatest_of({3, 7, -5}, {2, 0}), std::vector<std::uint32_t>{0}); }

TEST(Greatest, IsTheFirstOneIfAllAreNegative) { EXPECT_EQ(greatest_of({-3, -7}, {0, 1}), std::vector<std::uint32_t>{0}); }

TEST(Greatest, OfNothingIsNothing) { EXPECT_TRUE(greatest_of({1}, {}).empty()); }

}  // namespace
}  // namespace fathom::kernels
