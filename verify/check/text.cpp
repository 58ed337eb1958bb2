// SPDX-License-Identifier: Apache-2.0
#include "text.hpp"

namespace fathom_check {
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

}  // namespace

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 60;
  const bool cut = text.size() > longest;
  return "'" + escaped(text.substr(0, longest)) + (cut ? "...'" : "'");
}

std::string escaped(std::string_view text) {
  constexpr char digits[] = "0123456789ABCDEF";
  std::string result;
  for (const char c : text) {
    const unsigned code = static_cast<unsigned char>(c);
    if (c >= ' ' && c <= '~' && c != '%') {
      result += c;
    } else {
      result += {'%', digits[code / 16], digits[code % 16]};
    }
  }
  return result;
}

std::string unescaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool pair = text[i] == '%' && i + 2 < text.size();
    const int high = pair ? hex_digit(text[i + 1]) : -1, low = pair ? hex_digit(text[i + 2]) : -1;
    if (high < 0 || low < 0) {
      result += text[i];
    } else {
      result += static_cast<char>(high * 16 + low);
      i += 2;
    }
  }
  return result;
}

mpz_class to_integer(std::string_view token) {
  constexpr std::size_t short_enough = 18;  // fits a long
  if (token.size() > short_enough) {
    mpz_class result;
    result.set_str(std::string(token), 10);
    return result;
  }
  long value = 0;
  const bool negative = token[0] == '-';
  for (const char c : token.substr(negative ? 1 : 0)) value = value * 10 + (c - '0');
  return mpz_class(negative ? -value : value);
}

std::string ratio_text(const mpz_class& num, const mpz_class& den) {
  mpq_class ratio(num, den);
  ratio.canonicalize();
  return ratio.get_str();
}

}  // namespace fathom_check
