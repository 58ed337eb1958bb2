// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "cli/io/process.hpp"

namespace fathom::cli {
namespace {

using Texts = std::vector<std::string>;

TEST(Packed, ComesBack) {
  const std::string all_bytes = [] {
    std::string text;
    for (int i = 0; i < 256; ++i) text += static_cast<char>(i);
    return text;
  }();
  for (const Texts& texts :
       {Texts{}, Texts{""}, Texts{"", ""}, Texts{"12 ", "3", " "}, Texts{all_bytes, "x", all_bytes + all_bytes}}) {
    EXPECT_EQ(unpacked(packed(texts)), texts);
    std::string one_by_one;
    for (const std::string& text : texts) pack(one_by_one, text);
    EXPECT_EQ(one_by_one, packed(texts));
  }
  EXPECT_EQ(unpacked(packed({packed({"a", "b"}), "c"})).at(0), packed({"a", "b"}));
}

TEST(Packed, OtherTextsAreRefused) {
  const std::string good = packed({"abc", "defg"});
  for (std::size_t length = 1; length < good.size(); ++length) {
    const std::string part = good.substr(0, length);
    if (part != packed({"abc"})) {
      EXPECT_THROW(unpacked(part), std::invalid_argument) << part;
    }
  }
  for (const char* text : {"x", " ", "x 1", "5", "-1 a"}) EXPECT_THROW(unpacked(text), std::invalid_argument) << text;
}

}  // namespace
}  // namespace fathom::cli
