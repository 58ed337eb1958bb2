// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the charts of one hemisphere.
// Output  pairs (A_i, B_i) of sets of edges: every pair in A_i x B_i has crossing arcs, hence generates a facet of P (C2), and every
//         pair with crossing arcs lies in one of them (C3).                                    [AGHRS, section 2.2, "Computing F"]
// Size    sum |A_i| + |B_i| = O((m + n) log^2(m + n)).                                         [AGHRS, (C5) and equation (1)]
// Departs from the paper: the tree T_A stores A's arcs and takes B's as queries (the text swaps them once); both trees stand on one
//         skeleton, the walls of both colours; T_A takes a query at the children of the nodes in whose open strip it has an end, T_B at
//         those nodes themselves, so that a crossing is found once. Crossings are those of the perturbed diagrams.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "kernels/report.hpp"
#include "reference/chart/chart.hpp"

namespace fathom {

/// One (A_i, B_i): `stored` is a canonical subset of a node of T_A or T_B, in height order from the lowest arc to the highest; `queries`
/// are edges of the other body for which the node's query returned it, and whose arcs cross the stored ones in one sense. All stored
/// arcs span one strip, in which each query meets all of them. Queries that cross a stored arc further left come first: the order is the
/// same along every stored arc, so the crossings form a grid.                                     [proofs/canonical_subsets.md]
struct CanonicalPair {
  Colour stored_of;
  bool rising;  ///< going right, the query arcs cross from below the stored ones to above them
  std::span<const std::uint32_t> stored, queries;

  [[nodiscard]] std::span<const std::uint32_t> edges_of_a() const { return stored_of == Colour::a ? stored : queries; }
  [[nodiscard]] std::span<const std::uint32_t> edges_of_b() const { return stored_of == Colour::a ? queries : stored; }
};

/// The family F = F^A and F^B of one hemisphere. Edge ids are stored once a node and once a query: near-linear, however many crossings.
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
  struct Record {
    Colour stored_of;
    bool rising;
    std::uint64_t stored_begin, stored_end, queries_begin, queries_end;
  };
  std::vector<std::uint32_t> stored_, queries_;
  std::vector<Record> records_;
};

/// `keep_going` is called now and then with the share done; if it returns false, the rest is left out.
CanonicalSubsets canonical_subsets(Context& context, const Charts& charts, const std::function<bool(double)>& keep_going = {});

/// The naive twin: all pairs (edge of A, edge of B) whose perturbed arcs cross in the hemisphere; ascending. Tests every pair on the
/// sphere, without the charts' walls and orders, under the charts' perturbation.
std::vector<std::pair<std::uint32_t, std::uint32_t>> crossings_naive(const Charts& charts);

/// C1: indices are edges, each at most once in a set. C2, C3: the pairs are exactly the crossings of the naive twin, each once. The grid:
/// every pair crosses in the sense stated, stored arcs are in height order, and queries in their order along every stored arc. O(m n).
[[nodiscard]] Report validate(const CanonicalSubsets& subsets, const Charts& charts);

}  // namespace fathom
