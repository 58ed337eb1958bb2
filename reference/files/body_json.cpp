// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/body_json.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "fathom/numbers.hpp"

namespace fathom::files {
namespace {

constexpr std::size_t plain_digits = 15;  // integers with at most this many digits are binary64 numbers

std::string three(const Point& p) { return fmt::format("[{},{},{}]", number_json(p.x), number_json(p.y), number_json(p.z)); }

std::string matrix_json(const Pose& pose) {
  return array_json(pose, [](const auto& row) { return array_json(row, number_json); });
}

/// Of a NamedBody or a GivenPose.
std::string pose_json(const auto& given) {
  if (given.matrix) return matrix_json(*given.matrix);
  const Quaternion& turn = given.turn;
  return fmt::format(R"({{"quaternion":{},"translation":{}}})", array_json(std::array{turn.w, turn.x, turn.y, turn.z}, number_json),
                     three(given.place));
}

bool is_unmoved(const NamedBody& body) { return !body.matrix && body.turn == Quaternion{1, 0, 0, 0} && body.place == Point{}; }

}  // namespace

std::string number_json(const mpq_class& value) {
  if (value.get_den() == 1 && mpz_sizeinbase(value.get_num_mpz_t(), 10) <= plain_digits) return value.get_str();
  const double nearest = round_binary64(value, Rounding::rn);
  if (std::isfinite(nearest) && exact_value(nearest) == value) return fmt::format("{}", nearest);
  return '"' + exact_text(value) + '"';
}

std::string text_json(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

std::string body_json(const Body& body, const std::optional<Pose>& pose) {
  if (body.words && !pose) return body_json(*body.words);
  if (body.shape) throw std::invalid_argument("a shape without words has no text");
  const auto vertices = [](const auto& points) { return "{\"vertices\":" + array_json(points, three); };
  std::string result = body.pieces ? "{\"pieces\":" + array_json(*body.pieces, [&](const auto& piece) { return vertices(piece) + '}'; })
                                   : vertices(body.points);
  if (pose) result += ",\"pose\":" + matrix_json(*pose);
  return result + '}';
}

std::string body_json(const Body& body, const GivenPose& pose) {
  std::string text = body_json(body);
  text.pop_back();
  return text + ",\"pose\":" + pose_json(pose) + '}';
}

std::string body_json(const NamedBody& body, Defaults defaults) {
  const ShapeName& shape = *named_shape(body.shape).shape;
  const bool all = defaults == Defaults::written;
  std::string result = "{\"shape\":" + text_json(body.shape);
  const auto field = [&](std::string_view name, const std::string& text) { result += fmt::format(",\"{}\":{}", name, text); };
  const auto numbers = [&](std::string_view name) {
    const auto found = body.fields.numbers.find(name);
    if (found == body.fields.numbers.end()) return;
    field(name, found->second.size() == 1 ? number_json(found->second.front()) : array_json(found->second, number_json));
  };
  for (const NumberField& known : shape.numbers) numbers(known.name);
  if (shape.part == ShapePart::axis && (all || body.fields.axis != Axis::z))
    field("axis", body.fields.axis == Axis::x ? R"("x")" : body.fields.axis == Axis::y ? R"("y")" : R"("z")");
  if (!body.fields.vertices.empty()) field("vertices", array_json(body.fields.vertices, three));
  if (!body.terms.empty()) field("terms", array_json(body.terms, [&](const NamedBody& term) { return body_json(term, defaults); }));
  numbers("margin");
  if (all || !is_unmoved(body)) field("pose", pose_json(body));
  return result + '}';
}

}  // namespace fathom::files
