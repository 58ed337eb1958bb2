// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison of two reports for people at a terminal.
#include <fmt/format.h>

#include <algorithm>

#include "verify/harness/report/diff.hpp"
#include "verify/harness/report/text.hpp"

namespace fathom::harness {
namespace {

using Lines = std::vector<std::string>;

constexpr std::size_t longest_id = 60;  // characters

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
  if (changes.size() > most) lines.push_back(fmt::format("  {} more; --json and --html have all", changes.size() - most));
}

void add_header(Lines& lines, const ReportDiff& diff) {
  if (diff.header.empty()) return;
  lines.push_back("");
  lines.push_back("headers differ in");
  const auto shown = [](const std::string& value) { return value.empty() ? "nothing" : ascii(value); };
  for (const HeaderDifference& difference : diff.header)
    lines.push_back(fmt::format("  {}: {} -> {}", ascii(difference.field), shown(difference.old_value), shown(difference.new_value)));
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
    lines.push_back(fmt::format("     {} of an id that comes again; the last counts", count_text(report.repeated, "line", "lines")));
}

}  // namespace

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
    lines.push_back(fmt::format("{} on other points", count_text(diff.other_points, "case was put", "cases were put")));
  lines.push_back("errors are in parts of the largest coordinate");
  lines.push_back(totals_text(diff));
  return lines;
}

}  // namespace fathom::harness
