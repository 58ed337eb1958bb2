// SPDX-License-Identifier: GPL-3.0-or-later
// The support of P, which is irrational in general, from both sides: a point of P, a little inside
// where it must be, and a height that no point of P exceeds.     [proofs/shapes_curved.md, lemma 1]
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "fathom/signed_depth.hpp"
#include "kernels/context.hpp"
#include "reference/curved/lattice.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/position.hpp"

namespace fathom::curved {

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
