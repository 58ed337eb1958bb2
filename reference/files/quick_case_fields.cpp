// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a text once, from its first byte to its last, and keeps nothing but the numbers. Each
// function returns false if the twin has to read the case.
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/number/text.hpp"
#include "reference/files/case_fields.hpp"
#include "reference/files/cases.hpp"
#include "reference/files/mesh_formats.hpp"
#include "reference/text/json.hpp"

namespace fathom::files {
namespace {

constexpr int deepest = 16;             // arrays and objects within a field that is not ours; the twin allows more
constexpr std::size_t longest_id = 18;  // of an id that is a number: the twin prints it, and longer ones may change

/// A text of JSON, of which a part has been read. White space before what is taken is skipped.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

  char peek() {
    while (at_ != end_ && *at_ <= ' ' && (*at_ == ' ' || *at_ == '\t' || *at_ == '\r' || *at_ == '\n')) ++at_;
    return at_ != end_ ? *at_ : '\0';
  }
  bool take(char c) { return peek() == c && at_ != end_ ? ++at_, true : false; }
  bool take(std::string_view word) {
    peek();
    const bool found = std::string_view(at_, end_).starts_with(word);
    at_ += found ? word.size() : 0;
    return found;
  }
  [[nodiscard]] bool ended() { return peek() == '\0' && at_ == end_; }

  bool number(double& value) {
    peek();
    const char* const end = kernels::leading_number(at_, end_, value);
    if (end != nullptr) at_ = end;
    return end != nullptr;
  }
  /// The text of a number.
  bool number(std::string_view& text) {
    peek();
    const char* const begin = at_;
    double value = 0;
    const bool good = number(value);
    text = {begin, at_};
    return good;
  }

  /// A string with its escapes as they stand; false also if one is \u.
  bool string(std::string_view& content) {
    if (!take('"')) return false;
    const char* const begin = at_;
    while (at_ != end_ && *at_ != '"') {
      const auto byte = static_cast<unsigned char>(*at_);
      if (byte < ' ') return false;
      if (byte == '\\') {
        if (end_ - at_ < 2 || std::string_view("\"\\/bfnrt").find(at_[1]) == std::string_view::npos) return false;
        at_ += 2;
        continue;
      }
      const std::size_t size = byte < 0x80 ? 1 : text::utf8_size({at_, end_});
      if (size == 0) return false;
      at_ += size;
    }
    content = {begin, at_};
    return take('"');
  }
  /// A string without escapes.
  bool content(std::string_view& content) { return string(content) && content.find('\\') == std::string_view::npos; }

  /// An array: `read()` reads each element.
  template <class Read>
  bool array(const Read& read) {
    if (!take('[')) return false;
    if (take(']')) return true;
    do {
      if (!read()) return false;
    } while (take(','));
    return take(']');
  }
  /// An object: `read(key)` reads each value.
  template <class Read>
  bool object(const Read& read) {
    if (!take('{')) return false;
    if (take('}')) return true;
    do {
      std::string_view key;
      if (!content(key) || !take(':') || !read(key)) return false;
    } while (take(','));
    return take('}');
  }

 private:
  const char *at_, *end_;
};

/// A coordinate, or an entry of a pose.
bool read_number(Cursor& text, Coordinate& to) {
  if (text.peek() != '"') return text.number(to.emplace<double>());
  std::string_view exact;
  if (!text.content(exact)) return false;
  std::optional<mpq_class> value = parse_number(exact, Decimals::exact).value;
  if (!value) return false;
  if (const std::optional<double> same = kernels::in_binary64(*value)) to = *same;
  else to = *std::move(value);
  return true;
}

template <std::size_t n>
bool read_row(Cursor& text, std::array<Coordinate, n>& to) {
  std::size_t count = 0;
  return text.array([&] { return count < n && read_number(text, to[count++]); }) && count == n;
}

bool read_vertices(Cursor& text, GivenPoints& vertices) {
  CollectedPoints points;
  points.reserve(32);  // most bodies have fewer
  const bool good = text.array([&] {
    std::array<Coordinate, 3> point;
    if (!read_row(text, point)) return false;
    points.add(std::move(point));
    return true;
  });
  vertices = points.take();
  return good && !vertices.empty();
}

bool read_pose(Cursor& text, std::optional<Pose>& pose) {
  if (text.take("null")) return true;
  std::size_t count = 0;
  pose.emplace();
  const bool good = text.array([&] {
    std::array<Coordinate, 4> numbers;
    if (count == pose->size() || !read_row(text, numbers)) return false;
    for (std::size_t i = 0; i < numbers.size(); ++i) (*pose)[count][i] = exact(std::move(numbers[i]));
    ++count;
    return true;
  });
  return good && count == pose->size();
}

bool read_rounding(Cursor& text, bool& rounded) {
  rounded = text.take("\"binary64\"");
  return rounded || text.take("null");
}

bool read_id(Cursor& text, std::optional<std::string>& id) {
  if (text.take("null")) return true;
  std::string_view name;
  if (text.peek() == '"') {
    if (!text.content(name)) return false;
  } else if (!text.number(name) || name.size() > longest_id || name.find_first_of("-.eE") != name.npos) {
    return false;
  }
  id = std::string(name);
  return true;
}

/// Passes over a value that is not ours.
bool skip_value(Cursor& text, int depth) {
  if (depth > deepest) return false;
  std::string_view string;
  double number = 0;
  switch (text.peek()) {
    case '{': return text.object([&](std::string_view) { return skip_value(text, depth + 1); });
    case '[': return text.array([&] { return skip_value(text, depth + 1); });
    case '"': return text.string(string);
    default: return text.take("null") || text.take("true") || text.take("false") || text.number(number);
  }
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

bool read_body(Cursor& text, BodyFields& body, bool& misspelt) {
  OnceEach fields;
  const auto read = [&](std::string_view key) {
    const CasePlace place = field_of_body(key);
    if (!fields.first(place)) return false;
    switch (place) {
      case CasePlace::vertices: return read_vertices(text, body.vertices);
      case CasePlace::pose: return read_pose(text, body.pose);
      case CasePlace::body_rounding: return read_rounding(text, body.rounded);
      case CasePlace::shape: return false;
      case CasePlace::faces: body.has_faces = true; return skip_value(text, 0);
      default: misspelt = misspelt || looks_misspelt(key, true); return skip_value(text, 0);
    }
  };
  return text.object(read) && fields.seen(CasePlace::vertices);
}

bool read_case(Cursor& text, CaseFields& result) {
  OnceEach fields;
  bool has_a = false, has_b = false;
  std::string_view schema;
  const auto read = [&](std::string_view key) {
    const CasePlace place = field_of_case(key);
    if (place == CasePlace::body) {
      const bool first = !std::exchange(key == "a" ? has_a : has_b, true);
      return first && read_body(text, key == "a" ? result.a : result.b, result.misspelt);
    }
    if (!fields.first(place)) return false;
    switch (place) {
      case CasePlace::schema: return text.content(schema) && schema == case_schema;
      case CasePlace::id: return read_id(text, result.id);
      case CasePlace::rounding: return read_rounding(text, result.rounded);
      case CasePlace::twist:
      case CasePlace::dimension: return false;
      default: result.misspelt = result.misspelt || looks_misspelt(key, false); return skip_value(text, 0);
    }
  };
  return text.object(read) && has_a && has_b;
}

}  // namespace

std::optional<CaseFields> quick_case_fields(std::string_view text) {
  Cursor cursor(text);
  CaseFields fields;
  return read_case(cursor, fields) && cursor.ended() ? std::optional(std::move(fields)) : std::nullopt;
}

}  // namespace fathom::files
