// SPDX-License-Identifier: GPL-3.0-or-later
// Where bounds meet: if h(n) <= 0 is rational and the foot of O on the plane <n,x> = h(n) lies in P, it is the point of P nearest to O. It
// is sought in the face of P in direction n, exactly.                                                  [proofs/shapes_curved.md, lemma 4]
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "reference/curved/oracle.hpp"

namespace fathom::curved {

/// Convex combinations of points of both cores, with the same weights.
struct Combination {
  std::vector<InnerPoint> a, b;
  std::vector<mpq_class> weights;
};

/// The point of the hull's face in direction n, or the atom, if it lies in the face as a whole: `height` is the support of the term.
struct TightAtom {
  std::uint32_t atom;            ///< its index in the term
  bool whole;                    ///< it lies in the face
  std::vector<mpq_class> local;  ///< of the one point that does, if not
};

/// The atoms that reach the rational height max <n,x> of the term.
std::vector<TightAtom> tight_atoms(const Term& term, const Vector& n, const mpq_class& height);

/// The point center + sum of local_i axes[i].
Point place(const Atom& atom, std::span<const mpq_class> local);

/// `heights` are those of the terms of A in direction -n and of B in direction n, exact. Returns a combination whose difference is the foot
/// of O on the plane <n,x> = sum of the heights, or nullopt if none was found.
std::optional<Combination> foot_in_face(kernels::Context& context, const std::vector<Term>& a, const std::vector<Term>& b, const Vector& n,
                                        std::span<const TermHeight> heights);

}  // namespace fathom::curved
