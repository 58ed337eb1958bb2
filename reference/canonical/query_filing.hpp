// SPDX-License-Identifier: GPL-3.0-or-later
// Files queries under the canonical subsets that they cross, in the order in which they cross the stored arcs. For canonical_subsets alone.
#pragma once

#include <bit>
#include <span>
#include <vector>

#include "reference/canonical/canonical_subsets.hpp"

namespace fathom::canonical {

/// The strips over which a chart arc runs. An end at infinity lies strictly inside no strip.
Strip strips_of(const chart::Charts& charts, gaussian::Colour colour, chart::ChartArcId arc);

/// The queries that one node of a segment tree has answered. Over the node's list of stored arcs stands a balanced tree in heap order,
/// whose subtrees are the canonical subsets.
class Filing {
 public:
  struct Entry {
    std::uint64_t subset;  ///< index in the heap, then the sense of crossing in the lowest bit
    chart::ChartArcId query;
  };

  Filing(const chart::Charts& charts, gaussian::Colour query_of);

  [[nodiscard]] bool empty() const { return entries_.empty(); }

  /// Files the query under the subsets that make up [low, high) of a list of `size` arcs.
  void file(std::size_t size, std::size_t low, std::size_t high, bool rising, chart::ChartArcId query) {
    const std::size_t leaves = std::bit_ceil(size);
    for (std::size_t first = leaves + low, last = leaves + high; first < last; first /= 2, last /= 2) {
      if (first % 2 == 1) entries_.push_back({2 * first++ + rising, query});
      if (last % 2 == 1) entries_.push_back({2 * --last + rising, query});
    }
  }

  /// Calls visit(first, last, rising, entries) for each subset [first, last) and sense that has entries, these in the order in which
  /// they cross the stored arcs from left to right. Afterwards nothing is filed.
  template <class Visit>
  void take(std::size_t size, Visit visit) {
    sort();
    const std::size_t leaves = std::bit_ceil(size);
    for (std::size_t i = 0, j = 0; i < entries_.size(); i = j) {
      while (j < entries_.size() && entries_[j].subset == entries_[i].subset) ++j;
      const std::size_t heap = entries_[i].subset / 2, width = leaves / std::bit_floor(heap);
      const std::size_t first = (heap - std::bit_floor(heap)) * width;
      visit(first, std::min(first + width, size), entries_[i].subset % 2 == 1, std::span<const Entry>(entries_).subspan(i, j - i));
    }
    entries_.clear();
  }

 private:
  void sort();

  kernels::IdVector<chart::ChartArcId, Strip> strips_;  // of the query colour's arcs
  std::vector<Entry> entries_;
};

}  // namespace fathom::canonical
