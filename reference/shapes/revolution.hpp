// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a sum of terms.
// Output  the line about which it is a body of revolution, and what its atoms are about a line. An
//         atom c + M y is of revolution about c + s d if M M^T = R (<d,d> I - d d^T) + S d d^T.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "fathom/shape.hpp"

namespace fathom::shapes {

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
