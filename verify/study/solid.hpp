// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a shape.
// Output  what of it can coincide with something of another one: its centre, axis, radii, flat faces, generators. All in rationals and
//         square roots of such.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "fathom/numbers.hpp"
#include "fathom/shape.hpp"

namespace fathom::studies {

struct Line {
  RationalVector point;
  Vector direction;  ///< primitive
};

/// A flat face. Its plane is <normal,x> = height, on the body.
struct FlatFace {
  Vector normal;  ///< outward, primitive
  RootSum height;
};

/// The parallel generators of a cylinder, circular or elliptic, or of a capsule.
struct Generators {
  Line axis;
  std::optional<Surd> radius;  ///< if it is a circular cylinder about the axis
};

struct Solid {
  Shape shape;                           ///< simplified: a polytope as one term of its extreme points
  bool is_polytope = false;              ///< the core
  std::optional<RationalVector> centre;  ///< of symmetry
  std::optional<Line> axis;              ///< of revolution, if it is the only one
  std::vector<Surd> radii;               ///< different ones
  std::vector<FlatFace> faces;           ///< sorted by normal, which differ
  std::vector<Generators> sides;
  std::vector<RationalVector> apexes;  ///< of cones, and those that were cut off

  [[nodiscard]] const HalfSpace* half_space() const { return std::get_if<HalfSpace>(&shape.core); }
  [[nodiscard]] std::span<const Term> terms() const { return std::get<std::vector<Term>>(shape.core); }
};

/// A sum of more line directions of its terms than this has no facets looked for that two of them span.
inline constexpr std::size_t most_line_directions = 500;

/// The shape keeps the laws that signed_depth demands.
Solid solid_of(const Shape& shape);

/// What the face of the body in this direction is called: "vertex", "apex", "rim point", "smooth point", "edge", "generator", "face".
std::string_view word_of(const Solid& solid, const SupportFace& face);

}  // namespace fathom::studies
