// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds with their proof: how near to each other they have to be, what the searches found, in
// short numbers, and where both bounds meet.                     [proofs/shapes_curved.md, lemma 4]
#pragma once

#include <gmpxx.h>

#include <optional>
#include <span>
#include <vector>

#include "reference/curved/curved_bounds.hpp"
#include "reference/curved/oracle.hpp"

namespace fathom::curved {

/// A number is rho + the signed root of x: sqrt(x), or -sqrt(-x) for x < 0. It is named by x.
class Goal {
 public:
  /// If low and high have one sign, high - low is to be at most 2^-bits of both, or of the extent;
  /// if not, at most 2^-status_bits of the extent, which are not fewer.
  Goal(unsigned bits, unsigned status_bits, mpq_class extent, mpq_class rho);

  /// Multiples of 2^-k, moved by rho, at most and at least the number. They differ by less than the
  /// goal allows.
  [[nodiscard]] mpq_class from_below(const mpq_class& x) const;
  [[nodiscard]] mpq_class from_above(const mpq_class& x) const;
  /// The number itself, if x is the square of a rational or its negative; else from_below or
  /// from_above.
  [[nodiscard]] mpq_class exact_or_below(const mpq_class& x) const;
  [[nodiscard]] mpq_class exact_or_above(const mpq_class& x) const;
  [[nodiscard]] bool met(const mpq_class& low, const mpq_class& high) const;
  /// Whether these bounds have one sign.
  static bool decided(const mpq_class& low, const mpq_class& high) { return low > 0 || high < 0; }

  [[nodiscard]] const mpq_class& extent() const { return extent_; }
  [[nodiscard]] const mpq_class& rho() const { return rho_; }
  /// 2^-finest is a small part of what the goal allows for a number of the size of sqrt(|x|).
  [[nodiscard]] long finest(const mpq_class& x) const;
  /// 2^-bits, less some room for numbers in the proof that are rounded afterwards.
  [[nodiscard]] const mpq_class& share() const { return share_; }

 private:
  unsigned status_bits_;
  mpq_class extent_, rho_, share_, status_share_;
};

/// The least integer >= value.
mpz_class rounded_up(const mpq_class& value);

/// Convex combinations of points of both cores, with the same weights.
struct Combination {
  std::vector<InnerPoint> a, b;
  std::vector<mpq_class> weights;
};

/// The point of the hull's face in direction n, or the atom, if it lies in the face as a whole:
/// `height` is the support of the term.
struct TightAtom {
  std::uint32_t atom;            ///< its index in the term
  bool whole;                    ///< it lies in the face
  std::vector<mpq_class> local;  ///< of the one point that does, if not
};

/// The atoms that reach the rational height max <n,x> of the term.
std::vector<TightAtom> tight_atoms(const Term& term, const Vector& n, const mpq_class& height);

/// The point center + sum of local_i axes[i].
Point place(const Atom& atom, std::span<const mpq_class> local);

/// `heights` are those of the terms of A in direction -n and of B in direction n, exact. Returns a
/// combination whose difference is the foot of O on the plane <n,x> = sum of the heights, or
/// nullopt if none was found. `edges`: it is looked for in the edges of that face too.
std::optional<Combination> foot_in_face(kernels::Context& context, const std::vector<Term>& a,
                                        const std::vector<Term>& b, const Vector& n,
                                        std::span<const TermHeight> heights, bool edges = true);

/// The square of height/|n| with the sign of the height.
mpq_class signed_square(const mpq_class& height, const Vector& n);

/// The heights as they are, if all are exact; else rounded up, so far that it does not show in the
/// bounds.
std::vector<mpq_class> short_heights(const std::vector<TermHeight>& heights, const Vector& n, const Goal& goal);

class Assembly {
 public:
  Assembly(kernels::Context& context, const std::vector<Term>& a, const std::vector<Term>& b, Oracle& oracle,
           const Goal& goal)
      : context_(context), a_(a), b_(b), oracle_(oracle), goal_(goal) {}

  /// Takes a point of P as the lower side.
  void set_lower(const NearestFoot& nearest);
  /// Takes a polytope inside P, whose vertices name points of the oracle twice, with the squared
  /// distance of its nearest facet.
  void set_lower(const mpq_class& squared, InnerPolytope inner);
  /// Takes an outline in the half-plane of profiles, with the squared distance of its nearest edge.
  void set_lower(const mpq_class& squared, Revolution around);
  /// Requires the lowest height to be at most 0. Whether the bounds meet there; if so that is the
  /// lower side.
  bool meets_in_face();

  /// What the lower side and the lowest ceiling say of the cores, squared, with the sign; and
  /// whether both sides are one number.
  [[nodiscard]] const mpq_class& lower() const { return lower_; }
  [[nodiscard]] mpq_class upper() const;
  [[nodiscard]] bool closed() const;
  /// -|z|^2 in the shapes' unit.
  [[nodiscard]] mpq_class square_of(const polytope::SimplexFoot<mpz_class>& z) const;
  /// Whether the goal is met by this lower bound and the lowest ceiling.
  [[nodiscard]] bool met(const mpq_class& lower) const;

  CurvedBounds take();

 private:
  void set_weights(const Combination& combination);

  kernels::Context& context_;
  const std::vector<Term>&a_, &b_;
  Oracle& oracle_;
  const Goal& goal_;
  mpq_class lower_;  // signed square
  Bracket bracket_;
};

}  // namespace fathom::curved
