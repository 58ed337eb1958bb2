// SPDX-License-Identifier: GPL-3.0-or-later
// What a run did, in counts that do not depend on the machine.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string_view>

namespace fathom {

/// The predicates that decide the topology of the exact method, asked of directions on the sphere.
///                                                                         [docs/kernel_concept.md]
enum class Predicate {
  side_of_equator,    ///< in which hemisphere does a direction lie?
  x_order,            ///< which of two directions lies to the left in the chart?
  side_of_arc,        ///< on which side of a great circle does a direction lie?
  order_on_vertical,  ///< which of two arcs lies above the other on a vertical?
  order_at_infinity,  ///< the same, at the chart's left end
  count
};
/// In the order of Predicate.
inline constexpr std::array<std::string_view, static_cast<std::size_t>(Predicate::count)> predicate_names{
    "side_of_equator", "x_order", "side_of_arc", "order_on_vertical", "order_at_infinity"};

/// Calls of one predicate, by how far they went: filter, exact numbers, symbolic perturbation.
struct TierCounts {
  std::uint64_t calls = 0;  ///< all of them
  std::uint64_t exact = 0;  ///< of these, the filter was unsure
  std::uint64_t zero = 0;  ///< of these, the exact sign was zero: the input is degenerate, and the perturbation decided
  /// How many zeros each monomial in the infinitesimals decided. monomial_name of fathom/study.hpp
  /// reads the keys.
  std::map<std::uint64_t, std::uint64_t> decided;
};

/// in the order of Predicate
using PredicateCounts = std::array<TierCounts, static_cast<std::size_t>(Predicate::count)>;

/// Counters of one run; those of stages that did not run are 0. A crossing of arcs is an edge-edge
/// facet of P before coplanar ones merge.
struct Counters {
  std::uint64_t vertices_a = 0, vertices_b = 0, edges_a = 0, edges_b = 0, facets_a = 0, facets_b = 0;  ///< of the hulls
  std::uint64_t scans = 0;  ///< linear scans of the position test
  /// points that an expanding polytope took; of bounds, those that are its corners in the end
  std::uint64_t expansions = 0;
  std::uint64_t inner_facets = 0;                           ///< facets that it had in the end
  std::uint64_t support_calls = 0;                          ///< how often bounds of shapes asked for the support of P
  std::uint64_t vertex_facet_pairs = 0;                     ///< found
  std::uint64_t canonical_pairs = 0, sum_a = 0, sum_b = 0;  ///< number of (A_i, B_i), sum |A_i|, sum |B_i|
  std::uint64_t crossings = 0;                              ///< sum |A_i| |B_i|
  std::uint64_t pairs_evaluated = 0;                        ///< pairs of lines whose distance was looked at
  std::uint64_t pairs_exact = 0;                            ///< of these, compared in exact arithmetic
  std::uint64_t grids_cut = 0;      ///< canonical pairs that were cut; all others were scanned or cleared whole
  std::uint64_t cells = 0;          ///< cells of cuttings
  std::uint64_t block_tests = 0;    ///< blocks (cell x run, or cell x line) put to the vertex test
  std::uint64_t vertex_clears = 0;  ///< of these, cleared by it
  std::uint64_t frame_tests = 0, frame_clears = 0;  ///< blocks put to the frame test, and cleared by it
  /// of those not cleared: put to it in wide floats, and cleared by that
  std::uint64_t wide_tests = 0, wide_clears = 0;
  std::uint64_t offset_blocks = 0;      ///< of those still not cleared: done by the offset test
  std::uint64_t offset_pairs = 0;       ///< pairs of these that it left to be looked at
  std::uint64_t quota_checks = 0;       ///< conflict lists that were counted
  std::uint64_t quota_refinements = 0;  ///< of these, over the quota: the cell was refined
  std::uint64_t few_cells = 0;          ///< of these, over the quota, but the cell too small to be refined
  std::uint64_t seed = 0;               ///< of the closest lines' random order
  std::uint64_t rays = 0;               ///< shot through P
  std::uint64_t facets_visited = 0;     ///< facets of P that a walk near O went through
  PredicateCounts predicates{};         ///< calls of each
};

}  // namespace fathom
