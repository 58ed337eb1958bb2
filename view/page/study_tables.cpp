// SPDX-License-Identifier: GPL-3.0-or-later
// "What coincided" and "Cost". Parts of parts.hpp.
#include <fmt/format.h>

#include <algorithm>

#include "view/page/parts.hpp"
#include "view/picture/markup.hpp"

namespace fathom::page {
namespace {

/// "parallel edges", for parallel_edges.
std::string spoken(std::string_view name) {
  std::string words(name);
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string features(const std::vector<std::vector<std::uint32_t>>& all) {
  std::string result;
  for (const std::vector<std::uint32_t>& feature : all) result += fmt::format("{}[{}]", result.empty() ? "" : " ", points(Data(feature)));
  return result;
}

std::string listed(const stages::StagedCoincidence& found) {
  std::string lines;
  for (const stages::StagedInvolved& involved : found.listed) {
    if (!involved.a.empty()) lines += "A " + features(involved.a);
    if (!involved.b.empty()) lines += (involved.a.empty() ? "B " : "  B ") + features(involved.b);
    for (std::size_t i = 0; i < involved.decided_by.size(); ++i)
      lines += (i == 0 ? "  decided by " : ", ") + picture::markup(involved.decided_by[i]);
    lines += '\n';
  }
  if (found.count > found.listed.size()) lines += fmt::format("and {} more\n", found.count - found.listed.size());
  return found.listed.empty() ? "" : on_demand("which", lines);
}

std::string decided(const stages::Stages& stages) {
  Table table("Zeros of the predicates, and what decided them", {"'predicate", "zeros", "'decided by"});
  for (const stages::StagedDecision& decision : stages.decided) {
    if (decision.zero == 0) continue;
    std::string by;
    for (const stages::StagedMonomial& monomial : decision.monomials)
      by += fmt::format("{}{} {}", by.empty() ? "" : ", ", picture::markup(monomial.name), monomial.count);
    table.add({spoken(decision.predicate), std::to_string(decision.zero), by});
  }
  return table.empty() ? "" : table.text();
}

double seconds_of(const stages::Stages& stages, std::string_view stage) {
  for (const auto& [name, seconds] : stages.seconds)
    if (name == stage) return seconds;
  return -1;
}

}  // namespace

std::string coincided(const stages::Stages& stages) {
  Table table("Coincidences", {"'name", "count", "'features"});
  for (const stages::StagedCoincidence& found : stages.coincidences)
    if (found.count > 0)
      table.add({spoken(found.kind), std::to_string(found.count), listed(found)}, fmt::format("data-kind=\"{}\"", found.kind));
  return (table.empty() ? "" : table.text()) + decided(stages);
}

std::string costs(const stages::Stages& stages) {
  if (stages.bounds.empty()) return "";
  std::vector<std::string_view> heads{"'stage", "'what", "count", "'bound", "its value", "'source"};
  if (!stages.seconds.empty()) heads.emplace_back("seconds");
  Table table("Counts beside the bounds of AGHRS, without their constants", heads);
  std::string_view before;
  for (const stages::StagedBound& bound : stages.bounds) {
    std::vector<std::string> cells{std::string(bound.stage),
                                   std::string(bound.what),
                                   std::to_string(bound.count),
                                   picture::markup(bound.bound),
                                   fmt::format("{:.4g}", bound.bound_value),
                                   picture::markup(bound.source)};
    const double seconds = bound.stage == before ? -1 : seconds_of(stages, bound.stage);
    if (!stages.seconds.empty()) cells.push_back(seconds < 0 ? "" : fmt::format("{:.4f}", seconds));
    table.add(cells);
    before = bound.stage;
  }
  return table.text();
}

std::string lead_coincided(const stages::Stages& stages) {
  const auto counts = [](const auto& found) { return found.count > 0; };
  if (stages.charts.empty()) return "What is in special position about these bodies, by name.";
  if (std::ranges::any_of(stages.coincidences, counts))
    return "What is in special position about these bodies, by name. Topology is decided as if -A were moved and the frame tilted by "
           "infinitely little, E11 to E33 and a, b, c; values never are.";
  return "Nothing: the bodies are in general position.";
}

std::string lead_cost(const stages::Stages& stages) {
  if (stages.bounds.empty()) return "The exact method of AGHRS did not run: there is nothing to count.";
  return stages.status == Status::penetrating
             ? "What the exact method did, in counts."
             : "What the exact method makes of these bodies, in counts; the search for closest lines is for bodies that overlap.";
}

}  // namespace fathom::page
