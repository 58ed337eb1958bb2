// SPDX-License-Identifier: GPL-3.0-or-later
// Two cores on one lattice: the atoms of B and of -A as integers. P = B (+) (-A) is the sum of all
// their terms, those of A first. And the directions of it that are worth a try.
#pragma once

#include <cstddef>
#include <vector>

#include "fathom/shape.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/vector.hpp"

namespace fathom::curved {

/// The points center + sum of y_i axes[i], |y| <= 1, in the lattice's unit.
struct LatticeAtom {
  Vector center;  ///< from the term's anchor
  std::vector<Vector> axes;
  bool repeats = false;  ///< the axes are those of the atom before
};

/// The hull of its atoms and of its points, if these are too many to be looked at one by one.
struct LatticeTerm {
  Vector anchor;
  std::vector<LatticeAtom> atoms;    ///< points[i] is the atom of index names[i]; all atoms, or all that are no points
  std::vector<std::uint32_t> names;  ///< of the atoms: their indices in the term as it was given
  kernels::PointCloud cloud;         ///< of point atoms, from the anchor
  std::vector<std::uint32_t> cloud_names;
};

/// Points of P have integer coordinates in the fine unit, if their local parameters are multiples
/// of 2^-fine.
struct Lattice {
  mpq_class unit;     ///< of the atoms
  unsigned fine = 0;  ///< the fine unit is unit / 2^fine
  std::vector<LatticeTerm> terms;
  std::size_t terms_of_a = 0;
  Vector offset;      ///< the sum of the anchors
  long exponent = 0;  ///< |c| <= 2^exponent for the coordinates c of all points of P, in the fine unit
  mpz_class extent;   ///< the longest side of a box around P, in the unit: of each atom, center +- the sum of the axes'
                      ///< magnitudes
  mpq_class fine_unit;  ///< unit / 2^fine
};

/// A term of more points has no edges tried.
inline constexpr std::size_t most_edge_points = 12;

/// All its points, from the anchor.
std::vector<Vector> points_of(const LatticeTerm& term);

/// An atom has no axes, two or three, every term an atom, and all numbers are in lowest terms.
/// Throws InputError if all integers together would take more than 256 MB: the numbers'
/// denominators share too little.
Lattice lattice(const std::vector<Term>& a, const std::vector<Term>& b, unsigned fine);

// Directions in which people put shapes on, beside and into each other: there the support is
// rational, and the bounds can meet.

/// Returns the few directions with the least h(u)/|u|, as binary64 sees it, best first, of: the
/// axes of the coordinates and of the atoms; normals of discs, and normals of two of them; normals
/// of facets of terms of few points; the direction between the centers, and its part orthogonal to
/// a disc's normal. All are primitive.
std::vector<Vector> likely_directions(const Lattice& lattice, std::size_t most);

/// Returns directions near n whose components have short ratios, in the coordinates or in the frame
/// of some atom's axes: the first fractions to which n is much nearer than to others of their
/// length. Most directions have none. All are primitive, and other than n.
std::vector<Vector> short_directions(const Lattice& lattice, const Vector& n);

/// Returns directions near n that are exactly orthogonal to an edge of few points, or to a disc's
/// tangent that is short in its axes. Where a corner lies on a rim or on an edge the common normals
/// form a fan, and if n is near to a member inside, these are members. All are primitive.
std::vector<Vector> fan_directions(const Lattice& lattice, const Vector& n);

}  // namespace fathom::curved
