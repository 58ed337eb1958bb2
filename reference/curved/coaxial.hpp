// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two cores of revolution about one axis.
// Output  their signed depth, found in a half-plane that ends at the axis: there P = B (+) (-A) is
//         a profile, a sum of hulls of half ellipses.
//                                                [proofs/shapes_curved.md, "Around one axis"]
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "fathom/shape.hpp"
#include "kernels/context.hpp"
#include "reference/curved/curved_bounds.hpp"
#include "reference/shapes/revolution.hpp"

namespace fathom::curved {

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
