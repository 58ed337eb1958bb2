// SPDX-License-Identifier: GPL-3.0-or-later
// The counters by name, in the order in which results list them.
#pragma once

#include <cstdint>
#include <string_view>

#include "kernels/counters.hpp"

namespace fathom::cli {

/// Calls f(name, count) for every counter but those of the predicates.
template <class F>
void for_each_count(const Counters& counters, F f) {
  f("vertices_a", counters.vertices_a);
  f("vertices_b", counters.vertices_b);
  f("edges_a", counters.edges_a);
  f("edges_b", counters.edges_b);
  f("facets_a", counters.facets_a);
  f("facets_b", counters.facets_b);
  f("scans", counters.scans);
  f("expansions", counters.expansions);
  f("inner_facets", counters.inner_facets);
  f("vertex_facet_pairs", counters.vertex_facet_pairs);
  f("canonical_pairs", counters.canonical_pairs);
  f("sum_a", counters.sum_a);
  f("sum_b", counters.sum_b);
  f("crossings", counters.crossings);
  f("pairs_evaluated", counters.pairs_evaluated);
  f("pairs_exact", counters.pairs_exact);
  f("grids_cut", counters.grids_cut);
  f("cells", counters.cells);
  f("block_tests", counters.block_tests);
  f("vertex_clears", counters.vertex_clears);
  f("frame_tests", counters.frame_tests);
  f("frame_clears", counters.frame_clears);
  f("quota_checks", counters.quota_checks);
  f("quota_refinements", counters.quota_refinements);
  f("few_cells", counters.few_cells);
  f("seed", counters.seed);
  f("rays", counters.rays);
  f("facets_visited", counters.facets_visited);
}

}  // namespace fathom::cli
