// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/shape_text.hpp"

#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/messages.hpp"
#include "reference/files/named_body.hpp"

namespace fathom::files {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::string_view whole_name(std::string_view field) { return field == "r" ? "radius" : field == "h" ? "half_length" : field; }

class ShapeText {
 public:
  ShapeText(const std::string& word, Decimals decimals) : word_(word), decimals_(decimals) {}

  Body read() {
    const std::size_t colon = word_.find(':');
    const std::string name = word_.substr(0, colon);
    const NamedShape named = named_shape(name);
    if (named.shape == nullptr) fail("expected one of the shapes " + list_of_shapes() + "; found " + kernels::shown(name));
    if (named.shape->part == ShapePart::terms || named.shape->part == ShapePart::vertices)
      fail("a " + std::string(named.shape->name) + " has no short form: give it in a case, or a mesh");
    for (const std::string_view part : split(std::string_view(word_).substr(colon + 1), ',')) field(*named.shape, part);
    const auto& read = words_.fields.numbers;
    for (const NumberField& field : named.shape->numbers) require(field.name, read.contains(field.name));
    if (named.rounded) require("margin", read.contains("margin"));
    words_.shape = name;
    try {
      return body_of(std::move(words_));
    } catch (const std::invalid_argument& error) {
      fail(error.what());
    }
  }

 private:
  [[noreturn]] void fail(const std::string& sentence) const { throw InputError(kernels::printable(word_, readable), 0, sentence); }
  void require(std::string_view name, bool there) const {
    if (!there) fail("expected a field '" + std::string(name) + "', found none");
  }

  [[nodiscard]] std::vector<mpq_class> numbers(std::string_view text, std::size_t count) const {
    const std::vector<std::string_view> parts = split(text, ':');
    if (parts.size() != count)
      fail("expected " + std::to_string(count) + (count == 1 ? " number" : " numbers joined by colons") + ", found " +
           kernels::shown(text));
    std::vector<mpq_class> result;
    for (const std::string_view part : parts) {
      ParsedNumber number = parse_number(part, decimals_);
      if (!number.value) fail(number.error);
      result.push_back(*std::move(number.value));
    }
    return result;
  }
  [[nodiscard]] Point point(std::string_view text) const {
    const std::vector<mpq_class> p = numbers(text, 3);
    return {p[0], p[1], p[2]};
  }
  [[nodiscard]] Axis axis(std::string_view text) const {
    if (text == "x") return Axis::x;
    if (text == "y") return Axis::y;
    if (text == "z") return Axis::z;
    fail("expected the axis x, y or z, found " + kernels::shown(text));
  }

  static std::string fields(const ShapeName& shape) {
    std::string all;
    for (const NumberField& number : shape.numbers) all += std::string(number.name) + ", ";
    return all + (shape.part == ShapePart::axis ? "axis, margin, at or quaternion" : "margin, at or quaternion");
  }

  void field(const ShapeName& shape, std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) fail("expected FIELD=VALUE, found " + kernels::shown(text));
    const std::string name(whole_name(text.substr(0, equals)));
    const std::string_view value = text.substr(equals + 1);
    if (!seen_.insert(name).second) fail("expected one field '" + name + "', found a second one");
    if (has_number(shape, name)) {
      words_.fields.numbers[name] = numbers(value, number_field(name)->count);
    } else if (name == "axis" && shape.part == ShapePart::axis) {
      words_.fields.axis = axis(value);
    } else if (name == "at") {
      words_.place = point(value);
    } else if (name == "quaternion") {
      const std::vector<mpq_class> q = numbers(value, 4);
      words_.turn = {q[0], q[1], q[2], q[3]};
    } else {
      fail("expected a field of a " + std::string(shape.name) + ": " + fields(shape) + "; found " + kernels::shown(name));
    }
  }

  static constexpr std::size_t readable = 60;

  const std::string& word_;
  Decimals decimals_;
  NamedBody words_;
  std::set<std::string> seen_;
};

}  // namespace

bool is_shape_text(const std::string& word) {
  const std::size_t colon = word.find(':');
  if (colon == std::string::npos) return false;
  const std::string_view name = std::string_view(word).substr(0, colon);
  const bool is_word = !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string_view::npos;
  return named_shape(name).shape != nullptr || (is_word && word.find('=', colon) != std::string::npos);
}

Body parse_shape(const std::string& word, Decimals decimals) {
  const kernels::DefaultFloatEnvironment environment;
  return ShapeText(word, decimals).read();
}

}  // namespace fathom::files
