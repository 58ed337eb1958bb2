// SPDX-License-Identifier: GPL-3.0-or-later
// Which failures the page shows: first the worst of each verdict, then the worst of each family, then the worst of all.
#include <algorithm>
#include <set>
#include <utility>

#include "verify/harness/report/html.hpp"
#include "verify/harness/report/worst.hpp"

namespace fathom::harness {

std::vector<std::size_t> failures_to_show(std::span<const Outcome> outcomes, std::size_t most) {
  std::vector<std::pair<double, std::size_t>> worst;
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    if (fails(outcomes[i].verdict)) worst.emplace_back(-badness(outcomes[i]), i);
  std::ranges::sort(worst);

  std::vector<std::size_t> chosen;
  std::set<std::size_t> taken;
  const auto choose = [&](const auto& is_new) {
    for (const auto& [bad, i] : worst)
      if (chosen.size() < most && !taken.contains(i) && is_new(outcomes[i])) chosen.push_back(i), taken.insert(i);
  };
  std::set<Verdict> verdicts;
  std::set<std::string> families;
  choose([&](const Outcome& outcome) {
    const bool is_new = verdicts.insert(outcome.verdict).second;
    if (is_new) families.insert(family_of(outcome.id));
    return is_new;
  });
  choose([&](const Outcome& outcome) { return families.insert(family_of(outcome.id)).second; });
  choose([](const Outcome&) { return true; });
  std::ranges::sort(chosen, {}, [&](std::size_t i) { return std::pair(-badness(outcomes[i]), i); });
  return chosen;
}

}  // namespace fathom::harness
