// SPDX-License-Identifier: GPL-3.0-or-later
// Points, translations and directions to the nearest binary64 or exactly, for people.
#pragma once

#include <string>

#include "fathom/signed_depth.hpp"
#include "reference/rounded/coordinates.hpp"

namespace fathom::cli {

using rounded::CoordinatePair;
using rounded::Coordinates;
using rounded::coordinates;
using rounded::nearest_binary64;
using rounded::rational_point;
using rounded::unit;

/// "(-0.25, 0, 1)": the shortest decimals that read back as the nearest binary64 numbers; 17 digits
/// beyond that range.
std::string decimals(const Coordinates& values);

/// A point or translation: its decimals; or, if it is to be exact, fractions, and what is along a
/// direction apart: "(1/2, 0, 0) and 1/3 along (1, 1, 1)".
std::string place_text(const Point& p, bool exact);
std::string place_text(const AlongNormal& vector, bool exact);
std::string place_text(const RoundedPoint& point, bool exact);

/// A direction: the unit vector's decimals; or, if it is to be exact, the integers in lowest terms.
std::string way_text(const Vector& n, bool exact);

}  // namespace fathom::cli
