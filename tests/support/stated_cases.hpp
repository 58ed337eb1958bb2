// SPDX-License-Identifier: GPL-3.0-or-later
// The cases of real_cases.jsonl, report_cases.jsonl and others, with the answers that stand with
// them.
//                                                                            [tests/data/README.md]
#pragma once

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fathom/files.hpp"

namespace fathom::testing {

/// A case, and its exact answer as `fathom depth --json` prints it: status, depth_squared,
/// translations in lexicographic order of their texts, and of report_cases.jsonl signed_depth.
struct StatedCase {
  Case pair;
  std::string line;
  nlohmann::json answer;
};

/// Of these files; of the first two 63 and 141 cases.
inline std::vector<StatedCase> stated_cases(const std::vector<std::string>& names = {"real_cases.jsonl",
                                                                                     "report_cases.jsonl"}) {
  std::vector<StatedCase> result;
  for (const std::string& name : names) {
    std::ifstream file(FATHOM_TEST_DATA "/" + name);
    std::size_t number = 0;
    for (std::string line; std::getline(file, line);) {
      const nlohmann::json json = nlohmann::json::parse(line);
      nlohmann::json answer = json.contains("answer") ? json["answer"] : json.at("expected");
      std::sort(answer["translations"].begin(), answer["translations"].end());
      result.push_back({parse_case(line, name, ++number).value(), line, std::move(answer)});
    }
  }
  return result;
}

/// The shortest translations as the answers have them: (0, 0, 0) if there is none.
inline nlohmann::json translation_texts(const std::vector<Point>& translations) {
  nlohmann::json result = nlohmann::json::array();
  for (const Point& t : translations) result.push_back({t.x.get_str(), t.y.get_str(), t.z.get_str()});
  if (result.empty()) result.push_back({"0", "0", "0"});
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace fathom::testing
