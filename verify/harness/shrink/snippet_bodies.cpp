// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies as C++: their points in braces, or the functions of fathom/shape.hpp that make them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "fathom/numbers.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/harness/shrink/reproducer.hpp"

namespace fathom::harness {
namespace {

/// The binary64 number that it is, in its shortest text.
std::string number(const mpq_class& value) { return fmt::format("{}", round_binary64(value)); }

std::string triple(const mpq_class& x, const mpq_class& y, const mpq_class& z) {
  return fmt::format("{{{}, {}, {}}}", number(x), number(y), number(z));
}
std::string triple(const Point& p) { return triple(p.x, p.y, p.z); }

std::string list(const std::vector<Point>& points) {
  std::vector<std::string> texts;
  for (const Point& p : points) texts.push_back(triple(p));
  return fmt::format("{{{}}}", fmt::join(texts, ", "));
}

std::string hull_text(const std::vector<Point>& points) { return "fathom::hull(std::vector<fathom::Point>" + list(points) + ")"; }

std::string unmoved(const files::NamedBody& words);

/// The arguments of a shape's function are its fields, in their order.
std::string core_text(const files::NamedBody& words) {
  const files::ShapeName& shape = *files::named_shape(words.shape).shape;
  if (shape.part == files::ShapePart::vertices && shape.name == "hull") return hull_text(words.fields.vertices);
  if (shape.part == files::ShapePart::terms) {
    std::string sum;
    for (const files::NamedBody& term : words.terms) {
      const std::string text = shape_code(term);
      sum = sum.empty() ? text : fmt::format("fathom::minkowski_sum({}, {})", sum, text);
    }
    return sum;
  }
  std::vector<std::string> arguments;
  for (const Point& p : words.fields.vertices) arguments.push_back(triple(p));
  for (const files::NumberField& field : shape.numbers) {
    const std::vector<mpq_class>& values = words.fields.numbers.find(field.name)->second;
    arguments.push_back(field.count == 1 ? number(values[0]) : triple(values[0], values[1], values[2]));
  }
  if (shape.part == files::ShapePart::axis)
    arguments.push_back(fmt::format("fathom::Axis::{}", "xyz"[static_cast<int>(words.fields.axis)]));
  return fmt::format("fathom::{}({})", shape.name, fmt::join(arguments, ", "));
}

std::string unmoved(const files::NamedBody& words) {
  const auto margin = words.fields.numbers.find("margin");
  const std::string core = core_text(words);
  return margin == words.fields.numbers.end() ? core : fmt::format("fathom::with_margin({}, {})", core, number(margin->second[0]));
}

}  // namespace

std::string shape_code(const files::NamedBody& words) {
  if (words.matrix) {
    std::vector<std::string> rows;
    for (const auto& row : *words.matrix)
      rows.push_back(fmt::format("{{{}, {}, {}, {}}}", number(row[0]), number(row[1]), number(row[2]), number(row[3])));
    return fmt::format("fathom::moved({}, fathom::Pose{{{{{}}}}})", unmoved(words), fmt::join(rows, ", "));
  }
  const Quaternion& q = words.turn;
  const bool upright = q.x == 0 && q.y == 0 && q.z == 0;
  if (upright && words.place == Point{}) return unmoved(words);
  return fmt::format("fathom::moved({}, fathom::rigid_pose({{{}, {}, {}, {}}}, {}))", unmoved(words), number(q.w), number(q.x), number(q.y),
                     number(q.z), triple(words.place));
}

std::string body_code(const Body& body) { return body.words ? shape_code(*body.words) : list(body.points); }

std::string as_shape_code(const Body& body) { return body.words ? shape_code(*body.words) : hull_text(body.points); }

}  // namespace fathom::harness
