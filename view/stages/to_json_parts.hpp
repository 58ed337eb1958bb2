// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of to_json.
#pragma once

#include "reference/text/json.hpp"
#include "view/stages/stages.hpp"

namespace fathom::stages {

/// The digits of places, angles and lengths; normals have one less.
inline constexpr int places_digits = 7;

/// The fields sum, coincidences, decided.
void write_parts(text::JsonStream& json, const Stages& stages);
/// The fields bounds, seconds.
void write_costs(text::JsonStream& json, const Stages& stages);

}  // namespace fathom::stages
