// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies that touch, and a common point x.
// Output  all directions in which a plane through x has them on its two sides: the polar of the m +
//         n generators b - x and x - a.
// Time    scans for support points, and as many clips as there are generators that cut; without a
//         common lattice O((m + n) r) for at most r rays on the way.             [proofs/shapes.md]
#pragma once

#include <optional>
#include <vector>

#include "fathom/signed_depth.hpp"
#include "kernels/context.hpp"
#include "kernels/messages.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/points.hpp"

namespace fathom::rounded {

/// A cone on its way to its canonical form: it is clipped by one half-space after another.
struct ClippedCone {
  std::vector<Vector> lines;  ///< a basis of the lineality
  std::vector<Vector> rays;   ///< extreme rays, in cyclic order if there are three or more; unique up to the lineality
};

/// Everything.
ClippedCone whole_space();

/// Keeps the directions u with <g,u> <= 0.
void clip(ClippedCone& cone, const Vector& g);

/// The canonical form. The order of the rays' cycle is lost.
OptimalCone canonical(ClippedCone cone);

/// {u : h(u) = 0}, where `known` is one of them. Throws std::logic_error if there is none: then x
/// is no common point of bodies that touch.
OptimalCone optimal_cone(kernels::Context& context, const polytope::PlacedPair& pair, const Point& x,
                         const Vector& known);

/// The same by all generators, for bodies without a common lattice: the naive twin.
OptimalCone optimal_cone(kernels::Context& context, polytope::Positions a, polytope::Positions b, const Point& x);

/// A direction in the relative interior of the cone, but O: primitive.
Vector inner_direction(const OptimalCone& cone);

/// The faces in direction n of two bodies given by their points.
Contact contact_along(polytope::Positions a, polytope::Positions b, const Vector& n);

/// All planes between bodies that touch, and the least faces that share points: those in any
/// direction inside the cone.
struct PlanesBetween {
  OptimalCone cone;
  Contact contact;
};

/// `pair`: the bodies on one lattice, if that has been made.
PlanesBetween planes_between(kernels::Context& context, std::optional<polytope::PlacedPair> pair, polytope::Positions a,
                             polytope::Positions b, const Touch& touch);

/// Independent vectors that span the lineality: as many as its dimension.
std::vector<Vector> lineality_basis(const OptimalCone& cone);

/// Checks that h is 0 in every direction named, and that the form is canonical; not that no
/// direction is missing.
[[nodiscard]] kernels::Report validate(const OptimalCone& cone, polytope::Positions a, polytope::Positions b);

}  // namespace fathom::rounded
