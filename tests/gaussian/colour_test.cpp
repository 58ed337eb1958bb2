// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>

#include "reference/gaussian/gaussian_diagram.hpp"

namespace fathom::gaussian {
namespace {

template <class Index>
concept Colours = requires(PerColour<int> pair, Index index) {
  pair[index];
};
static_assert(Colours<Colour> && !Colours<int> && !Colours<bool>, "only a colour tells whose");

TEST(PerColour, HoldsOneForEachColour) {
  PerColour<std::string> names{"minus a", "b"};
  EXPECT_EQ(names[Colour::a], "minus a");
  EXPECT_EQ(names[other(Colour::a)], "b");
  for (const Colour c : both_colours) names[c] += "!";
  EXPECT_EQ(names.a, "minus a!");
  EXPECT_EQ(names.b, "b!");
}

}  // namespace
}  // namespace fathom::gaussian
