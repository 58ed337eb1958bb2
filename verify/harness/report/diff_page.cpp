// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison of two reports as a page.
#include <fmt/format.h>

#include <algorithm>

#include "verify/harness/report/diff.hpp"
#include "verify/harness/report/html.hpp"
#include "verify/harness/report/text.hpp"
#include "view/picture/markup.hpp"

namespace fathom::harness {
namespace {

constexpr std::size_t most_listed = 5000;

std::string error_cell(const std::optional<double>& error) { return error ? error_text(*error) : ""; }

std::string row(const Change& change) {
  return fmt::format(
      "<tr><th scope=\"row\" class=\"id\">{}</th><td class=\"name\">{}</td><td class=\"name\">{}</td><td>{}</td><td>{}</td><td "
      "class=\"name\">{}</td></tr>\n",
      markup(shown_id(change.id, change.variant)), name(change.old_verdict), name(change.new_verdict), error_cell(change.old_error),
      error_cell(change.new_error), change.other_points ? "other points" : "");
}

std::string changes_section(const std::string& title, const std::vector<Change>& changes, const char* empty) {
  std::string rows;
  const std::size_t listed = std::min(changes.size(), most_listed);
  for (std::size_t i = 0; i < listed; ++i) rows += row(changes[i]);
  const std::string table = fmt::format(
      "<thead><tr><th scope=\"col\" class=\"text\">case</th><th scope=\"col\" class=\"text\">old</th><th scope=\"col\" "
      "class=\"text\">new</th><th scope=\"col\">old error / R</th><th scope=\"col\">new error / R</th><th scope=\"col\" "
      "class=\"text\"></th></tr></thead>\n<tbody>{}</tbody>",
      rows);
  const std::string more = changes.size() > listed ? fmt::format("<p>{} more: --json has all.</p>\n", changes.size() - listed) : "";
  return fmt::format("<section><h2>{}</h2>\n{}{}</section>\n", title,
                     changes.empty() ? fmt::format("<p>{}</p>\n", empty) : picture::table_box(title, table, true), more);
}

std::string header_section(const ReportDiff& diff) {
  if (diff.header.empty()) return "<p>The headers are the same: subject, version, settings, tolerance, and fathom.</p>\n";
  std::string rows;
  for (const HeaderDifference& difference : diff.header)
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td class=\"text\">{}</td></tr>\n",
                        markup(difference.field), markup(difference.old_value), markup(difference.new_value));
  return picture::table_box("Headers",
                            "<thead><tr><th scope=\"col\" class=\"text\">header</th><th scope=\"col\" class=\"text\">old</th><th "
                            "scope=\"col\" class=\"text\">new</th></tr></thead>\n<tbody>" +
                                rows + "</tbody>",
                            false);
}

std::string verdict_table(const ReportDiff& diff) {
  std::string rows;
  for (std::size_t i = verdict_count; i-- > 0;) {
    const auto then = static_cast<long long>(diff.old_row.verdicts[i]), now = static_cast<long long>(diff.new_row.verdicts[i]);
    if (then + now > 0)
      rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n", name(static_cast<Verdict>(i)), then, now,
                          now == then ? "" : fmt::format("{:+}", now - then));
  }
  return picture::table_box("Verdicts",
                            "<thead><tr><th scope=\"col\" class=\"text\">cases of both</th><th scope=\"col\">old</th><th "
                            "scope=\"col\">new</th><th scope=\"col\">change</th></tr></thead>\n<tbody>" +
                                rows + "</tbody>",
                            false);
}

std::string report_line(const char* which, const ReportFile& report) {
  const std::string short_of = report.whole ? "" : "; cut short: it has no summary";
  const std::string repeated =
      report.repeated > 0 ? fmt::format("; {} lines of an id that comes again, whose last counts", report.repeated) : "";
  return fmt::format("<dt>{}</dt><dd>{}, {}{}{}</dd>", which, markup(report.title()), markup(picture::without_folders(report.path)),
                     short_of, repeated);
}

}  // namespace

std::string diff_page(const ReportFile& before, const ReportFile& after, const ReportDiff& diff, const std::string& version,
                      const std::string& command) {
  std::string body = fmt::format("<header><h1>{} against {}</h1>\n<p class=\"answer\">{}</p>\n<dl>{}{}</dl>\n", markup(after.title()),
                                 markup(before.title()), totals_text(diff), report_line("old", before), report_line("new", after));
  if (diff.other_points > 0)
    body += fmt::format("<p class=\"warning\" role=\"note\">{} on other points: of another precision, or another case.</p>\n",
                        count_text(diff.other_points, "case was put", "cases were put"));
  body += "</header>\n<main>\n<section><h2>Verdicts</h2>\n" +
          picture::share_bar(verdict_shares(diff.old_row, {}), "old", "The old report") +
          picture::share_bar(verdict_shares(diff.new_row, {}), "new", "The new report") + verdict_table(diff) + "</section>\n";
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
