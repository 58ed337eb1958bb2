// SPDX-License-Identifier: GPL-3.0-or-later
// Round lengths: the greatest that fits, and a number that says exactly that length.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "fathom/numbers.hpp"
#include "tests/support/property.hpp"
#include "view/picture/view.hpp"

namespace fathom::picture {
namespace {

mpq_class read(const std::string& text) { return parse_number(text, Decimals::exact).value.value(); }

TEST(RoundLength, OfEachDigit) {
  const auto text = [](const char* most) { return round_length(read(most)).text; };
  EXPECT_EQ(text("1"), "1");
  EXPECT_EQ(text("1.999999999"), "1");
  EXPECT_EQ(text("2"), "2");
  EXPECT_EQ(text("4.99"), "2");
  EXPECT_EQ(text("5"), "5");
  EXPECT_EQ(text("9.99"), "5");
  EXPECT_EQ(text("10"), "10");
  EXPECT_EQ(text("99999"), "50000");
  EXPECT_EQ(text("100000"), "1e5");
  EXPECT_EQ(text("0.000123"), "0.0001");
  EXPECT_EQ(text("0.07"), "0.05");
  EXPECT_EQ(text("0.00009"), "5e-5");
  EXPECT_EQ(text("3e300"), "2e300");
  EXPECT_EQ(text("7e-300"), "5e-300");
}

TEST(RoundLength, IsTheGreatestAndSaysSo) {
  EXPECT_TRUE(holds({.seed = 76, .runs = 1000}, [] {
    mpq_class most(*rc::gen::inRange(1, 1'000'000), *rc::gen::inRange(1, 1'000'000));
    most.canonicalize();
    const mpq_class power = read("1e" + std::to_string(*rc::gen::inRange(-310, 310)));
    most *= power;
    const RoundLength length = round_length(most);
    RC_ASSERT(length.value <= most && most < length.value * mpq_class(5, 2));
    RC_ASSERT(read(length.text) == length.value);
    RC_ASSERT(length.text.size() <= 6U);
  }));
}

}  // namespace
}  // namespace fathom::picture
