// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "kernels/messages.hpp"

namespace fathom::kernels {
namespace {

TEST(NearMisses, OneSlipForThreeLetters) {
  for (const char* text : {"depht", "dept", "Depth", "depths", "xepth"}) EXPECT_TRUE(is_near(text, "depth")) << text;
  for (const char* text : {"", "death_", "dpeht", "deep", "penetration_depth", "d"})
    EXPECT_FALSE(is_near(text, "depth")) << text;
  EXPECT_TRUE(is_near("driection_", "direction"));
  EXPECT_FALSE(is_near("c", "a"));
  EXPECT_EQ(slips("kitten", "sitting"), 3U);
}

}  // namespace
}  // namespace fathom::kernels
