// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/subjects/read_shape.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace subject {
namespace {

using nlohmann::json;

enum class Field { radius, half_length, axis, half, radii, normal, offset, vertices };

const std::map<std::string, std::vector<Field>>& vocabulary() {
  using enum Field;
  static const std::map<std::string, std::vector<Field>> fields{{"sphere", {radius}},
                                                                {"capsule", {radius, half_length, axis}},
                                                                {"box", {half}},
                                                                {"cylinder", {radius, half_length, axis}},
                                                                {"cone", {radius, half_length, axis}},
                                                                {"ellipsoid", {radii}},
                                                                {"halfspace", {normal, offset}},
                                                                {"hull", {vertices}}};
  return fields;
}

template <std::size_t N>
std::array<double, N> numbers(const json& from) {
  if (!from.is_array() || from.size() != N) throw std::invalid_argument("expected " + std::to_string(N) + " numbers, found " + from.dump());
  return from.get<std::array<double, N>>();
}

double positive(double x, const char* name) {
  if (!(x > 0)) throw std::invalid_argument(std::string(name) + " expects what is positive, found " + json(x).dump());
  return x;
}

double positive_number(const json& from, const char* name) { return positive(from.at(name).get<double>(), name); }

Vector positive_numbers(const json& from, const char* name) {
  const Vector v = numbers<3>(from.at(name));
  for (const double x : v) positive(x, name);
  return v;
}

/// v -> q v q^-1 of a quaternion w, x, y, z that need not be a unit.
Pose turn(std::array<double, 4> q) {
  double largest = 0;
  for (const double x : q) largest = std::max(largest, std::abs(x));
  if (!(largest > 0)) throw std::invalid_argument("a quaternion of zeros");
  double squared = 0;
  for (double& x : q) {
    x /= largest;  // nothing overflows, and not all vanishes
    squared += x * x;
  }
  const auto [w, x, y, z] = q;
  const double s = 2 / squared;
  Pose pose;
  pose.rows = {{{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
                {s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)},
                {s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)}}};
  return pose;
}

Pose read_pose(const json& from) {
  Pose pose;
  if (from.is_object()) {
    pose = turn(numbers<4>(from.at("quaternion")));
    pose.translation = numbers<3>(from.at("translation"));
    return pose;
  }
  if (!from.is_array() || from.size() != 3) throw std::invalid_argument("a pose is a quaternion and a translation, or three rows");
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<double, 4> row = numbers<4>(from[i]);
    pose.rows[i] = {row[0], row[1], row[2]};
    pose.translation[i] = row[3];
  }
  return pose;
}

/// Turns z into the axis, and the axes behind z into those behind it.
void turn_to_axis(Pose& pose, const std::string& name) {
  const std::size_t axis = name.size() == 1 ? std::string("xyz").find(name) : std::string::npos;
  if (axis == std::string::npos) throw std::invalid_argument("an axis is x, y or z, found " + name);
  for (Vector& row : pose.rows) row = {row[(axis + 1) % 3], row[(axis + 2) % 3], row[axis]};
}

void read_field(Field field, const json& from, Body& body) {
  Shape& shape = *body.shape;
  switch (field) {
    case Field::radius: shape.radius = positive_number(from, "radius"); return;
    case Field::half_length: shape.half_length = positive_number(from, "half_length"); return;
    case Field::axis: turn_to_axis(shape.pose, from.value("axis", "z")); return;
    case Field::half: shape.half = positive_numbers(from, "half"); return;
    case Field::radii: shape.radii = positive_numbers(from, "radii"); return;
    case Field::offset: shape.offset = from.at("offset").get<double>(); return;
    case Field::normal:
      shape.normal = numbers<3>(from.at("normal"));
      if (shape.normal == Vector{}) throw std::invalid_argument("a normal of zeros");
      return;
    case Field::vertices:
      for (const json& vertex : from.at("vertices")) body.vertices.push_back(numbers<3>(vertex));
      if (body.vertices.empty()) throw std::invalid_argument("a hull without vertices");
      return;
  }
}

bool is_rotation(const Pose& pose) {
  constexpr double tolerance = 4e-6;  // entries that are off by 1e-6 change a product of two rows by 2 sqrt(3) as much
  const auto& [u, v, w] = pose.rows;
  double determinant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    determinant += u[i] * (v[j] * w[k] - v[k] * w[j]);
    for (std::size_t l = 0; l < 3; ++l) {
      const Vector &p = pose.rows[i], &q = pose.rows[l];
      const double product = p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
      if (!(std::abs(product - (i == l ? 1 : 0)) <= tolerance)) return false;
    }
  }
  return determinant > 0;
}

}  // namespace

Body read_shape(const json& from) {
  Body body{{}, {}, Shape{.name = from.at("shape").get<std::string>()}};
  const auto fields = vocabulary().find(body.shape->name);
  if (fields == vocabulary().end()) return body;
  body.shape->pose = read_pose(from.at("pose"));
  for (const Field field : fields->second) read_field(field, from, body);
  body.shape->margin = from.value("margin", 0.0);
  if (!(body.shape->margin >= 0)) throw std::invalid_argument("a margin below 0");
  return body;
}

void check_taken(const Body& body, const Mode& mode) {
  if (!body.shape) return;
  const Shape& shape = *body.shape;
  const auto takes = [&mode](const std::string& word) { return std::ranges::find(mode.shapes, word) != mode.shapes.end(); };
  if (!vocabulary().contains(shape.name) || !takes(shape.name)) throw Unsupported("a " + shape.name + ", which " + mode.name + " has not");
  if (shape.margin > 0 && !takes("margin")) throw Unsupported("a margin, which " + mode.name + " has not");
  if (!is_rotation(shape.pose)) throw Unsupported("a pose that is no rotation");
}

Vector Pose::turned(const Vector& v) const {
  Vector w{};
  for (std::size_t i = 0; i < 3; ++i) w[i] = rows[i][0] * v[0] + rows[i][1] * v[1] + rows[i][2] * v[2];
  return w;
}

Vector Pose::turned_back(const Vector& v) const {
  Vector w{};
  for (std::size_t i = 0; i < 3; ++i) w[i] = rows[0][i] * v[0] + rows[1][i] * v[1] + rows[2][i] * v[2];
  return w;
}

}  // namespace subject
