// SPDX-License-Identifier: GPL-3.0-or-later
// The one writer of JSON. `Json` is a value that can be put into another one; `JsonStream` writes
// straight into one text, commas and all, where there may be hundreds of thousands of numbers.
// Neither builds a document.
#pragma once

#include <gmpxx.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/vector.hpp"

namespace fathom::text {

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
  /// A number in the shortest text that reads back as it, and as a float: 2.0. What is not finite
  /// becomes null.
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
  /// The items as an array, each as `write` makes it a Json.
  template <class List, class Write>
  static Json array_of(const List& list, Write write) {
    Json result = array();
    for (const auto& item : list) result.push_back(write(item));
    return result;
  }
  /// What is a value of JSON already.
  static Json written(std::string text);
  /// An exact number for any reader: a JSON number if it is one of binary64, in the shortest text
  /// that reads back as it; else a string, an integer or p/q.
  static Json exact(const mpq_class& value);
  static Json exact(const Point& p) { return array({exact(p.x), exact(p.y), exact(p.z)}); }

  /// Makes room for a text of so many bytes.
  Json& reserve(std::size_t room) {
    text_.reserve(room);
    return *this;
  }
  /// Appends to an array.
  void push_back(const Json& value);
  /// Appends a field to an object; null becomes one. The key, any bytes, is new.
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
  /// The same on several lines, each level two spaces further in.
  [[nodiscard]] std::string indented() const;

 private:
  void open_for_more();

  std::string text_;
};

struct Json::Field {
  std::string_view key;
  Json value;
};

/// Appends values to a text, with commas where needed. Keys need no escapes.
class JsonStream {
 public:
  /// With room for so many bytes; it grows.
  explicit JsonStream(std::size_t room = 0) { text_.reserve(room); }

  [[nodiscard]] std::string take() { return std::move(text_); }

  JsonStream& open(char bracket);
  JsonStream& close(char bracket);
  /// `fill` writes the fields, or the elements.
  template <class Fill>
  void object(Fill fill) {
    open('{');
    fill();
    close('}');
  }
  template <class Fill>
  void array(Fill fill) {
    open('[');
    fill();
    close(']');
  }
  /// An array of what `write` writes for each element.
  template <class Range, class Write>
  void array_of(const Range& range, Write write) {
    array([&] {
      for (const auto& element : range) write(element);
    });
  }
  void array_of(const std::vector<std::uint32_t>& numbers) {
    array_of(numbers, [this](std::uint32_t n) { integer(n); });
  }

  /// Before a value in an object.
  JsonStream& key(std::string_view name);

  JsonStream& null() { return value("null"); }
  JsonStream& boolean(bool is) { return value(is ? "true" : "false"); }
  template <std::integral Integer>
  JsonStream& integer(Integer n) {
    return value(std::to_string(n));
  }
  JsonStream& integer_or_null(const std::optional<std::uint32_t>& n) { return n ? integer(*n) : null(); }
  /// A finite number with so many significant digits; 0 stands for the shortest text that reads
  /// back as it. -0 becomes 0.
  JsonStream& number(double value, int digits);
  JsonStream& numbers(const std::array<double, 3>& values, int digits);
  /// A number as Json writes it: 2.0, and null of what is not finite.
  JsonStream& decimal(double value);
  /// Exact numbers, as strings.
  JsonStream& exact(const mpz_class& n);
  JsonStream& exact(const mpq_class& q);
  JsonStream& exact(const Vector& v) { return open('[').exact(v.x).exact(v.y).exact(v.z).close(']'); }
  JsonStream& exact(const Point& p) { return open('[').exact(p.x).exact(p.y).exact(p.z).close(']'); }
  /// Hexadecimal floats, as strings.
  JsonStream& hex(double value);
  JsonStream& hex(const std::array<double, 3>& p) { return open('[').hex(p[0]).hex(p[1]).hex(p[2]).close(']'); }
  /// A string of any bytes: what is not UTF-8 is replaced.
  JsonStream& string(std::string_view any) { return value(Json(any).text()); }
  /// A string of characters that need no escapes.
  JsonStream& plain(std::string_view characters);
  /// What is a value of JSON already.
  JsonStream& value(std::string_view written);

 private:
  void separate();

  std::string text_;
  bool first_ = true;  // no comma is due
};

/// How many bytes the first character of a text has; 0 if it is not UTF-8.
std::size_t utf8_size(std::string_view text);

/// Returns the text with U+FFFD for what is not UTF-8.
std::string valid_utf8(const std::string& text);

}  // namespace fathom::text
