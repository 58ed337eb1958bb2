// SPDX-License-Identifier: GPL-3.0-or-later
// The counters by name and stage, in the order in which results list them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "fathom/counters.hpp"

namespace fathom::kernels {

struct Count {
  std::string_view name;
  std::uint64_t value;
};

/// The counters of one stage of a run, but those of the predicates. It has run if any of them is not 0.
struct StageCounts {
  std::string_view stage;
  std::vector<Count> counts;
  [[nodiscard]] bool ran() const {
    return std::ranges::any_of(counts, [](const Count& count) { return count.value != 0; });
  }
};

inline std::vector<StageCounts> counts_by_stage(const Counters& c) {
  return {
      {"hulls",
       {{"vertices_a", c.vertices_a},
        {"vertices_b", c.vertices_b},
        {"edges_a", c.edges_a},
        {"edges_b", c.edges_b},
        {"facets_a", c.facets_a},
        {"facets_b", c.facets_b}}},
      {"position", {{"scans", c.scans}}},
      {"expanding polytope", {{"expansions", c.expansions}, {"inner_facets", c.inner_facets}}},
      {"supports", {{"support_calls", c.support_calls}}},
      {"vertex-facet pairs", {{"vertex_facet_pairs", c.vertex_facet_pairs}}},
      {"canonical subsets", {{"canonical_pairs", c.canonical_pairs}, {"sum_a", c.sum_a}, {"sum_b", c.sum_b}, {"crossings", c.crossings}}},
      {"closest lines",
       {{"pairs_evaluated", c.pairs_evaluated},
        {"pairs_exact", c.pairs_exact},
        {"grids_cut", c.grids_cut},
        {"cells", c.cells},
        {"block_tests", c.block_tests},
        {"vertex_clears", c.vertex_clears},
        {"frame_tests", c.frame_tests},
        {"frame_clears", c.frame_clears},
        {"wide_tests", c.wide_tests},
        {"wide_clears", c.wide_clears},
        {"offset_blocks", c.offset_blocks},
        {"offset_pairs", c.offset_pairs},
        {"quota_checks", c.quota_checks},
        {"quota_refinements", c.quota_refinements},
        {"few_cells", c.few_cells},
        {"seed", c.seed}}},
      {"rays", {{"rays", c.rays}, {"facets_visited", c.facets_visited}}},
  };
}

}  // namespace fathom::kernels
