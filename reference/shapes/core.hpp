// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a shape.
// Output  the same body with as simple a core as its numbers allow; the points of a core that is a
//         polytope; how far the body reaches in a direction.    [proofs/shapes.md, proofs/judge.md]
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/shape.hpp"
#include "kernels/number/irrational.hpp"

namespace fathom::shapes {

/// Throws std::invalid_argument, with a sentence that says what is wrong, unless the shape is as
/// fathom/shape.hpp asks for.
void require_shape(const Shape& shape);

/// The same for all but the coordinates of a core that is one hull of points: penetration_depth
/// looks at them. Returns whether it is one.
bool require_all_but_points(const Shape& shape);

/// Throws std::invalid_argument, with a sentence that says why, if the width of this valid shape is
/// infinite: that of a half-space.
void require_width(const Shape& shape);

inline bool is_halfspace(const Shape& shape) { return std::holds_alternative<HalfSpace>(shape.core); }
inline bool is_halfspace(const Body& body) { return body.shape && is_halfspace(*body.shape); }

/// The same body, for a valid shape. A round ball of rational radius that is alone in its term
/// becomes a point, and its radius one of the shape; an atom whose axes are all 0 becomes a point.
Shape simplified(Shape shape);

/// The points whose hull is the core: of one term its points, of several all sums of a point of
/// each, unless these are more than `most`. Returns nullopt then, and if an atom is not a point or
/// the core is a half-space. For a valid shape.
std::optional<std::vector<Point>> polytope_points(const Shape& shape, std::size_t most);

/// Encloses the greatest <u,x>/|u| over the points x of the body, its radius included; every root
/// is taken to `bits` bits. A value without irrational roots is known. The shape is valid, its core
/// is no half-space, and u is not zero.
kernels::RationalInterval support(const Shape& shape, const Point& u, unsigned bits);

// Input   a sum of terms.
// Output  the line about which it is a body of revolution, and what its atoms are about a line. An
//         atom c + M y is of revolution about c + s d if M M^T = R (<d,d> I - d d^T) + S d d^T.

/// M M^T of an atom c + M y, row by row: two atoms about one centre are equal as sets if and only
/// if these are.
using Gram = std::array<Point, 3>;
Gram gram_of(const Atom& atom);

/// An atom is the points center + z d + r e with z^2 R + r^2 S <= R S, for all e orthogonal to d
/// and as long; z is 0 if S is, and r if R is.
struct AtomProfile {
  mpq_class across, along;  ///< R and S, >= 0
};

/// Returns nullopt if the atom is not of revolution about the line through its center in direction
/// d, which is not 0.
std::optional<AtomProfile> profile_about(const Atom& atom, const Vector& d);

/// A line about which a sum of terms is of revolution.
struct AxisLine {
  Point point;
  std::optional<Vector> direction;  ///< primitive; nullopt: every one will do
};

/// Returns nullopt if there is none. Finds every axis of a sum whose terms are bodies of revolution
/// one by one.
std::optional<AxisLine> axis_of(std::span<const Term> terms);

}  // namespace fathom::shapes
