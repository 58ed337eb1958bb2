// SPDX-License-Identifier: GPL-3.0-or-later
// Studies for people: a block for one case, a line for each case of a stream.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "cli/io/terminal.hpp"
#include "cli/output/decimal.hpp"
#include "cli/output/study_output.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/numbers.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t most_monomials = 6;
constexpr std::size_t most_indices = 12;
constexpr std::size_t longest_exact = 40;
constexpr std::size_t decided_column = 52, features_column = 32, none_column = 6;

using Lines = std::vector<std::string>;

std::string count_text(std::uint64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// With the gap to the column before.
std::string decided_text(const TierCounts& tiers) {
  Lines parts;
  for (const auto& [packed, count] : tiers.decided) {
    if (parts.size() == most_monomials) {
      parts.emplace_back("...");
      break;
    }
    parts.push_back(fmt::format("{}: {}", monomial_name(packed), count));
  }
  return parts.empty() ? "" : fmt::format("  {}", fmt::join(parts, ", "));
}

void add_predicates(Lines& lines, const PredicateCounts& counts) {
  bool any = false;
  lines.push_back(fitted(fmt::format("{:<18}{:>12}{:>10}{:>10}  {}", "predicate", "calls", "exact", "zero", "decided by"), decided_column));
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    const TierCounts& tiers = counts[i];
    lines.push_back(fitted(
        fmt::format("{:<18}{:>12}{:>10}{:>10}{}", spoken(predicate_names[i]), tiers.calls, tiers.exact, tiers.zero, decided_text(tiers)),
        decided_column));
    any = any || tiers.zero > 0;
  }
  if (any) lines.push_back(fitted("Eij are the infinitesimals that move -A; a, b, c tilt the chart's frame"));
}

void add_features(Lines& parts, std::string_view body, const std::vector<Feature>& features) {
  for (const Feature& points : features) {
    const std::size_t shown = std::min(points.size(), most_indices);
    parts.push_back(fmt::format("{} {}{}", body, fmt::join(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(shown), " "),
                                shown < points.size() ? fmt::format(" ... ({} in all)", points.size()) : ""));
  }
}

/// "A 0 1, B 4 5": the input points of each feature.
std::string involved_text(const Involved& involved) {
  Lines parts;
  add_features(parts, "A", involved.a);
  add_features(parts, "B", involved.b);
  return fmt::format("{}", fmt::join(parts, ", "));
}

void add_coincidences(Lines& lines, const Study& study, bool all) {
  Lines absent;
  lines.push_back(
      fitted(fmt::format("{:<22}{:>8}  {}", "coincidence", "count", all ? "points of the features" : "points of the first's features"),
             features_column));
  for (std::size_t i = 0; i < coincidence_names.size(); ++i) {
    const auto& [count, listed] = study.coincidences[i];
    if (count == 0) {
      absent.push_back(spoken(coincidence_names[i]));
      continue;
    }
    lines.push_back(fitted(
        fmt::format("{:<22}{:>8}{}", spoken(coincidence_names[i]), count, listed.empty() ? "" : "  " + involved_text(listed.front())),
        features_column));
    if (!all) continue;
    for (std::size_t k = 1; k < listed.size(); ++k)
      lines.push_back(fitted(fmt::format("{:{}}{}", "", features_column, involved_text(listed[k])), features_column));
  }
  if (!absent.empty()) lines.push_back(fitted(fmt::format("none: {}", fmt::join(absent, ", ")), none_column));
}

}  // namespace

std::string size_text(const BodySize& size) {
  return fmt::format("{}, {}, {}{}", count_text(size.vertices, "vertex", "vertices"), count_text(size.edges, "edge", "edges"),
                     count_text(size.facets, "facet", "facets"), size.rank < 3 ? "; flat" : "");
}

std::string status_text(const Depth& depth) {
  std::string result(name(depth.status()));
  if (depth.status() != Status::penetrating) return result;
  const std::string squared = exact_text(depth.squared());
  result += squared.size() <= longest_exact ? "; depth^2 " + squared : "; depth " + root_text(depth.squared());
  return result + "; " + count_text(depth.optima().size(), "optimum", "optima");
}

std::string spoken(std::string_view name) {
  std::string result(name);
  std::ranges::replace(result, '_', ' ');
  if (result.ends_with(" of a")) result.back() = 'A';
  if (result.ends_with(" of b")) result.back() = 'B';
  return result;
}

std::string study_block(const Study& study, bool all) {
  Lines lines{fitted(status_text(study.depth), body_column), fitted("A  " + size_text(study.a), body_column),
              fitted("B  " + size_text(study.b), body_column), ""};
  add_predicates(lines, study.predicates);
  lines.emplace_back();
  add_coincidences(lines, study, all);
  return fmt::format("{}", fmt::join(lines, "\n"));
}

std::string study_line(const std::string& id, const Study& study) {
  Lines parts{status_text(study.depth)};
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    const TierCounts& tiers = study.predicates[i];
    if (tiers.zero > 0) parts.push_back(fmt::format("{} {} of {} zero", spoken(predicate_names[i]), tiers.zero, tiers.calls));
  }
  for (std::size_t i = 0; i < coincidence_names.size(); ++i) {
    if (study.coincidences[i].count > 0) parts.push_back(fmt::format("{} {}", spoken(coincidence_names[i]), study.coincidences[i].count));
  }
  return case_line(id, parts);
}

}  // namespace fathom::cli
