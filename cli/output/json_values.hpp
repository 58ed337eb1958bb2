// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of JSON results.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <string_view>

#include "fathom/depth.hpp"
#include "kernels/number/roundings.hpp"
#include "kernels/vector.hpp"
#include "reference/text/json.hpp"

namespace fathom::cli {

using text::Json;

/// Exact numbers as strings.
Json exact(const Point& p);
Json exact(const Vector& v);

/// A length by its exact square, with roundings, and an enclosure if digits are given.
Json length(const mpq_class& squared, const std::optional<unsigned>& digits);
Json length(const mpq_class& squared, const kernels::Roundings& rounded, const std::optional<unsigned>& digits);
/// A rational number, exact and rounded.
Json number(const mpq_class& value);

Json contact_object(const Contact& contact);
Json witness_object(const Witness& witness);
Json flat_array(const BodyFacts& facts);

/// Returns the line for a case of a stream that has no result.
std::string error_object(std::string_view schema, const std::string& id, std::size_t line, std::string_view error);

}  // namespace fathom::cli
