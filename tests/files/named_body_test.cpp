// SPDX-License-Identifier: GPL-3.0-or-later
// The words of a shape survive reading: they build the very body that was read, and print as a case
// that reads as the same again.
#include <gtest/gtest.h>

#include "fathom/files.hpp"
#include "reference/files/case_json.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::files {
namespace {

Body read(const std::string& a) {
  const CaseItem item = parse_case(R"({"a":)" + a + R"(,"b":{"vertices":[[0,0,0]]}})", "test");
  return item.ok() ? item.value().a : throw item.error();
}

void expect_same(const Body& x, const Body& y, const std::string& text) {
  EXPECT_EQ(x.points, y.points) << text;
  EXPECT_EQ(x.shape, y.shape) << text;
}

TEST(NamedBody, WordsBuildAndPrintTheBodyThatWasRead) {
  for (
      const char* text : {
          R"({"shape":"sphere","radius":0.5})",
          R"({"shape":"capsule","radius":"1/3","half_length":1,"axis":"x","margin":0.1})",
          R"({"shape":"box","half":[1,2,3],"pose":{"quaternion":[1,2,3,4],"translation":[0.1,0,5]}})",
          R"({"shape":"box","half":[1,2,3],"pose":[[1,0,0,0.5],[0,0,-1,0],[0,1,0,0]]})",
          R"({"shape":"rounded_box","half":[1,2,3],"margin":0})",
          R"({"shape":"triangle","vertices":[[0,0,0],[1,0,0],[0,1,0]],"margin":0.25})",
          R"({"shape":"halfspace","normal":[0,0,1],"offset":-1})",
          R"({"shape":"sum","terms":[{"shape":"cylinder","radius":1,"half_length":2,"axis":"y","pose":{"quaternion":[1,1,0,0]}},)"
          R"({"shape":"sum","terms":[{"shape":"hull","vertices":[[0,0,0],[1,0,0]]}]}],"margin":2})",
          R"({"vertices":[[0,0,0],[1,0,0]],"margin":0.5})",
      }) {
    const Body body = read(text);
    ASSERT_TRUE(body.words) << text;
    expect_same(body_of(*body.words), body, text);
    for (const Defaults defaults : {Defaults::left_out, Defaults::written}) {
      const std::string printed = body_json(*body.words, defaults).text();
      expect_same(read(printed), body, printed);
      EXPECT_EQ(body_json(*read(printed).words, defaults).text(), printed)
          << "law: printing and reading changes nothing";
    }
  }
}

TEST(NamedBody, SaysWhatItLeavesOut) {
  const Body body = read(R"({"shape":"capsule","radius":0.5,"half_length":1})");
  EXPECT_EQ(body_json(body).text(), R"({"shape":"capsule","radius":0.5,"half_length":1})");
  EXPECT_EQ(
      body_json(*body.words, Defaults::written).text(),
      R"({"shape":"capsule","radius":0.5,"half_length":1,"axis":"z","pose":{"quaternion":[1,0,0,0],"translation":[0,0,0]}})");
}

TEST(NamedBody, VerticesHaveNone) {
  EXPECT_FALSE(read(R"({"vertices":[[0,0,0],[1,0,0]]})").words);
  EXPECT_FALSE(read(R"({"vertices":[[0,0,0],[1,0,0]],"pose":{"quaternion":[1,1,0,0]}})").words);
}

TEST(NamedBody, RoundedPointsAreSaidAsTheyAre) {
  const std::string pose = R"("pose":{"quaternion":[1,2,3,4]},"pose_rounding":"binary64")";
  EXPECT_FALSE(read(R"({"shape":"box","half":[1,2,3],)" + pose + "}").words)
      << "law: its vertices are no longer those of a box";
  const Body body = read(R"({"shape":"box","half":[1,2,3],"margin":0.5,)" + pose + "}");
  ASSERT_TRUE(body.words);
  EXPECT_EQ(body.words->shape, "hull");
  expect_same(body_of(*body.words), body, "rounded");
}

TEST(NamedBody, FurtherMotionsApplyToMatricesToo) {
  const Body turned = read(R"({"shape":"box","half":[1,2,3],"pose":{"quaternion":[1,1,0,0],"translation":[1,2,3]}})");
  const Body mapped = read(R"({"shape":"box","half":[1,2,3],"pose":[[1,0,0,1],[0,0,-1,2],[0,1,0,3]]})");
  expect_same(turned, mapped, "the same pose in two forms");
  const Quaternion turn{1, 2, 3, 4};
  expect_same(body_of(posed(*turned.words, turn, {5, 6, 7})), body_of(posed(*mapped.words, turn, {5, 6, 7})),
              "moved again");
}

TEST(NamedBody, WordsOfTheCommandLineStay) {
  const Body body = parse_shape("capsule:r=0.5,h=1,axis=y,at=1:2:3", Decimals::binary64);
  ASSERT_TRUE(body.words);
  expect_same(body_of(*body.words), body, "capsule");
  EXPECT_EQ(
      body_json(body).text(),
      R"({"shape":"capsule","radius":0.5,"half_length":1,"axis":"y","pose":{"quaternion":[1,0,0,0],"translation":[1,2,3]}})");
}

}  // namespace
}  // namespace fathom::files
