// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a shape.
// Output  the same body with as simple a core as its numbers allow; the points of a core that is a
//         polytope; how far the body reaches in a direction.    [proofs/shapes.md, proofs/judge.md]
#pragma once

#include <optional>
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

}  // namespace fathom::shapes
