// SPDX-License-Identifier: GPL-3.0-or-later
// Input   half-spaces <n,x> >= h.
// Output  the point nearest to O that lies in all of them, exactly; or that none does. An LP-type
//         problem of dimension 3, by the incremental algorithm of Seidel (1991), whose constraints
//         come in the order given. Points are computed by Cramer's rule from the at most three
//         planes that hold them, so that numbers do not grow.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "fathom/union.hpp"
#include "kernels/context.hpp"
#include "kernels/filters/meeting_points.hpp"
#include "reference/unions/pair_table.hpp"
#include "reference/unions/pieces.hpp"

namespace fathom::unions {

/// The point set { x : <normal, x> >= height }.
template <class Numbers>
using BarrierIn = const kernels::OrientedPlaneIn<Numbers>*;
using Barrier = BarrierIn<kernels::AnyNumbers>;
template <class Numbers>
using BarriersIn = std::type_identity_t<std::span<const BarrierIn<Numbers>>>;
/// A squared distance, or null.
template <class Numbers>
using LimitIn = const std::type_identity_t<kernels::SquaredDistanceIn<Numbers>>*;

/// What a search for the nearest point found.
enum class CellEnd {
  found,       ///< the point
  beyond,      ///< all points are farther away than the limit
  infeasible,  ///< there is none
};

/// Finds the point of the plane of `wall` nearest to O that lies in all `barriers`: the nearest of
/// the cell that they and `wall` make, if the nearest point without `wall` lies strictly below its
/// plane. `limit` may be null; it ends the search early. `nearest` is set if the point is found.
/// All coordinates are of size about 2^exponent. If the end is infeasible and `conflict` is not
/// null, it gets at most four of the half-spaces, `wall` among them, that have no common point by
/// themselves.
template <class Numbers>
CellEnd nearest_on_wall(BarrierIn<Numbers> wall, BarriersIn<Numbers> barriers, LimitIn<Numbers> limit, long exponent,
                        kernels::RationalPointIn<Numbers>& nearest,
                        std::type_identity_t<std::vector<BarrierIn<Numbers>>>* conflict = nullptr);

/// Finds the point nearest to O in all `barriers`.
template <class Numbers>
CellEnd nearest_in_cell(BarriersIn<Numbers> barriers, long exponent, kernels::RationalPointIn<Numbers>& nearest);

// Input   the pieces of two unions, on one lattice.
// Output  the least squared length of a translation t of A that lies in the interior of no P_ij,
//         and all such t. A branch-and-bound search over cells of half-spaces, by their exact
//         points nearest to O: the cell whose point is nearest comes first. If that point lies in
//         the interior of a P_ij, the facets of a polytope inside P_ij split the rest of the cell.
//         [proofs/unions.md]

/// An ongoing search. `Numbers`: the integers that hold all of it.
template <class Numbers>
class UnionSearchIn {
 public:
  using Place = kernels::RationalPointIn<Numbers>;
  using Pair = PiecePairIn<Numbers>;
  using Facet = PieceFacetIn<Numbers>;
  using Wall = BarrierIn<Numbers>;
  using Distance = kernels::SquaredDistanceIn<Numbers>;

  /// `pieces` must outlive it. If `all_pairs`, each point is asked of all of them.
  explicit UnionSearchIn(const PlacedPieces& pieces, bool all_pairs = false);

  /// Whether O itself lies in the interior of no P_ij.
  bool starts_free();
  /// Takes a point for an answer if it lies in the interior of no P_ij and is not farther than
  /// those before.
  void offer(const Place& p);
  /// Walks greedily to a free point, and offers it.
  void dive();
  /// Searches to the end. Returns false if the context stopped it; then squared_low() and best()
  /// enclose the answer.
  bool run(kernels::Context& context);

  /// The squared distance of the nearest free point so far; at the end the nearest there is.
  [[nodiscard]] const std::optional<Distance>& best() const { return best_; }
  /// At the end: all nearest free points.
  [[nodiscard]] const std::vector<Place>& optima() const { return optima_; }
  /// The squared distances of best(), and of a bound below all free points, in the unit of the
  /// input.
  [[nodiscard]] std::optional<mpq_class> squared_best() const;
  [[nodiscard]] mpq_class squared_low() const;
  [[nodiscard]] UnionCounters counts() const;
  [[nodiscard]] PairTableIn<Numbers>& table() { return table_; }
  /// The facets of Q that a cell's point has to pass in the cell, nearest first, each with its
  /// nearest point; every one supports P_ij. No facet that is left out lets a point of the cell
  /// pass that is as near as best().
  struct OpenFacet {
    Facet* facet;
    Place nearest;
  };
  std::vector<OpenFacet> open_facets(Pair& pair, std::span<const Wall> cell);
  /// A pair in whose interior a point lies, the deepest of those compared; or null if it is free.
  Pair* deepest(const Place& p);
  /// How a cell's nearest point is found when it is cut by one more wall, with best() as the limit.
  CellEnd cut(std::span<const Wall> cell, Wall wall, Place& nearest);

 private:
  struct Link {
    Wall barrier;
    std::uint32_t before;
  };
  struct Cell {
    Place nearest;
    std::uint32_t link;
  };
  static constexpr std::uint32_t none = UINT32_MAX;

  static bool is_farther(const Cell& x, const Cell& y) { return x.nearest.image_square > y.nearest.image_square; }

  void push(Place nearest, std::uint32_t link);
  Cell pop();
  void split(const Cell& cell);
  void collect(std::uint32_t link);
  [[nodiscard]] std::string stage() const;
  bool is_free(const Place& p);
  void accept(const Place& p);

  const PlacedPieces& pieces_;
  PairTableIn<Numbers> table_;
  Pair* last_ = nullptr;  // that held a point
  std::vector<Link> links_;
  std::vector<Cell> open_;  // a heap
  std::vector<Wall> cell_;
  std::optional<Distance> best_;
  std::vector<Place> optima_;
  UnionCounters counts_;
};
using UnionSearch = UnionSearchIn<kernels::AnyNumbers>;

/// Whether p = q.
template <class Numbers>
bool same_point(const kernels::RationalPointIn<Numbers>& p, const kernels::RationalPointIn<Numbers>& q);

/// How the twins of union_depth work; as it does by default.
struct UnionWork {
  bool any_size = false;   ///< in integers of any size, also where those of a fixed size would do
  bool all_pairs = false;  ///< no pair is left out because of its box
  Lattices lattices = Lattices::fitting;
};
UnionDepth union_depth_twin(const UnionWork& work, const Pieces& a, const Pieces& b, const UnionOptions& options = {});

}  // namespace fathom::unions
