// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate checker as a library: what it accepts, and that each single fault is found where
// it is. A row of faults.jsonl names a certificate of the test data, or none, and the places that
// are edited one after another, and has the line that is said then.
#include "verify/check/check.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "tests/check/edits.hpp"

namespace fathom_check {
namespace {

const std::filesystem::path certificates = std::filesystem::path(FATHOM_TEST_DATA) / "certificates";

TEST(Check, FindsEachFaultWhereItIs) {
  std::istringstream rows(data("faults.jsonl"));
  std::set<std::string> whole;
  std::size_t count = 0;
  for (std::string line; std::getline(rows, line); ++count) {
    const nlohmann::json row = nlohmann::json::parse(line);
    const std::string of = row.at("of");
    std::string text = of.empty() ? "" : data(of);
    for (const nlohmann::json& edit : row.at("edits")) text = edited(text, edit.at(0), edit.at(1));
    EXPECT_EQ(verdict_line(verify(text), "<stdin>"), row.at("says")) << line;
    if (row.at("edits").empty()) whole.insert(of);
  }
  EXPECT_GT(count, 300U);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(certificates)) {
    const std::filesystem::path path = entry.path().lexically_relative(certificates);
    EXPECT_TRUE(path.extension() != ".cert" || path.stem() == "two_in_one_file" || whole.contains(path)) << path;
  }
}

TEST(Check, EveryTruncationIsMalformed) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(certificates)) {
    if (entry.path().extension() != ".cert" || entry.path().stem() == "two_in_one_file") continue;
    const std::string text = read(entry.path());
    for (std::size_t length = 0; length < text.size(); ++length)
      EXPECT_EQ(verify(std::string_view(text).substr(0, length)).outcome, Outcome::malformed)
          << entry.path() << " cut to " << length;
  }
}

TEST(Check, VerdictStartsFromNo) { EXPECT_FALSE(Verdict().accepted()); }

TEST(Check, NamesAreEscapedInTheLine) {
  EXPECT_EQ(
      verdict_line(verify(""), "a\nb% c"),
      "s MALFORMED a%0Ab%25%20c:1: expected 'fathom-certificate' and a format: 1 to 6, found the end of the input");
}

TEST(Check, OneTextHoldsOneCertificate) {
  EXPECT_EQ(verify(data("two_in_one_file.cert")).outcome, Outcome::malformed);
  EXPECT_EQ(verify(data("depth_cubes.cert") + "# the end\n").outcome, Outcome::verified);
  EXPECT_EQ(verify(data("depth_cubes.cert") + "\n").outcome, Outcome::malformed);
}

TEST(Check, CommentsHoldAnyBytes) {
  EXPECT_TRUE(verify(edited(data("disjoint_cubes.cert"), "0 0 0\n", "# any \xff bytes\n0 0 0\n")).accepted());
}

TEST(Check, WhatIsApartHasNoDepth) {
  const Verdict verdict = verify(data("format_3/pieces_apart.cert"));
  EXPECT_EQ(verdict.format, 3);
  EXPECT_EQ(verdict.depth_squared + verdict.signed_depth, "");
  EXPECT_EQ(verdict.distance_squared, "25");
}

}  // namespace
}  // namespace fathom_check
