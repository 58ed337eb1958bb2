// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/loose_json.hpp"

#include <algorithm>
#include <cctype>
#include <limits>

#include "fathom/numbers.hpp"

namespace fathom::harness {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool same_word(std::string_view text, std::string_view lower) {
  if (text.size() != lower.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (std::tolower(static_cast<unsigned char>(text[i])) != lower[i]) return false;
  return true;
}

/// The string that starts at `from`, a quotation mark, with both of its marks.
std::string_view string_at(std::string_view text, std::size_t from) {
  for (std::size_t i = from + 1; i < text.size(); ++i) {
    if (text[i] == '\\') ++i;
    else if (text[i] == '"') return text.substr(from, i + 1 - from);
  }
  return text.substr(from);
}

/// The bare word that starts at `from`; "nan(0x8000)" is one.
std::string_view word_at(std::string_view text, std::size_t from) {
  std::size_t end = from;
  const auto belongs = [&](char c) { return is_letter(c) || is_digit(c) || c == '+' || c == '-' || c == '.' || c == '_' || c == '#'; };
  while (end < text.size() && belongs(text[end])) ++end;
  if (end < text.size() && text[end] == '(') {
    const std::size_t close = text.find(')', end);
    if (close != std::string_view::npos) end = close + 1;
  }
  return text.substr(from, end - from);
}

/// "nan", or with what C calls a sequence of characters: "nan(0x8000)".
bool is_nan(std::string_view word) {
  if (!same_word(word.substr(0, word.find('(')), "nan")) return false;
  const std::string_view rest = word.substr(3);
  const auto belongs = [](char c) { return is_letter(c) || is_digit(c) || c == '_'; };
  return rest.empty() || (rest.size() > 1 && rest.back() == ')' && std::all_of(rest.begin() + 1, rest.end() - 1, belongs));
}

std::string_view without_sign(std::string_view word) { return word.starts_with('-') || word.starts_with('+') ? word.substr(1) : word; }

bool is_infinite(std::string_view word) { return same_word(word, "inf") || same_word(word, "infinity"); }

bool looks_like_a_number(std::string_view word) {
  const std::string_view size = without_sign(word);
  return !size.empty() && (is_digit(size[0]) || size[0] == '.' || is_nan(size) || is_infinite(size));
}

/// The number with an exponent that is read exactly. A larger one makes any number that is not as long itself infinite, or 0, and so does
/// the largest that is read.
std::string with_exponent_in_reach(std::string_view text) {
  constexpr std::size_t longest = 90'000;  // characters: fewer digits, and fewer bits, than the exponents' limits
  const std::string_view size = without_sign(text);
  const bool hex = size.size() > 1 && same_word(size.substr(0, 2), "0x");
  const std::size_t letter = text.find_first_of(hex ? "pP" : "eE");
  if (letter == text.npos || text.size() > longest) return std::string(text);
  const std::size_t digits = letter + 1 + (letter + 1 < text.size() && (text[letter + 1] == '-' || text[letter + 1] == '+') ? 1 : 0);
  if (digits == text.size() || !std::all_of(text.begin() + static_cast<std::ptrdiff_t>(digits), text.end(), is_digit))
    return std::string(text);
  const std::string_view exponent = text.substr(std::min(text.find_first_not_of('0', digits), text.size()));
  const std::string largest = std::to_string(hex ? largest_binary_exponent : largest_decimal_exponent);
  const bool in_reach = exponent.size() < largest.size() || (exponent.size() == largest.size() && exponent <= largest);
  return std::string(text.substr(0, digits)) + (in_reach ? std::string(text.substr(digits)) : largest);
}

}  // namespace

WithoutNumbers without_numbers(std::string_view text) {
  WithoutNumbers result;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view piece = text[i] == '"' ? string_at(text, i) : word_at(text, i);
    if (piece.empty()) {
      result.text += text[i++];
      continue;
    }
    if (text[i] != '"' && looks_like_a_number(piece)) {
      result.text += std::to_string(result.numbers.size());
      result.numbers.emplace_back(piece);
    } else {
      result.text += piece;
    }
    i += piece.size();
  }
  return result;
}

std::optional<double> read_number(std::string_view text, Precision precision) {
  const std::string_view word = without_sign(text);
  if (is_nan(word)) return std::numeric_limits<double>::quiet_NaN();
  if (is_infinite(word)) return (text[0] == '-' ? -1 : 1) * std::numeric_limits<double>::infinity();
  if (text.find('/') != text.npos) return std::nullopt;
  const ParsedNumber number = parse_number(with_exponent_in_reach(text), Decimals::exact);
  if (!number.value) return std::nullopt;
  if (precision == Precision::binary32) return round_binary32(*number.value, Rounding::rn);
  return round_binary64(*number.value, Rounding::rn);
}

std::optional<std::string> read_integer(std::string_view text) {
  const ParsedNumber number = parse_number(text, Decimals::exact);
  if (!number.value || number.value->get_den() != 1) return std::nullopt;
  return number.value->get_num().get_str();
}

}  // namespace fathom::harness
