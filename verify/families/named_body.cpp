// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/families/named_body.hpp"

#include "reference/files/pose.hpp"

namespace fathom::families {
namespace {

Quaternion product(const Quaternion& p, const Quaternion& q) {
  return {p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z, p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
          p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x, p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
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
  body.turn = product(turn, body.turn);
  body.place = files::placed(body.place, rigid_pose(turn, place));
  return body;
}

Shape shape_of(const NamedBody& body) {
  files::ShapeFields fields = body.fields;
  for (const NamedBody& term : body.terms) fields.terms.push_back(shape_of(term));
  return moved(files::made_shape(*files::named_shape(body.shape).shape, fields), rigid_pose(body.turn, body.place));
}

Case ShapeCase::read() const { return {id, files::body_of(shape_of(pair.a)), files::body_of(shape_of(pair.b))}; }

}  // namespace fathom::families
