// SPDX-License-Identifier: GPL-3.0-or-later
// Points, translations and directions to the nearest binary64, as decimals for people and as numbers of JSON; and exactly for people.
#pragma once

#include <optional>
#include <string>

#include "fathom/signed_depth.hpp"
#include "reference/rounded/coordinates.hpp"
#include "reference/text/json.hpp"

namespace fathom::cli {

using text::Json;

using rounded::CoordinatePair;
using rounded::Coordinates;
using rounded::coordinates;
using rounded::nearest_binary64;
using rounded::rational_point;
using rounded::unit;

template <class SomeWitness>
std::optional<CoordinatePair> coordinates_of(const std::optional<SomeWitness>& witness) {
  return witness ? std::optional(coordinates(*witness)) : std::nullopt;
}

/// Each coordinate to the nearest binary64; null if one is beyond all finite numbers.
Json numbers(const Coordinates& values);

/// Adds the fields "unit_f64", "translation_f64" and "witness_f64", which stand beside exact ones; null of what there is not.
void add_rounded(Json& result, const Vector& direction, const std::optional<Coordinates>& translation,
                 const std::optional<CoordinatePair>& witness);

/// "(-0.25, 0, 1)": the shortest decimals that read back as the nearest binary64 numbers; 17 digits beyond that range.
std::string decimals(const Coordinates& values);

/// A point or translation: its decimals; or, if it is to be exact, fractions, and what is along a direction apart: "(1/2, 0, 0) and 1/3
/// along (1, 1, 1)".
std::string place_text(const Point& p, bool exact);
std::string place_text(const AlongNormal& vector, bool exact);
std::string place_text(const RoundedPoint& point, bool exact);

/// A direction: the unit vector's decimals; or, if it is to be exact, the integers in lowest terms.
std::string way_text(const Vector& n, bool exact);

}  // namespace fathom::cli
