// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison of two reports as JSON, schemas/diff.schema.json.
#include <cmath>
#include <nlohmann/json.hpp>

#include "verify/harness/report/diff.hpp"

namespace fathom::harness {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

Json report_json(const ReportFile& report) {
  return {{"file", report.path},         {"header", report.header},
          {"whole", report.whole},       {"cases", report.outcomes.size()},
          {"repeated", report.repeated}, {"unattributed", report.unattributed}};
}

Json changes_json(const std::vector<Change>& changes) {
  Json list = Json::array();
  for (const Change& change : changes) {
    Json json = {{"id", change.id}};
    if (!change.variant.empty()) json["variant"] = change.variant;
    json["old"] = name(change.old_verdict);
    json["new"] = name(change.new_verdict);
    if (change.old_error) json["old_error"] = number(*change.old_error);
    if (change.new_error) json["new_error"] = number(*change.new_error);
    json["other_points"] = change.other_points;
    list.push_back(json);
  }
  return list;
}

}  // namespace

std::string diff_json(const ReportFile& before, const ReportFile& after, const ReportDiff& diff) {
  Json json = {{"schema", "fathom/diff/1"}, {"old", report_json(before)}, {"new", report_json(after)}};
  json["header"] = Json::object();
  for (const HeaderDifference& difference : diff.header)
    json["header"][difference.field] = {{"old", difference.old_value}, {"new", difference.new_value}};
  json["both"] = diff.new_row.total;
  json["only_old"] = diff.only_old;
  json["only_new"] = diff.only_new;
  json["other_points"] = diff.other_points;
  json["verdicts"] = Json::object();
  for (std::size_t i = 0; i < verdict_count; ++i) {
    const std::size_t then = diff.old_row.verdicts[i], now = diff.new_row.verdicts[i];
    if (then + now > 0) json["verdicts"][std::string(name(static_cast<Verdict>(i)))] = {{"old", then}, {"new", now}};
  }
  json["newly_failing"] = changes_json(diff.newly_failing);
  json["newly_passing"] = changes_json(diff.newly_passing);
  json["another_verdict"] = changes_json(diff.otherwise);
  json["largest_changes"] = changes_json(diff.errors);
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

}  // namespace fathom::harness
