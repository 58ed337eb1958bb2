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

/// What `write` writes.
template <class Write>
Json written(Write write) {
  JsonStream out(256);  // most take less
  write(out);
  return Json::written(out.take());
}

template <class Float>
void write(JsonStream& out, const kernels::EveryMode<Float>& rounded) {
  out.open('{').key("rn").hex(rounded.rn).key("rd").hex(rounded.rd).key("ru").hex(rounded.ru).close('}');
}

/// The fields of a number that is printed exactly as `key`.
Json rounded_number(std::string_view key, const mpq_class& exactly, const kernels::Roundings& rounded) {
  return written([&](JsonStream& out) {
    out.open('{').key(key).exact(exactly).key("value").value(
        nearest_binary64(rounded.binary64.rn, sgn(exactly)).text());
    out.key("rounded").open('{').key("f64");
    write(out, rounded.binary64);
    out.key("f32");
    write(out, rounded.binary32);
    out.close('}').close('}');
  });
}

std::optional<mpq_class> rational_square(const Surd& value) {
  if (value.rational == 0) return abs(value.root);
  const std::optional<mpq_class> number = kernels::rational_value(value);
  return number ? std::optional<mpq_class>(*number * *number) : std::nullopt;
}

template <class Float>
Json in_every_direction(const Surd& value, Float (*round)(const Surd&, Rounding)) {
  const kernels::EveryMode<Float> rounded{round(value, Rounding::rn), round(value, Rounding::rd),
                                          round(value, Rounding::ru)};
  return written([&](JsonStream& out) { write(out, rounded); });
}

/// Of a point, or of a vector.
Json exact_array(const auto& p, unsigned dimension) {
  return written([&](JsonStream& out) {
    if (dimension == 3) out.exact(p);
    else out.open('[').exact(p.x).exact(p.y).close(']');
  });
}

Json bound(double value) { return std::isfinite(value) ? Json(value) : Json(); }

/// null for what is not finite.
Json finite_array(const std::optional<std::array<double, 3>>& values, unsigned dimension = 3) {
  if (!values || !std::ranges::all_of(*values, [](double x) { return std::isfinite(x); })) return {};
  return written([&](JsonStream& out) {
    out.open('[');
    for (unsigned i = 0; i < dimension; ++i) out.decimal((*values)[i]);
    out.close(']');
  });
}

Json object_of(const polytope::MeshConvexity& found) {
  Json object = {{"convex", Json::boolean(!found.dents)}};
  if (const auto& dents = found.dents) {
    object["volume_ratio"] = dents->volume_ratio ? number(*dents->volume_ratio) : Json();
    object["deepest"] =
        dents->deepest ? Json{{"point", dents->deepest->point}, {"depth", length(dents->deepest->squared_depth, {})}}
                       : Json();
  }
  if (found.open) object["open"] = Json::boolean(true);
  return object;
}

/// Of a union: its pieces that are not convex, or open.
Json array_of(const shapes::DentedPieces& pieces) {
  Json result = Json::array();
  for (const shapes::DentedPiece& piece : pieces) {
    Json object = object_of(piece.found);
    object["piece"] = piece.piece;
    if (!piece.name.empty()) object["name"] = piece.name;
    result.push_back(object);
  }
  return result;
}

}  // namespace

Json exact(const mpq_class& q) {
  return written([&](JsonStream& out) { out.exact(q); });
}

Json exact(const Point& p, unsigned dimension) { return exact_array(p, dimension); }
Json exact(const Vector& v, unsigned dimension) { return exact_array(v, dimension); }

Json weights_array(const std::vector<Weight>& weights) {
  return Json::array_of(weights, [](const Weight& w) { return Json::array({Json(w.index), exact(w.weight)}); });
}

Json turn_object(const Point& w, unsigned dimension) { return dimension == 2 ? exact(w.z) : exact(w); }

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
  return {{"sign", sgn(value.root)}, {"root", exact(abs(value.root))}, {"plus", exact(value.rational)}};
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

Json vector_object(const AlongNormal& vector, unsigned dimension) {
  if (const std::optional<Point> point = rounded::rational_point(vector)) return exact(*point, dimension);
  return {{"normal", exact(vector.normal, dimension)}, {"alpha", exact(vector.alpha)}, {"beta", exact(vector.beta)}};
}

Json point_object(const RoundedPoint& point, unsigned dimension) {
  if (const std::optional<Point> place = rounded::rational_point(point)) return exact(*place, dimension);
  return {{"core", exact(point.core, dimension)},
          {"normal", exact(point.normal, dimension)},
          {"distance", exact(point.distance)}};
}

Json numbers(const std::array<double, 3>& values, unsigned dimension) { return finite_array(values, dimension); }
Json unit_f64(const Vector& direction, unsigned dimension) {
  return numbers(rounded::nearest_unit(direction), dimension);
}

Json contact_object(const Contact& contact) {
  return written([&](JsonStream& out) {
    out.open('{').key("kind").plain(name(contact.kind)).key("a").array_of(contact.a);
    out.key("b").array_of(contact.b);
    out.close('}');
  });
}

Json witness_object(const Witness& witness, unsigned dimension) {
  return {{"a", exact(witness.a, dimension)}, {"b", exact(witness.b, dimension)}};
}

Json flat_array(const BodyFacts& facts) {
  Json result = Json::array();
  if (facts.flat_a) result.push_back("a");
  if (facts.flat_b) result.push_back("b");
  return result;
}

AboutBodies about_bodies(const Case& input, bool one_body) {
  if (input.a.pieces || input.b.pieces)
    return {shapes::sizes_of(input.a, input.b),
            {{}, {}, shapes::dented_pieces(input.a), shapes::dented_pieces(input.b)},
            input.a.solid,
            input.b.solid};
  if (one_body) return {shapes::sizes_of(input.a), {shapes::hull_fact(input.a), std::nullopt}};
  return {shapes::sizes_of(input.a, input.b), {shapes::hull_fact(input.a), shapes::hull_fact(input.b)}};
}

Json sizes_object(const shapes::BodySizes& sizes) {
  const unsigned dimension = sizes.plane ? 2 : 3;
  Json result = {{"a", finite_array(sizes.a, dimension)}};
  if (!sizes.one_body) result["b"] = finite_array(sizes.b, dimension);
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

Json solid_object(const Solid& solid) {
  return {{"pieces", pieces_of(solid).size()},
          {"points", {{"of_mesh", given_points(solid)}, {"all", solid.points.size()}}},
          {"triangles", solid.triangles.size()},
          {"volume", number(volume(solid))},
          {"bent_faces", solid.bent_faces},
          {"turned", Json::boolean(solid.turned)},
          {"overlaps", Json::boolean(solid.overlaps)}};
}

std::optional<Json> solids_object(const AboutBodies& bodies) {
  if (!bodies.solid_a && !bodies.solid_b) return std::nullopt;
  Json solids = Json::object();
  if (bodies.solid_a) solids["a"] = solid_object(*bodies.solid_a);
  if (bodies.solid_b) solids["b"] = solid_object(*bodies.solid_b);
  return solids;
}

std::string error_object(std::string_view schema, const std::string& id, std::size_t line, std::string_view error) {
  return Json{{"schema", schema}, {"id", id}, {"line", line}, {"error", error}}.text();
}

}  // namespace fathom::output
