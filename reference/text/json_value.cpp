// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/text/json_value.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "kernels/messages.hpp"
#include "kernels/number/text.hpp"

namespace fathom::text {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_of_word(char c) {
  return kernels::is_decimal_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.' ||
         c == '+' || c == '-';
}

void append_utf8(std::string& text, unsigned code) {
  const auto add = [&](unsigned byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  const auto rest = [&](unsigned shift) { add(0x80U | (code >> shift & 0x3FU)); };
  if (code < 0x80) return add(code);
  if (code < 0x800) return add(0xC0U | code >> 6U), rest(0);
  if (code < 0x10000) return add(0xE0U | code >> 12U), rest(6), rest(0);
  add(0xF0U | code >> 18U), rest(12), rest(6), rest(0);
}

std::string kind_name(const JsonValue& value) {
  if (value.is_null()) return "null";
  if (value.is_string()) return "a text";
  if (value.is_number()) return "a number";
  return value.is_array() ? "an array" : value.is_object() ? "an object" : "a truth value";
}

}  // namespace

const std::vector<JsonValue> JsonValue::none_;

JsonValue::JsonValue(Kind kind, std::string text, double number)
    : kind_(kind), number_(number), parts_(std::make_unique<Parts>()) {
  parts_->text = std::move(text);
}

std::string JsonValue::text() const {
  if (parts_) return parts_->text;
  if (kind_ == Kind::boolean) return number_ == 1 ? "true" : "false";
  return is_number() ? std::to_string(static_cast<long long>(number_)) : "null";
}

std::vector<JsonValue::Field> JsonValue::fields() const {
  std::vector<Field> result;
  if (!is_object()) return result;
  for (std::size_t i = items().size(); i-- > 0;) result.emplace_back(key(i), &items()[i]);
  std::ranges::stable_sort(result, {}, &Field::first);
  const auto same_key = [](const Field& one, const Field& other) { return one.first == other.first; };
  result.erase(std::unique(result.begin(), result.end(), same_key), result.end());
  return result;
}

const JsonValue* JsonValue::find(std::string_view name) const {
  if (!is_object()) return nullptr;
  for (std::size_t i = items().size(); i-- > 0;)
    if (key(i) == name) return &items()[i];
  return nullptr;
}

const JsonValue& JsonValue::at(std::string_view name) const {
  if (const JsonValue* const value = find(name)) return *value;
  throw JsonFault("expected a field '" + std::string(name) + "', found none");
}

const JsonValue& JsonValue::at(std::size_t i) const {
  if (is_array() && i < items().size()) return items()[i];
  throw JsonFault("expected an element " + std::to_string(i) + ", found none");
}

const std::string& JsonValue::string() const {
  if (is_string()) return parts_->text;
  throw JsonFault("expected a text, found " + kind_name(*this));
}

bool JsonValue::boolean() const {
  if (kind_ == Kind::boolean) return number_ == 1;
  throw JsonFault("expected true or false, found " + kind_name(*this));
}

std::uint64_t JsonValue::natural(std::uint64_t most) const {
  std::uint64_t value = 0;
  const std::string digits = text();
  if (!is_natural() || std::from_chars(digits.data(), digits.data() + digits.size(), value).ec != std::errc() ||
      value > most)
    throw JsonFault("expected a natural number, found " + kernels::printable(written().text(), kernels::readable));
  return value;
}

Json JsonValue::written(Form form) const {
  if (is_string()) return {text()};
  if (kind_ == Kind::real && form == Form::canonical) return {number_};
  if (is_array()) return Json::array_of(items(), [form](const JsonValue& item) { return item.written(form); });
  if (!is_object()) return Json::written(text());
  Json result = Json::object();
  if (form != Form::given)
    for (const auto& [name, value] : fields()) result[name] = value->written(form);
  else
    for (std::size_t i = 0; i < items().size(); ++i) result[key(i)] = items()[i].written(form);
  return result;
}

/// Reads a text from its first byte to its last, or to the first fault: without recursion, as
/// brackets may be nested without end.
class JsonBuilder {
 public:
  JsonRead read;

  JsonBuilder(std::string_view text, NumberWord word) : text_(text.substr(0, text.find('\0'))), word_(word) {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // a byte order mark
    read.whole = document();
  }

 private:
  [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(char c) { return peek() == c ? ++at_, true : false; }
  void skip_space() {
    while (is_space(peek())) ++at_;
  }

  /// Returns false.
  bool fault(const std::string& expected) {
    std::size_t end = at_;
    while (end < text_.size() && is_of_word(text_[end])) ++end;
    const std::string_view found = text_.substr(at_, std::max<std::size_t>(end - at_, 1));
    read.error_at = at_;
    read.error = "expected " + expected + ", found " +
                 (found.empty() ? "the end" : '\'' + kernels::printable(found, kernels::readable) + '\'');
    return false;
  }

  bool document() {
    if (!value()) return false;
    while (!brackets_.empty()) {
      skip_space();
      const bool in_object = brackets_.back() == '{';
      if (take(',')) {
        if ((in_object && !key()) || !value()) return false;
      } else if (take(in_object ? '}' : ']')) {
        end();
      } else {
        return fault(in_object ? "',' or '}'" : "',' or ']'");
      }
    }
    skip_space();
    return at_ == text_.size() || fault("nothing more");
  }

  /// A value that has no parts, and the brackets that open before it.
  bool value() {
    for (;;) {
      skip_space();
      const bool is_object = peek() == '{';
      if (!is_object && peek() != '[') return scalar();
      start(text_[at_++]);
      skip_space();
      if (take(is_object ? '}' : ']')) return end(), true;
      if (is_object && !key()) return false;
    }
  }

  bool key() {
    skip_space();
    if (peek() != '"') return fault("a field's name in quotes");
    std::string name;
    if (!string(name)) return false;
    skip_space();
    if (!take(':')) return fault("':'");
    if (left_out_ == 0) open_.back()->parts_->keys.push_back(std::move(name));
    return true;
  }

  bool scalar() {
    if (const std::size_t length = word_ ? word_(text_.substr(at_)) : 0; length > 0)
      return add({JsonValue::Kind::real, taken(length)});
    if (peek() == '"') {
      std::string text;
      return string(text) && add({JsonValue::Kind::string, std::move(text)});
    }
    if (peek() == '-' || kernels::is_decimal_digit(peek())) return number();
    if (literal("null")) return add(JsonValue());
    if (literal("true")) return add(JsonValue(JsonValue::Kind::boolean, 1));
    return literal("false") ? add(JsonValue(JsonValue::Kind::boolean, 0)) : fault("a value");
  }

  std::string taken(std::size_t length) {
    at_ += length;
    return std::string(text_.substr(at_ - length, length));
  }
  bool literal(std::string_view word) {
    if (!text_.substr(at_).starts_with(word)) return false;
    at_ += word.size();
    return true;
  }
  bool digits() {
    if (!kernels::is_decimal_digit(peek())) return fault("a digit");
    while (kernels::is_decimal_digit(peek())) ++at_;
    return true;
  }

  bool number() {
    const std::size_t begin = at_;
    const bool is_negative = take('-');
    if (!take('0') && !digits()) return false;
    const std::size_t integer_end = at_;
    if (take('.') && !digits()) return false;
    if (peek() == 'e' || peek() == 'E') {
      ++at_;
      if (!take('-')) take('+');
      if (!digits()) return false;
    }
    const std::string_view text = text_.substr(begin, at_ - begin);
    const bool is_integer = at_ == integer_end;
    if (is_integer && is_negative && integer<std::int64_t>(JsonValue::Kind::negative, text)) return true;
    if (is_integer && !is_negative && integer<std::uint64_t>(JsonValue::Kind::natural, text)) return true;
    return real(text);
  }
  /// Returns false if it has too many digits.
  template <class Integer>
  bool integer(JsonValue::Kind kind, std::string_view text) {
    constexpr double exact_up_to = 0x1p53;
    Integer value{};
    if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc()) return false;
    const auto number = static_cast<double>(value);
    return add(std::abs(number) < exact_up_to ? JsonValue(kind, number)
                                              : JsonValue(kind, std::to_string(value), number));
  }
  bool real(std::string_view text) {
    const double number = kernels::nearest_binary64(text);
    if (std::isfinite(number)) return add({JsonValue::Kind::real, std::string(text), number});
    left_out_ = 0;
    add_value({JsonValue::Kind::real, std::string(text)}).too_large = true;
    return false;
  }

  /// From one quotation mark to the other.
  bool string(std::string& text) {
    ++at_;
    while (!take('"')) {
      const std::size_t begin = at_;
      while (at_ < text_.size() && text_[at_] >= ' ' && text_[at_] <= '~' && text_[at_] != '"' && text_[at_] != '\\')
        ++at_;
      text.append(text_, begin, at_ - begin);
      if (at_ == text_.size()) return fault("'\"'");
      if (text_[at_] == '\\') {
        if (!escape(text)) return false;
      } else if (static_cast<unsigned char>(text_[at_]) < ' ') {
        return fault("an escape for a control character in a text");
      } else if (text_[at_] != '"') {
        const std::size_t size = utf8_size(text_.substr(at_));
        if (size == 0) return fault("UTF-8");
        text += taken(size);
      }
    }
    return true;
  }

  bool escape(std::string& text) {
    constexpr std::string_view letters = "\"\\/bfnrt", characters = "\"\\/\b\f\n\r\t";
    ++at_;
    if (const std::size_t i = letters.find(peek()); i != letters.npos && at_ < text_.size()) {
      text += characters[i];
      return ++at_, true;
    }
    unsigned code = 0, low = 0;
    if (!take('u')) return fault("one of \"\\/bfnrtu behind a backslash");
    if (!code_unit(code)) return false;
    if (code >= 0xD800 && code < 0xDC00) {
      if (!take('\\') || !take('u')) return fault("the second half of a character, \\udc00 to \\udfff");
      if (!code_unit(low)) return false;
      if (low < 0xDC00 || low > 0xDFFF) return fault("the second half of a character before this");
      code = 0x10000 + ((code - 0xD800) << 10U | (low - 0xDC00));
    } else if (code >= 0xDC00 && code < 0xE000) {
      return fault("the first half of a character, \\ud800 to \\udbff, before its second");
    }
    append_utf8(text, code);
    return true;
  }

  bool code_unit(unsigned& code) {
    const std::string_view hex = text_.substr(at_, 4);
    if (hex.size() < 4 || std::from_chars(hex.data(), hex.data() + 4, code, 16).ptr != hex.data() + 4)
      return fault("four hexadecimal digits");
    at_ += 4;
    return true;
  }

  JsonValue& add_value(JsonValue value) {
    if (open_.empty()) return read.value = std::move(value);
    return open_.back()->parts_->items.emplace_back(std::move(value));
  }
  bool add(JsonValue value) {
    if (left_out_ == 0) add_value(std::move(value));
    return true;
  }
  void start(char bracket) {
    brackets_ += bracket;
    if (left_out_ != 0) return void(++left_out_);
    JsonValue& value = add_value({bracket == '{' ? JsonValue::Kind::object : JsonValue::Kind::array, std::string()});
    if (open_.size() < deepest_json) {
      open_.push_back(&value);
    } else {
      value.too_deep = true;
      ++left_out_;
    }
  }
  void end() {
    brackets_.pop_back();
    if (left_out_ != 0) --left_out_;
    else open_.pop_back();
  }

  std::string_view text_;
  NumberWord word_;
  std::size_t at_ = 0;
  std::string brackets_;          // those that are open
  std::vector<JsonValue*> open_;  // each the last item of the one before
  std::size_t left_out_ = 0;      // arrays and objects within one that is too deep
};

JsonRead read_json(std::string_view text, NumberWord word) { return JsonBuilder(text, word).read; }

JsonValue parsed_json(std::string_view text) {
  JsonRead read = read_json(text);
  if (!read.whole || text.find('\0') != text.npos)
    throw JsonFault("expected JSON, found a fault in column " + std::to_string(read.error_at + 1) + ": " + read.error);
  return std::move(read.value);
}

ParsedNumber exact_number(const JsonValue& value) {
  if (value.is_string()) return parse_number(value.text(), Decimals::exact);
  ParsedNumber result;
  if (value.is_number()) result.value = exact_value(value.number());
  return result;
}

}  // namespace fathom::text
