// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of the plane from SVG, read by pugixml: polygon, polyline, path of straight segments,
// rect, circle and line, by their geometry alone; stroke and fill are not looked at, of style only
// whether it moves something. Coordinates are those that are written: y points down on a screen,
// and up here. Transforms are applied exactly. What would change a coordinate otherwise is refused:
// units, curves, turns by other angles than quarter turns.
#include <algorithm>
#include <array>
#include <cstddef>
#include <new>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kernels/messages.hpp"
#include "kernels/number/text.hpp"
#include "reference/files/mesh_formats.hpp"
#include "reference/files/pose.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::files {
namespace {

constexpr std::string_view svg_shapes = "polygon, polyline, path, rect, circle or line";
constexpr std::string_view between_numbers = " \t\r\n,";

/// Elements whose content is not drawn where it stands.
bool is_not_drawn(std::string_view element) {
  constexpr std::array<std::string_view, 14> names{"defs",   "title",   "desc",           "metadata",       "style",
                                                   "symbol", "marker",  "linearGradient", "radialGradient", "filter",
                                                   "mask",   "pattern", "clipPath",       "script"};
  return std::ranges::find(names, element) != names.end();
}

/// How many characters of `text` a number of SVG takes: "1-2" is two of them, and so is "1.5.5".
std::size_t number_size(std::string_view text) {
  std::size_t at = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  const auto digits = [&] {
    while (at < text.size() && kernels::is_decimal_digit(text[at])) ++at;
  };
  digits();
  if (at < text.size() && text[at] == '.') (++at, digits());
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    const std::size_t sign = at + 1 < text.size() && (text[at + 1] == '-' || text[at + 1] == '+') ? 1 : 0;
    if (at + 1 + sign < text.size() && kernels::is_decimal_digit(text[at + 1 + sign])) (at += 1 + sign, digits());
  }
  return at;
}

constexpr std::size_t most_transforms = 100;  // around one shape: each may add digits

/// The map from where an element is written to where it is drawn.
struct Transform {
  Pose pose{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  std::size_t parts = 0;  ///< how many functions it is made of
};

/// The factor by which it makes lengths longer, if that is the same in every direction, and
/// rational.
std::optional<mpq_class> scale_of(const Pose& pose) {
  const mpq_class &a = pose[0][0], &c = pose[0][1], &b = pose[1][0], &d = pose[1][1];
  const mpq_class squared = a * a + b * b;
  if (squared != c * c + d * d || a * c + b * d != 0) return std::nullopt;
  if (!mpz_perfect_square_p(squared.get_num_mpz_t()) || !mpz_perfect_square_p(squared.get_den_mpz_t()))
    return std::nullopt;
  return mpq_class(sqrt(squared.get_num()), sqrt(squared.get_den()));
}

/// Whether a style has a property that moves what is drawn; text-transform is none.
bool moves(std::string_view style) {
  constexpr std::array<std::string_view, 5> movers{"transform", "transform-origin", "translate", "rotate", "scale"};
  while (!style.empty()) {
    const std::string_view declaration = style.substr(0, style.find(';'));
    const std::string_view property = trimmed(declaration.substr(0, declaration.find(':')));
    const auto is_property = [&](std::string_view name) {
      return std::ranges::equal(property, name, {}, kernels::lower);
    };
    if (std::ranges::any_of(movers, is_property)) return true;
    style.remove_prefix(std::min(declaration.size() + 1, style.size()));
  }
  return false;
}

class SvgReader {
 public:
  SvgReader(std::string_view text, const std::string& file, Decimals decimals)
      : text_(text), file_(file), decimals_(decimals) {}

  std::vector<NamedPiece> read() {
    std::vector<NamedPiece> pieces;
    std::vector<std::pair<pugi::xml_node, Transform>> ahead{{root(), {}}};
    while (!ahead.empty()) {
      const auto [node, around] = std::move(ahead.back());
      ahead.pop_back();
      if (const pugi::xml_node next = node.next_sibling()) ahead.emplace_back(next, around);
      const std::string_view name = node.name();
      if (node.type() != pugi::node_element || name.find(':') != name.npos || is_not_drawn(name)) continue;
      const Transform placing = transform(node, around);
      const bool holds = name == "svg" || name == "g" || name == "a" || name == "switch";
      if (!holds) pieces.push_back({placed_body(node, name, placing.pose), node.attribute("id").value()});
      else if (node.first_child()) ahead.emplace_back(node.first_child(), placing);
    }
    if (pieces.empty()) fail({}, "expected at least one shape (" + std::string(svg_shapes) + "), found none");
    return pieces;
  }

 private:
  [[noreturn]] void fail(const pugi::xml_node& at, const std::string& sentence) const {
    fail_at(at ? std::max<std::ptrdiff_t>(at.offset_debug(), 0) : 0,
            (at ? "<" + std::string(at.name()) + ">: " : "") + sentence);
  }
  [[noreturn]] void fail_at(std::ptrdiff_t offset, const std::string& sentence) const {
    throw InputError(file_, static_cast<std::size_t>(std::count(text_.begin(), text_.begin() + offset, '\n')) + 1,
                     sentence);
  }

  pugi::xml_node root() {
    const pugi::xml_parse_result result = document_.load_buffer(
        text_.data(), text_.size(), pugi::parse_escapes | pugi::parse_wconv_attribute, pugi::encoding_utf8);
    if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
    const pugi::xml_node root = document_.document_element();
    if (!result)
      fail_at(std::clamp<std::ptrdiff_t>(result.offset, 0, std::ssize(text_)), "expected XML, found a fault");
    if (root.name() != std::string_view("svg")) fail_at(0, "expected <svg>, the root of an SVG, found another element");
    return root;
  }

  /// The number at the beginning of `text`, which it leaves with what separates it from the next.
  mpq_class number(const pugi::xml_node& at, std::string_view& text) const {
    const std::size_t size = number_size(text);
    ParsedNumber parsed = parse_number(text.substr(0, size), decimals_);
    if (size == 0 || !parsed.value) fail(at, "expected a number, found " + kernels::shown(text));
    text.remove_prefix(size);
    skip_separators(text);
    return *std::move(parsed.value);
  }
  static void skip_separators(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(between_numbers), text.size()));
  }
  mpq_class length(const pugi::xml_node& at, const char* name, bool required = false) const {
    const pugi::xml_attribute attribute = at.attribute(name);
    if (!attribute && required) fail(at, "expected " + std::string(name) + "=\"...\", found none");
    if (!attribute) return 0;
    ParsedNumber parsed = parse_number(trimmed(attribute.value()), decimals_);
    if (!parsed.value) fail(at, std::string(name) + "=: " + parsed.error);
    if (required && *parsed.value <= 0) fail(at, "expected " + std::string(name) + "= above 0, found another number");
    return *std::move(parsed.value);
  }

  /// "translate(1 2) scale(3)": the last one is applied first, and `around` last.
  Transform transform(const pugi::xml_node& at, Transform around) const {
    if (moves(at.attribute("style").value()) || at.attribute("transform-origin"))
      fail(at, "expected no transform in style= and no transform-origin=, found one: only transform= is read");
    if (at.name() == std::string_view("svg") && at != document_.document_element())
      for (const char* const name : {"x", "y", "viewBox"})
        if (at.attribute(name)) fail(at, "expected no x=, y= or viewBox= of an inner svg, found one: use a transform");
    std::string_view text = at.attribute("transform").value();
    skip_separators(text);
    while (!text.empty()) {
      if (++around.parts > most_transforms)
        fail(at, "expected at most " + std::to_string(most_transforms) + " transforms around a shape, found more");
      const std::size_t open = text.find('(');
      const std::string_view name = trimmed(text.substr(0, open));
      if (open == std::string_view::npos)
        fail(at, "expected a transform such as scale(2), found " + kernels::shown(text));
      text.remove_prefix(open + 1);
      skip_separators(text);
      std::vector<mpq_class> numbers;
      while (!text.empty() && !text.starts_with(')')) numbers.push_back(number(at, text));
      if (text.empty()) fail(at, "expected ) behind " + kernels::shown(name) + ", found none");
      text.remove_prefix(1);
      skip_separators(text);
      around.pose = product(around.pose, function(at, name, numbers));
    }
    return around;
  }

  Pose function(const pugi::xml_node& at, std::string_view name, const std::vector<mpq_class>& n) const {
    const std::size_t count = n.size();
    const auto map = [](const mpq_class& a, const mpq_class& b, const mpq_class& c, const mpq_class& d,
                        const mpq_class& e, const mpq_class& f) {
      return *plane_pose({{{a, c, e}, {b, d, f}}}).matrix;
    };
    if (name == "translate" && (count == 1 || count == 2)) return map(1, 0, 0, 1, n[0], count == 2 ? n[1] : 0);
    if (name == "rotate" && (count == 1 || count == 3)) {
      const mpq_class quarters = n[0] / 90;
      if (quarters.get_den() != 1)
        fail(at,
             "expected a turn by a multiple of 90 degrees, found another: its sine is irrational or rounded; "
             "matrix(cos sin -sin cos 0 0) says which numbers are meant");
      const unsigned long turns = mpz_fdiv_ui(quarters.get_num_mpz_t(), 4);
      const int cosine = turns == 0 ? 1 : turns == 2 ? -1 : 0, sine = turns == 1 ? 1 : turns == 3 ? -1 : 0;
      const mpq_class x = count == 3 ? n[1] : mpq_class(0), y = count == 3 ? n[2] : mpq_class(0);
      return map(cosine, sine, -sine, cosine, x - cosine * x + sine * y, y - sine * x - cosine * y);
    }
    const bool scale = name == "scale" && (count == 1 || count == 2), matrix = name == "matrix" && count == 6;
    if (!scale && !matrix)
      fail(at, "expected matrix(a b c d e f), translate(x y), scale(x y) or rotate(a x y), found " +
                   kernels::shown(name) + " of " + std::to_string(count) + (count == 1 ? " number" : " numbers"));
    if (scale ? n[0] == 0 || n.back() == 0 : n[0] * n[3] == n[1] * n[2])
      fail(at, "expected a transform that does not flatten what it moves, found one that does");
    return scale ? map(n[0], 0, 0, n.back(), 0, 0) : map(n[0], n[1], n[2], n[3], n[4], n[5]);
  }

  Body placed_body(const pugi::xml_node& at, std::string_view name, const Pose& pose) const {
    Body result = body(at, name);
    const std::optional<mpq_class> scale = scale_of(pose);
    if (result.shape && !scale)
      fail(at, "expected a circle that stays one, by a rational scale, found another transform of it");
    place(result, {pose});
    if (result.shape) result.shape->radius *= *scale;
    return result;
  }

  std::vector<Point> points(const pugi::xml_node& at) const {
    std::string_view text = at.attribute("points").value();
    skip_separators(text);
    std::vector<Point> result;
    while (!text.empty()) {
      mpq_class x = number(at, text);
      if (text.empty()) fail(at, "expected as many y as x, found one x more");
      result.push_back({std::move(x), number(at, text), 0});
    }
    if (result.empty()) fail(at, "expected at least one point, found none");
    return result;
  }

  /// The ends of its segments.
  std::vector<Point> path(const pugi::xml_node& at) const {
    std::string_view text = at.attribute("d").value();
    skip_separators(text);
    if (!text.starts_with('M') && !text.starts_with('m')) fail(at, "expected a path that begins with M, found none");
    std::vector<Point> result;
    Point here, start;
    bool drawn = false;  // something since the last M
    char command = 'M';
    const auto draw_to = [&](const Point& p) {
      if (!std::exchange(drawn, true)) result.push_back(here);
      result.push_back(here = p);
    };
    while (!text.empty()) {
      const char letter = text.front();
      if ((letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z')) {
        if (std::string_view("MmLlHhVvZz").find(letter) == std::string_view::npos)
          fail(at, "expected straight segments (M L H V Z), found '" + std::string(1, letter) + "'");
        command = letter;
        text.remove_prefix(1);
        skip_separators(text);
        if (command == 'Z' || command == 'z') {
          if (drawn) here = start;
          continue;
        }
      } else if (command == 'Z' || command == 'z') {
        fail(at, "expected a letter behind Z, found " + kernels::shown(text));
      }
      const bool relative = command >= 'a';
      const char kind = static_cast<char>(relative ? command - 'a' + 'A' : command);
      Point p = relative || kind == 'H' || kind == 'V' ? here : Point{};
      if (!relative && kind == 'H') p.x = 0;
      if (!relative && kind == 'V') p.y = 0;
      if (kind != 'V') p.x += number(at, text);
      if (kind != 'H') p.y += number(at, text);
      if (kind != 'M') {
        draw_to(p);
        continue;
      }
      here = start = p;
      drawn = false;
      command = relative ? 'l' : 'L';  // further pairs
    }
    if (result.empty()) fail(at, "expected at least one segment, found none");
    return result;
  }

  std::vector<Point> rectangle(const pugi::xml_node& at) const {
    if (length(at, "rx") != 0 || length(at, "ry") != 0)
      fail(at, "expected a rect without round corners, found rx= or ry=");
    const mpq_class x = length(at, "x"), y = length(at, "y");
    const mpq_class right = x + length(at, "width", true), top = y + length(at, "height", true);
    return {{x, y, 0}, {right, y, 0}, {right, top, 0}, {x, top, 0}};
  }

  Body body(const pugi::xml_node& at, std::string_view name) const {
    Body result;
    result.dimension = 2;
    if (name == "polygon" || name == "polyline") result.points = points(at);
    else if (name == "path") result.points = path(at);
    else if (name == "rect") result.points = rectangle(at);
    else if (name == "line")
      result.points = {{length(at, "x1"), length(at, "y1"), 0}, {length(at, "x2"), length(at, "y2"), 0}};
    else if (name == "circle")
      result.shape =
          Shape{hull(std::vector<Point>{{length(at, "cx"), length(at, "cy"), 0}}).core, length(at, "r", true)};
    else fail(at, "expected a " + std::string(svg_shapes) + ", found another element");
    return result;
  }

  std::string_view text_;
  const std::string& file_;
  Decimals decimals_;
  pugi::xml_document document_;
};

}  // namespace

std::vector<NamedPiece> parse_svg_pieces(std::string_view text, const std::string& name, Decimals decimals) {
  return SvgReader(text, name, decimals).read();
}

Body parse_svg(std::string_view text, const std::string& name, Decimals decimals) {
  std::vector<NamedPiece> pieces = parse_svg_pieces(text, name, decimals);
  if (pieces.size() != 1)
    throw InputError(name, 0,
                     "expected one shape, found " + std::to_string(pieces.size()) + ": --pieces takes their union");
  return std::move(pieces.front().mesh);
}

}  // namespace fathom::files
