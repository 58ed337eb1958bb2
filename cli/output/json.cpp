// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace fathom::cli {
namespace {

bool is_plain(char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; }

/// Escapes as the library does.
std::string dumped(const nlohmann::json& value) { return value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace); }

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

Json Json::plain(std::string_view string) {
  Json result;
  result.text_.reserve(string.size() + 2);
  ((result.text_ = '"') += string) += '"';
  return result;
}

Json Json::boolean(bool value) {
  Json result;
  result.text_ = value ? "true" : "false";
  return result;
}

Json Json::array(std::initializer_list<Json> values) {
  Json result;
  result.text_ = "[]";
  for (const Json& value : values) result.push_back(value);
  return result;
}

Json Json::object() {
  Json result;
  result.text_ = "{}";
  return result;
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

std::string valid_utf8(const std::string& text) { return nlohmann::json::parse(dumped(nlohmann::json(text))).get<std::string>(); }

}  // namespace fathom::cli
