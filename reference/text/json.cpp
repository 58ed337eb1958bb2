// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/text/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/number/rounding.hpp"

namespace fathom::text {
namespace {

constexpr std::size_t plain_digits = 15;  // integers with at most this many digits are binary64 numbers

bool is_plain(char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; }

/// Escapes as the library does.
std::string dumped(const nlohmann::json& value) {
  return value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
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
    text_ = dumped(nlohmann::json(string));
  }
}

Json::Json(double value) : text_(dumped(nlohmann::json(value))) {}

Json::Json(std::initializer_list<Field> fields) : text_("{}") {
  for (const Field& field : fields) add(field.key, field.value);
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
  (((text_ += '"') += key) += "\":") += value.text_;
  text_ += '}';
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

void JsonStream::digits(mpz_srcptr n) {
  const std::size_t begin = text_.size();
  text_.resize(begin + mpz_sizeinbase(n, 10) + 2);
  mpz_get_str(text_.data() + begin, 10, n);
  text_.resize(text_.find('\0', begin));
}

JsonStream& JsonStream::exact(const mpz_class& n) {
  separate();
  text_ += '"';
  digits(n.get_mpz_t());
  text_ += '"';
  return *this;
}

JsonStream& JsonStream::exact(const mpq_class& q) {
  separate();
  text_ += '"';
  digits(q.get_num_mpz_t());
  if (q.get_den() != 1) {
    text_ += '/';
    digits(q.get_den_mpz_t());
  }
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

std::string valid_utf8(const std::string& text) {
  return nlohmann::json::parse(dumped(nlohmann::json(text))).get<std::string>();
}

}  // namespace fathom::text
