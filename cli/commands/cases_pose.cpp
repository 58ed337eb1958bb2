// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/cases_pose.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "fathom/files.hpp"
#include "kernels/printable.hpp"

namespace fathom::cli {
namespace {

using Json = nlohmann::json;

/// A number and whether a decimal in it is exact.
struct Entry {
  std::string text;
  Decimals decimals;
};
using Rows = std::vector<std::vector<Entry>>;

Rows rows_of_text(const std::string& text, Decimals decimals) {
  Rows rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line, ';');) {
    std::vector<Entry> row;
    std::istringstream words(line);
    for (std::string word; words >> word;) row.push_back({word, decimals});
    if (!row.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

/// Returns the entries of a JSON array of arrays, or no rows for anything else.
Rows rows_of_json(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  Rows rows;
  if (!json.is_array()) return rows;
  for (const Json& line : json) {
    std::vector<Entry>& row = rows.emplace_back();
    if (!line.is_array()) continue;
    for (const Json& value : line) {
      if (value.is_string()) row.push_back({value.get<std::string>(), Decimals::exact});
      // As a decimal, so that it means the nearest binary64; 17 digits tell which that is.
      else if (value.is_number()) row.push_back({fmt::format("{:.16e}", value.get<double>()), Decimals::binary64});
      else row.push_back({value.dump(-1, ' ', true, Json::error_handler_t::replace), Decimals::exact});
    }
  }
  return rows;
}

}  // namespace

files::Pose parse_pose(const std::string& text, const std::string& option, Decimals decimals) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool json = first != std::string::npos && text[first] == '[';
  const Rows rows = json ? rows_of_json(text) : rows_of_text(text, decimals);
  if (rows.size() != 3 || rows[0].size() != 4 || rows[1].size() != 4 || rows[2].size() != 4)
    throw InputError(
        option, 0,
        "expected three rows of four numbers, \"r11 r12 r13 t1; r21 ...; r31 ...\" or a JSON array, found " + kernels::shown(text));
  files::Pose pose;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      ParsedNumber number = parse_number(rows[i][j].text, rows[i][j].decimals);
      if (!number.value) throw InputError(option, 0, fmt::format("row {}, number {}: {}", i + 1, j + 1, number.error));
      pose[i][j] = *std::move(number.value);
    }
  return pose;
}

}  // namespace fathom::cli
