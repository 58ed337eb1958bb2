// SPDX-License-Identifier: GPL-3.0-or-later
// The table of verdicts by family.
#include <fmt/format.h>

#include "verify/harness/report/html_parts.hpp"
#include "verify/harness/report/markup.hpp"
#include "verify/harness/report/subject_text.hpp"

namespace fathom::harness {
namespace {

std::string cell(const std::string& text) { return "<td>" + text + "</td>"; }

std::string error_cells(const Errors& errors) {
  return errors.empty() ? cell("") + cell("") : cell(error_text(errors.worst())) + cell(error_text(errors.median()));
}

std::string row_element(const Tally::Line& line, const Tally& tally, const std::string& style) {
  std::string result = fmt::format("<tr{}><th scope=\"row\">{}</th>{}", style, markup(line.label), cell(fmt::format("{}", line.row.total)));
  for (const Verdict verdict : tally.verdicts()) result += cell(line.row[verdict] > 0 ? fmt::format("{}", line.row[verdict]) : "");
  if (!tally.all().relative.empty()) result += error_cells(line.row.relative);
  if (!tally.all().u_r.empty()) result += error_cells(line.row.u_r);
  return result + "</tr>\n";
}

}  // namespace

std::string tally_table(const Tally& tally) {
  std::string head = "<th scope=\"col\" class=\"text\">family</th><th scope=\"col\">cases</th>";
  const auto add = [&](std::string_view text) { head += fmt::format("<th scope=\"col\">{}</th>", text); };
  for (const Verdict verdict : tally.verdicts()) add(name(verdict));
  if (!tally.all().relative.empty()) add("worst, relative"), add("median, relative");
  if (!tally.all().u_r.empty()) add("worst, in uR"), add("median, in uR");
  std::string rows = row_element({"all", tally.all()}, tally, " class=\"all\"");
  for (const Tally::Line& line : tally.lines()) rows += row_element(line, tally, "");
  return fmt::format(
      "<p class=\"soft\">Errors are those of the claimed depths, below 0 where the depth is too small; medians are of their magnitudes. u "
      "is "
      "the unit roundoff of the subject's precision, R the largest coordinate of a case.</p>\n<div class=\"wide\" tabindex=\"0\" "
      "role=\"region\" aria-label=\"Verdicts by family\"><table><caption>Cases by family and verdict</caption>\n"
      "<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
      head, rows);
}

}  // namespace fathom::harness
