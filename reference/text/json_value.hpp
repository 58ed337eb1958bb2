// SPDX-License-Identifier: GPL-3.0-or-later
// The one reader of JSON into memory: fields in their order, repeated ones too, and numbers as they
// were written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/numbers.hpp"
#include "reference/text/json.hpp"

namespace fathom::text {

/// JSON is not what a reader of it expects: "expected a field 'id', found none".
struct JsonFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A value of JSON. Small, as a text may hold many millions of numbers.
class JsonValue {
 public:
  /// Integers of at most 64 bits are `natural`, or `negative` with a minus before them; all other
  /// numbers are `real`.
  enum class Kind : unsigned char { null, boolean, natural, negative, real, string, array, object };
  using Field = std::pair<std::string_view, const JsonValue*>;

  JsonValue() = default;
  explicit JsonValue(Kind kind, double number = 0) : kind_(kind), number_(number) {}
  JsonValue(Kind kind, std::string text, double number = 0);

  [[nodiscard]] bool is_null() const { return kind_ == Kind::null; }
  [[nodiscard]] bool is_natural() const { return kind_ == Kind::natural; }
  [[nodiscard]] bool is_number() const {
    return kind_ == Kind::natural || kind_ == Kind::negative || kind_ == Kind::real;
  }
  [[nodiscard]] bool is_boolean() const { return kind_ == Kind::boolean; }
  [[nodiscard]] bool is_string() const { return kind_ == Kind::string; }
  [[nodiscard]] bool is_array() const { return kind_ == Kind::array; }
  [[nodiscard]] bool is_object() const { return kind_ == Kind::object; }
  [[nodiscard]] Kind kind() const { return kind_; }

  /// The nearest binary64 of a number; 1 or 0 of true or false.
  [[nodiscard]] double number() const { return number_; }
  /// The characters of a string; a number as it was written (an integer by its digits); "true",
  /// "false", "null".
  [[nodiscard]] std::string text() const;
  /// The elements of an array; the values of an object. None of others.
  [[nodiscard]] const std::vector<JsonValue>& items() const { return parts_ ? parts_->items : none_; }
  [[nodiscard]] std::string_view key(std::size_t i) const { return parts_->keys[i]; }
  /// The fields of an object by their names; of a repeated one the last.
  [[nodiscard]] std::vector<Field> fields() const;
  /// The last field of this name; null if there is none, or if this is no object.
  [[nodiscard]] const JsonValue* find(std::string_view name) const;

  // For readers of what fathom itself writes: each throws JsonFault unless it is there, and of the
  // kind.
  [[nodiscard]] const JsonValue& at(std::string_view name) const;
  [[nodiscard]] const JsonValue& at(std::size_t i) const;
  [[nodiscard]] const std::string& string() const;
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] std::uint64_t natural(std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) const;

  /// canonical: fields by their names and numbers as the nearest binary64, so that equal values
  /// have the same text. sorted: fields by their names, numbers as they were written. given: all as
  /// it was written.
  enum class Form { canonical, sorted, given };
  /// Written anew, in one line.
  [[nodiscard]] Json written(Form form = Form::canonical) const;

  bool too_deep = false;   ///< this array or object lies in so many others that it was not read
  bool too_large = false;  ///< this number is beyond binary64; it is the last value of its text that was read

 private:
  friend class JsonBuilder;
  struct Parts {
    std::string text;
    std::vector<JsonValue> items;
    std::vector<std::string> keys;
  };
  static const std::vector<JsonValue> none_;

  Kind kind_ = Kind::null;
  double number_ = 0;
  std::unique_ptr<Parts> parts_;
};

/// What could be read of a text.
struct JsonRead {
  JsonValue value;           ///< all of it, or what came before the error
  bool whole = false;        ///< the text is one value of JSON
  std::size_t error_at = 0;  ///< the byte where the text is no JSON any more
  std::string error;         ///< "expected ',' or ']', found 'x'"; "" also if a number was too large
};

/// Arrays and objects within each other that are read, as in the checker of certificates.
inline constexpr std::size_t deepest_json = 64;

/// How many of the bytes that a text begins with are a number that JSON does not have, such as a
/// NaN; 0 if none is. It is kept as it was written, and its number() is 0.
using NumberWord = std::size_t (*)(std::string_view text);

/// Never throws on bad input. A null byte ends the text. `word`, if given, is asked first where a
/// value begins.
JsonRead read_json(std::string_view text, NumberWord word = nullptr);

/// The value, or throws JsonFault.
JsonValue parsed_json(std::string_view text);

/// The exact number that is meant: a JSON number is the nearest binary64, an integer too; a string
/// is what parse_number reads as exact. Neither a value nor an error if it is neither.
ParsedNumber exact_number(const JsonValue& value);

}  // namespace fathom::text
