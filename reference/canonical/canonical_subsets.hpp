// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the charts of one hemisphere.
// Output  pairs (A_i, B_i) of sets of edges: the arcs of every pair in A_i x B_i cross, hence the
//         two edges generate a facet of P (C2), and every pair whose arcs cross lies in one of them
//         (C3).                                                 [AGHRS, section 2.2, "Computing F"]
// Size    sum |A_i| + |B_i| = O((m + n) log^2(m + n)).               [AGHRS, (C5) and equation (1)]
// Departs from the paper: the tree T_A stores A's arcs and takes B's as queries (the text swaps
// them once); both trees stand on one
//         skeleton, the walls of both colours; T_A takes a query at the children of the nodes in
//         whose open strip it has an end, T_B at those nodes themselves, so that a crossing is
//         found once. Crossings are those of the perturbed diagrams.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "kernels/context.hpp"
#include "kernels/messages.hpp"
#include "reference/chart/chart.hpp"

namespace fathom::canonical {

/// A range [first, last) of elementary strips: strip i lies between walls i - 1 and i, the first
/// and the last one reach infinity.
struct Strip {
  std::uint32_t first, last;

  [[nodiscard]] bool within(Strip s) const { return s.first <= first && last <= s.last; }
  [[nodiscard]] bool overlaps(Strip s) const { return first < s.last && s.first < last; }
  /// Whether an end of this range lies strictly inside s.
  [[nodiscard]] bool ends_inside(Strip s) const {
    return (s.first < first && first < s.last) || (s.first < last && last < s.last);
  }
};

/// One (A_i, B_i), by the arcs of the chart. The arcs of colour `stored_of` are a canonical subset
/// of a node of T_A or T_B, in height order from the lowest to the highest; the others are the
/// queries to which the node's query returned it and that cross the stored arcs in one sense. All
/// stored arcs span `strip`, in which each query meets all of them. Queries that cross a stored arc
/// further left come first: the order is the same along every stored arc, so the crossings form a
/// grid.                                                              [proofs/canonical_subsets.md]
struct CanonicalPair {
  gaussian::Colour stored_of;
  bool rising;  ///< going right, the query arcs cross from below the stored ones to above them
  Strip strip;  ///< of the node of T_A or T_B: all crossings of the pair lie in it
  std::span<const chart::ChartArcOfA> a;
  std::span<const chart::ChartArcOfB> b;

  [[nodiscard]] std::uint64_t crossings() const { return std::uint64_t{a.size()} * b.size(); }
};

/// The family F = F^A and F^B of one hemisphere. Ids are stored once a node and once a query:
/// near-linear, however many crossings.
class CanonicalSubsets {
 public:
  [[nodiscard]] std::size_t size() const { return records_.size(); }
  [[nodiscard]] CanonicalPair operator[](std::size_t i) const;

  /// sum |A_i|, sum |B_i| and sum |A_i| |B_i|: the last is the number of crossings.
  struct Sums {
    std::uint64_t a = 0, b = 0, product = 0;
  };
  [[nodiscard]] Sums sums() const;

 private:
  friend class CanonicalBuilder;
  struct Range {
    std::uint64_t first, last;
  };
  struct Record {
    gaussian::Colour stored_of;
    bool rising;
    Strip strip;
    gaussian::PerColour<Range> arcs;
  };
  std::vector<chart::ChartArcOfA> a_;
  std::vector<chart::ChartArcOfB> b_;
  std::vector<Record> records_;
};

/// Reports the stage "canonical subsets".
CanonicalSubsets canonical_subsets(kernels::Context& context, const chart::Charts& charts);

/// The naive twin: all pairs (edge of A, edge of B) whose perturbed arcs cross in the hemisphere;
/// ascending. Tests every pair on the sphere, without the charts' walls and orders, under the
/// charts' perturbation.
std::vector<std::pair<gaussian::EdgeOfA, gaussian::EdgeOfB>> crossings_naive(const chart::Charts& charts);

/// C1: ids are arcs of the chart, each at most once in a set. C2, C3: the pairs are exactly the
/// crossings of the naive twin, each once. The strip: all stored arcs span it, and every crossing
/// lies in it. The grid: every pair crosses in the sense stated, stored arcs are in height order,
/// queries in their order along every stored arc. O(m n).
[[nodiscard]] kernels::Report validate(const CanonicalSubsets& subsets, const chart::Charts& charts);

}  // namespace fathom::canonical
