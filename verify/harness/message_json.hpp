// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of subjects as JSON whose numbers are as they were written, and fields of a type. Not a door: that is protocol.hpp.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/judge.hpp"
#include "kernels/printable.hpp"

namespace fathom::harness {

/// Throws ProtocolError: "expected ..., found ...".
[[noreturn]] void refuse(const std::string& expected, const std::string& found);

/// Whether this is a number as it was written, which a parser of JSON would round: a type of value that no text makes.
bool is_number(const nlohmann::json& value);
std::string written(const nlohmann::json& number);

/// As JSON, but with numbers as they were written; and in quotes for messages.
std::string dumped(const nlohmann::json& value);
std::string shown_json(const nlohmann::json& value);

/// The JSON on the line. What is nested deeper than any message of ours is left out, so that no line costs more than a few times its
/// length. `repeated`, if given, becomes the first name that an object has twice: readers differ in which of the two they take.
nlohmann::json json_on(std::string_view line, std::string* repeated = nullptr);
/// The same, which must be an object, each with its fields once.
nlohmann::json object_on(std::string_view line);

/// The field, or null. A field that is null is no way to leave it out: it is what many a program writes for NaN.
const nlohmann::json* field(const nlohmann::json& object, const char* name);

// Each throws ProtocolError unless the field `name` is there, and of the type; `of` names the object in the message.
std::string text_in(const nlohmann::json& object, const char* name, const char* of);
bool flag_in(const nlohmann::json& object, const char* name, const char* of, std::optional<bool> otherwise = std::nullopt);
const nlohmann::json& object_in(const nlohmann::json& object, const char* name, const char* of);
/// A number, or a text of one, rounded to the precision; NaN and infinities too.
double number_of(const nlohmann::json& value, const char* name, Precision precision);
/// Three of them; nullopt if the field is not there.
std::optional<Triple> triple_in(const nlohmann::json& object, const char* name, const char* called, Precision precision);

/// The value of one of the words.
template <class Value>
Value word_in(const nlohmann::json& object, const char* name, const char* of, std::initializer_list<std::pair<const char*, Value>> words) {
  const std::string text = text_in(object, name, of);
  std::vector<std::string> expected;
  for (const auto& [word, value] : words) {
    if (text == word) return value;
    expected.emplace_back(word);
  }
  refuse(fmt::format("{} for \"{}\" in {}", fmt::join(expected, ", "), name, of), kernels::shown(text));
}

}  // namespace fathom::harness
