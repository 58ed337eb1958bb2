// SPDX-License-Identifier: GPL-3.0-or-later
// Results as JSON: one object per line, fields as in schemas/result.schema.json and in its order.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "cli/args/request.hpp"
#include "cli/output/answer.hpp"
#include "cli/output/json.hpp"
#include "kernels/number/roundings.hpp"

namespace fathom::cli {

/// The first fields of every result, exact or approximate: the schema, the version of fathom, the id, the status.
Json result_head(const std::string& id, std::string_view status);

/// Doubles on both sides of a signed depth: positive if the bodies penetrate, negative if they are apart. Equal if it is that double.
struct SignedDepthBounds {
  double low, high;
};

/// Of bodies that penetrate with this depth, or are this far apart.
SignedDepthBounds penetrating_by(const kernels::Roundings& depth);
SignedDepthBounds apart_by(const kernels::Roundings& distance);

/// The field "signed_depth" but for its exact form. A bound that is infinite becomes null.
Json signed_depth_object(const SignedDepthBounds& bounds);

/// The field "counters".
Json counters_object(const Counters& counters);

/// One line, without its newline. Pure ASCII whatever the id holds.
std::string json_result(const Answer& answer, const Request& request);

/// Returns the line for a case of a stream that has no result.
std::string json_error(const std::string& id, std::size_t line, std::string_view error);

}  // namespace fathom::cli
