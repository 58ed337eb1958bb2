// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/study_page_parts.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/output/study_output.hpp"
#include "view/picture/markup.hpp"

namespace fathom::cli {
namespace {

using Counts = std::vector<std::pair<std::string, std::uint64_t>>;

std::string row_element(const CoincidenceRow& row) {
  const std::string lights = row.lights.empty() ? "" : fmt::format(" data-lights=\"{}\"", fmt::join(row.lights, " "));
  return fmt::format(
      "<tr data-kind=\"{0}\"{1}><th scope=\"row\">{0}</th><td>{2}</td><td class=\"name\">{3}</td><td class=\"name\">{4}</td></tr>\n",
      row.kind, lights, row.number, row.a, row.b);
}

std::string unlisted_text(const std::vector<CoincidenceRow>& rows, const Counts& counts) {
  std::vector<std::string> parts;
  for (const auto& [kind, count] : counts) {
    const auto listed = static_cast<std::uint64_t>(std::ranges::count(rows, kind, &CoincidenceRow::kind));
    if (listed < count) parts.push_back(fmt::format("{} of {}", count - listed, kind));
  }
  return parts.empty() ? "" : fmt::format("<p class=\"soft\">Not listed: {}; --all lists every one.</p>\n", fmt::join(parts, ", "));
}

std::string counts_list(const std::string& anchor, const Counts& counts) {
  std::string items;
  std::vector<std::string> none;
  for (const auto& [kind, count] : counts) {
    if (count == 0) none.push_back(kind);
    else
      items += fmt::format("<li><b>{0}</b> <a href=\"#{1}rows\" data-of=\"{1}rows\" data-find=\"\" data-choice=\"{2}\">{2}</a></li>", count,
                           anchor, kind);
  }
  std::string result = items.empty() ? "" : fmt::format("<ul class=\"legend\">{}</ul>\n", items);
  if (!none.empty()) result += fmt::format("<p class=\"soft\">none: {}</p>\n", fmt::join(none, ", "));
  return result;
}

}  // namespace

std::string Marks::of(bool of_a, const Feature& feature) {
  const auto found = ids_.find({of_a, feature});
  if (found != ids_.end()) return found->second;
  if (ids_.size() == most_) return "";
  return ids_[{of_a, feature}] = fmt::format("{}{}{}", anchor_, of_a ? "a" : "b", ids_.size() + 1);
}

std::string coincidences_part(const std::string& anchor, const std::vector<CoincidenceRow>& rows, const Counts& counts) {
  std::string result = counts_list(anchor, counts);
  if (rows.empty()) return result;
  std::string body;
  for (const CoincidenceRow& row : rows) body += row_element(row);
  std::vector<picture::Choice> kinds;
  for (const auto& [kind, count] : counts)
    if (count > 0) kinds.push_back({kind, kind});
  const std::string table = fmt::format(
      "<thead><tr><th scope=\"col\" class=\"text\">coincidence</th><th scope=\"col\">no.</th><th scope=\"col\" class=\"text\">of A</th>"
      "<th scope=\"col\" class=\"text\">of B</th></tr></thead>\n<tbody id=\"{}rows\">\n{}</tbody>",
      anchor, body);
  return result + picture::filter_bar(anchor + "rows", "coincidence", kinds) + picture::table_box("Coincidences", table, true) +
         unlisted_text(rows, counts);
}

std::string predicates_part(const PredicateCounts& counts) {
  std::string rows;
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    std::vector<std::string> decided;
    for (const auto& [packed, count] : counts[i].decided) decided.push_back(fmt::format("{}: {}", monomial_name(packed), count));
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td class=\"text\">{}</td></tr>\n",
                        spoken(predicate_names[i]), counts[i].calls, counts[i].exact, counts[i].zero,
                        picture::markup(fmt::format("{}", fmt::join(decided, ", "))));
  }
  const std::string table =
      "<thead><tr><th scope=\"col\" class=\"text\">predicate</th><th scope=\"col\">calls</th><th scope=\"col\">exact</th>"
      "<th scope=\"col\">zero</th><th scope=\"col\" class=\"text\">decided by</th></tr></thead>\n<tbody>\n" +
      rows + "</tbody>";
  return picture::table_box("What the perturbation decided", table, false) +
         "<p class=\"soft\">exact: calls that floating point could not decide; zero: those that are 0, which the perturbation then "
         "decided. Eij "
         "are the infinitesimals that move -A; a, b, c tilt the chart's frame.</p>\n";
}

}  // namespace fathom::cli
