// SPDX-License-Identifier: GPL-3.0-or-later
// Studies as lines of CSV.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/output/study_output.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/numbers.hpp"

namespace fathom::cli {
namespace {

/// Safe for a terminal, and between quotes where it must be.
std::string field(const std::string& any) {
  const std::string text = safe_id(any);
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string row(const std::vector<std::string>& fields) { return fmt::format("{}", fmt::join(fields, ",")); }

std::vector<std::string> columns() {
  std::vector<std::string> names{"id", "status", "squared", "optima"};
  for (const std::string_view what : coincidence_names) names.emplace_back(what);
  for (const std::string_view what : predicate_names) {
    for (const char* tier : {"calls", "exact", "zero"}) names.push_back(fmt::format("{}_{}", what, tier));
  }
  names.emplace_back("error");
  return names;
}

}  // namespace

std::string study_csv_header() { return row(columns()); }

std::string study_csv_row(const std::string& id, const Study& study) {
  const Depth& depth = study.depth;
  std::vector<std::string> fields{field(id), std::string(name(depth.status())), exact_text(depth.squared()),
                                  std::to_string(depth.optima().size())};
  for (const Coincidences& all : study.coincidences) fields.push_back(std::to_string(all.count));
  for (const TierCounts& tiers : study.predicates) {
    for (const std::uint64_t count : {tiers.calls, tiers.exact, tiers.zero}) fields.push_back(std::to_string(count));
  }
  fields.emplace_back();  // no error
  return row(fields);
}

std::string study_csv_error(const std::string& id, const std::string& error) {
  std::vector<std::string> fields(columns().size());
  fields.front() = field(id);
  fields.back() = field(error);
  return row(fields);
}

}  // namespace fathom::cli
