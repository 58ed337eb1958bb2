// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/shape_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <vector>

#include "cli/output/answer.hpp"
#include "cli/output/coordinates.hpp"
#include "cli/output/json_result.hpp"
#include "cli/output/json_values.hpp"
#include "cli/output/surd_output.hpp"
#include "cli/output/text_result.hpp"
#include "cli/output/text_rows.hpp"
#include "kernels/number/surd.hpp"

namespace fathom::cli {
namespace {

const Surd zero{0, 0};

Surd negated(const Surd& value) { return {-value.rational, -value.root}; }

std::string_view status_name(const SignedDepth& depth) { return depth.status() ? name(*depth.status()) : "undecided"; }

/// The overlapping cores' optima, which are those of the bodies; null in all other cases.
const Penetration* of_cores(const SignedDepth& depth) {
  const Depth* const cores = std::get_if<Depth>(&depth.core);
  return cores ? cores->penetration() : nullptr;
}

std::string_view method_of(const SignedDepth& depth) {
  if (const Depth* const cores = std::get_if<Depth>(&depth.core)) return method_name(*cores);
  return std::holds_alternative<PlaneSupport>(depth.core) ? "support" : "enclosure";
}

/// 0 <= low < high, rounded outward to that many digits.
Enclosure enclosure_of(const Bounds& bounds, unsigned digits) {
  return {enclose(Surd{bounds.low, 0}, digits).low, enclose(Surd{bounds.high, 0}, digits).high};
}

// ---- JSON ----

/// What of an enclosed length is certain: nothing but its bounds, unless both round to the same number.
Json enclosed_length(const Bounds& bounds, const std::optional<unsigned>& digits) {
  const mpq_class low = bounds.low > 0 ? bounds.low : mpq_class(0), high = bounds.high > 0 ? bounds.high : mpq_class(0);
  if (low == high) return length(low * low, digits);
  const double nearest = round_binary64(low);
  const bool known = nearest == round_binary64(high) && std::isfinite(nearest) && nearest != 0;
  Json result{{"squared", Json()}, {"value", known ? Json(nearest) : Json()}, {"rounded", Json()}};
  if (digits) {
    const Enclosure enclosure = enclosure_of({low, high}, *digits);
    result["enclosure"] = Json::array({enclosure.low, enclosure.high});
  }
  return result;
}

Json length_of(const SignedDepth& depth, bool of_distance, const std::optional<unsigned>& digits) {
  if (!depth.status()) return {{"squared", Json()}, {"value", Json()}, {"rounded", Json()}};
  if (const Bounds* const bounds = depth.bounds())
    return enclosed_length(of_distance ? Bounds{-bounds->high, -bounds->low} : *bounds, digits);
  const Surd value = of_distance ? negated(*depth.exact()) : *depth.exact();
  return surd_length(sign(value) > 0 ? value : zero, digits);
}

Json cone_object(const OptimalCone& cone) {
  constexpr std::string_view names[] = {"none", "line", "plane", "all"};
  Json rays = Json::array();
  for (const Vector& ray : cone.rays) rays.push_back(exact(ray));
  const bool has_axis = cone.lineality == Lineality::line || cone.lineality == Lineality::plane;
  return {{"lineality", names[static_cast<std::size_t>(cone.lineality)]}, {"axis", has_axis ? exact(cone.axis) : Json()}, {"rays", rays}};
}

Json witness_object(const RoundedWitness& witness) { return {{"a", point_object(witness.a)}, {"b", point_object(witness.b)}}; }

Json contact_of(const SignedDepth& depth) { return depth.contact() ? contact_object(*depth.contact()) : Json(); }

Json optima_array(const SignedDepth& depth, const std::vector<AlongNormal>& translations) {
  Json result = Json::array();
  if (depth.status() != Status::penetrating) return result;
  const Penetration* const cores = of_cores(depth);
  for (std::size_t i = 0; i < translations.size(); ++i)
    result.push_back({{"direction", exact(translations[i].normal)},
                      {"translation", vector_object(translations[i])},
                      {"contact", cores ? contact_object(cores->optima[i].contact) : contact_of(depth)}});
  return result;
}

/// How A is moved until the interiors are disjoint, unless only bounds are known.
std::optional<AlongNormal> translation_of(const SignedDepth& depth, const std::vector<AlongNormal>& translations) {
  if (depth.status() == Status::touching || depth.status() == Status::disjoint) return AlongNormal{depth.direction(), 0, 0};
  return translations.empty() ? std::nullopt : std::optional(translations.front());
}

/// The fields "translation", "direction" and others are exact; these are the rounded ones.
void add_rounded_places(Json& result, const SignedDepth& depth, const std::optional<AlongNormal>& translation,
                        const std::optional<RoundedWitness>& witness) {
  add_rounded(result, depth.direction(), translation ? std::optional(coordinates(*translation)) : std::nullopt, coordinates_of(witness));
}

Json distance_object(const SignedDepth& depth, const std::vector<AlongNormal>& translations, const std::optional<unsigned>& digits) {
  Json result = length_of(depth, true, digits);
  result["direction"] = exact(depth.direction());
  const std::optional<AlongNormal> translation = translations.empty() ? std::nullopt : std::optional(translations.front());
  result["translation"] = translation ? vector_object(*translation) : Json();
  const std::optional<RoundedWitness> witness = depth.witness();
  result["witness"] = witness ? witness_object(*witness) : Json();
  add_rounded_places(result, depth, translation, witness);
  return result;
}

// ---- text ----

std::string value_text(const SignedDepth& depth, int sign_of_it) {
  if (const Surd* const exactly = depth.exact()) return surd_text(sign_of_it > 0 ? *exactly : negated(*exactly));
  const double low = depth.low_binary64(), high = depth.high_binary64();
  return sign_of_it > 0 ? fmt::format("from {} to {}", low, high) : fmt::format("from {} to {}", -high, -low);
}

std::string cone_text(const OptimalCone& cone, bool exact) {
  std::vector<std::string> parts;
  if (cone.lineality == Lineality::all) parts.emplace_back("every direction");
  if (cone.lineality == Lineality::plane) parts.push_back("the plane orthogonal to " + way_text(cone.axis, exact));
  if (cone.lineality == Lineality::line) parts.push_back("the line of " + way_text(cone.axis, exact));
  for (const Vector& ray : cone.rays) parts.push_back(way_text(ray, exact));
  return fmt::format("the cone of {}", fmt::join(parts, ", "));
}

std::string undecided_text(const SignedDepth& depth) {
  return fmt::format("from {} to {}: deep if positive, apart if negative", depth.low_binary64(), depth.high_binary64());
}

void add_length(std::vector<Row>& rows, const SignedDepth& depth, const Request& request) {
  const std::optional<Status> status = depth.status();
  if (!status) {
    rows.emplace_back("signed depth", undecided_text(depth));
    return;
  }
  const bool apart = status == Status::disjoint;
  rows.emplace_back(quantity(request), apart || status == Status::touching ? "0" : value_text(depth, 1));
  if (apart) rows.emplace_back("distance", value_text(depth, -1));
  if (const Surd* const exactly = depth.exact()) {
    const Surd length = apart ? negated(*exactly) : *exactly;
    if (request.exact) rows.emplace_back("exactly", kernels::exact_surd_text(length));
    if (request.digits) {
      const Enclosure enclosure = enclose(length, *request.digits);
      rows.emplace_back("enclosure", fmt::format("[{}, {}]", enclosure.low, enclosure.high));
    }
  } else if (request.digits) {
    const Bounds& bounds = *depth.bounds();
    const Enclosure enclosure = enclosure_of(apart ? Bounds{-bounds.high, -bounds.low} : bounds, *request.digits);
    rows.emplace_back("enclosure", fmt::format("[{}, {}]", enclosure.low, enclosure.high));
  }
}

void add_places(std::vector<Row>& rows, const SignedDepth& depth, const Request& request) {
  const bool same_body = has_one_body(request);
  const std::vector<AlongNormal> translations = depth.translations();
  const bool apart = depth.status() == Status::disjoint;
  rows.emplace_back("direction", way_text(depth.direction(), request.exact));
  if (!translations.empty() && depth.status() != Status::touching && !same_body)
    rows.emplace_back(apart ? "A to B" : "translation", place_text(translations.front(), request.exact));
  if (depth.contact()) rows.emplace_back("contact", contact_text(*depth.contact(), same_body));
  if (const std::optional<RoundedWitness> witness = depth.witness())
    add_points(rows, apart ? "nearest" : "witness", place_text(witness->a, request.exact), place_text(witness->b, request.exact),
               same_body);
  if (has_continuum(depth)) rows.emplace_back("ties", cone_text(*depth.cone, request.exact));
  if (const Penetration* const cores = of_cores(depth); cores && cores->optima.size() > (same_body ? 2 : 1))
    rows.emplace_back("ties", fmt::format("{} {}; the first is shown, --json lists all", cores->optima.size() / (same_body ? 2 : 1),
                                          same_body ? "pairs of planes" : "nearest facets"));
}

}  // namespace

bool has_continuum(const SignedDepth& depth) {
  return depth.cone && (depth.cone->lineality != Lineality::none || depth.cone->rays.size() > 1);
}

std::string shape_length_text(const SignedDepth& depth) {
  const std::optional<Status> status = depth.status();
  if (!status) return "undecided: signed depth " + undecided_text(depth);
  if (status == Status::touching) return "touching: depth 0";
  return status == Status::disjoint ? "disjoint: distance " + value_text(depth, -1) : "penetrating: depth " + value_text(depth, 1);
}

std::string shape_json(const ShapeAnswer& answer, const Request& request) {
  const SignedDepth& depth = answer.depth;
  const std::vector<AlongNormal> translations = depth.translations();
  const Penetration* const cores = of_cores(depth);
  const Json size = length_of(depth, false, request.digits);
  Json result = result_head(answer.id, status_name(depth));
  result["signed_depth"] = signed_depth_object(depth);
  result["depth"] = size;
  const std::optional<AlongNormal> translation = translation_of(depth, translations);
  result["translation"] = translation ? vector_object(*translation) : Json();
  result["direction"] = exact(depth.direction());
  result["contact"] = contact_of(depth);
  const std::optional<RoundedWitness> witness = depth.status() == Status::disjoint ? std::nullopt : depth.witness();
  result["witness"] = witness ? witness_object(*witness) : Json();
  add_rounded_places(result, depth, translation, witness);
  result["optima"] = optima_array(depth, translations);
  if (request.optima) result["optima_count"] = cores ? cores->optima.size() + cores->unlisted : translations.size();
  if (depth.cone) result["optimal_cone"] = cone_object(*depth.cone);
  if (depth.status() == Status::disjoint) result["distance"] = distance_object(depth, translations, request.digits);
  add_bodies(result, answer.bodies);
  result["flat"] = flat_array(answer.facts);
  result["method"] = method_of(depth);
  if (request.counters) result["counters"] = counters_object(depth.counters());
  if (request.embed_certificate) result["certificate"] = answer.certificate;
  if (has_one_body(request)) result["width"] = size;
  return result.text();
}

std::string shape_block(const ShapeAnswer& answer, const Request& request) {
  std::vector<Row> rows;
  add_length(rows, answer.depth, request);
  add_places(rows, answer.depth, request);
  add_bodies(rows, answer.bodies);
  rows.emplace_back("method", method_of(answer.depth));
  if (const std::string flat = flat_text(answer.facts, has_one_body(request)); !flat.empty()) rows.emplace_back("flat", flat);
  if (request.counters) add_counters(rows, answer.depth.counters());
  return aligned(has_one_body(request) ? "" : std::string(status_name(answer.depth)), rows);
}

std::string shape_line(const ShapeAnswer& answer, const Request& request) {
  std::vector<Row> rows;
  add_length(rows, answer.depth, request);
  rows.emplace_back("direction", way_text(answer.depth.direction(), request.exact));
  if (request.counters) add_counters(rows, answer.depth.counters());
  std::vector<std::string> parts;
  if (!has_one_body(request)) parts.emplace_back(status_name(answer.depth));
  for (const auto& [label, text] : rows) parts.push_back(label + " " + text);
  return case_line(answer.id, parts);
}

}  // namespace fathom::cli
