// SPDX-License-Identifier: Apache-2.0
// Small things about text and numbers as text.
#pragma once

#include <gmpxx.h>

#include <string>
#include <string_view>

namespace fathom_check {

/// In quotes, printable and short, whatever it was.
std::string shown(std::string_view text);

/// What is not printable ASCII, and %, as %XX.
std::string escaped(std::string_view text);
/// The reverse; a % that no two hexadecimal digits follow stays.
std::string unescaped(std::string_view text);

/// -?[0-9]+, which the caller has made sure of.
mpz_class to_integer(std::string_view token);

/// "p/q" in lowest terms, without a denominator of 1. The denominator is positive.
std::string ratio_text(const mpz_class& num, const mpz_class& den);

}  // namespace fathom_check
