// SPDX-License-Identifier: GPL-3.0-or-later
// JSON as programs print it that know nothing of JSON: printf("%g") of a NaN, for one.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verify/judge/reply.hpp"

namespace fathom::harness {

/// A text whose numbers were taken out, so that none is rounded by a reader of JSON.
struct WithoutNumbers {
  std::string text;                  ///< JSON if the text was JSON but for its numbers: each of them is its index in `numbers` now
  std::vector<std::string> numbers;  ///< as they were written
};
/// Takes out every bare word that starts like a number, or is a spelling of NaN or infinity.
WithoutNumbers without_numbers(std::string_view text);

/// A decimal or C99 hex float, rounded once to the precision, or a spelling of NaN or infinity with or without a sign, in any case
/// ("-nan", "NAN", "nan(0x8000)", "inf", "-Infinity"). Nothing if it is none of these; a ratio is none.
std::optional<double> read_number(std::string_view text, Precision precision);

/// The digits of an integer, however it is written ("7", "7.0", "7e0"); nothing if it is none.
std::optional<std::string> read_integer(std::string_view text);

}  // namespace fathom::harness
