// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a sum of terms.
// Output  the line about which it is a body of revolution.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "verify/study/solid.hpp"

namespace fathom::studies {

/// M M^T of an atom c + M y, row by row: two atoms about one centre are equal as sets if and only if these are.
using Gram = std::array<RationalVector, 3>;
Gram gram_of(const Atom& atom);

/// The square of the radius of a circular disc or a round ball. Returns nullopt for other atoms, points among them.
std::optional<mpq_class> round_square(const Atom& atom);

/// The axis of revolution. Returns nullopt if there is none, or if there are several, as of a ball. Finds every axis of a sum whose terms
/// are bodies of revolution one by one.
std::optional<Line> axis_of(std::span<const Term> terms);

}  // namespace fathom::studies
