// SPDX-License-Identifier: GPL-3.0-or-later
// JSON that is written, and never read: a value is its text, so no document is built.
#pragma once

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace fathom::cli {

/// A value of JSON, as one line of pure ASCII. Fields stay in the order in which they are added.
class Json {
 public:
  struct Field;

  Json() : text_("null") {}
  Json(std::nullptr_t) : Json() {}
  /// A string; any bytes: what is not UTF-8 is replaced, never an error.
  Json(std::string_view string);
  Json(const std::string& string) : Json(std::string_view(string)) {}
  Json(const char* string) : Json(std::string_view(string)) {}
  template <std::integral Integer>
  Json(Integer value) : text_(std::to_string(value)) {
    static_assert(sizeof(Integer) > 1, "neither bool nor char");
  }
  /// A finite number, in a short text that reads back as it.
  Json(double value);
  template <std::integral Integer>
  Json(const std::vector<Integer>& values) : Json(array()) {
    for (const Integer value : values) push_back(value);
  }
  /// An object.
  Json(std::initializer_list<Field> fields);

  /// A string of characters that need no escapes: what numbers are written with.
  static Json plain(std::string_view string);
  static Json boolean(bool value);
  static Json array(std::initializer_list<Json> values = {});
  static Json object();

  /// Appends to an array.
  void push_back(const Json& value);
  /// Appends a field to an object; null becomes one. The key is new, and needs no escapes.
  void add(std::string_view key, const Json& value);

  /// `json[key] = value` is `json.add(key, value)`.
  class Place {
   public:
    Place(Json& object, std::string_view key) : object_(object), key_(key) {}
    void operator=(const Json& value) && { object_.add(key_, value); }

   private:
    Json& object_;
    std::string_view key_;
  };
  Place operator[](std::string_view key) { return {*this, key}; }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void open_for_more();

  std::string text_;
};

struct Json::Field {
  std::string_view key;
  Json value;
};

/// Returns the text with U+FFFD for what is not UTF-8.
std::string valid_utf8(const std::string& text);

}  // namespace fathom::cli
