// SPDX-License-Identifier: GPL-3.0-or-later
// Exact values for people: in full where that is short, else a few digits behind a "~".
#pragma once

#include <gmpxx.h>

#include <string>

#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"

namespace fathom::cli {

/// The square root as a decimal: the shortest one that reads back as its nearest binary64; 17
/// digits beyond that range.
std::string root_text(const mpq_class& squared);
/// As root_text, of a value >= 0.
std::string surd_text(const Surd& value);

inline Surd negated(const Surd& value) { return {-value.rational, -value.root}; }

/// "(1/2, 0, -3)", or "~(0.333333333, ...)".
std::string point_text(const Point& p);

/// "(-1, 0, 0)", or where the integers are long the unit vector of that direction: "~(0.577350269,
/// ...)".
std::string direction_text(const Vector& n);

}  // namespace fathom::cli
