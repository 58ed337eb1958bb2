// SPDX-License-Identifier: Apache-2.0
// Small things about text and numbers as text.
#pragma once

#include <gmpxx.h>

#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "certificate.hpp"

namespace fathom_check {

/// In quotes, printable and short, whatever it was. Blanks stay.
std::string shown(std::string_view text);

/// Returns the text with %XX in place of blanks, % and what is not printable ASCII.
std::string escaped(std::string_view text);
/// The reverse; a % that no two hexadecimal digits follow stays.
std::string unescaped(std::string_view text);

/// Whether these bytes are UTF-8: no overlong forms, no surrogates.
bool is_utf8(std::string_view text);

/// Digits, at least one.
bool is_natural(std::string_view token);

/// -?[0-9]+, which the caller has made sure of.
mpz_class to_integer(std::string_view token);

/// -?[0-9]+ of so few digits that an Int holds every number of as many. Returns nullopt for other
/// text.
template <class Int>
std::optional<Int> short_integer(std::string_view token) {
  const bool negative = !token.empty() && token[0] == '-';
  if (negative) token.remove_prefix(1);
  if (token.empty() || token.size() > std::size_t{std::numeric_limits<Int>::digits10}) return std::nullopt;
  Int value = 0;
  for (const char c : token) {
    if (c < '0' || c > '9') return std::nullopt;
    value = static_cast<Int>(value * 10 + (c - '0'));
  }
  return negative ? static_cast<Int>(-value) : value;
}

/// "p/q" for a fraction in lowest terms, without a denominator of 1. The denominator is positive.
std::string ratio_text(const mpz_class& num, const mpz_class& den);
inline std::string text(const Rational& r) { return ratio_text(r.num.value(), r.den.value()); }

}  // namespace fathom_check
