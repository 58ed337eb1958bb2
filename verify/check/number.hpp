// SPDX-License-Identifier: Apache-2.0
// Numbers of case files, read exactly. No floating point is involved, whatever the numbers stand
// for.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace fathom_check {

constexpr std::size_t longest_case_number = 2'000'000;      ///< digits
constexpr std::int64_t largest_decimal_exponent = 100'000;  ///< in magnitude, as written
constexpr std::int64_t largest_binary_exponent = 400'000;

/// An exact number: integer, p/q, decimal, or C99 hexadecimal float, with an optional sign. Returns
/// nullopt for other text, and beyond the limits.
std::optional<mpq_class> exact_number(std::string_view text);

/// What a JSON number means: the binary64 nearest to it, ties to even. Returns nullopt if that is
/// infinite.
std::optional<mpq_class> nearest_binary64(std::string_view json_number);

/// Rounds to the nearest binary64, ties to even, subnormals included. False if that would be
/// infinite.
bool round_to_binary64(mpq_class& value);

}  // namespace fathom_check
