// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <span>
#include <stdexcept>

#include "fathom/solid.hpp"
#include "reference/files/cases.hpp"
#include "reference/files/mesh_formats.hpp"

namespace fathom::files {
namespace {

using text::Json;

Json number_json(const mpq_class& value) { return Json::exact(value); }
Json point_json(const Point& p) { return Json::exact(p); }
Json plane_point_json(const Point& p) { return Json::array({Json::exact(p.x), Json::exact(p.y)}); }

/// A body of the plane needs no words: all that there are have these fields.
Json plane_body_json(const Body& body) {
  const auto vertices = [](const auto& points) { return Json::array_of(points, plane_point_json); };
  if (body.pieces) return {{"pieces", Json::array_of(*body.pieces, vertices)}};
  if (!body.shape) return {{"vertices", vertices(body.points)}};
  const HalfSpace* const half = std::get_if<HalfSpace>(&body.shape->core);
  Json result = half ? Json{{"shape", "halfplane"},
                            {"normal", plane_point_json(half->normal)},
                            {"offset", number_json(half->offset)}}
                     : Json{{"vertices", vertices(points_of(*body.shape).value())}};
  if (body.shape->radius > 0) result["margin"] = number_json(body.shape->radius);
  return result;
}

Json matrix_json(const Pose& pose) {
  return Json::array_of(pose, [](const auto& row) { return Json::array_of(row, number_json); });
}

/// Of a NamedBody or a GivenPose.
Json pose_json(const auto& given) {
  if (given.matrix) return matrix_json(*given.matrix);
  const Quaternion& turn = given.turn;
  return {
      {"quaternion", Json::array({number_json(turn.w), number_json(turn.x), number_json(turn.y), number_json(turn.z)})},
      {"translation", Json::exact(given.place)}};
}

bool is_unmoved(const NamedBody& body) {
  return !body.matrix && body.turn == Quaternion{1, 0, 0, 0} && body.place == Point{};
}

}  // namespace

Json body_json(const Body& body, const std::optional<Pose>& pose) {
  if (body.dimension == 2 && pose) throw std::invalid_argument("a pose in space is none of a body of the plane");
  if (body.dimension == 2) return plane_body_json(body);
  if (body.words && !pose) return body_json(*body.words);
  if (body.shape) throw std::invalid_argument("a shape without words has no text");
  const auto vertices = [](const auto& points) { return Json{{"vertices", Json::array_of(points, point_json)}}; };
  const auto solid = [](const Solid& s) {
    const auto indices = [](const auto& t) { return Json(std::vector<std::uint32_t>(t.begin(), t.end())); };
    if (s.mesh_faces) {
      Json faces = Json::array();
      for_each_face(*s.mesh_faces, s.mesh_points.size(), [&](const auto& face) { faces.push_back(indices(face)); });
      return Json{{"vertices", Json::array_of(s.mesh_points.exact(), point_json)}, {"faces", faces}};
    }
    const std::span mesh(s.points.data(), given_points(s));
    return Json{{"vertices", Json::array_of(mesh, point_json)}, {"faces", Json::array_of(s.triangles, indices)}};
  };
  Json result = body.solid    ? Json{{"solid", solid(*body.solid)}}
                : body.pieces ? Json{{"pieces", Json::array_of(*body.pieces, vertices)}}
                              : vertices(body.points);
  if (pose) result["pose"] = matrix_json(*pose);
  return result;
}

Json body_json(const Body& body, const GivenPose& pose) {
  Json result = body_json(body);
  result["pose"] = pose_json(pose);
  return result;
}

Json body_json(const NamedBody& body, Defaults defaults) {
  const ShapeName& shape = *named_shape(body.shape).shape;
  const bool all = defaults == Defaults::written;
  Json result{{"shape", body.shape}};
  const auto numbers = [&](std::string_view name) {
    const auto found = body.fields.numbers.find(name);
    if (found == body.fields.numbers.end()) return;
    result[name] =
        found->second.size() == 1 ? number_json(found->second.front()) : Json::array_of(found->second, number_json);
  };
  for (const NumberField& known : shape.numbers) numbers(known.name);
  if (shape.part == ShapePart::axis && (all || body.fields.axis != Axis::z))
    result["axis"] = body.fields.axis == Axis::x ? "x" : body.fields.axis == Axis::y ? "y" : "z";
  if (!body.fields.vertices.empty()) result["vertices"] = Json::array_of(body.fields.vertices, point_json);
  if (!body.terms.empty())
    result["terms"] = Json::array_of(body.terms, [&](const NamedBody& term) { return body_json(term, defaults); });
  numbers("margin");
  if (all || !is_unmoved(body)) result["pose"] = pose_json(body);
  return result;
}

Json motion_json(const Motion& motion) {
  const auto twist = [](const Twist& of) { return Json{{"v", point_json(of.v)}, {"w", point_json(of.w)}}; };
  return {{"a", twist(motion.of_a)}, {"b", twist(motion.of_b)}};
}

std::string case_json(const CaseText& text) {
  Json result{{"schema", case_schema}, {"id", text.id}};
  if (text.plane) result["dimension"] = 2;
  result["a"] = text.a;
  result["b"] = text.b;
  if (text.pose_rounding) result["pose_rounding"] = "binary64";
  if (text.motion) result["twist"] = motion_json(*text.motion);
  if (!text.source.empty()) {
    Json source = Json::object();
    for (const auto& [key, value] : text.source) source[key] = value;
    result["source"] = source;
  }
  if (!text.comment.empty()) result["comment"] = text.comment;
  return result.text();
}

std::string case_json(const Case& pair, const std::string& comment) {
  return case_json(
      {pair.id, body_json(pair.a), body_json(pair.b), {}, comment, false, pair.motion, pair.a.dimension == 2});
}

}  // namespace fathom::files
