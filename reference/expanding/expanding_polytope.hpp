// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two point clouds.
// Output  the facets of P nearest to O, found and proved by a polytope Q that grows inside P
//         towards them; no hull, no decomposition. In engines this search is known as EPA, the
//         expanding polytope algorithm (van den Bergen 2001); here binary64 guesses which point
//         comes next and integers decide.                                     [proofs/expanding.md]
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/nearest.hpp"
#include "kernels/report.hpp"
#include "reference/polytope/narrow_lattice.hpp"

namespace fathom::expanding {

/// A budget without a limit on the points that are added to Q.
inline constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

enum class ExpansionEnd {
  proved,      ///< Q holds the requested ball
  not_inside,  ///< O is not in the interior of P
  spent        ///< the budget is used up
};

struct Expansion {
  ExpansionEnd end = ExpansionEnd::spent;
  /// proved: the directions of all facets of P nearest to O, with their squared distance. Exact.
  kernels::NearestPlanes nearest;
  /// proved: Q, with one facet in the plane of each nearest facet of P, and all others strictly
  /// farther from O.
  InnerPolytope inner;
  /// not_inside: whether O is known to be outside P.
  bool outside = false;
  std::size_t points = 0;  ///< added to Q beyond the first four
  /// How often it was asked on which side of a triangle a point lies, and how often binary64 could
  /// not tell.
  std::uint64_t sides = 0, sides_exact = 0;
  /// In lazy integers: how many had to be computed.
  std::uint64_t computed = 0;
};

/// The clouds must be non-empty and have the same exponent, on all axes. Always ends: gives up if Q
/// would need more than `budget` points. `workspace` may be null; with one, nothing is allocated on
/// a narrow lattice but the result, once it has grown. Throws Interrupted.
Expansion nearest_by_expansion(kernels::Context& context, const kernels::PointCloud& a, const kernels::PointCloud& b,
                               std::size_t budget = unlimited, Workspace* workspace = nullptr);
/// The same on a narrow lattice, in each of its integers.
template <class Integer>
Expansion nearest_by_expansion(kernels::Context& context, const polytope::NarrowBodies<Integer>& bodies,
                               std::size_t budget = unlimited, Workspace* workspace = nullptr);
/// The same in lazy integers, the way for lattices that are not narrow.
Expansion nearest_by_expansion_lazily(kernels::Context& context, const kernels::PointCloud& a,
                                      const kernels::PointCloud& b, std::size_t budget = unlimited,
                                      Workspace* workspace = nullptr);
/// The same in integers of any size: the naive twin.
Expansion nearest_by_expansion_in_mpz(kernels::Context& context, const kernels::PointCloud& a,
                                      const kernels::PointCloud& b, std::size_t budget = unlimited,
                                      Workspace* workspace = nullptr);

/// Where O lies, as far as a growing Q shows it.
struct OriginExpansion {
  ExpansionEnd end = ExpansionEnd::spent;  ///< proved: in the interior of P; not_inside: on its boundary, or outside
  /// not_inside: the sign of h(normal). O is outside if it is below 0; 0 leaves that open, as in a
  /// flat P.
  int side = 0;
  Vector normal;     ///< if O is outside and this has been asked for
  mpz_class height;  ///< h(normal) then, in units of the lattice
};

/// Grows Q until O is in its interior or a facet of P shows that it is not in that of P.
template <class Integer>
OriginExpansion locate_origin(kernels::Context& context, const polytope::NarrowBodies<Integer>& bodies,
                              Workspace* workspace, bool with_normal);

/// Checks the laws of a proved expansion: Q is convex and closed, its vertices are differences, it
/// is no nearer than the nearest planes, touches them in one facet each, and these support P.
/// Quadratic in the size of Q.
[[nodiscard]] kernels::Report validate(const Expansion& expansion, const kernels::PointCloud& a,
                                       const kernels::PointCloud& b);

/// A proof of low <= depth^2 <= high, all in the clouds' unit.
struct BallExpansion {
  ExpansionEnd end = ExpansionEnd::spent;
  bool low_holds = false, high_holds = false;  ///< proved: whether the two bounds are true
  Vector direction;                            ///< if `high` is true: n with h(n)^2 <= high <n,n>
  InnerPolytope inner;                         ///< if `low` is true: holds the ball of squared radius `low`
};

/// Grows Q until it holds the ball of squared radius `low`, and then until a direction shows
/// `high`; `hint`, if given, is tried first.
BallExpansion expand_to_ball(kernels::Context& context, const kernels::PointCloud& a, const kernels::PointCloud& b,
                             const mpq_class& low, const mpq_class& high,
                             const std::optional<Vector>& hint = std::nullopt, std::size_t budget = unlimited);

/// Requires O in the interior of P, `nearest` = depth^2, and `bound`, a larger squared distance of
/// a facet plane of P. Returns the squared distance of a facet plane, larger than `nearest` and at
/// most `bound`, such that no facet at a distance strictly between holds the foot
/// point of O in its interior. All in the clouds' unit. Throws std::invalid_argument if O is not in
/// the interior of P.  [proofs/gap.md, lemma 2]
std::optional<mpq_class> next_nearest_by_expansion(kernels::Context& context, const polytope::PlacedPair& pair,
                                                   const mpq_class& nearest, const mpq_class& bound,
                                                   Workspace& workspace);
/// The same on a narrow lattice, in the workspace that the bodies may be a part of. Returns nullopt
/// if `bound` has too many bits for it.
std::optional<mpq_class> next_nearest_by_expansion(kernels::Context& context,
                                                   const polytope::NarrowBodies<polytope::NarrowInteger>& bodies,
                                                   const mpq_class& nearest, const mpq_class& bound,
                                                   Workspace& workspace);

}  // namespace fathom::expanding
