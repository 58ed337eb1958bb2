// SPDX-License-Identifier: GPL-3.0-or-later
// Reads JSON from programs that print it by hand, for example a NaN by printf("%g").
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/judge.hpp"

namespace fathom::harness {

/// A text whose numbers have been taken out, so that no JSON reader rounds them.
struct WithoutNumbers {
  std::string text;                  ///< each number is replaced by its index in `numbers`
  std::vector<std::string> numbers;  ///< as they were written
};
/// Takes out every bare word that starts like a number, or is a spelling of NaN or infinity.
WithoutNumbers without_numbers(std::string_view text);

/// Reads a decimal or C99 hex float with any exponent, rounded once to the precision, or a spelling of NaN or infinity with or without a
/// sign, in upper or lower case ("-nan", "NAN", "nan(0x8000)", "inf", "-Infinity"). Returns nullopt for anything else, ratios included.
std::optional<double> read_number(std::string_view text, Precision precision);

/// The digits of an integer, however it is written ("7", "7.0", "7e0"); nullopt if it is not an integer.
std::optional<std::string> read_integer(std::string_view text);

}  // namespace fathom::harness
