// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/named_body.hpp"

#include <memory>

namespace fathom::files {
namespace {

/// `first`, and then `second`.
Pose product(const Pose& second, const Pose& first) {
  Pose result;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column) {
      result[row][column] = column == 3 ? second[row][3] : mpq_class(0);
      for (std::size_t k = 0; k < 3; ++k) result[row][column] += second[row][k] * first[k][column];
    }
  return result;
}

}  // namespace

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

}  // namespace fathom::files
