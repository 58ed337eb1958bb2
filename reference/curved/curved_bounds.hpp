// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two shapes of which at most one is a half-space.
// Output  rational low <= signed depth <= high, both proved: a direction with rational heights, and
//         points inside the cores. The search is that of engines, GJK and EPA, on a support of
//         which both sides are rational.                                  [proofs/shapes_curved.md]
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "fathom/shape.hpp"
#include "fathom/signed_depth.hpp"
#include "kernels/context.hpp"
#include "kernels/messages.hpp"
#include "reference/shapes/core.hpp"

namespace fathom::curved {

struct CurvedBounds {
  mpq_class low, high;            ///< of the signed depth; equal only if it is rational
  std::optional<Surd> exact;      ///< the signed depth, if it is known: if low = high, or of cores around one axis
  Bracket bracket;                ///< the proof
  std::size_t support_calls = 0;  ///< that the search took
  std::size_t facet_scans = 0;    ///< of the polytope inside P, for the goal; in the last search
};

/// Searches until high - low is at most 2^-bits of both bounds, where they have one sign, or of the
/// extent, or until the support of P has been asked for `support_calls` times, at least once.
/// Bounds without a sign are searched again, to 2^-80 of the extent and then 2^-160, as long as
/// calls are left: so they are narrower than was asked for. Where they have one, the search ends
/// early if, as the bounds have closed in so far, the calls that are left will not do. The extent
/// is the longest side of a box around P', in which each atom counts as its center +- the sums of
/// its axes' magnitudes. The shapes keep the laws that signed_depth demands; bits is at most
/// most_bound_bits. Bounds that are equal are found where a facet, an axis or the centers give the
/// direction, or where it is short. With `coaxial`, cores that are of revolution about one axis and
/// penetrate are looked at in a half-plane. Throws InputError as `lattice` does, and Interrupted.
CurvedBounds signed_bounds(kernels::Context& context, const Shape& a, const Shape& b, unsigned bits = 40,
                           std::size_t support_calls = 5000, bool coaxial = true);

/// Checks the proof by the definitions, in rationals: the naive twin of the checkers.
[[nodiscard]] kernels::Report validate(const CurvedBounds& bounds, const Shape& a, const Shape& b);

// Input   two cores of revolution about one axis.
// Output  their signed depth, found in a half-plane that ends at the axis: there P = B (+) (-A) is
//         a profile, a sum of hulls of half ellipses.
//                                                [proofs/shapes_curved.md, "Around one axis"]

/// An atom of P: the points (zeta + z) d + r e with z^2 R + r^2 S <= R S. Those of A are reflected.
struct ProfileAtom : shapes::AtomProfile {
  mpq_class zeta;  ///< of the center
};

/// P, whose axis goes through O in direction d.
struct Profile {
  Vector axis;                                  ///< d, primitive
  std::vector<std::vector<ProfileAtom>> terms;  ///< those of A first
  std::size_t terms_of_a = 0;
  Vector across;  ///< orthogonal to d; if there is a short one, of a length that is a rational multiple of that of d
};

/// Returns nullopt if the cores have no axis in common.
std::optional<Profile> common_profile(const std::vector<Term>& a, const std::vector<Term>& b);

/// A direction a d + b e of the half-plane, b >= 0, e as long as d.
struct ProfileDirection {
  mpq_class a, b;
};

struct ArcDepth {
  Surd depth;                  ///< of the cores: the least h(u)/|u|, exact
  ProfileDirection direction;  ///< that attains it, if it is rational; else near to that
};

/// The depth by the directions in which atoms tie: of atoms that are points, discs and balls, of
/// rational radii, if the length of d is rational. Returns nullopt else, and if there are so many
/// atoms that it would take long.
std::optional<ArcDepth> depth_of_arcs(const Profile& profile);

/// The bounds by points of P in the half-plane. `bits` and `status_bits` as of a Goal. Returns
/// nullopt if the cores are not seen to penetrate: then the direction of the axis, which the
/// general search tries first, is the best.
std::optional<CurvedBounds> coaxial_bounds(kernels::Context& context, const Profile& profile, const Shape& a,
                                           const Shape& b, unsigned bits, unsigned status_bits,
                                           std::size_t support_calls);

}  // namespace fathom::curved
