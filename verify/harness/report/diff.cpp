// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/report/diff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

namespace fathom::harness {
namespace {

/// In parts of R.
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

}  // namespace

double Change::error_change() const {
  const auto magnitude = [](const std::optional<double>& error) { return error && std::isfinite(*error) ? std::abs(*error) : 0; };
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
  for (auto* changes : {&result.newly_failing, &result.newly_passing, &result.otherwise, &result.errors}) sort_by_change(*changes);
  result.errors.resize(std::min(result.errors.size(), most_errors));
  return result;
}

std::string totals_text(const ReportDiff& diff) {
  std::string result = fmt::format("{} newly failing, {} newly passing, {} with another verdict; {} in both", diff.newly_failing.size(),
                                   diff.newly_passing.size(), diff.otherwise.size(), diff.new_row.total);
  if (diff.only_old > 0) result += fmt::format(", {} in the old report only", diff.only_old);
  if (diff.only_new > 0) result += fmt::format(", {} in the new report only", diff.only_new);
  return result;
}

}  // namespace fathom::harness
