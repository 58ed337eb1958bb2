// SPDX-License-Identifier: GPL-3.0-or-later
// Every record is given again by the other methods; whatever is changed in one, they notice.
#include "verify/golden/records/recompute.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/golden/some_recipes.hpp"
#include "tests/support/monitors.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {
namespace {

using Json = nlohmann::ordered_json;  // keeps the order of fields

TEST(Recompute, EachMethodGivesWhatWasMade) {
  for (const Recipe& recipe : testing::some_recipes(3)) {
    for (const Record& record : records_of(recipe))
      for (const Method method : {Method::exact, Method::naive})
        EXPECT_EQ(disagreement_with(method, record.line).value_or(""), "") << record.id;
  }
}

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
  for (const Recipe& recipe : {Recipe{Source::family, "random_ball", 6, 4}, Recipe{Source::family, "exact_ties", 6, 2},
                               Recipe{Source::family, "touching_edge_face", 4, 1}, Recipe{Source::family, "random_disjoint", 4, 1}}) {
    const Record record = records_of(recipe).front();
    const Json right = Json::parse(record.line);
    for (const char* part : {"/expected", "/flags", "/formats"}) {
      std::vector<std::string> leaves;
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
  EXPECT_EQ(disagreement_with(Method::exact, "{}").value_or("").substr(0, 41), "by the method exact: expected a record, f");
}

TEST(Recompute, CanBeStopped) {
  const Record record = records_of({Source::family, "random_ball", 6, 4}).front();
  fathom::testing::Recorder impatient(0);
  EXPECT_THROW(disagreement_with(Method::exact, record.line, &impatient), Interrupted);
}

}  // namespace
}  // namespace fathom::golden
