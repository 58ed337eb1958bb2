// SPDX-License-Identifier: Apache-2.0
// A small reader of JSON (RFC 8259). Numbers keep their text. Nesting is limited, memory is paid
// for.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limits.hpp"

namespace fathom_check {

struct Json {
  enum class Kind { null, boolean, number, text, array, object };
  Kind kind = Kind::null;
  std::string text;               ///< of a number as written, of a text decoded to UTF-8
  std::vector<Json> items;        ///< of an array; the values of an object
  std::vector<std::string> keys;  ///< of an object

  /// The value of a field, or nothing. Faults with a field that is given twice: readers differ in
  /// which one they take.
  [[nodiscard]] const Json* field(std::string_view key, std::size_t line) const;
};

/// Reads values from a text, one after another; blanks between them. The text must outlive this.
class JsonReader {
 public:
  static constexpr int deepest = 64;

  /// `line` is that of the text's first byte.
  JsonReader(std::string_view text, std::size_t line) : rest_(text), line_(line) {}

  /// Moves past blanks; whether anything is left.
  bool more();
  /// The next value. Throws Fault.
  Json next(Budget& budget) { return value(budget, 0); }
  [[nodiscard]] std::size_t line() const { return line_; }

 private:
  Json value(Budget& budget, int depth);
  void members(Json& result, Budget& budget, int depth);
  Json number();
  std::string string();
  void escape(std::string& result);
  unsigned code_unit();
  bool take(char c);
  void word(std::string_view text);
  [[nodiscard]] Fault wrong(const std::string& expected) const;

  std::string_view rest_;
  std::size_t line_;
};

// Numbers of case files, read exactly. No floating point is involved, whatever the numbers stand
// for.

constexpr std::size_t longest_case_number = 2'000'000;      ///< digits
constexpr std::int64_t largest_decimal_exponent = 100'000;  ///< in magnitude, as written
constexpr std::int64_t largest_binary_exponent = 400'000;

/// An exact number: integer, p/q, decimal, or C99 hexadecimal float, with an optional sign. Returns
/// nullopt for other text, and beyond the limits.
std::optional<mpq_class> exact_number(std::string_view text);

/// What a JSON number means: the binary64 nearest to it, ties to even. Returns nullopt if that is
/// infinite.
std::optional<mpq_class> nearest_binary64(std::string_view json_number);

/// Rounds to the nearest binary64, ties to even, subnormals included. False if that would be
/// infinite.
bool round_to_binary64(mpq_class& value);

}  // namespace fathom_check
