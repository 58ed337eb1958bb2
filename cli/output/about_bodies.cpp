// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/about_bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "cli/output/json_values.hpp"

namespace fathom::cli {
namespace {

/// null for what is not finite.
Json lengths_array(const std::optional<std::array<double, 3>>& lengths) {
  if (!lengths || !std::ranges::all_of(*lengths, [](double x) { return std::isfinite(x); })) return {};
  return Json::array({(*lengths)[0], (*lengths)[1], (*lengths)[2]});
}

Json sizes_object(const shapes::BodySizes& sizes) {
  Json result = {{"a", lengths_array(sizes.a)}};
  if (!sizes.one_body) result["b"] = lengths_array(sizes.b);
  return result;
}

Json object_of(const polytope::Dents& dents) {
  return {{"convex", Json::boolean(false)},
          {"volume_ratio", dents.volume_ratio ? number(*dents.volume_ratio) : Json()},
          {"deepest", dents.deepest ? Json{{"point", dents.deepest->point}, {"depth", length(dents.deepest->squared_depth, {})}} : Json()}};
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

/// nullopt if no mesh was compared.
std::optional<Json> hull_object(const shapes::HullFacts& facts) {
  Json result = Json::object();
  if (facts.a) result["a"] = object_of(*facts.a);
  if (facts.b) result["b"] = object_of(*facts.b);
  if (facts.pieces_a) result["a"] = array_of(*facts.pieces_a);
  if (facts.pieces_b) result["b"] = array_of(*facts.pieces_b);
  const bool any = facts.a || facts.b || facts.pieces_a || facts.pieces_b;
  return any ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace

AboutBodies about_bodies(const Case& input, bool one_body) {
  if (input.a.pieces || input.b.pieces)
    return {shapes::sizes_of(input.a, input.b), {{}, {}, shapes::dented_pieces(input.a), shapes::dented_pieces(input.b)}};
  if (one_body) return {shapes::sizes_of(input.a), {shapes::hull_fact(input.a), std::nullopt}};
  return {shapes::sizes_of(input.a, input.b), {shapes::hull_fact(input.a), shapes::hull_fact(input.b)}};
}

void add_bodies(std::vector<Row>& rows, const AboutBodies& bodies) {
  rows.emplace_back("sizes", shapes::sizes_text(bodies.sizes));
  add_hull(rows, bodies.hull);
}

void add_hull(std::vector<Row>& rows, const shapes::HullFacts& facts) {
  if (const std::string dents = shapes::dents_text(facts); !dents.empty()) rows.emplace_back("hull", dents);
}

void add_bodies(Json& result, const AboutBodies& bodies) {
  result["sizes"] = sizes_object(bodies.sizes);
  add_hull(result, bodies.hull);
}

void add_hull(Json& result, const shapes::HullFacts& facts) {
  if (const std::optional<Json> hull = hull_object(facts)) result["hull"] = *hull;
}

}  // namespace fathom::cli
