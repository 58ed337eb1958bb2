// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/text/json_value.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace fathom::text {

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

Json JsonValue::written() const {
  if (is_string()) return {text()};
  if (kind_ == Kind::real) return {number_};
  if (is_array()) return Json::array_of(items(), [](const JsonValue& item) { return item.written(); });
  if (!is_object()) return Json::written(text());
  std::string result = "{";
  for (const auto& [name, value] : fields())
    result += (result.size() > 1 ? "," : "") + Json(name).text() + ':' + value->written().text();
  return Json::written(result + '}');
}

/// Takes the events of a parser, which does not tell where in the text a value stands.
class JsonBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  JsonRead read;

  bool null() override { return add(JsonValue()); }
  bool boolean(bool value) override { return add(JsonValue(JsonValue::Kind::boolean, value ? 1 : 0)); }
  bool number_integer(number_integer_t value) override { return integer(JsonValue::Kind::negative, value); }
  bool number_unsigned(number_unsigned_t value) override { return integer(JsonValue::Kind::natural, value); }
  bool number_float(number_float_t value, const std::string& text) override {
    return add({JsonValue::Kind::real, text, value});
  }
  bool string(std::string& text) override { return add({JsonValue::Kind::string, std::move(text)}); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return start(JsonValue::Kind::object); }
  bool start_array(std::size_t) override { return start(JsonValue::Kind::array); }
  bool end_object() override { return end(); }
  bool end_array() override { return end(); }
  bool key(std::string& name) override {
    if (left_out_ == 0) open_.back()->parts_->keys.push_back(std::move(name));
    return true;
  }

  bool parse_error(std::size_t position, const std::string& last_token,
                   const nlohmann::json::exception& error) override {
    constexpr int number_overflow = 406;
    read.error_at = position > 0 ? position - 1 : 0;
    if (error.id == number_overflow) {
      left_out_ = 0;
      JsonValue& value = add_value({JsonValue::Kind::real, last_token});
      value.too_large = true;
      return false;
    }
    read.error = error.what();
    const std::size_t dash = read.error.find(" - ");
    if (dash != std::string::npos) read.error.erase(0, dash + 3);
    return false;
  }

 private:
  JsonValue& add_value(JsonValue value) {
    if (open_.empty()) return read.value = std::move(value);
    return open_.back()->parts_->items.emplace_back(std::move(value));
  }
  bool add(JsonValue value) {
    if (left_out_ == 0) add_value(std::move(value));
    return true;
  }
  template <class Integer>
  bool integer(JsonValue::Kind kind, Integer value) {
    constexpr double exact_up_to = 0x1p53;
    const auto number = static_cast<double>(value);
    return add(std::abs(number) < exact_up_to ? JsonValue(kind, number)
                                              : JsonValue(kind, std::to_string(value), number));
  }
  bool start(JsonValue::Kind kind) {
    if (left_out_ != 0) return ++left_out_, true;
    JsonValue& value = add_value({kind, std::string()});
    if (open_.size() < deepest_json) {
      open_.push_back(&value);
    } else {
      value.too_deep = true;
      ++left_out_;
    }
    return true;
  }
  bool end() {
    if (left_out_ != 0) --left_out_;
    else open_.pop_back();
    return true;
  }

  std::vector<JsonValue*> open_;  // each the last item of the one before
  std::size_t left_out_ = 0;      // arrays and objects within one that is too deep
};

JsonRead read_json(std::string_view text) {
  JsonBuilder builder;
  builder.read.whole = nlohmann::json::sax_parse(text, &builder);
  return std::move(builder.read);
}

ParsedNumber exact_number(const JsonValue& value) {
  if (value.is_string()) return parse_number(value.text(), Decimals::exact);
  ParsedNumber result;
  if (value.is_number()) result.value = exact_value(value.number());
  return result;
}

}  // namespace fathom::text
