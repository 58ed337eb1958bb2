// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a direction in which a facet of P lies.
// Output  the contact: the faces of both bodies in that direction, the translation, and a pair of points that meet.      [proofs/depth.md]
#pragma once

#include "kernels/filters/support.hpp"
#include "reference/depth/depth.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/polytope/position.hpp"

namespace fathom {

/// The extreme points of both bodies, and the lattice that they live on.
struct Bodies {
  const Lattice& lattice;
  const Polytope& a;
  const Polytope& b;
  PointCloud vertices_a, vertices_b;
};

/// The optimum in direction n, the outward normal of a facet of P. Throws std::logic_error when the faces in direction n do not span a
/// facet.
Optimum optimum(const Bodies& bodies, const Vector& n);

/// Points a of the face of A and b of the face of B with b - a = translation. They exist for a nearest facet: the foot point of O lies in it.
Witness witness(const Bodies& bodies, const Optimum& optimum);

/// The rational position of a convex combination of lattice points.
Point combination(const Lattice& lattice, std::span<const Vector> points, const std::vector<Weight>& weights);

}  // namespace fathom
