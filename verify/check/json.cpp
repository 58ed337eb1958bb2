// SPDX-License-Identifier: Apache-2.0
#include "json.hpp"

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

}  // namespace fathom_check
