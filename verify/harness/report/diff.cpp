// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

#include "reference/text/json.hpp"
#include "verify/harness/report/reports.hpp"
#include "view/picture/markup.hpp"

namespace fathom::harness {
namespace {

constexpr std::size_t most_errors = 20;

/// Returns the error of the claimed depth in parts of R.
std::optional<double> error_of(const Outcome& outcome, double unit_roundoff) {
  if (!outcome.judgement || !outcome.judgement->error_u_r) return std::nullopt;
  return *outcome.judgement->error_u_r * unit_roundoff;
}

void sort_by_change(std::vector<Change>& changes) {
  std::ranges::sort(changes, {}, [](const Change& change) {
    return std::tuple(-change.error_change(), std::string_view(change.id), std::string_view(change.variant));
  });
}

std::vector<HeaderDifference> differences(const std::map<std::string, std::string>& before,
                                          const std::map<std::string, std::string>& after) {
  std::vector<HeaderDifference> result;
  for (const auto& [field, value] : before)
    if (const auto other = after.find(field); other == after.end()) result.push_back({field, value, ""});
    else if (other->second != value) result.push_back({field, value, other->second});
  for (const auto& [field, value] : after)
    if (!before.contains(field)) result.push_back({field, "", value});
  return result;
}

// ---- as text ----

using Lines = std::vector<std::string>;

std::string error_or_none(const std::optional<double>& error) { return error ? error_text(*error) : "none"; }

std::string errors_text(const Change& change) {
  if (!change.old_error && !change.new_error) return "";
  return fmt::format("error {} -> {}", error_or_none(change.old_error), error_or_none(change.new_error));
}

void add_changes(Lines& lines, const std::string& title, const std::vector<Change>& changes, std::size_t most) {
  if (changes.empty()) return;
  lines.push_back("");
  lines.push_back(fmt::format("{} ({})", title, changes.size()));
  for (std::size_t i = 0; i < std::min(changes.size(), most); ++i) {
    const Change& change = changes[i];
    const std::string verdicts = change.old_verdict == change.new_verdict
                                     ? std::string(name(change.new_verdict))
                                     : fmt::format("{} -> {}", name(change.old_verdict), name(change.new_verdict));
    const std::string errors = errors_text(change);
    lines.push_back(fmt::format("  {}: {}{}{}{}", ascii(shown_id(change.id, change.variant), longest_id), verdicts,
                                errors.empty() ? "" : ", ", errors, change.other_points ? ", other points" : ""));
  }
  if (changes.size() > most)
    lines.push_back(fmt::format("  {} more; --json and --html have all", changes.size() - most));
}

void add_header(Lines& lines, const ReportDiff& diff) {
  if (diff.header.empty()) return;
  lines.push_back("");
  lines.push_back("headers differ in");
  const auto shown = [](const std::string& value) { return value.empty() ? "nothing" : ascii(value); };
  for (const HeaderDifference& difference : diff.header)
    lines.push_back(fmt::format("  {}: {} -> {}", ascii(difference.field), shown(difference.old_value),
                                shown(difference.new_value)));
}

void add_verdicts(Lines& lines, const ReportDiff& diff) {
  lines.push_back("");
  lines.push_back(fmt::format("{:<22}  {:>7}  {:>7}", "cases of both", "old", "new"));
  for (std::size_t i = verdict_count; i-- > 0;) {
    const std::size_t then = diff.old_row.verdicts[i], now = diff.new_row.verdicts[i];
    if (then + now > 0) lines.push_back(fmt::format("{:<22}  {:>7}  {:>7}", name(static_cast<Verdict>(i)), then, now));
  }
}

void add_report(Lines& lines, const char* which, const ReportFile& report) {
  lines.push_back(fmt::format("{}  {}, {}", which, ascii(report.title()), ascii(report.path)));
  if (!report.whole) lines.push_back("     cut short: it has no summary");
  if (report.repeated > 0)
    lines.push_back(
        fmt::format("     {} of an id that comes again; the last counts", counted(report.repeated, "line", "lines")));
}

// ---- as JSON: diff.schema.json ----

using text::Json;

Json number(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

Json report_json(const ReportFile& report) {
  Json header = Json::object();
  for (const auto& [field, value] : report.header) header[field] = value;
  return {{"file", report.path},
          {"header", header},
          {"whole", Json::boolean(report.whole)},
          {"cases", report.outcomes.size()},
          {"repeated", report.repeated},
          {"unattributed", report.unattributed}};
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
    json["other_points"] = Json::boolean(change.other_points);
    list.push_back(json);
  }
  return list;
}

// ---- as a page ----

std::string error_cell(const std::optional<double>& error) { return error ? error_text(*error) : ""; }

std::string row(const Change& change) {
  return fmt::format(
      "<tr><th scope=\"row\" class=\"id\">{}</th><td class=\"name\">{}</td><td "
      "class=\"name\">{}</td><td>{}</td><td>{}</td><td "
      "class=\"name\">{}</td></tr>\n",
      markup(shown_id(change.id, change.variant)), name(change.old_verdict), name(change.new_verdict),
      error_cell(change.old_error), error_cell(change.new_error), change.other_points ? "other points" : "");
}

std::string changes_section(const std::string& title, const std::vector<Change>& changes, const char* empty) {
  std::string rows;
  const std::size_t listed = std::min(changes.size(), most_listed);
  for (std::size_t i = 0; i < listed; ++i) rows += row(changes[i]);
  const std::string table = fmt::format(
      "<thead><tr><th scope=\"col\" class=\"text\">case</th><th scope=\"col\" class=\"text\">old</th><th scope=\"col\" "
      "class=\"text\">new</th><th scope=\"col\">old error / R</th><th scope=\"col\">new error / R</th><th "
      "scope=\"col\" "
      "class=\"text\"></th></tr></thead>\n<tbody>{}</tbody>",
      rows);
  const std::string more =
      changes.size() > listed ? fmt::format("<p>{} more: --json has all.</p>\n", changes.size() - listed) : "";
  return fmt::format("<section><h2>{}</h2>\n{}{}</section>\n", title,
                     changes.empty() ? fmt::format("<p>{}</p>\n", empty) : picture::table_box(title, table, true),
                     more);
}

std::string header_section(const ReportDiff& diff) {
  if (diff.header.empty())
    return "<p>The headers are the same: subject, version, settings, tolerance, and fathom.</p>\n";
  std::string rows;
  for (const HeaderDifference& difference : diff.header)
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td class=\"text\">{}</td></tr>\n",
                        markup(difference.field), markup(difference.old_value), markup(difference.new_value));
  return picture::table_box(
      "Headers",
      "<thead><tr><th scope=\"col\" class=\"text\">header</th><th scope=\"col\" class=\"text\">old</th><th "
      "scope=\"col\" class=\"text\">new</th></tr></thead>\n<tbody>" +
          rows + "</tbody>",
      false);
}

std::string verdict_table(const ReportDiff& diff) {
  std::string rows;
  for (std::size_t i = verdict_count; i-- > 0;) {
    const auto then = static_cast<long long>(diff.old_row.verdicts[i]),
               now = static_cast<long long>(diff.new_row.verdicts[i]);
    if (then + now > 0)
      rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                          name(static_cast<Verdict>(i)), then, now, now == then ? "" : fmt::format("{:+}", now - then));
  }
  return picture::table_box(
      "Verdicts",
      "<thead><tr><th scope=\"col\" class=\"text\">cases of both</th><th scope=\"col\">old</th><th "
      "scope=\"col\">new</th><th scope=\"col\">change</th></tr></thead>\n<tbody>" +
          rows + "</tbody>",
      false);
}

std::string report_line(const char* which, const ReportFile& report) {
  const std::string short_of = report.whole ? "" : "; cut short: it has no summary";
  const std::string repeated =
      report.repeated > 0 ? fmt::format("; {} lines of an id that comes again, whose last counts", report.repeated)
                          : "";
  return fmt::format("<dt>{}</dt><dd>{}, {}{}{}</dd>", which, markup(report.title()),
                     markup(picture::without_folders(report.path)), short_of, repeated);
}

}  // namespace

double Change::error_change() const {
  const auto magnitude = [](const std::optional<double>& error) {
    return error && std::isfinite(*error) ? std::abs(*error) : 0;
  };
  return std::abs(magnitude(new_error) - magnitude(old_error));
}

ReportDiff diff(const ReportFile& before, const ReportFile& after) {
  ReportDiff result;
  result.header = differences(before.header, after.header);
  std::map<std::pair<std::string_view, std::string_view>, const Outcome*> earlier;
  for (const Outcome& outcome : before.outcomes) earlier[{outcome.id, outcome.variant}] = &outcome;
  for (const Outcome& now : after.outcomes) {
    const auto found = earlier.find({now.id, now.variant});
    if (found == earlier.end()) {
      ++result.only_new;
      continue;
    }
    const Outcome& then = *found->second;
    result.old_row.add(then);
    result.new_row.add(now);
    const Change change{now.id,
                        now.variant,
                        then.verdict,
                        now.verdict,
                        error_of(then, before.unit_roundoff),
                        error_of(now, after.unit_roundoff),
                        then.digest != now.digest};
    result.other_points += change.other_points ? 1 : 0;
    if (then.verdict == now.verdict) {
      if (change.old_error && change.new_error && change.error_change() > 0) result.errors.push_back(change);
    } else if (fails(now.verdict) && !fails(then.verdict)) {
      result.newly_failing.push_back(change);
    } else if (passes(now.verdict) && !passes(then.verdict)) {
      result.newly_passing.push_back(change);
    } else {
      result.otherwise.push_back(change);
    }
  }
  result.only_old = before.outcomes.size() - result.old_row.total;
  for (auto* changes : {&result.newly_failing, &result.newly_passing, &result.otherwise, &result.errors})
    sort_by_change(*changes);
  result.errors.resize(std::min(result.errors.size(), most_errors));
  return result;
}

std::string totals_text(const ReportDiff& diff) {
  std::string result =
      fmt::format("{} newly failing, {} newly passing, {} with another verdict; {} in both", diff.newly_failing.size(),
                  diff.newly_passing.size(), diff.otherwise.size(), diff.new_row.total);
  if (diff.only_old > 0) result += fmt::format(", {} in the old report only", diff.only_old);
  if (diff.only_new > 0) result += fmt::format(", {} in the new report only", diff.only_new);
  return result;
}

Lines diff_text(const ReportFile& before, const ReportFile& after, const ReportDiff& diff, std::size_t most) {
  Lines lines;
  add_report(lines, "old", before);
  add_report(lines, "new", after);
  add_header(lines, diff);
  add_verdicts(lines, diff);
  add_changes(lines, "newly failing", diff.newly_failing, most);
  add_changes(lines, "newly passing", diff.newly_passing, most);
  add_changes(lines, "another verdict", diff.otherwise, most);
  add_changes(lines, "same verdict, another error: the largest changes", diff.errors, most);
  lines.push_back("");
  if (diff.other_points > 0)
    lines.push_back(fmt::format("{} on other points", counted(diff.other_points, "case was put", "cases were put")));
  lines.push_back("errors are in parts of the largest coordinate");
  lines.push_back(totals_text(diff));
  return lines;
}

std::string diff_json(const ReportFile& before, const ReportFile& after, const ReportDiff& diff) {
  Json json = {{"schema", "fathom/diff/1"}, {"old", report_json(before)}, {"new", report_json(after)}};
  Json header = Json::object(), verdicts = Json::object();
  for (const HeaderDifference& difference : diff.header)
    header[difference.field] = Json{{"old", difference.old_value}, {"new", difference.new_value}};
  json["header"] = header;
  json["both"] = diff.new_row.total;
  json["only_old"] = diff.only_old;
  json["only_new"] = diff.only_new;
  json["other_points"] = diff.other_points;
  for (std::size_t i = 0; i < verdict_count; ++i) {
    const std::size_t then = diff.old_row.verdicts[i], now = diff.new_row.verdicts[i];
    if (then + now > 0) verdicts[name(static_cast<Verdict>(i))] = Json{{"old", then}, {"new", now}};
  }
  json["verdicts"] = verdicts;
  json["newly_failing"] = changes_json(diff.newly_failing);
  json["newly_passing"] = changes_json(diff.newly_passing);
  json["another_verdict"] = changes_json(diff.otherwise);
  json["largest_changes"] = changes_json(diff.errors);
  return json.text();
}

std::string diff_page(const ReportFile& before, const ReportFile& after, const ReportDiff& diff,
                      const std::string& version, const std::string& command) {
  std::string body =
      fmt::format("<header><h1>{} against {}</h1>\n<p class=\"answer\">{}</p>\n<dl>{}{}</dl>\n", markup(after.title()),
                  markup(before.title()), totals_text(diff), report_line("old", before), report_line("new", after));
  if (diff.other_points > 0)
    body += fmt::format(
        "<p class=\"warning\" role=\"note\">{} on other points: of another precision, or another case.</p>\n",
        counted(diff.other_points, "case was put", "cases were put"));
  body += "</header>\n<main>\n<section><h2>Verdicts</h2>\n" +
          picture::share_bar(verdict_shares(diff.old_row, {}), "old", "The old report") +
          picture::share_bar(verdict_shares(diff.new_row, {}), "new", "The new report") + verdict_table(diff) +
          "</section>\n";
  body += "<section><h2>How they were made</h2>\n" + header_section(diff) + "</section>\n";
  body += changes_section("Newly failing", diff.newly_failing, "No case that did not fail fails now.");
  body += changes_section("Newly passing", diff.newly_passing, "No case that did not pass passes now.");
  body += changes_section("Another verdict", diff.otherwise, "No other case changed its verdict.");
  body += changes_section("Same verdict, another error: the largest changes", diff.errors, "There are none.");
  body += fmt::format(
      "</main>\n<footer><p class=\"soft\">Compared by fathom {}. R is the largest coordinate of a pair.</p>\n<p "
      "class=\"soft\"><code>{}</code></p></footer>\n",
      markup(version), markup(picture::without_folders(command)));
  return picture::page(markup(after.title()) + ": what changed", body);
}

}  // namespace fathom::harness
