// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/context.hpp"

namespace fathom {

PredicateCounts operator-(const PredicateCounts& now, const PredicateCounts& before) {
  PredicateCounts result;
  for (std::size_t i = 0; i < now.size(); ++i) {
    result[i] = {now[i].calls - before[i].calls, now[i].exact - before[i].exact, now[i].zero - before[i].zero, {}};
    for (const auto& [monomial, count] : now[i].decided) {
      const auto old = before[i].decided.find(monomial);
      const std::uint64_t since = count - (old == before[i].decided.end() ? 0 : old->second);
      if (since > 0) result[i].decided.emplace(monomial, since);
    }
  }
  return result;
}

PredicateCounts& operator+=(PredicateCounts& sum, const PredicateCounts& more) {
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i].calls += more[i].calls;
    sum[i].exact += more[i].exact;
    sum[i].zero += more[i].zero;
    for (const auto& [monomial, count] : more[i].decided) sum[i].decided[monomial] += count;
  }
  return sum;
}

Counters& operator+=(Counters& sum, const Counters& more) {
  for (const auto field : {&Counters::vertices_a,      &Counters::vertices_b,
                           &Counters::edges_a,         &Counters::edges_b,
                           &Counters::facets_a,        &Counters::facets_b,
                           &Counters::scans,           &Counters::expansions,
                           &Counters::inner_facets,    &Counters::vertex_facet_pairs,
                           &Counters::canonical_pairs, &Counters::sum_a,
                           &Counters::sum_b,           &Counters::crossings,
                           &Counters::pairs_evaluated, &Counters::pairs_exact,
                           &Counters::grids_cut,       &Counters::cells,
                           &Counters::block_tests,     &Counters::vertex_clears,
                           &Counters::frame_tests,     &Counters::frame_clears,
                           &Counters::wide_tests,      &Counters::wide_clears,
                           &Counters::offset_blocks,   &Counters::offset_pairs,
                           &Counters::quota_checks,    &Counters::quota_refinements,
                           &Counters::few_cells,       &Counters::rays,
                           &Counters::facets_visited}) {
    sum.*field += more.*field;
  }
  sum.predicates += more.predicates;
  return sum;
}

}  // namespace fathom
