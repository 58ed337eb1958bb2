// SPDX-License-Identifier: GPL-3.0-or-later
// The table of verdicts by family.
#include <fmt/format.h>

#include "verify/harness/report/html.hpp"
#include "verify/harness/report/text.hpp"
#include "view/picture/markup.hpp"

namespace fathom::harness {
namespace {

constexpr std::size_t few_families = 12;  // shown without being asked for

std::string cell(const std::string& text) { return "<td>" + text + "</td>"; }

/// Text that refers to the table of cases, and narrows it down to a family and a verdict where scripts run.
std::string to_cases(const std::string& text, const std::string& find, const std::string& verdict) {
  return fmt::format("<a href=\"#all-cases\" data-of=\"cases\" data-find=\"{}\" data-choice=\"{}\">{}</a>", find, verdict, text);
}

std::string error_cells(const Errors& errors) {
  return errors.empty() ? cell("") + cell("") : cell(error_text(errors.worst())) + cell(error_text(errors.median()));
}

bool has_two_passes(const Tally& tally) { return tally.all()[Verdict::touching_by_convention] > 0; }

std::string row_element(const Tally::Line& line, const Tally& tally, const std::string& style) {
  const bool one_family = style.empty() && !line.label.starts_with('(');
  const std::string find = one_family ? markup(line.label) : "";
  const std::string label = one_family ? to_cases(markup(line.label), find, "") : markup(line.label);
  std::string result = fmt::format("<tr{}><th scope=\"row\">{}</th>{}", style, label, cell(fmt::format("{}", line.row.total)));
  if (has_two_passes(tally)) result += cell(fmt::format("{}", line.row.passes()));
  for (const Verdict verdict : tally.verdicts()) {
    const std::string count = line.row[verdict] > 0 ? fmt::format("{}", line.row[verdict]) : "";
    const bool linked = !count.empty() && (one_family || !style.empty());
    result += cell(linked ? to_cases(count, find, std::string(name(verdict))) : count);
  }
  if (!tally.all().relative.empty()) result += error_cells(line.row.relative);
  if (!tally.all().u_r.empty()) result += error_cells(line.row.u_r);
  return result + "</tr>\n";
}

}  // namespace

std::string tally_table(const Tally& tally) {
  if (tally.all().total == 0) return "";
  std::string head = "<th scope=\"col\" class=\"text\">family</th><th scope=\"col\">cases</th>";
  const auto add = [&](std::string_view text) { head += fmt::format("<th scope=\"col\">{}</th>", text); };
  if (has_two_passes(tally)) add("passes, of both kinds");
  for (const Verdict verdict : tally.verdicts()) add(name(verdict));
  if (!tally.all().relative.empty()) add("worst, relative"), add("median, relative");
  if (!tally.all().u_r.empty()) add("worst, in uR"), add("median, in uR");
  const std::vector<Tally::Line> lines = tally.lines();
  std::string rows = row_element({"all", tally.all()}, tally, " class=\"all\"");
  for (const Tally::Line& part : shown_parts(tally)) rows += row_element({"(" + part.label + ")", part.row}, tally, "");
  for (const Tally::Line& line : lines) rows += row_element(line, tally, "");
  const std::string table =
      fmt::format("<caption>Cases by family and verdict</caption>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody>", head, rows);
  return fmt::format(
      "<details class=\"part\"{}><summary>Families: {}</summary>\n<p class=\"soft\">Errors are those of the claimed depths, below 0 where "
      "the "
      "depth is too small; medians are of their magnitudes. u is the unit roundoff of the subject's precision, R the largest coordinate of "
      "a "
      "case.</p>\n{}</details>\n",
      lines.size() <= few_families ? " open=\"open\"" : "", lines.size(), picture::table_box("Verdicts by family", table, true));
}

}  // namespace fathom::harness
