// SPDX-License-Identifier: GPL-3.0-or-later
// simdjson finds where values begin, and checks UTF-8, quotes and brackets. What a value is, is
// decided here from its text, which is why fields that are not ours are looked at too. Each
// function returns false if the twin has to read the case.
#include <simdjson.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/number/text.hpp"
#include "reference/files/case_fields.hpp"
#include "reference/files/cases.hpp"
#include "reference/files/mesh_formats.hpp"

namespace fathom::files {
namespace {

namespace ondemand = simdjson::ondemand;
using Value = simdjson::simdjson_result<ondemand::value>;

constexpr int deepest = 16;             // arrays and objects within a field that is not ours; the twin allows more
constexpr std::size_t longest_id = 18;  // of an id that is a number: the twin prints it, and longer ones may change

/// The text of a scalar; of an array or object, its bracket. Call it once for a value.
std::string_view token_of(Value value) {
  std::string_view token;
  if (value.raw_json_token().get(token)) return "";
  // simdjson would take a string that is passed over, with a colon behind it, for a key.
  if (token.starts_with('"') && value.get_raw_json_string().error()) return "";
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  while (!token.empty() && is_blank(token.back())) token.remove_suffix(1);
  return token;
}

/// The content of a string; nullopt if there is an escape in it, or if it is no string.
std::optional<std::string_view> content_of(std::string_view token) {
  if (token.size() < 2 || token.front() != '"' || token.back() != '"') return std::nullopt;
  const std::string_view content = token.substr(1, token.size() - 2);
  if (content.find_first_of("\\\"") != std::string_view::npos) return std::nullopt;
  return content;
}

/// Whether the text is a string of JSON; false also if there is an escape \u in it.
bool is_string(std::string_view token) {
  std::size_t at = token.starts_with('"') ? 1 : token.size();
  while (at < token.size() && token[at] != '"') {
    const bool escape = token[at++] == '\\';
    if (escape && (at >= token.size() || std::string_view("\"\\/bfnrt").find(token[at++]) == std::string_view::npos))
      return false;
  }
  return at + 1 == token.size();
}

/// Whether the text is a number of JSON.
bool is_number(std::string_view text) {
  const char *at = text.data(), *const end = at + text.size();
  const auto skip = [&](char one, char other) {
    const bool found = at != end && (*at == one || *at == other);
    at += found;
    return found;
  };
  const auto skip_digits = [&] {
    const char* const begin = at;
    while (at != end && kernels::is_decimal_digit(*at)) ++at;
    return at - begin;
  };
  skip('-', '-');
  if (!skip('0', '0') && skip_digits() == 0) return false;
  if (skip('.', '.') && skip_digits() == 0) return false;
  if (skip('e', 'E')) {
    skip('+', '-');
    if (skip_digits() == 0) return false;
  }
  return at == end;
}

/// The nearest binary64, which is what a number of JSON means; nullopt beyond its range and in its
/// lowest part.
std::optional<double> binary64_of(std::string_view token) {
  double value = 0;
  if (!is_number(token)) return std::nullopt;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  return error == std::errc() && end == token.data() + token.size() ? std::optional(value) : std::nullopt;
}

/// A coordinate, or an entry of a pose: the one place where numbers are made of their texts.
bool read_number(Value number, Coordinate& to) {
  // In a text of at most 20 characters simdjson reads every number right; of more digits after "0."
  // version 3.0.1 may lose some.
  constexpr std::size_t longest_short = 20;
  const std::string_view token = token_of(number);
  if (double value = 0; !token.starts_with('"') && token.size() <= longest_short) {
    if (number.get_double().get(value)) return false;
    to = value;
    return true;
  }
  if (const std::optional<std::string_view> exact = content_of(token)) {
    std::optional<mpq_class> value = parse_number(*exact, Decimals::exact).value;
    if (!value) return false;
    if (const std::optional<double> same = kernels::in_binary64(*value)) to = *same;
    else to = *std::move(value);
    return true;
  }
  const std::optional<double> value = binary64_of(token);
  if (value) to = *value;
  return value.has_value();
}

template <std::size_t n>
bool read_row(Value row, std::array<Coordinate, n>& to) {
  ondemand::array numbers;
  std::size_t count = 0;
  if (row.get_array().get(numbers)) return false;
  for (const Value number : numbers)
    if (count == n || !read_number(number, to[count++])) return false;
  return count == n;
}

bool read_vertices(Value value, GivenPoints& vertices) {
  ondemand::array rows;
  std::size_t count = 0;
  if (value.get_array().get(rows) || rows.count_elements().get(count)) return false;
  CollectedPoints points;
  points.reserve(count);
  for (const Value row : rows) {
    std::array<Coordinate, 3> point;
    if (!read_row(row, point)) return false;
    points.add(std::move(point));
  }
  vertices = points.take();
  return !vertices.empty();
}

bool read_pose(Value value, std::optional<Pose>& pose) {
  if (token_of(value) == "null") return true;
  ondemand::array rows;
  std::size_t count = 0;
  if (value.get_array().get(rows)) return false;
  pose.emplace();
  for (const Value row : rows) {
    if (count == pose->size()) return false;
    std::array<Coordinate, 4> numbers;
    if (!read_row(row, numbers)) return false;
    for (std::size_t i = 0; i < numbers.size(); ++i) (*pose)[count][i] = exact(std::move(numbers[i]));
    ++count;
  }
  return count == pose->size();
}

bool read_rounding(Value value, bool& rounded) {
  const std::string_view token = token_of(value);
  rounded = token == "\"binary64\"";
  return rounded || token == "null";
}

bool read_id(Value value, std::optional<std::string>& id) {
  const std::string_view token = token_of(value);
  if (token == "null") return true;
  const std::optional<std::string_view> content = content_of(token);
  const bool is_short_natural =
      token.size() <= longest_id && is_number(token) && token.find_first_of("-.eE") == token.npos;
  if (content || is_short_natural) id = std::string(content.value_or(token));
  return id.has_value();
}

/// The key that begins here; nullopt if there is an escape in it, or if no colon follows. The text
/// ends with a zero.
std::optional<std::string_view> key_at(const char* begin) {
  const char* const end = begin + std::strcspn(begin, "\\\"");
  const bool ends = *end == '"' && end[1 + std::strspn(end + 1, " \t\r\n")] == ':';
  return ends ? std::optional(std::string_view(begin, static_cast<std::size_t>(end - begin))) : std::nullopt;
}

/// Calls `read(key, value)` for each field of the object.
template <class Read>
bool for_each_field(Value value, const Read& read) {
  ondemand::object object;
  if (value.get_object().get(object)) return false;
  for (simdjson::simdjson_result<ondemand::field> field : object) {
    ondemand::raw_json_string raw;
    if (field.key().get(raw)) return false;
    const std::optional<std::string_view> key = key_at(raw.raw());
    if (!key || !read(*key, field.value())) return false;
  }
  return true;
}

/// Whether a value that is not ours is one of JSON.
bool is_value(Value value, int depth) {
  if (depth > deepest) return false;
  const std::string_view token = token_of(value);
  if (token == "{")
    return for_each_field(value, [depth](std::string_view, Value field) { return is_value(field, depth + 1); });
  if (token == "[") {
    ondemand::array items;
    if (value.get_array().get(items)) return false;
    for (const Value item : items)
      if (!is_value(item, depth + 1)) return false;
    return true;
  }
  return token == "null" || token == "true" || token == "false" || is_string(token) || binary64_of(token);
}

/// The fields of ours that an object may have once each.
class OnceEach {
 public:
  bool first(CasePlace place) {
    return place == CasePlace::other || !std::exchange(seen_[static_cast<std::size_t>(place)], true);
  }
  [[nodiscard]] bool seen(CasePlace place) const { return seen_[static_cast<std::size_t>(place)]; }

 private:
  std::array<bool, static_cast<std::size_t>(CasePlace::other)> seen_{};
};

bool read_body(Value value, BodyFields& body, bool& misspelt) {
  OnceEach fields;
  const auto read = [&](std::string_view key, Value field) {
    const CasePlace place = field_of_body(key);
    if (!fields.first(place)) return false;
    switch (place) {
      case CasePlace::vertices: return read_vertices(field, body.vertices);
      case CasePlace::pose: return read_pose(field, body.pose);
      case CasePlace::body_rounding: return read_rounding(field, body.rounded);
      case CasePlace::shape: return false;
      case CasePlace::faces: body.has_faces = true; return is_value(field, 0);
      default: misspelt = misspelt || looks_misspelt(key, true); return is_value(field, 0);
    }
  };
  return for_each_field(value, read) && fields.seen(CasePlace::vertices);
}

bool read_case(Value value, CaseFields& result) {
  OnceEach fields;
  bool has_a = false, has_b = false;
  const auto read = [&](std::string_view key, Value field) {
    const CasePlace place = field_of_case(key);
    if (place == CasePlace::body) {
      const bool first = !std::exchange(key == "a" ? has_a : has_b, true);
      return first && read_body(field, key == "a" ? result.a : result.b, result.misspelt);
    }
    if (!fields.first(place)) return false;
    switch (place) {
      case CasePlace::schema: return content_of(token_of(field)) == case_schema;
      case CasePlace::id: return read_id(field, result.id);
      case CasePlace::rounding: return read_rounding(field, result.rounded);
      case CasePlace::twist:
      case CasePlace::dimension: return false;
      default: result.misspelt = result.misspelt || looks_misspelt(key, false); return is_value(field, 0);
    }
  };
  return for_each_field(value, read) && has_a && has_b;
}

}  // namespace

struct QuickCaseReader::Scratch {
  ondemand::parser parser;
  std::string padded;

  std::optional<CaseFields> fields(std::string_view text) {
    padded.reserve(text.size() + simdjson::SIMDJSON_PADDING);
    padded = text;
    ondemand::document document;
    CaseFields fields;
    const simdjson::padded_string_view view(padded.data(), text.size(), text.size() + simdjson::SIMDJSON_PADDING);
    if (parser.iterate(view).get(document) || !read_case(document.get_value(), fields)) return std::nullopt;
    if (document.current_location().error() != simdjson::OUT_OF_BOUNDS) return std::nullopt;  // more follows
    return fields;
  }
};

QuickCaseReader::QuickCaseReader() : scratch_(std::make_unique<Scratch>()) {}
QuickCaseReader::QuickCaseReader(QuickCaseReader&&) noexcept = default;
QuickCaseReader& QuickCaseReader::operator=(QuickCaseReader&&) noexcept = default;
QuickCaseReader::~QuickCaseReader() = default;

std::optional<CaseFields> QuickCaseReader::fields(std::string_view text) {
  constexpr std::size_t kept = std::size_t{1} << 20;  // longer texts shall not hold memory once they are read
  return text.size() > kept ? Scratch().fields(text) : scratch_->fields(text);
}

}  // namespace fathom::files
