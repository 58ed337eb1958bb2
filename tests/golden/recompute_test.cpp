// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever is changed in a record, the other methods notice. That they give what is right:
// prove_test.cpp.
#include <gtest/gtest.h>

#include "fathom/numbers.hpp"
#include "tests/golden/forged.hpp"
#include "tests/golden/some_recipes.hpp"
#include "tests/support/monitors.hpp"
#include "verify/golden/records/prove.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {
namespace {

using testing::Json;
using testing::read;

/// Every place of a value below `json`, as a JSON pointer.
void leaves_of(const Json& json, const std::string& path, std::vector<std::string>& leaves) {
  if (!json.is_structured()) return leaves.push_back(path);
  for (const auto& [key, value] : json.items()) leaves_of(value, path + "/" + key, leaves);
}

/// Another value of the same kind.
Json other(const Json& value) {
  if (value.is_number()) return value.get<std::uint64_t>() + 1;
  if (value.is_null()) return "0";
  std::string text = value;
  text.back() = text.back() == '1' ? '2' : '1';
  return text;
}

TEST(Recompute, NoticesEveryChangedValue) {
  std::size_t changed = 0;
  for (const Recipe& recipe :
       {Recipe{Source::family, "random_ball", 6, 4}, Recipe{Source::family, "exact_ties", 6, 2},
        Recipe{Source::family, "touching_edge_face", 4, 1}, Recipe{Source::family, "random_disjoint", 4, 1},
        Recipe{Source::shape_family, "capsules", 8, 1}, Recipe{Source::union_catalogue, "cavity_too_small"},
        Recipe{Source::union_catalogue, "gap_of_a_body"}}) {
    const Record record = records_of(recipe).front();
    const Json right = Json::parse(record.line);
    for (const char* part : {"/expected", "/flags", "/formats"}) {
      std::vector<std::string> leaves;
      if (!right.contains(Json::json_pointer(part))) continue;  // shapes and unions have no flags
      leaves_of(right.at(Json::json_pointer(part)), part, leaves);
      for (const std::string& leaf : leaves) {
        Json wrong = right;
        Json& value = wrong[Json::json_pointer(leaf)];
        value = other(value);
        const std::optional<std::string> sentence = disagreement_with(Method::exact, wrong.dump());
        EXPECT_TRUE(sentence && sentence->starts_with("by the method exact: ")) << record.id << leaf;
        ++changed;
      }
    }
  }
  EXPECT_GT(changed, 200u);
}

TEST(Recompute, SaysWhereAndHow) {
  const Record record = records_of({Source::family, "random_ball", 6, 4}).front();
  Json wrong = Json::parse(record.line);
  const std::string right = wrong["expected"]["depth"]["squared"].dump();
  wrong["expected"]["depth"]["squared"] = "1/7";
  EXPECT_EQ(disagreement_with(Method::naive, wrong.dump()),
            "by the method naive: expected.depth.squared: expected " + right + ", found \"1/7\"");
  EXPECT_EQ(disagreement_with(Method::exact, "{}").value_or("").substr(0, 41),
            "by the method exact: expected a record, f");
}

TEST(Recompute, CanBeStopped) {
  const Record record = records_of({Source::family, "random_ball", 6, 4}).front();
  fathom::testing::Recorder impatient(0);
  EXPECT_THROW(disagreement_with(Method::exact, record.line, &impatient), Interrupted);
}

TEST(Recompute, ShapesNeedAnotherSignedDepthToDiffer) {
  Json wrong = Json::parse(records_of({Source::shape_family, "capsules", 8, 1}).front().line);
  wrong["expected"]["signed_depth"]["exact"]["plus"] = "100";
  EXPECT_EQ(disagreement_with(Method::naive, wrong.dump()),
            "by the method naive: expected.signed_depth: the bodies, turned and exchanged, have another one");
  wrong = Json::parse(testing::enclosed_record().line);
  Json& bounds = wrong["expected"]["signed_depth"]["bounds"];
  for (Json& bound : bounds) bound = exact_text(mpq_class(read(bound) + mpq_class(1, 1000)));
  EXPECT_NE(disagreement_with(Method::exact, wrong.dump()).value_or("").find("have another one"), std::string::npos);
  bounds = Json::array();
  EXPECT_NE(disagreement_with(Method::exact, wrong.dump()).value_or("").find("expected a record"), std::string::npos);
}

TEST(Recompute, NearestPiecesMustBeTheNearest) {
  const auto by_exact = [](const Json& line) { return disagreement_with(Method::exact, line.dump()).value_or(""); };
  Json wrong = Json::parse(records_of({Source::union_catalogue, "gap_of_a_body"}).front().line);
  ASSERT_EQ(wrong["expected"]["distance"]["pieces"], (Json{0, 0}));
  wrong["expected"]["distance"]["pieces"] = {0, 7};
  EXPECT_NE(by_exact(wrong).find("there are no such pieces"), std::string::npos);
  const Json chain = Json::parse(records_of({Source::union_catalogue, "rings_linked"}).front().line);
  EXPECT_EQ(by_exact(chain), "");
  const std::uint32_t a = chain["expected"]["distance"]["pieces"][0];
  wrong = chain;
  wrong["expected"]["distance"]["pieces"][0] = (a + 2) % 4;
  EXPECT_NE(by_exact(wrong).find("not the nearest"), std::string::npos) << by_exact(wrong);
  wrong["expected"]["distance"].erase("pieces");
  EXPECT_NE(by_exact(wrong).find("expected a record"), std::string::npos);
}

}  // namespace
}  // namespace fathom::golden
