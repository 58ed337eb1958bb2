// SPDX-License-Identifier: Apache-2.0
#include "json.hpp"

#include <algorithm>
#include <string>

#include "text.hpp"

namespace fathom_check {

namespace {

void append_utf8(std::string& text, unsigned code) {
  const auto tail = [&](int shift) { text += static_cast<char>(0x80 | ((code >> shift) & 0x3F)); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0 | (code >> 6));
    tail(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0 | (code >> 12));
    tail(6);
    tail(0);
  } else {
    text += static_cast<char>(0xF0 | (code >> 18));
    tail(12);
    tail(6);
    tail(0);
  }
}

std::size_t digits(std::string_view text) {
  const std::size_t end = text.find_first_not_of("0123456789");
  return end == std::string_view::npos ? text.size() : end;
}

}  // namespace

const Json* Json::field(std::string_view key, std::size_t line) const {
  const Json* found = nullptr;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] != key) continue;
    if (found) throw malformed(line, "the field " + shown(key) + " is given twice");
    found = &items[i];
  }
  return found;
}

Fault JsonReader::wrong(const std::string& expected) const {
  return malformed(line_,
                   "expected " + expected + ", found " + (rest_.empty() ? "the end" : shown(rest_.substr(0, 20))));
}

bool JsonReader::more() {
  while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\t' || rest_[0] == '\r' || rest_[0] == '\n')) {
    if (rest_[0] == '\n') ++line_;
    rest_.remove_prefix(1);
  }
  return !rest_.empty();
}

bool JsonReader::take(char c) {
  if (!more() || rest_[0] != c) return false;
  rest_.remove_prefix(1);
  return true;
}

void JsonReader::word(std::string_view text) {
  if (rest_.substr(0, text.size()) != text) throw wrong("a JSON value");
  rest_.remove_prefix(text.size());
}

Json JsonReader::value(Budget& budget, int depth) {
  budget.store(2 * sizeof(Json), line_);  // vectors grow by doubling
  Json result;
  if (!more()) throw wrong("a JSON value");
  const char first = rest_[0];
  if (first == '{' || first == '[') {
    if (depth == deepest) throw malformed(line_, "nested more than 64 deep");
    members(result, budget, depth);
  } else if (first == '"') {
    result.kind = Json::Kind::text;
    result.text = string();
    budget.store(result.text.size(), line_);
  } else if (first == '-' || (first >= '0' && first <= '9')) {
    result = number();
    budget.store(result.text.size(), line_);
  } else if (first == 'n') {
    word("null");
  } else {
    result.kind = Json::Kind::boolean;
    word(first == 't' ? "true" : "false");
  }
  return result;
}

void JsonReader::members(Json& result, Budget& budget, int depth) {
  const bool object = take('{');
  if (!object) take('[');
  result.kind = object ? Json::Kind::object : Json::Kind::array;
  const char close = object ? '}' : ']';
  if (take(close)) return;
  do {
    if (object) {
      if (!more() || rest_[0] != '"') throw wrong("a field's name in quotes");
      result.keys.push_back(string());
      budget.store(2 * sizeof(std::string) + result.keys.back().size(), line_);
      if (!take(':')) throw wrong("':'");
    }
    result.items.push_back(value(budget, depth + 1));
  } while (take(','));
  if (!take(close)) throw wrong(object ? "',' or '}'" : "',' or ']'");
}

Json JsonReader::number() {
  const std::string_view start = rest_;
  const auto skip = [this](std::size_t count) { rest_.remove_prefix(count); };
  if (rest_[0] == '-') skip(1);
  const std::size_t whole = digits(rest_);
  if (whole == 0 || (whole > 1 && rest_[0] == '0')) throw wrong("a JSON number");
  skip(whole);
  if (!rest_.empty() && rest_[0] == '.') {
    skip(1);
    if (digits(rest_) == 0) throw wrong("digits behind the point");
    skip(digits(rest_));
  }
  if (!rest_.empty() && (rest_[0] | 0x20) == 'e') {
    skip(1);
    if (!rest_.empty() && (rest_[0] == '+' || rest_[0] == '-')) skip(1);
    if (digits(rest_) == 0) throw wrong("the digits of an exponent");
    skip(digits(rest_));
  }
  Json result;
  result.kind = Json::Kind::number;
  result.text = start.substr(0, start.size() - rest_.size());
  return result;
}

std::string JsonReader::string() {
  std::string result;
  rest_.remove_prefix(1);
  while (!rest_.empty() && rest_[0] != '"') {
    const char c = rest_[0];
    if (static_cast<unsigned char>(c) < ' ') throw wrong("no control characters within a text");
    rest_.remove_prefix(1);
    if (c == '\\') {
      escape(result);
    } else {
      result += c;
    }
  }
  if (rest_.empty()) throw wrong("the end of a text");
  if (!is_utf8(result)) throw wrong("UTF-8 in the text before this");  // an escape never completes a sequence
  rest_.remove_prefix(1);
  return result;
}

void JsonReader::escape(std::string& result) {
  constexpr std::string_view names = "\"\\/bfnrt", values = "\"\\/\b\f\n\r\t";
  if (rest_.empty()) throw wrong("an escape");
  const char name = rest_[0];
  rest_.remove_prefix(1);
  if (name != 'u') {
    const std::size_t at = names.find(name);
    if (at == std::string_view::npos) throw wrong("a known escape before this");
    result += values[at];
    return;
  }
  unsigned code = code_unit();
  if (code >= 0xD800 && code < 0xDC00) {  // the first half of a pair
    if (rest_.substr(0, 2) != "\\u") throw wrong("the second half of a surrogate pair");
    rest_.remove_prefix(2);
    const unsigned low = code_unit();
    if (low < 0xDC00 || low > 0xDFFF) throw wrong("the second half of a surrogate pair");
    code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
  } else if (code >= 0xDC00 && code < 0xE000) {
    throw wrong("the first half of a surrogate pair before this");
  }
  append_utf8(result, code);
}

unsigned JsonReader::code_unit() {
  unsigned code = 0;
  for (int i = 0; i < 4; ++i) {
    const char c = rest_.empty() ? ' ' : rest_[0];
    const char lower = static_cast<char>(c | 0x20);
    const bool decimal = c >= '0' && c <= '9';
    if (!decimal && (lower < 'a' || lower > 'f')) throw wrong("four hexadecimal digits");
    code = code * 16 + static_cast<unsigned>(decimal ? c - '0' : lower - 'a' + 10);
    rest_.remove_prefix(1);
  }
  return code;
}

namespace {

/// Characters of a number, taken one after another.
class Scan {
 public:
  explicit Scan(std::string_view text) : rest_(text) {}
  bool take(char c, char or_else = '\0') {
    if (rest_.empty() || (rest_[0] != c && (or_else == '\0' || rest_[0] != or_else))) return false;
    rest_.remove_prefix(1);
    return true;
  }
  bool take_sign() {
    const bool minus = !rest_.empty() && rest_[0] == '-';
    if (minus || (!rest_.empty() && rest_[0] == '+')) rest_.remove_prefix(1);
    return minus;
  }
  std::string_view take_digits(bool hexadecimal) {
    const auto is_digit = [hexadecimal](char c) {
      return (c >= '0' && c <= '9') || (hexadecimal && (c | 0x20) >= 'a' && (c | 0x20) <= 'f');
    };
    const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_digit);
    const std::string_view digits = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
    rest_.remove_prefix(digits.size());
    return digits;
  }
  [[nodiscard]] bool done() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

/// (-) digits * base^exponent, where the base is 10, or 16 with an exponent of 2.
struct Float {
  bool negative = false;
  std::string digits;
  std::int64_t exponent = 0;          ///< of the last digit
  std::int64_t written_exponent = 0;  ///< saturated
};

/// [digits][.digits][e[+-]digits]; `hexadecimal` with p for e.
std::optional<Float> scan_float(Scan scan, bool negative, bool hexadecimal) {
  constexpr std::int64_t far = 1'000'000'000;  // larger in magnitude than anything that matters
  Float result;
  result.negative = negative;
  result.digits = scan.take_digits(hexadecimal);
  std::int64_t behind_point = 0;
  if (scan.take('.')) {
    const std::string_view fraction = scan.take_digits(hexadecimal);
    result.digits += fraction;
    behind_point = static_cast<std::int64_t>(fraction.size()) * (hexadecimal ? 4 : 1);
  }
  if (result.digits.empty() || result.digits.size() > longest_case_number) return std::nullopt;
  if (hexadecimal ? scan.take('p', 'P') : scan.take('e', 'E')) {
    const bool minus = scan.take_sign();
    const std::string_view digits = scan.take_digits(false);
    if (digits.empty()) return std::nullopt;
    for (const char c : digits) result.written_exponent = std::min(far, result.written_exponent * 10 + (c - '0'));
    if (minus) result.written_exponent = -result.written_exponent;
  }
  if (!scan.done()) return std::nullopt;
  result.exponent = result.written_exponent - behind_point;
  return result;
}

mpz_class power(unsigned long base, std::int64_t exponent) {
  mpz_class result;
  mpz_ui_pow_ui(result.get_mpz_t(), base, static_cast<unsigned long>(exponent));  // limits keep it within 32 bits
  return result;
}

/// Binary digits, and a shift by as many as GMP takes: no number here has 2^32 of them.
std::int64_t size_of(const mpz_class& value) { return static_cast<std::int64_t>(mpz_sizeinbase(value.get_mpz_t(), 2)); }
unsigned long shift_by(std::int64_t bits) { return static_cast<unsigned long>(bits); }

mpq_class value_of(const Float& number, int digit_base, unsigned long exponent_base) {
  mpz_class digits;
  digits.set_str(number.digits, digit_base);
  if (number.negative) digits = -digits;
  mpq_class result(digits);
  if (number.exponent >= 0) {
    result *= power(exponent_base, number.exponent);
  } else {
    result /= power(exponent_base, -number.exponent);
  }
  return result;
}

std::optional<mpq_class> ratio(Scan scan, bool negative) {
  const std::string_view num = scan.take_digits(false);
  if (num.empty() || !scan.take('/')) return std::nullopt;
  const std::string_view den = scan.take_digits(false);
  if (!scan.done() || num.size() > longest_case_number || den.size() > longest_case_number) return std::nullopt;
  if (den.find_first_not_of('0') == std::string_view::npos) return std::nullopt;
  mpq_class result;
  result.get_num().set_str(std::string(num), 10);
  result.get_den().set_str(std::string(den), 10);
  result.canonicalize();
  if (negative) result = -result;
  return result;
}

}  // namespace

std::optional<mpq_class> exact_number(std::string_view text) {
  Scan scan(text);
  const bool negative = scan.take_sign();
  if (const std::optional<mpq_class> found = ratio(scan, negative)) return found;
  Scan prefix = scan;
  const bool hexadecimal = prefix.take('0') && prefix.take('x', 'X');
  const std::optional<Float> number = scan_float(hexadecimal ? prefix : scan, negative, hexadecimal);
  const std::int64_t limit = hexadecimal ? largest_binary_exponent : largest_decimal_exponent;
  if (!number || number->written_exponent > limit || number->written_exponent < -limit) return std::nullopt;
  return value_of(*number, hexadecimal ? 16 : 10, hexadecimal ? 2 : 10);
}

std::optional<mpq_class> nearest_binary64(std::string_view json_number) {
  Scan scan(json_number);
  const bool negative = scan.take_sign();
  std::optional<Float> number = scan_float(scan, negative, false);
  if (!number) return std::nullopt;
  number->digits.erase(0, std::min(number->digits.find_first_not_of('0'), number->digits.size()));
  if (number->digits.empty()) return mpq_class(0);
  const std::int64_t magnitude = static_cast<std::int64_t>(number->digits.size()) +
                                 number->exponent;  // below 10^magnitude, and not below a tenth of it
  if (magnitude > 310) return std::nullopt;
  if (magnitude < -330) return mpq_class(0);
  mpq_class result = value_of(*number, 10, 10);
  if (!round_to_binary64(result)) return std::nullopt;
  return result;
}

bool round_to_binary64(mpq_class& value) {
  constexpr std::int64_t precision = 53, smallest = -1074, largest = 1024;
  if (value == 0) return true;
  const mpz_class magnitude = abs(value.get_num());
  const mpz_class& den = value.get_den();
  // 2^(top - 1) < |value| < 2^(top + 1)
  std::int64_t top = size_of(magnitude) - size_of(den);
  const bool below = top >= 0 ? magnitude < (den << shift_by(top)) : (magnitude << shift_by(-top)) < den;
  if (below) --top;
  const std::int64_t unit = std::max(top - (precision - 1), smallest);  // the exponent of the last bit
  mpz_class num = magnitude, unit_den = den;
  if (unit < 0) num <<= shift_by(-unit);
  if (unit > 0) unit_den <<= shift_by(unit);
  mpz_class rounded, rest;
  mpz_fdiv_qr(rounded.get_mpz_t(), rest.get_mpz_t(), num.get_mpz_t(), unit_den.get_mpz_t());
  const int half = cmp(mpz_class(2 * rest), unit_den);
  if (half > 0 || (half == 0 && mpz_odd_p(rounded.get_mpz_t()))) ++rounded;
  if (size_of(rounded) + unit > largest && rounded != 0) return false;
  const bool negative = value < 0;
  value = rounded;
  if (unit > 0) value <<= shift_by(unit);
  if (unit < 0) value >>= shift_by(-unit);
  if (negative) value = -value;
  return true;
}

}  // namespace fathom_check
