// SPDX-License-Identifier: GPL-3.0-or-later
// JSON as programs print it that know nothing of JSON: printf("%g") of a NaN, for one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "verify/judge/reply.hpp"

namespace fathom::harness {

/// The text with every bare word that starts like a number, or like a spelling of NaN or infinity, put between quotation marks: what is
/// left is JSON if the text was JSON but for its numbers.
std::string with_quoted_numbers(std::string_view text);

/// A decimal or C99 hex float, rounded once to the precision, or a spelling of NaN or infinity with or without a sign, in any case
/// ("-nan", "NAN", "nan(0x8000)", "inf", "-Infinity"). Nothing if it is none of these.
std::optional<double> read_number(std::string_view text, Precision precision);

}  // namespace fathom::harness
