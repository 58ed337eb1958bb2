// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/text/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/number/text.hpp"

namespace fathom::text {
namespace {

constexpr std::size_t plain_digits = 15;  // integers with at most this many digits are binary64 numbers

bool is_plain(char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; }

constexpr char32_t replacement = 0xFFFD;

/// A character of UTF-8.
struct Character {
  char32_t code;     // that of the replacement character for what is none
  std::size_t size;  // in bytes
  bool good = true;
};

/// The character that begins at `from`, or as much of one as there is.
Character character_at(std::string_view text, std::size_t from) {
  const auto byte = [&](std::size_t i) {
    return from + i < text.size() ? static_cast<unsigned char>(text[from + i]) : 0U;
  };
  const unsigned first = byte(0);
  if (first < 0x80) return {first, 1};
  if (first < 0xC2 || first > 0xF4) return {replacement, 1, false};
  const std::size_t size = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  // No overlong forms, no surrogates, nothing above U+10FFFF.
  const unsigned least = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned most = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  char32_t code = first & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if (byte(i) < (i == 1 ? least : 0x80) || byte(i) > (i == 1 ? most : 0xBF)) return {replacement, i, false};
    code = code << 6 | (byte(i) & 0x3FU);
  }
  return {code, size};
}

void append_escaped(char32_t code, std::string& text) {
  constexpr std::string_view letters = "\"\\\b\f\n\r\t", escapes = "\"\\bfnrt";
  if (const std::size_t i = code < 0x80 ? letters.find(static_cast<char>(code)) : letters.npos; i != letters.npos)
    (text += '\\') += escapes[i];
  else if (code >= ' ' && code <= '~') text += static_cast<char>(code);
  else if (code < 0x10000) fmt::format_to(std::back_inserter(text), "\\u{:04x}", std::uint32_t{code});
  else
    fmt::format_to(std::back_inserter(text), "\\u{:04x}\\u{:04x}", 0xD7C0U + (code >> 10U), 0xDC00U + (code & 0x3FFU));
}

std::string quoted(std::string_view string) {
  std::string text = "\"";
  for (std::size_t i = 0; i < string.size();) {
    const Character character = character_at(string, i);
    append_escaped(character.code, text);
    i += character.size;
  }
  return text + '"';
}

/// The shortest digits that read back as the number, always with a point or an exponent: 0.5, 2.0,
/// 1e-05, 1.5e+20. null of what is not finite.
void append_decimal(double value, std::string& text) {
  if (!std::isfinite(value)) {
    text += "null";
    return;
  }
  const double size = std::abs(value);
  const bool in_place = value == 0 || (size >= 1e-4 && size < 1e15);
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 in_place ? std::chars_format::fixed : std::chars_format::scientific)
                       .ptr;
  text.append(digits.data(), end);
  if (in_place && std::find(digits.data(), end, '.') == end) text += ".0";
}

void append_key(std::string_view key, std::string& text) {
  if (std::ranges::all_of(key, is_plain)) ((text += '"') += key) += '"';
  else text += quoted(key);
  text += ':';
}

}  // namespace

Json::Json(std::string_view string) {
  if (std::ranges::all_of(string, [](char c) { return is_plain(c) || c == '\n'; })) {
    text_.reserve(string.size() + 2);
    text_ += '"';
    for (std::size_t begin = 0; begin <= string.size();) {  // certificates have many lines
      const std::size_t end = std::min(string.find('\n', begin), string.size());
      text_.append(string, begin, end - begin);
      if (end < string.size()) text_ += "\\n";
      begin = end + 1;
    }
    text_ += '"';
  } else {
    text_ = quoted(string);
  }
}

Json::Json(double value) { append_decimal(value, text_); }

Json::Json(std::initializer_list<Field> fields) {
  std::size_t size = 2;
  for (const Field& field : fields) size += field.key.size() + field.value.text_.size() + 4;
  text_.reserve(size);
  text_ = '{';
  for (const Field& field : fields) {
    if (text_.size() > 1) text_ += ',';
    append_key(field.key, text_);
    text_ += field.value.text_;
  }
  text_ += '}';
}

Json Json::written(std::string text) {
  Json result;
  result.text_ = std::move(text);
  return result;
}

Json Json::plain(std::string_view string) {
  Json result;
  result.text_.reserve(string.size() + 2);
  ((result.text_ = '"') += string) += '"';
  return result;
}

Json Json::boolean(bool value) { return written(value ? "true" : "false"); }

Json Json::array(std::initializer_list<Json> values) {
  Json result = written("[]");
  for (const Json& value : values) result.push_back(value);
  return result;
}

Json Json::object() { return written("{}"); }

Json Json::exact(const mpq_class& value) {
  if (value.get_den() == 1 && mpz_sizeinbase(value.get_num_mpz_t(), 10) <= plain_digits)
    return written(value.get_str());
  const double nearest = round_binary64(value, Rounding::rn);
  if (std::isfinite(nearest) && exact_value(nearest) == value) return written(fmt::format("{}", nearest));
  return plain(exact_text(value));
}

void Json::open_for_more() {
  const bool first = text_.size() == 2;
  text_.pop_back();
  if (!first) text_ += ',';
}

void Json::push_back(const Json& value) {
  open_for_more();
  (text_ += value.text_) += ']';
}

void Json::add(std::string_view key, const Json& value) {
  if (text_ == "null") text_ = "{}";
  open_for_more();
  append_key(key, text_);
  (text_ += value.text_) += '}';
}

std::string Json::indented() const {
  std::string result, margin = "\n";
  bool in_string = false;
  for (std::size_t i = 0; i < text_.size(); ++i) {
    const char c = text_[i];
    const bool closes = !in_string && (c == ']' || c == '}');
    if (closes) margin.resize(margin.size() - 2);
    if (closes && text_[i - 1] != '[' && text_[i - 1] != '{') result += margin;
    result += c;
    if (in_string) {
      if (c == '\\') result += text_[++i];
      else in_string = c != '"';
      continue;
    }
    in_string = c == '"';
    if (c == ':') result += ' ';
    if (c == '[' || c == '{') margin += "  ";
    if (c == ',' || ((c == '[' || c == '{') && text_[i + 1] != ']' && text_[i + 1] != '}')) result += margin;
  }
  return result;
}

void JsonStream::separate() {
  if (!first_) text_ += ',';
  first_ = false;
}

JsonStream& JsonStream::open(char bracket) {
  separate();
  text_ += bracket;
  first_ = true;
  return *this;
}

JsonStream& JsonStream::close(char bracket) {
  text_ += bracket;
  first_ = false;
  return *this;
}

JsonStream& JsonStream::key(std::string_view name) {
  plain(name);
  text_ += ':';
  first_ = true;
  return *this;
}

JsonStream& JsonStream::value(std::string_view written) {
  separate();
  text_ += written;
  return *this;
}

JsonStream& JsonStream::plain(std::string_view characters) {
  separate();
  ((text_ += '"') += characters) += '"';
  return *this;
}

JsonStream& JsonStream::number(double value, int digits) {
  separate();
  value += 0.0;  // -0 becomes 0
  if (digits == 0) fmt::format_to(std::back_inserter(text_), "{}", value);
  else fmt::format_to(std::back_inserter(text_), "{:.{}g}", value, digits);
  return *this;
}

JsonStream& JsonStream::numbers(const std::array<double, 3>& values, int digits) {
  return open('[').number(values[0], digits).number(values[1], digits).number(values[2], digits).close(']');
}

JsonStream& JsonStream::decimal(double value) {
  separate();
  append_decimal(value, text_);
  return *this;
}

JsonStream& JsonStream::exact(const mpz_class& n) {
  separate();
  text_ += '"';
  kernels::append_digits(n.get_mpz_t(), text_);
  text_ += '"';
  return *this;
}

JsonStream& JsonStream::exact(const mpq_class& q) {
  separate();
  text_ += '"';
  kernels::append_exact(q, text_);
  text_ += '"';
  return *this;
}

JsonStream& JsonStream::hex(double value) {
  separate();
  text_ += '"';
  kernels::append_hex(value, text_);
  text_ += '"';
  return *this;
}

std::size_t utf8_size(std::string_view text) {
  const Character first = character_at(text, 0);
  return text.empty() || !first.good ? 0 : first.size;
}

std::string valid_utf8(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const Character character = character_at(text, i);
    if (character.good) result.append(text, i, character.size);
    else result += "\xEF\xBF\xBD";
    i += character.size;
  }
  return result;
}

}  // namespace fathom::text
