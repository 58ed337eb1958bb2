// SPDX-License-Identifier: GPL-3.0-or-later
// Random pairs of shapes whose numbers all are binary64, so that programs in doubles can take them as they are.
#pragma once

#include "verify/families/random.hpp"
#include "verify/families/shape_pairs.hpp"

namespace fathom::families {

enum class ShapeKind {
  sphere,
  capsule,
  tapered_capsule,
  box,
  rounded_box,
  cylinder,
  rounded_cylinder,
  cone,
  rounded_cone,
  frustum,
  ellipsoid,
  hull,
  rounded_hull,
  rounded_triangle,
  sum
};
inline constexpr int shape_kinds = static_cast<int>(ShapeKind::sum) + 1;

ShapeKind random_kind(Random& random);

/// Bodies of about unit size that overlap deeply, slightly, or are apart, by a hair or by far; a fifth touch. Those that touch, and some of
/// the others, are turned by symmetries of the cube, so that faces and axes are parallel. A hull has `n` points, at least 4.
NamedPair random_pair(ShapeKind a, ShapeKind b, Random& random, unsigned n);

/// The same for two hulls that depend on n alone: only the poses are random.
NamedPair prepared_hulls(Random& random, unsigned n);

/// The same with every length of the bodies up to 256 times larger or smaller.
NamedPair stretched_pair(ShapeKind a, ShapeKind b, Random& random, unsigned n);

/// A body against a half-space; either may be the first.
NamedPair random_pair_with_plane(ShapeKind kind, Random& random, unsigned n);

}  // namespace fathom::families
