// SPDX-License-Identifier: Apache-2.0
#include "text.hpp"

#include <algorithm>

namespace fathom_check {
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// What is below `first`, not ASCII, or %, as %XX.
std::string escaped_below(char first, std::string_view text) {
  constexpr char digits[] = "0123456789ABCDEF";
  std::string result;
  for (const char c : text) {
    const unsigned code = static_cast<unsigned char>(c);
    if (c >= first && c <= '~' && c != '%') {
      result += c;
    } else {
      result += {'%', digits[code / 16], digits[code % 16]};
    }
  }
  return result;
}

}  // namespace

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 60;
  const bool cut = text.size() > longest;
  return "'" + escaped_below(' ', text.substr(0, longest)) + (cut ? "...'" : "'");
}

std::string escaped(std::string_view text) { return escaped_below('!', text); }

// The length of a sequence and the range of its second byte follow from the first byte (Unicode,
// table 3-7).
bool is_utf8(std::string_view text) {
  const auto within = [](char c, unsigned low, unsigned high) {
    const unsigned code = static_cast<unsigned char>(c);
    return low <= code && code <= high;
  };
  while (!text.empty()) {
    const char c = text[0];
    const std::size_t length = within(c, 0, 0x7F)      ? 1
                               : within(c, 0xC2, 0xDF) ? 2
                               : within(c, 0xE0, 0xEF) ? 3
                               : within(c, 0xF0, 0xF4) ? 4
                                                       : 0;
    if (length == 0 || text.size() < length) return false;
    const unsigned low = c == '\xE0'   ? 0xA0
                         : c == '\xF0' ? 0x90
                                       : 0x80,
                   high = c == '\xED'   ? 0x9F
                          : c == '\xF4' ? 0x8F
                                        : 0xBF;
    for (std::size_t i = 1; i < length; ++i)
      if (!within(text[i], i == 1 ? low : 0x80, i == 1 ? high : 0xBF)) return false;
    text.remove_prefix(length);
  }
  return true;
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

bool is_natural(std::string_view token) {
  return !token.empty() && std::all_of(token.begin(), token.end(), [](char c) { return c >= '0' && c <= '9'; });
}

mpz_class to_integer(std::string_view token) {
  if (const std::optional<long> value = short_integer<long>(token)) return *value;
  mpz_class result;
  result.set_str(std::string(token), 10);
  return result;
}

std::string ratio_text(const mpz_class& num, const mpz_class& den) {
  return den == 1 ? num.get_str() : num.get_str() + '/' + den.get_str();
}

}  // namespace fathom_check
