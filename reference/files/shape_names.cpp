// SPDX-License-Identifier: GPL-3.0-or-later
// The table of shapes, bodies that keep the words they were given in, and shapes as one word of the
// command line.
#include "reference/files/shape_names.hpp"

#include <algorithm>
#include <memory>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/messages.hpp"

namespace fathom::files {
namespace {

constexpr NumberField margin{"margin", 1};
constexpr std::string_view rounded_prefix = "rounded_";

const mpq_class& number(const ShapeFields& fields, std::string_view name) {
  return fields.numbers.find(name)->second.front();
}

Point triple(const ShapeFields& fields, std::string_view name) {
  const std::vector<mpq_class>& numbers = fields.numbers.find(name)->second;
  return {numbers[0], numbers[1], numbers[2]};
}

Shape made_sphere(const ShapeFields& f) { return sphere(number(f, "radius")); }
Shape made_capsule(const ShapeFields& f) { return capsule(number(f, "radius"), number(f, "half_length"), f.axis); }
Shape made_tapered_capsule(const ShapeFields& f) {
  return tapered_capsule(number(f, "radius_low"), number(f, "radius_high"), number(f, "half_length"), f.axis);
}
Shape made_box(const ShapeFields& f) { return box(triple(f, "half")); }
Shape made_cylinder(const ShapeFields& f) { return cylinder(number(f, "radius"), number(f, "half_length"), f.axis); }
Shape made_cone(const ShapeFields& f) { return cone(number(f, "radius"), number(f, "half_length"), f.axis); }
Shape made_frustum(const ShapeFields& f) {
  return frustum(number(f, "radius_low"), number(f, "radius_high"), number(f, "half_length"), f.axis);
}
Shape made_ellipsoid(const ShapeFields& f) { return ellipsoid(triple(f, "radii")); }
Shape made_hull(const ShapeFields& f) { return hull(f.vertices); }
Shape made_halfspace(const ShapeFields& f) { return halfspace(triple(f, "normal"), number(f, "offset")); }

Shape made_triangle(const ShapeFields& f) {
  if (f.vertices.size() != 3)
    throw std::invalid_argument("a triangle has three vertices, found " + std::to_string(f.vertices.size()));
  return triangle(f.vertices[0], f.vertices[1], f.vertices[2]);
}

Shape made_sum(const ShapeFields& f) {
  if (f.terms.empty()) throw std::invalid_argument("a sum has at least one term, found none");
  Shape sum = f.terms.front();
  for (std::size_t i = 1; i < f.terms.size(); ++i) sum = minkowski_sum(sum, f.terms[i]);
  return sum;
}

// ---- of the plane: z is 0 ----

Shape made_rectangle(const ShapeFields& f) {
  const std::vector<mpq_class>& half = f.numbers.find("half")->second;
  if (half[0] <= 0 || half[1] <= 0) throw std::invalid_argument("the half lengths of a box are > 0");
  return hull(std::vector<Point>{
      {-half[0], -half[1], 0}, {half[0], -half[1], 0}, {half[0], half[1], 0}, {-half[0], half[1], 0}});
}

Shape made_halfplane(const ShapeFields& f) {
  const std::vector<mpq_class>& normal = f.numbers.find("normal")->second;
  if (normal[0] == 0 && normal[1] == 0) throw std::invalid_argument("the normal of a half-plane is not 0");
  return halfspace({normal[0], normal[1], 0}, number(f, "offset"));
}

const std::vector<ShapeName>& names_of_plane() {
  constexpr NumberField radius{"radius", 1}, half_length{"half_length", 1};
  static const std::vector<ShapeName> all{
      {"circle", {radius}, ShapePart::none, made_sphere},
      {"capsule", {radius, half_length}, ShapePart::axis, made_capsule},
      {"box", {{"half", 2}}, ShapePart::none, made_rectangle},
      {"polygon", {}, ShapePart::vertices, made_hull},
      {"halfplane", {{"normal", 2}, {"offset", 1}}, ShapePart::none, made_halfplane},
  };
  return all;
}

const std::vector<ShapeName>& names() {
  constexpr NumberField radius{"radius", 1}, half_length{"half_length", 1}, low{"radius_low", 1},
      high{"radius_high", 1};
  static const std::vector<ShapeName> all{
      {"sphere", {radius}, ShapePart::none, made_sphere},
      {"capsule", {radius, half_length}, ShapePart::axis, made_capsule},
      {"tapered_capsule", {low, high, half_length}, ShapePart::axis, made_tapered_capsule},
      {"box", {{"half", 3}}, ShapePart::none, made_box},
      {"cylinder", {radius, half_length}, ShapePart::axis, made_cylinder},
      {"cone", {radius, half_length}, ShapePart::axis, made_cone},
      {"frustum", {low, high, half_length}, ShapePart::axis, made_frustum},
      {"ellipsoid", {{"radii", 3}}, ShapePart::none, made_ellipsoid},
      {"hull", {}, ShapePart::vertices, made_hull},
      {"triangle", {}, ShapePart::vertices, made_triangle},
      {"halfspace", {{"normal", 3}, {"offset", 1}}, ShapePart::none, made_halfspace},
      {"sum", {}, ShapePart::terms, made_sum},
  };
  return all;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::string_view whole_name(std::string_view field) {
  return field == "r" ? "radius" : field == "h" ? "half_length" : field;
}

constexpr std::string_view plane_prefix = "plane:";

/// "capsule:r=1,h=2", and "plane:circle:r=1".
struct ShapeWord {
  unsigned dimension;
  std::string_view name;
  std::optional<std::string_view> fields;  ///< what stands behind the name's colon

  explicit ShapeWord(std::string_view word) : dimension(word.starts_with(plane_prefix) ? 2 : 3) {
    if (dimension == 2) word.remove_prefix(plane_prefix.size());
    const std::size_t colon = word.find(':');
    name = word.substr(0, colon);
    if (colon != std::string_view::npos) fields = word.substr(colon + 1);
  }
};

class ShapeText {
 public:
  ShapeText(const std::string& word, Decimals decimals) : word_(word), decimals_(decimals) {}

  Body read() {
    const ShapeWord word(word_);
    dimension_ = word.dimension;
    if (dimension_ == 2) words_.fields.axis = Axis::x;
    const std::string name(word.name);
    const NamedShape named = named_shape(name, dimension_);
    if (named.shape == nullptr)
      fail("expected one of the shapes " + list_of_shapes(dimension_) + "; found " + kernels::shown(name) +
           (named_shape(name, 2).shape ? ": of the plane, it is plane:" + name + ":..." : ""));
    if (named.shape->part == ShapePart::terms || named.shape->part == ShapePart::vertices)
      fail("a " + std::string(named.shape->name) + " has no short form: give it in a case, or a " +
           (dimension_ == 2 ? "file" : "mesh"));
    for (const std::string_view part : split(word.fields.value_or(""), ',')) field(*named.shape, part);
    const auto& read = words_.fields.numbers;
    for (const NumberField& field : named.shape->numbers) require(field.name, read.contains(field.name));
    if (named.rounded) require("margin", read.contains("margin"));
    words_.shape = name;
    try {
      return dimension_ == 2 ? body_in_plane(*named.shape) : body_of(std::move(words_));
    } catch (const std::invalid_argument& error) {
      fail(error.what());
    }
  }

 private:
  [[noreturn]] void fail(const std::string& sentence) const {
    throw InputError(kernels::printable(word_, readable), 0, sentence);
  }
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
    const std::vector<mpq_class> p = numbers(text, dimension_);
    return {p[0], p[1], dimension_ == 2 ? mpq_class(0) : p[2]};
  }
  [[nodiscard]] Axis axis(std::string_view text) const {
    if (text == "x") return Axis::x;
    if (text == "y") return Axis::y;
    if (text == "z" && dimension_ == 3) return Axis::z;
    fail(std::string("expected the axis ") + (dimension_ == 2 ? "x or y" : "x, y or z") + ", found " +
         kernels::shown(text));
  }
  [[nodiscard]] std::string_view turn() const { return dimension_ == 2 ? "half_angle" : "quaternion"; }

  /// The words of bodies in space are none of these.
  [[nodiscard]] Body body_in_plane(const ShapeName& shape) const {
    Body body = files::body_of(made_shape(shape, words_.fields));
    body.dimension = 2;
    files::place(body, {.turn = words_.turn, .place = words_.place});
    return body;
  }

  [[nodiscard]] std::string fields(const ShapeName& shape) const {
    std::string all;
    for (const NumberField& number : shape.numbers) all += std::string(number.name) + ", ";
    return all + (shape.part == ShapePart::axis ? "axis, margin, at or " : "margin, at or ") + std::string(turn());
  }

  void field(const ShapeName& shape, std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) fail("expected FIELD=VALUE, found " + kernels::shown(text));
    const std::string name(whole_name(text.substr(0, equals)));
    const std::string_view value = text.substr(equals + 1);
    if (!seen_.insert(name).second) fail("expected one field '" + name + "', found a second one");
    if (const NumberField* const number = number_field(shape, name)) {
      words_.fields.numbers[name] = numbers(value, number->count);
    } else if (name == "axis" && shape.part == ShapePart::axis) {
      words_.fields.axis = axis(value);
    } else if (name == "at") {
      words_.place = point(value);
    } else if (name == turn() && dimension_ == 2) {
      words_.turn.z = numbers(value, 1).front();
    } else if (name == turn()) {
      const std::vector<mpq_class> q = numbers(value, 4);
      words_.turn = {q[0], q[1], q[2], q[3]};
    } else {
      fail("expected a field of a " + std::string(shape.name) + ": " + fields(shape) + "; found " +
           kernels::shown(name));
    }
  }

  static constexpr std::size_t readable = 60;

  const std::string& word_;
  Decimals decimals_;
  unsigned dimension_ = 3;
  NamedBody words_;
  std::set<std::string> seen_;
};

}  // namespace

std::span<const ShapeName> shape_names(unsigned dimension) { return dimension == 2 ? names_of_plane() : names(); }

NamedShape named_shape(std::string_view name, unsigned dimension) {
  const bool rounded = name.starts_with(rounded_prefix);
  if (rounded) name.remove_prefix(rounded_prefix.size());
  for (const ShapeName& shape : shape_names(dimension))
    if (shape.name == name) return {&shape, rounded};
  return {};
}

const NumberField* number_field(std::string_view name) {
  if (name == margin.name) return &margin;
  for (const ShapeName& shape : names())
    for (const NumberField& field : shape.numbers)
      if (field.name == name) return &field;
  return nullptr;
}

const NumberField* number_field(const ShapeName& shape, std::string_view name) {
  if (name == margin.name) return &margin;
  const auto found = std::ranges::find(shape.numbers, name, &NumberField::name);
  return found == shape.numbers.end() ? nullptr : &*found;
}

std::string list_of_shapes(unsigned dimension) {
  std::string list;
  for (const ShapeName& shape : shape_names(dimension)) list += (list.empty() ? "" : ", ") + std::string(shape.name);
  return list;
}

Shape shape_of(const Body& body) { return body.shape ? *body.shape : hull(body.points); }

Body body_of(Shape shape) {
  const std::optional<std::vector<Point>> points = shape.radius == 0 ? points_of(shape) : std::nullopt;
  Body body;
  if (points) body.points = *points;
  else body.shape = std::move(shape);
  return body;
}

std::optional<std::vector<Point>> points_of(const Shape& shape) {
  const auto* const terms = std::get_if<std::vector<Term>>(&shape.core);
  if (!terms || terms->size() != 1) return std::nullopt;
  std::vector<Point> points;
  for (const Atom& atom : terms->front().atoms) {
    if (!atom.axes.empty()) return std::nullopt;
    points.push_back(atom.center);
  }
  return points;
}

Shape made_shape(const ShapeName& shape, const ShapeFields& fields) {
  Shape result = shape.made(fields);
  return fields.numbers.contains(margin.name) ? with_margin(std::move(result), number(fields, margin.name)) : result;
}

NamedBody named(std::string shape, NumbersByName numbers, Axis axis) {
  NamedBody body{std::move(shape)};
  for (const auto& [name, values] : numbers) body.fields.numbers[name] = values;
  body.fields.axis = axis;
  return body;
}

NamedBody named_hull(std::vector<Point> vertices) {
  NamedBody body{"hull"};
  body.fields.vertices = std::move(vertices);
  return body;
}

NamedBody named_sum(std::vector<NamedBody> terms) {
  NamedBody body{"sum"};
  body.terms = std::move(terms);
  return body;
}

NamedBody rounded(NamedBody body, const mpq_class& margin) {
  body.shape.insert(0, "rounded_");
  body.fields.numbers["margin"] = {margin};
  return body;
}

NamedBody posed(NamedBody body, const Quaternion& turn, const Point& place) {
  const Pose motion = rigid_pose(turn, place);
  if (body.matrix) {
    body.matrix = product(motion, *body.matrix);
  } else {
    body.turn = product(turn, body.turn);
    body.place = placed(body.place, motion);
  }
  return body;
}

NamedBody posed(NamedBody body, const GivenPose& pose) {
  if (!pose.matrix) return posed(std::move(body), pose.turn, pose.place);
  body.matrix = product(*pose.matrix, pose_of(body));
  return body;
}

Pose pose_of(const NamedBody& body) { return body.matrix ? *body.matrix : rigid_pose(body.turn, body.place); }

Shape shape_of(const NamedBody& body) {
  ShapeFields fields = body.fields;
  for (const NamedBody& term : body.terms) fields.terms.push_back(shape_of(term));
  return moved(made_shape(*named_shape(body.shape).shape, fields), pose_of(body));
}

Body body_of(NamedBody body) {
  Body result = body_of(shape_of(body));
  result.words = std::make_shared<const NamedBody>(std::move(body));
  return result;
}

bool is_shape_text(const std::string& word) {
  const ShapeWord split(word);
  if (!split.fields) return false;
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz_";
  const bool is_word = !split.name.empty() && split.name.find_first_not_of(letters) == std::string_view::npos;
  return named_shape(split.name, split.dimension).shape != nullptr ||
         (is_word && split.fields->find('=') != std::string_view::npos);
}

Body parse_shape(const std::string& word, Decimals decimals) {
  const kernels::DefaultFloatEnvironment environment;
  return ShapeText(word, decimals).read();
}

}  // namespace fathom::files
