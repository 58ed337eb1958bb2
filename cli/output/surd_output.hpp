// SPDX-License-Identifier: GPL-3.0-or-later
// Signed depths, and what goes along their directions, for people and as JSON. Such numbers are rational but for one root.
#pragma once

#include <optional>
#include <string>

#include "fathom/signed_depth.hpp"
#include "reference/text/json.hpp"

namespace fathom::cli {

using text::Json;

inline Surd negated(const Surd& value) { return {-value.rational, -value.root}; }

/// As root_text: the shortest decimal that reads back as the nearest binary64; 17 digits beyond that range.
std::string surd_text(const Surd& value);

/// A length: value >= 0. Its exact square is null if that is irrational.
Json surd_length(const Surd& value, const std::optional<unsigned>& digits);

/// {"sign", "root", "plus"}.
Json exact_object(const Surd& value);

/// The field "signed_depth" of an answer about shapes.
Json signed_depth_object(const SignedDepth& depth);

/// A point as three rationals if it is rational; else {"normal", "alpha", "beta"}, and {"core", "normal", "distance"}.
Json vector_object(const AlongNormal& vector);
Json point_object(const RoundedPoint& point);

}  // namespace fathom::cli
