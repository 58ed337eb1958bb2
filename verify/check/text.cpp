// SPDX-License-Identifier: Apache-2.0
#include "text.hpp"

#include <algorithm>
#include <array>

#include "fixed.hpp"

namespace fathom_check {
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// Eight characters, the first one lowest. Compilers make one load of it.
std::uint64_t eight(const char* at) {
  const auto byte = [at](unsigned i) { return std::uint64_t{static_cast<unsigned char>(at[i])} << 8 * i; };
  return byte(0) | byte(1) | byte(2) | byte(3) | byte(4) | byte(5) | byte(6) | byte(7);
}

/// Whether each is 0x30 to 0x39: with 6 added, its upper half is 3 still.
bool are_digits(std::uint64_t characters) {
  constexpr std::uint64_t upper = 0xf0f0f0f0f0f0f0f0, zeros = 0x3030303030303030, six = 0x0606060606060606;
  return (characters & upper) == zeros && ((characters + six) & upper) == zeros;
}

/// The number that eight digits spell. Each step joins neighbours: digits to pairs, these to fours,
/// these to the whole.
std::uint64_t eight_digits(const char* at) {
  const std::uint64_t digits = eight(at) & 0x0f0f0f0f0f0f0f0f;
  const std::uint64_t pairs = (10 * digits + (digits >> 8)) & 0x00ff00ff00ff00ff,
                      fours = (100 * pairs + (pairs >> 16)) & 0x0000ffff0000ffff;
  return (10000 * fours + (fours >> 32)) & 0xffffffff;
}

/// Of at most 16 digits.
std::uint64_t number_of(std::string_view digits) {
  std::uint64_t value = 0;
  for (; digits.size() >= 8; digits.remove_prefix(8)) value = value * 100'000'000 + eight_digits(digits.data());
  for (const char c : digits) value = value * 10 + static_cast<std::uint64_t>(c - '0');
  return value;
}

constexpr std::size_t most_digits_by_words = 640;  // GMP's time for more does not grow with their square

/// Takes 16 digits after another into words; 19 digits are less than 64 bits.
mpz_class integer_by_words(std::string_view digits) {
  constexpr std::size_t step = 16;
  std::array<std::uint64_t, most_digits_by_words / 19 + 1> words;
  std::size_t size = 0;
  for (std::size_t count = digits.size() % step; !digits.empty(); count = step) {
    std::uint64_t carry = number_of(digits.substr(0, count));
    digits.remove_prefix(count);
    for (std::size_t i = 0; i < size; ++i) {
      const Uint128 product = Uint128{words[i]} * 10'000'000'000'000'000U + carry;
      words[i] = static_cast<std::uint64_t>(product);
      carry = static_cast<std::uint64_t>(product >> 64);
    }
    if (carry != 0) words[size++] = carry;
  }
  mpz_class result;
  mpz_import(result.get_mpz_t(), size, -1, sizeof(words[0]), 0, 0, words.data());
  return result;
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
  if (token.empty()) return false;
  for (; token.size() >= 8; token.remove_prefix(8))
    if (!are_digits(eight(token.data()))) return false;
  return std::all_of(token.begin(), token.end(), [](char c) { return c >= '0' && c <= '9'; });
}

mpz_class to_integer(std::string_view token) {
  if (const std::optional<long> value = short_integer<long>(token)) return *value;
  const bool negative = token[0] == '-';
  const std::string_view digits = token.substr(negative ? 1 : 0);
  mpz_class result;
  if (digits.size() <= most_digits_by_words) result = integer_by_words(digits);
  else result.set_str(std::string(digits), 10);
  if (negative) result = -result;
  return result;
}

std::string ratio_text(const mpz_class& num, const mpz_class& den) {
  return den == 1 ? num.get_str() : num.get_str() + '/' + den.get_str();
}

}  // namespace fathom_check
