// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/json_result.hpp"

#include <fmt/format.h>

#include <cmath>

#include "cli/output/coordinates.hpp"
#include "cli/output/json_values.hpp"
#include "fathom/numbers.hpp"
#include "kernels/counts.hpp"
#include "kernels/number/infinitesimal.hpp"

namespace fathom::cli {
namespace {

/// The first optimum's direction and translation are those of the depth.
Json optima_array(const Depth& depth, const Json& direction, const Json& translation) {
  Json result = Json::array();
  for (const Optimum& optimum : depth.optima()) {
    const bool first = &optimum == &depth.optima().front();
    result.push_back({{"direction", first ? direction : exact(optimum.direction)},
                      {"translation", first ? translation : exact(optimum.translation())},
                      {"contact", contact_object(optimum.contact)}});
  }
  return result;
}

Json distance_object(const Distance& distance, const kernels::Roundings& rounded, const Request& request) {
  Json result = length(distance.squared, rounded, request.digits);
  result["direction"] = exact(distance.direction);
  result["translation"] = exact(distance.translation);
  result["witness"] = witness_object(distance.witness);
  add_rounded(result, distance.direction, coordinates(distance.translation), coordinates(distance.witness));
  return result;
}

/// The signed depth of two polytopes: sign * sqrt(root) + plus.
Json exact_signed_depth(const SignedDepthBounds& bounds, int sign, const mpq_class& root) {
  Json result = signed_depth_object(bounds);
  result["exact"] = {{"sign", sign}, {"root", Json::plain(exact_text(root))}, {"plus", Json::plain("0")}};
  return result;
}

constexpr std::string_view schema = "fathom/result/2";

Json bound(double value) { return std::isfinite(value) ? Json(value) : Json(); }

}  // namespace

Json result_head(const std::string& id, std::string_view status) {
  Json result = {{"schema", schema}, {"fathom", FATHOM_VERSION}, {"id", id}, {"status", status}};
  return result;
}

SignedDepthBounds penetrating_by(const kernels::Roundings& depth) { return {depth.binary64.rd, depth.binary64.ru}; }

SignedDepthBounds apart_by(const kernels::Roundings& distance) { return {-distance.binary64.ru, 0 - distance.binary64.rd}; }

Json signed_depth_object(const SignedDepthBounds& bounds) { return {{"low", bound(bounds.low)}, {"high", bound(bounds.high)}}; }

Json counters_object(const Counters& counters) {
  Json result;
  Json stages = Json::array();
  for (const kernels::StageCounts& stage : kernels::counts_by_stage(counters)) {
    if (stage.ran()) stages.push_back(stage.stage);
    for (const kernels::Count& count : stage.counts) result[count.name] = count.value;
  }
  result["stages"] = stages;
  Json predicates = Json::object();
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    const TierCounts& tiers = counters.predicates[i];
    Json decided = Json::object();
    for (const auto& [packed, count] : tiers.decided) decided[kernels::Monomial::unpacked(packed).text()] = count;
    predicates[predicate_names[i]] = {{"calls", tiers.calls}, {"exact", tiers.exact}, {"zero", tiers.zero}, {"decided_by", decided}};
  }
  result["predicates"] = predicates;
  return result;
}

std::string json_result(const Answer& answer, const Request& request) {
  const Depth& depth = answer.depth;
  Json result = result_head(answer.id, name(depth.status()));
  const mpq_class squared = depth.squared();
  const kernels::Roundings rounded = kernels::roundings_of_root(squared);
  const Distance* const distance = depth.distance();
  const kernels::Roundings rounded_distance = distance ? kernels::roundings_of_root(distance->squared) : kernels::Roundings{};
  result["signed_depth"] = distance ? exact_signed_depth(apart_by(rounded_distance), -1, distance->squared)
                                    : exact_signed_depth(penetrating_by(rounded), sgn(squared), squared);
  const Json size = length(squared, rounded, request.digits);
  result["depth"] = size;
  const Json translation = exact(depth.translation()), direction = exact(depth.direction());
  result["translation"] = translation;
  result["direction"] = direction;
  result["contact"] = depth.contact() ? contact_object(*depth.contact()) : Json();
  const std::optional<Witness> witness = depth.witness();
  result["witness"] = witness ? witness_object(*witness) : Json();
  add_rounded(result, depth.direction(), coordinates(depth.translation()), coordinates_of(witness));
  result["optima"] = optima_array(depth, direction, translation);
  if (request.optima) result["optima_count"] = depth.optima_count();
  if (distance) result["distance"] = distance_object(*distance, rounded_distance, request);
  add_bodies(result, answer.bodies);
  result["flat"] = flat_array(depth);
  result["method"] = method_name(depth);
  if (request.counters) result["counters"] = counters_object(depth.counters);
  if (request.embed_certificate) result["certificate"] = answer.certificate;
  if (request.command == Command::width) result["width"] = size;
  return result.text();
}

std::string json_error(const std::string& id, std::size_t line, std::string_view error) { return error_object(schema, id, line, error); }

}  // namespace fathom::cli
