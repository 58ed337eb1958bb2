// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/loose_json.hpp"

#include <cctype>
#include <limits>

#include "kernels/number/parse.hpp"
#include "kernels/number/rounding.hpp"

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

bool is_nan(std::string_view word) {
  const std::size_t bracket = word.find('(');
  if (bracket != std::string_view::npos && word.back() != ')') return false;
  return same_word(word.substr(0, bracket), "nan");
}

}  // namespace

std::string with_quoted_numbers(std::string_view text) {
  std::string result;
  result.reserve(text.size() + text.size() / 4);
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view piece = text[i] == '"' ? string_at(text, i) : word_at(text, i);
    if (piece.empty()) {
      result += text[i++];
      continue;
    }
    const bool as_it_is = text[i] == '"' || piece == "true" || piece == "false" || piece == "null";
    if (!as_it_is) result += '"';
    result += piece;
    if (!as_it_is) result += '"';
    i += piece.size();
  }
  return result;
}

std::optional<double> read_number(std::string_view text, Precision precision) {
  const bool has_sign = !text.empty() && (text[0] == '-' || text[0] == '+');
  const std::string_view word = text.substr(has_sign ? 1 : 0);
  const double sign = has_sign && text[0] == '-' ? -1 : 1;
  if (!word.empty() && is_nan(word)) return std::numeric_limits<double>::quiet_NaN();
  if (same_word(word, "inf") || same_word(word, "infinity")) return sign * std::numeric_limits<double>::infinity();
  const ParsedNumber number = parse_number(text, Decimals::exact);
  if (!number.value) return std::nullopt;
  if (precision == Precision::binary32) return round_binary32(*number.value, Rounding::rn);
  return round_binary64(*number.value, Rounding::rn);
}

}  // namespace fathom::harness
