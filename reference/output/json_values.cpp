// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/output/json_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "fathom/numbers.hpp"
#include "kernels/number/irrational.hpp"

namespace fathom::output {
namespace {

/// null unless the number is finite and tells a positive value from 0: the exact fields speak then.
Json nearest_binary64(double value, int sign) {
  if (!std::isfinite(value) || (value == 0 && sign != 0)) return nullptr;
  return value;
}

template <class Float>
Json in_every_direction(const kernels::EveryMode<Float>& rounded) {
  return {{"rn", Json::plain(hex_text(rounded.rn))},
          {"rd", Json::plain(hex_text(rounded.rd))},
          {"ru", Json::plain(hex_text(rounded.ru))}};
}

/// The fields of a number that is printed exactly as `key`.
Json rounded_number(std::string_view key, const mpq_class& exactly, const kernels::Roundings& rounded) {
  return {{key, Json::plain(exact_text(exactly))},
          {"value", nearest_binary64(rounded.binary64.rn, sgn(exactly))},
          {"rounded", {{"f64", in_every_direction(rounded.binary64)}, {"f32", in_every_direction(rounded.binary32)}}}};
}

std::optional<mpq_class> rational_square(const Surd& value) {
  if (value.rational == 0) return abs(value.root);
  const std::optional<mpq_class> number = kernels::rational_value(value);
  return number ? std::optional<mpq_class>(*number * *number) : std::nullopt;
}

template <class Float>
Json in_every_direction(const Surd& value, Float (*round)(const Surd&, Rounding)) {
  return {{"rn", Json::plain(hex_text(round(value, Rounding::rn)))},
          {"rd", Json::plain(hex_text(round(value, Rounding::rd)))},
          {"ru", Json::plain(hex_text(round(value, Rounding::ru)))}};
}

Json bound(double value) { return std::isfinite(value) ? Json(value) : Json(); }

/// null for what is not finite.
Json finite_array(const std::optional<std::array<double, 3>>& values) {
  if (!values || !std::ranges::all_of(*values, [](double x) { return std::isfinite(x); })) return {};
  return Json::array({(*values)[0], (*values)[1], (*values)[2]});
}

Json object_of(const polytope::Dents& dents) {
  return {{"convex", Json::boolean(false)},
          {"volume_ratio", dents.volume_ratio ? number(*dents.volume_ratio) : Json()},
          {"deepest", dents.deepest
                          ? Json{{"point", dents.deepest->point}, {"depth", length(dents.deepest->squared_depth, {})}}
                          : Json()}};
}

Json object_of(const polytope::MeshConvexity& found) {
  return found.dents ? object_of(*found.dents) : Json{{"convex", Json::boolean(true)}};
}

/// Of a union: its pieces that are not convex.
Json array_of(const shapes::DentedPieces& pieces) {
  Json result = Json::array();
  for (const auto& [piece, dents] : pieces) {
    Json object = object_of(dents);
    object["piece"] = piece;
    result.push_back(object);
  }
  return result;
}

}  // namespace

Json exact(const Point& p) {
  return Json::array({Json::plain(exact_text(p.x)), Json::plain(exact_text(p.y)), Json::plain(exact_text(p.z))});
}

Json exact(const Vector& v) {
  return Json::array({Json::plain(v.x.get_str()), Json::plain(v.y.get_str()), Json::plain(v.z.get_str())});
}

Json length(const mpq_class& squared, const std::optional<unsigned>& digits) {
  return length(squared, kernels::roundings_of_root(squared), digits);
}

Json length(const mpq_class& squared, const kernels::Roundings& rounded, const std::optional<unsigned>& digits) {
  Json result = rounded_number("squared", squared, rounded);
  if (digits) {
    const Enclosure enclosure = enclose_root(squared, *digits);
    result["enclosure"] = Json::array({enclosure.low, enclosure.high});
  }
  return result;
}

Json number(const mpq_class& value) { return rounded_number("exact", value, kernels::roundings(value)); }

Json surd_length(const Surd& value, const std::optional<unsigned>& digits) {
  const std::optional<mpq_class> square = rational_square(value);
  if (square) return length(*square, digits);
  const double nearest = round_binary64(value);
  Json result = {{"squared", Json()},
                 {"value", std::isfinite(nearest) && nearest != 0 ? Json(nearest) : Json()},
                 {"rounded",
                  {{"f64", in_every_direction<double>(value, round_binary64)},
                   {"f32", in_every_direction<float>(value, round_binary32)}}}};
  if (digits) {
    const Enclosure enclosure = enclose(value, *digits);
    result["enclosure"] = Json::array({enclosure.low, enclosure.high});
  }
  return result;
}

Json exact_object(const Surd& value) {
  return {{"sign", sgn(value.root)},
          {"root", Json::plain(exact_text(abs(value.root)))},
          {"plus", Json::plain(exact_text(value.rational))}};
}

SignedDepthBounds penetrating_by(const kernels::Roundings& depth) { return {depth.binary64.rd, depth.binary64.ru}; }

SignedDepthBounds apart_by(const kernels::Roundings& distance) {
  return {-distance.binary64.ru, 0 - distance.binary64.rd};
}

Json signed_depth_object(const SignedDepthBounds& bounds) {
  return {{"low", bound(bounds.low)}, {"high", bound(bounds.high)}};
}

Json signed_depth_object(const SignedDepth& depth) {
  Json result = signed_depth_object({depth.low_binary64(), depth.high_binary64()});
  if (depth.exact()) result["exact"] = exact_object(*depth.exact());
  return result;
}

Json vector_object(const AlongNormal& vector) {
  if (const std::optional<Point> point = rounded::rational_point(vector)) return exact(*point);
  return {{"normal", exact(vector.normal)},
          {"alpha", Json::plain(exact_text(vector.alpha))},
          {"beta", Json::plain(exact_text(vector.beta))}};
}

Json point_object(const RoundedPoint& point) {
  if (const std::optional<Point> place = rounded::rational_point(point)) return exact(*place);
  return {{"core", exact(point.core)},
          {"normal", exact(point.normal)},
          {"distance", Json::plain(exact_text(point.distance))}};
}

Json numbers(const rounded::Coordinates& values) { return finite_array(rounded::nearest_binary64(values)); }
Json unit_f64(const Vector& direction) { return numbers(rounded::unit(direction)); }

Json contact_object(const Contact& contact) {
  return {{"kind", name(contact.kind)}, {"a", Json(contact.a)}, {"b", Json(contact.b)}};
}

Json witness_object(const Witness& witness) { return {{"a", exact(witness.a)}, {"b", exact(witness.b)}}; }

Json flat_array(const BodyFacts& facts) {
  Json result = Json::array();
  if (facts.flat_a) result.push_back("a");
  if (facts.flat_b) result.push_back("b");
  return result;
}

AboutBodies about_bodies(const Case& input, bool one_body) {
  if (input.a.pieces || input.b.pieces)
    return {shapes::sizes_of(input.a, input.b),
            {{}, {}, shapes::dented_pieces(input.a), shapes::dented_pieces(input.b)}};
  if (one_body) return {shapes::sizes_of(input.a), {shapes::hull_fact(input.a), std::nullopt}};
  return {shapes::sizes_of(input.a, input.b), {shapes::hull_fact(input.a), shapes::hull_fact(input.b)}};
}

Json sizes_object(const shapes::BodySizes& sizes) {
  Json result = {{"a", finite_array(sizes.a)}};
  if (!sizes.one_body) result["b"] = finite_array(sizes.b);
  return result;
}

std::optional<Json> hull_object(const shapes::HullFacts& facts) {
  if (!facts.a && !facts.b && !facts.pieces_a && !facts.pieces_b) return std::nullopt;  // no mesh was compared
  Json hull = Json::object();
  if (facts.a) hull["a"] = object_of(*facts.a);
  if (facts.b) hull["b"] = object_of(*facts.b);
  if (facts.pieces_a) hull["a"] = array_of(*facts.pieces_a);
  if (facts.pieces_b) hull["b"] = array_of(*facts.pieces_b);
  return hull;
}

std::string error_object(std::string_view schema, const std::string& id, std::size_t line, std::string_view error) {
  return Json{{"schema", schema}, {"id", id}, {"line", line}, {"error", error}}.text();
}

}  // namespace fathom::output
