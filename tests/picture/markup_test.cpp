// SPDX-License-Identifier: GPL-3.0-or-later
// Foreign text in documents: any bytes become something well-formed, good text stays as it is, and
// different ids stay different.
#include "view/picture/markup.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "tests/harness/report/outcomes.hpp"
#include "tests/harness/report/well_formed.hpp"
#include "tests/support/property.hpp"

namespace fathom::picture {
namespace {

using harness::testing::read_xml;

std::string there_and_back(const std::string& text) {
  const harness::testing::Element element = read_xml("<e a=\"" + markup(text) + "\">" + markup(text) + "</e>");
  EXPECT_EQ(element.text, element["a"]);
  return element.text;
}

TEST(Markup, GoodTextComesBack) {
  for (const std::string text : {"", "plain", "<a href=\"x\">&amp;'</a>", "]]>", "a\tb\nc\r",
                                 "\xc3\xa9 \xe2\x88\x9a \xf0\x9f\x98\x80", "\xed\x9f\xbf\xee\x80\x80"})
    EXPECT_EQ(there_and_back(text), text);
}

TEST(Markup, WhatNoDocumentMayHoldIsShown) {
  EXPECT_EQ(there_and_back(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(there_and_back("\x1b[31m\x7f"), "\\x1b[31m\\x7f");
  EXPECT_EQ(there_and_back("\xff\x80"), "\\xff\\x80");
  EXPECT_EQ(there_and_back("\xc0\xaf"), "\\xc0\\xaf") << "overlong";
  EXPECT_EQ(there_and_back("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "a surrogate";
  EXPECT_EQ(there_and_back("\xef\xbf\xbe"), "\\xef\\xbf\\xbe") << "U+FFFE";
  EXPECT_EQ(there_and_back("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond U+10FFFF";
  EXPECT_EQ(there_and_back("\xe2\x88"), "\\xe2\\x88") << "cut short";
}

TEST(Markup, AnyBytes) {
  EXPECT_FALSE(there_and_back(harness::testing::hostile()).empty());
  EXPECT_TRUE(holds({.seed = 71, .runs = 1000},
                    [](const std::string& text) { RC_ASSERT(there_and_back(text).size() >= text.size()); }));
  EXPECT_TRUE(holds({.seed = 71, .runs = 1000}, [] {
    const auto bytes = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0x7e, 0x100));
    std::string text;
    for (const int byte : bytes) text += static_cast<char>(byte);
    RC_ASSERT(there_and_back(text).size() >= text.size());
  }));
}

TEST(WithoutFolders, CutsAbsolutePathsAndNothingElse) {
  EXPECT_EQ(without_folders("/home/me/a.off /srv/b.off"), "a.off b.off");
  EXPECT_EQ(without_folders("fathom certify --subject './run --in=/home/me/x.json' \"/tmp/c.jsonl\""),
            "fathom certify --subject './run --in=x.json' \"c.jsonl\"");
  EXPECT_EQ(without_folders("/home/me/cases.jsonl:3: expected a case"), "cases.jsonl:3: expected a case");
  EXPECT_EQ(without_folders("into /home/me/folder/, then"), "into folder, then");
  for (const char* text : {"", "/", "a / b", "1/2", "tests/data/cube.off", "and/or", "</script>", "box:half=1,1/2,1"})
    EXPECT_EQ(without_folders(text), text);
}

TEST(Ascii, IsCutAndPrintable) {
  EXPECT_EQ(ascii("plain", 5), "plain");
  EXPECT_EQ(ascii("plainer", 5), "pl...");
  EXPECT_EQ(ascii("a\nb\xff"), "a\\x0ab\\xff");
  EXPECT_TRUE(holds({.seed = 71, .runs = 1000}, [](const std::string& text) {
    const std::string shown = ascii(text, 10);
    RC_ASSERT(shown.size() <= 10U);
    for (const char c : shown) RC_ASSERT(c >= 0x20 && c < 0x7f);
  }));
}

}  // namespace
}  // namespace fathom::picture
