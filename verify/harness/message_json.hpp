// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of subjects as JSON whose numbers are as they were written, even by hand, as a NaN by
// printf("%g"); and fields of a type. Not a door: that is protocol.hpp.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/judge.hpp"
#include "kernels/messages.hpp"
#include "reference/text/json_value.hpp"
#include "verify/judge/fields.hpp"

namespace fathom::harness {

using text::JsonValue;

/// How many of the bytes that a text begins with are a number, even one that JSON does not have:
/// every bare word that starts like a number, or is a spelling of NaN or infinity.
std::size_t number_word(std::string_view text);

/// Reads a decimal or C99 hex float with any exponent, rounded once to the precision, or a spelling
/// of NaN or infinity with or without a sign, in upper or lower case ("-nan", "NAN", "nan(0x8000)",
/// "inf", "-Infinity"). Returns nullopt for anything else, ratios included.
std::optional<double> read_number(std::string_view text, Precision precision);

/// The digits of an integer, however it is written ("7", "7.0", "7e0"); nullopt if it is not an
/// integer.
std::optional<std::string> read_integer(std::string_view text);

/// Throws ProtocolError: "expected ..., found ...".
[[noreturn]] void refuse(const std::string& expected, const std::string& found);

/// For messages: in quotes, with numbers as they were written.
std::string shown_json(const JsonValue& value);

/// The JSON on the line, its numbers as they were written; null if it is none.
JsonValue json_on(std::string_view line);
/// The same, which must be an object, each with its fields once: readers differ in which of two
/// they take.
JsonValue object_on(std::string_view line);

// Each throws ProtocolError unless the field `name` is there, and of the type; `of` names the
// object in the message.
std::string text_in(const JsonValue& object, const char* name, const char* of);
bool flag_in(const JsonValue& object, const char* name, const char* of, std::optional<bool> otherwise = std::nullopt);
const JsonValue& object_in(const JsonValue& object, const char* name, const char* of);
/// A number, or a text of one, rounded to the precision; NaN and infinities too.
double number_of(const JsonValue& value, const char* name, Precision precision);
/// Three of them; nullopt if the field is not there.
std::optional<Triple> triple_in(const JsonValue& object, const char* name, const char* called, Precision precision);

/// Of a value, not of a field: `name` is what it is called.
Triple triple_of(const JsonValue& value, const char* name, Precision precision);

/// The value of one of the words of its type.
template <class Value>
Value word_in(const JsonValue& object, const char* name, const char* of) {
  const std::string text = text_in(object, name, of);
  std::vector<std::string_view> expected;
  for (const auto& [word, value] : judging::words_of(Value())) {
    if (text == word) return value;
    expected.push_back(word);
  }
  refuse(fmt::format("{} for \"{}\" in {}", fmt::join(expected, ", "), name, of), kernels::shown(text));
}

}  // namespace fathom::harness
