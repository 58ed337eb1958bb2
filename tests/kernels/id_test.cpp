// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/id.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace fathom::kernels {
namespace {

using Apple = Id<struct AppleTag>;
using Pear = Id<struct PearTag>;
using Apples = IdVector<Apple, int>;

static_assert(sizeof(Apple) == sizeof(std::uint32_t) && std::is_trivially_copyable_v<Apple>,
              "an id is as cheap as the number");
static_assert(!std::is_convertible_v<std::uint32_t, Apple> && !std::is_convertible_v<Apple, std::uint32_t>,
              "a number is no id");
static_assert(!std::is_constructible_v<Apple, Pear> && !std::is_assignable_v<Apple&, Pear>,
              "ids of two kinds do not mix");

template <class Left, class Right>
concept Comparable = requires(Left left, Right right) {
  left == right;
};
template <class Left, class Right>
concept Ordered = requires(Left left, Right right) {
  left < right;
};
static_assert(Comparable<Apple, Apple> && !Comparable<Apple, Pear> && !Comparable<Apple, int>);
static_assert(Ordered<Apple, Apple> && !Ordered<Apple, Pear> && !Ordered<Apple, int>);

template <class Vector, class Index>
concept Indexed = requires(Vector vector, Index index) {
  vector[index];
};
static_assert(Indexed<Apples, Apple> && Indexed<const Apples, Apple>);
static_assert(!Indexed<Apples, Pear> && !Indexed<Apples, std::size_t> && !Indexed<Apples, int>);

TEST(Id, NoneIsNoIdAndGreaterThanAll) {
  EXPECT_TRUE(Apple::none().is_none());
  EXPECT_FALSE(Apple().is_none());
  EXPECT_LT(Apple(UINT32_MAX - 1), Apple::none());
  EXPECT_EQ(Apple(3).next(), Apple(4));
}

TEST(Id, NumbersBecomeIdsInTheirOrder) {
  EXPECT_EQ(to_ids<Apple>({4, 0, 9}), (std::vector{Apple(4), Apple(0), Apple(9)}));
}

TEST(IdVector, FindsElementsByTheirIds) {
  Apples apples{5, 6, 7};
  std::vector<Apple> ids;
  for (const Apple i : apples.ids()) ids.push_back(i);
  EXPECT_EQ(ids, (std::vector<Apple>{Apple(0), Apple(1), Apple(2)}));
  apples[Apple(1)] = 8;
  EXPECT_EQ(apples, (std::vector<int>{5, 8, 7}));
}

}  // namespace
}  // namespace fathom::kernels
