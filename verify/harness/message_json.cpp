// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/message_json.hpp"

#include <algorithm>
#include <cctype>
#include <limits>

#include "fathom/numbers.hpp"
#include "verify/harness/protocol.hpp"

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

/// The bare word that a text begins with; "nan(0x8000)" is one.
std::string_view first_word(std::string_view text) {
  std::size_t end = 0;
  const auto belongs = [&](char c) {
    return is_letter(c) || is_digit(c) || c == '+' || c == '-' || c == '.' || c == '_' || c == '#';
  };
  while (end < text.size() && belongs(text[end])) ++end;
  if (end < text.size() && text[end] == '(') {
    const std::size_t close = text.find(')', end);
    if (close != std::string_view::npos) end = close + 1;
  }
  return text.substr(0, end);
}

/// "nan", or with what C calls a sequence of characters: "nan(0x8000)".
bool is_nan(std::string_view word) {
  if (!same_word(word.substr(0, word.find('(')), "nan")) return false;
  const std::string_view rest = word.substr(3);
  const auto belongs = [](char c) { return is_letter(c) || is_digit(c) || c == '_'; };
  return rest.empty() ||
         (rest.size() > 1 && rest.back() == ')' && std::all_of(rest.begin() + 1, rest.end() - 1, belongs));
}

std::string_view without_sign(std::string_view word) {
  return word.starts_with('-') || word.starts_with('+') ? word.substr(1) : word;
}

bool is_infinite(std::string_view word) { return same_word(word, "inf") || same_word(word, "infinity"); }

bool looks_like_a_number(std::string_view word) {
  const std::string_view size = without_sign(word);
  return !size.empty() && (is_digit(size[0]) || size[0] == '.' || is_nan(size) || is_infinite(size));
}

/// The number with an exponent that is read exactly. A larger one makes any number that is not as
/// long itself infinite, or 0, and so does the largest that is read.
std::string with_exponent_in_reach(std::string_view text) {
  constexpr std::size_t longest = 90'000;  // characters: fewer digits, and fewer bits, than the exponents' limits
  const std::string_view size = without_sign(text);
  const bool hex = size.size() > 1 && same_word(size.substr(0, 2), "0x");
  const std::size_t letter = text.find_first_of(hex ? "pP" : "eE");
  if (letter == text.npos || text.size() > longest) return std::string(text);
  const std::size_t digits =
      letter + 1 + (letter + 1 < text.size() && (text[letter + 1] == '-' || text[letter + 1] == '+') ? 1 : 0);
  if (digits == text.size() || !std::all_of(text.begin() + static_cast<std::ptrdiff_t>(digits), text.end(), is_digit))
    return std::string(text);
  const std::string_view exponent = text.substr(std::min(text.find_first_not_of('0', digits), text.size()));
  const std::string largest = std::to_string(hex ? largest_binary_exponent : largest_decimal_exponent);
  const bool in_reach = exponent.size() < largest.size() || (exponent.size() == largest.size() && exponent <= largest);
  return std::string(text.substr(0, digits)) + (in_reach ? std::string(text.substr(digits)) : largest);
}

using Json = JsonValue;
constexpr std::size_t shown_bytes = 200;

/// A field that an object in the value has twice; or "".
std::string repeated_field(const Json& value) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < value.items().size(); ++i) {
    if (value.is_object()) names.push_back(value.key(i));
    if (std::string within = repeated_field(value.items()[i]); !within.empty()) return within;
  }
  std::ranges::sort(names);
  const auto twice = std::ranges::adjacent_find(names);
  return twice == names.end() ? "" : std::string(*twice);
}

}  // namespace

std::size_t number_word(std::string_view text) {
  const std::string_view word = first_word(text);
  return looks_like_a_number(word) ? word.size() : 0;
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

void refuse(const std::string& expected, const std::string& found) {
  throw ProtocolError("expected " + expected + ", found " + found);
}

std::string shown_json(const Json& value) {
  return '\'' + kernels::printable(value.written(Json::Form::sorted).text(), shown_bytes) + '\'';
}

Json json_on(std::string_view line) {
  text::JsonRead read = text::read_json(line, number_word);
  return read.whole ? std::move(read.value) : Json();
}

Json object_on(std::string_view line) {
  if (line.find('\0') != std::string_view::npos)
    refuse("a JSON object", "a null byte in " + kernels::shown(line));  // to the parser, the end
  Json object = json_on(line);
  if (!object.is_object())
    throw ProtocolError("expected a JSON object, found " + (line.empty() ? "an empty line" : kernels::shown(line)));
  if (const std::string repeated = repeated_field(object); !repeated.empty())
    refuse("each field once", kernels::shown(repeated) + " twice");
  return object;
}

std::string text_in(const Json& object, const char* name, const char* of) {
  const Json* value = object.find(name);
  if (!value) refuse(fmt::format("\"{}\" in {}", name, of), "none");
  if (!value->is_string()) refuse(fmt::format("a text for \"{}\" in {}", name, of), shown_json(*value));
  return value->text();
}

bool flag_in(const Json& object, const char* name, const char* of, std::optional<bool> otherwise) {
  const Json* value = object.find(name);
  if (!value && otherwise) return *otherwise;
  if (!value) refuse(fmt::format("\"{}\" in {}", name, of), "none");
  if (!value->is_boolean()) refuse(fmt::format("true or false for \"{}\" in {}", name, of), shown_json(*value));
  return value->boolean();
}

const Json& object_in(const Json& object, const char* name, const char* of) {
  const Json* value = object.find(name);
  if (!value || !value->is_object())
    refuse(fmt::format("an object for \"{}\" in {}", name, of), value ? shown_json(*value) : "none");
  return *value;
}

double number_of(const Json& value, const char* name, Precision precision) {
  std::optional<double> number;
  if (value.is_number() || value.is_string()) number = read_number(value.text(), precision);
  if (!number)
    refuse(fmt::format("a number for \"{}\"{}", name, value.is_null() ? " (NaN is \"nan\")" : ""), shown_json(value));
  return *number;
}

Triple triple_of(const Json& value, const char* name, Precision precision) {
  Triple triple;
  if (value.items().size() != triple.size() || !value.is_array())
    refuse(fmt::format("three numbers for \"{}\"", name), shown_json(value));
  for (std::size_t i = 0; i < triple.size(); ++i) triple[i] = number_of(value.items()[i], name, precision);
  return triple;
}

std::optional<Triple> triple_in(const Json& object, const char* name, const char* called, Precision precision) {
  const Json* value = object.find(name);
  return value ? std::optional(triple_of(*value, called, precision)) : std::nullopt;
}

}  // namespace fathom::harness
