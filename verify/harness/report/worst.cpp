// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/report/worst.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace fathom::harness {

double badness(const Outcome& outcome) {
  constexpr double beyond = std::numeric_limits<double>::infinity();
  if (!outcome.judgement || !outcome.judgement->error_relative) return beyond;
  const double error = std::abs(*outcome.judgement->error_relative);
  return std::isnan(error) ? beyond : error;
}

std::map<Verdict, std::vector<std::size_t>> worst_failures(std::span<const Outcome> outcomes) {
  std::map<Verdict, std::vector<std::size_t>> result;
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    if (fails(outcomes[i].verdict)) result[outcomes[i].verdict].push_back(i);
  for (auto& [verdict, indices] : result)
    std::ranges::stable_sort(indices, std::greater{}, [&](std::size_t i) { return badness(outcomes[i]); });
  return result;
}

}  // namespace fathom::harness
