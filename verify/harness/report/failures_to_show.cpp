// SPDX-License-Identifier: GPL-3.0-or-later
// Which failures the page shows: first the worst of each verdict, then the worst of each family, then the worst of all.
#include <algorithm>
#include <set>

#include "verify/harness/report/html.hpp"
#include "verify/harness/tally.hpp"

namespace fathom::harness {

std::vector<std::size_t> failures_to_show(std::span<const Outcome> outcomes, std::size_t most) {
  const std::vector<std::size_t> worst = worst_first(outcomes);
  std::set<std::size_t> chosen;  // places in `worst`
  const auto choose = [&](const auto& is_new) {
    for (std::size_t k = 0; k < worst.size(); ++k)
      if (chosen.size() < most && !chosen.contains(k) && is_new(outcomes[worst[k]])) chosen.insert(k);
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
  std::vector<std::size_t> result;
  for (const std::size_t k : chosen) result.push_back(worst[k]);
  return result;
}

}  // namespace fathom::harness
