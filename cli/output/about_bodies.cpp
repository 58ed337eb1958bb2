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

Json object_of(const polytope::MeshConvexity& found) {
  if (!found.dents) return {{"convex", Json::boolean(true)}};
  const polytope::Dents& dents = *found.dents;
  return {{"convex", Json::boolean(false)},
          {"volume_ratio", dents.volume_ratio ? number(*dents.volume_ratio) : Json()},
          {"deepest", dents.deepest ? Json{{"point", dents.deepest->point}, {"depth", length(dents.deepest->squared_depth, {})}} : Json()}};
}

/// nullopt if no mesh was compared.
std::optional<Json> hull_object(const shapes::HullFacts& facts) {
  if (!facts.a && !facts.b) return std::nullopt;
  Json result = Json::object();
  if (facts.a) result["a"] = object_of(*facts.a);
  if (facts.b) result["b"] = object_of(*facts.b);
  return result;
}

}  // namespace

AboutBodies about_bodies(const Case& input, bool one_body) {
  if (one_body) return {shapes::sizes_of(input.a), {shapes::hull_fact(input.a), std::nullopt}};
  return {shapes::sizes_of(input.a, input.b), {shapes::hull_fact(input.a), shapes::hull_fact(input.b)}};
}

void add_bodies(std::vector<Row>& rows, const AboutBodies& bodies) {
  rows.emplace_back("sizes", shapes::sizes_text(bodies.sizes));
  if (const std::string dents = shapes::dents_text(bodies.hull); !dents.empty()) rows.emplace_back("hull", dents);
}

void add_bodies(Json& result, const AboutBodies& bodies) {
  result["sizes"] = sizes_object(bodies.sizes);
  if (const std::optional<Json> hull = hull_object(bodies.hull)) result["hull"] = *hull;
}

}  // namespace fathom::cli
