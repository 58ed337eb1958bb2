// SPDX-License-Identifier: GPL-3.0-or-later
// Two cores on one lattice: the atoms of B and of -A as integers. P = B (+) (-A) is the sum of all
// their terms, those of A first. And the directions of it that are worth a try.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "fathom/shape.hpp"
#include "fathom/signed_depth.hpp"
#include "kernels/context.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/position.hpp"

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

// The support of P, which is irrational in general, from both sides: a point of P, a little inside
// where it must be, and a height that no point of P exceeds.     [proofs/shapes_curved.md, lemma 1]

/// A point of one term: of the lattice atom, or cloud point, of this index; y in multiples of
/// 2^-fine.
struct Pick {
  std::uint32_t atom = 0;
  bool of_cloud = false;
  std::array<mpz_class, 3> y;
};

/// A point of P, as the sum of one point of each term.
struct PickedPoint {
  std::vector<Pick> picks;
  Vector place;  ///< in the fine unit
};

/// Proves least h(u)/|u| <= height/|direction|.
struct Ceiling {
  Vector direction;
  mpz_class height;  ///< >= h(direction), in the fine unit
};

/// The sign of a.height/|a.direction| - b.height/|b.direction|.
int compare(const Ceiling& a, const Ceiling& b);

/// What h is for one term: in the unit of the shapes.
struct TermHeight {
  mpq_class height;  ///< at least the support of the term, or of its negative if it is one of A's
  bool exact;        ///< it is the support
};

/// Its first three members make it a set of differences for the start of an expansion: a difference
/// names a point twice.
class Oracle {
 public:
  using Integer = mpz_class;

  Oracle(kernels::Context& context, const Lattice& lattice, std::size_t budget)
      : context_(context), lattice_(lattice), budget_(budget) {}

  [[nodiscard]] const Vector& operator[](polytope::Difference d) const { return points_[d.first].place; }
  [[nodiscard]] long exponent() const { return lattice_.exponent; }
  /// A point that is nearly extreme in direction u, of any length; the first one if no call is
  /// left.
  polytope::Difference extreme(const Vector& u);

  /// Finds the height of direction n, and a point that falls short of it by about 2^-precision of
  /// an atom's axes at most; precision <= fine. n is not zero. Throws Interrupted.
  polytope::Difference ask(const Vector& n, unsigned precision);
  /// n times a positive number, nearly, with components of about as many bits as matter.
  [[nodiscard]] Vector shortened(const Vector& n) const;

  [[nodiscard]] std::size_t calls() const { return points_.size(); }
  [[nodiscard]] std::size_t budget() const { return budget_; }
  [[nodiscard]] bool spent() const { return calls() >= budget_; }
  [[nodiscard]] const Lattice& lattice() const { return lattice_; }
  [[nodiscard]] const std::vector<PickedPoint>& points() const { return points_; }
  /// The lowest ceiling, and the height that was found last, in the direction that was asked for.
  [[nodiscard]] const std::optional<Ceiling>& lowest() const { return lowest_; }
  [[nodiscard]] const mpz_class& height() const { return height_; }

  /// The height of each term of P in direction n.
  [[nodiscard]] std::vector<TermHeight> heights(const Vector& n);
  /// The point of the core of A (B) that is part of points()[i].
  [[nodiscard]] InnerPoint inner_point(std::size_t i, bool of_a) const;

 private:
  /// The greatest of a term's atoms.
  struct Greatest {
    std::uint32_t atom = 0;
    bool of_cloud = false;
    mpz_class height;  ///< from the anchor, in the fine unit, rounded up
    bool exact = true;
  };
  void find_greatest(const LatticeTerm& term, const Vector& n);
  void set_local(const LatticeAtom& atom, const Vector& n, unsigned precision, Pick& pick);
  [[nodiscard]] AtomPoint atom_point(const LatticeTerm& term, const Pick& pick) const;

  kernels::Context& context_;
  const Lattice& lattice_;
  std::size_t budget_;
  std::vector<PickedPoint> points_;
  std::optional<Ceiling> lowest_;
  mpz_class height_;
  // Scratch.
  Greatest greatest_;
  mpz_class value_, root_, rest_, square_;
  std::array<mpz_class, 3> slope_;
};

// The search of Gilbert, Johnson and Keerthi on the support of P: the point of the hull of one to
// three points of P that is nearest to O, while more points come.
//                                                                [proofs/shapes_curved.md, lemma 3]

enum class NearestEnd {
  common,  ///< the foot is O
  inside,  ///< O is in the interior of a tetrahedron of four corners; there is no foot
  near,    ///< `enough` said so
  open     ///< no further point, or no further call
};

struct NearestFoot {
  NearestEnd end;
  std::vector<polytope::SimplexCorner<mpz_class>> corners;
  polytope::SimplexFoot<mpz_class> foot;
};

/// Starts from a point that has been found. `enough` and `precision` are asked for each foot; the
/// second says how fine the next point is.
template <class Enough, class Precision>
NearestFoot find_nearest(Oracle& oracle, polytope::Difference first, Enough enough, Precision precision) {
  NearestFoot result{NearestEnd::open, {{first, oracle[first]}}, {}};
  while (true) {
    auto foot = polytope::nearest_in_simplex(result.corners);
    if (!foot) {
      result.end = NearestEnd::inside;
      return result;
    }
    result.foot = std::move(*foot);
    const polytope::SimplexFoot<mpz_class>& z = result.foot;
    if (is_zero(z.point) || enough(z)) {
      result.end = is_zero(z.point) ? NearestEnd::common : NearestEnd::near;
      return result;
    }
    const Vector n = oracle.shortened(-z.point);
    const mpz_class square = dot(z.point, z.point);
    bool found = false;  // a point that leads nearer
    for (unsigned fine : {precision(z), oracle.lattice().fine}) {
      if (found || oracle.spent()) break;
      const polytope::Difference next = oracle.ask(n, fine);
      found = z.denominator * dot(z.point, oracle[next]) < square;
      if (found) result.corners.push_back({next, oracle[next]});
    }
    if (!found) return result;
  }
}

}  // namespace fathom::curved
