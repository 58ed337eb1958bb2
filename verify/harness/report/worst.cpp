// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <tuple>

#include "verify/harness/tally.hpp"

namespace fathom::harness {

double badness(const Outcome& outcome) {
  constexpr double beyond = std::numeric_limits<double>::infinity();
  if (!outcome.judgement || !outcome.judgement->error_relative) return beyond;
  const double error = std::abs(*outcome.judgement->error_relative);
  return std::isnan(error) ? beyond : error;
}

std::vector<std::size_t> worst_first(std::span<const Outcome> outcomes) {
  std::vector<std::size_t> failures;
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    if (fails(outcomes[i].verdict)) failures.push_back(i);
  std::ranges::sort(failures, {}, [&](std::size_t i) {
    const Outcome& outcome = outcomes[i];
    return std::tuple(-badness(outcome), std::string_view(outcome.id), std::string_view(outcome.variant), i);
  });
  return failures;
}

std::map<Verdict, std::vector<std::size_t>> worst_failures(std::span<const Outcome> outcomes) {
  std::map<Verdict, std::vector<std::size_t>> result;
  for (const std::size_t i : worst_first(outcomes)) result[outcomes[i].verdict].push_back(i);
  return result;
}

}  // namespace fathom::harness
