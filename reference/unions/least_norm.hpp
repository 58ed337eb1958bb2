// SPDX-License-Identifier: GPL-3.0-or-later
// Input   half-spaces <n,x> >= h.
// Output  the point nearest to O that lies in all of them, exactly; or that none does. An LP-type
//         problem of dimension 3, by the incremental algorithm of Seidel (1991), whose constraints
//         come in the order given. Points are computed by Cramer's rule from the at most three
//         planes that hold them, so that numbers do not grow.
#pragma once

#include <span>
#include <type_traits>
#include <vector>

#include "kernels/filters/meeting_points.hpp"

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

}  // namespace fathom::unions
