// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/shape_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <vector>

#include "cli/output/answer.hpp"
#include "cli/output/decimal.hpp"
#include "cli/output/json_result.hpp"
#include "cli/output/json_values.hpp"
#include "cli/output/surd_output.hpp"
#include "cli/output/text_result.hpp"
#include "cli/output/text_rows.hpp"

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

// ---- JSON ----

/// What of an enclosed length is certain: nothing but its bounds, unless both round to the same number.
Json enclosed_length(const Bounds& bounds) {
  const mpq_class low = bounds.low > 0 ? bounds.low : mpq_class(0), high = bounds.high > 0 ? bounds.high : mpq_class(0);
  if (low == high) return length(low * low, {});
  const double nearest = round_binary64(low);
  const bool known = nearest == round_binary64(high) && std::isfinite(nearest) && nearest != 0;
  return {{"squared", Json()}, {"value", known ? Json(nearest) : Json()}, {"rounded", Json()}};
}

Json length_of(const SignedDepth& depth, bool of_distance, const std::optional<unsigned>& digits) {
  if (!depth.status()) return {{"squared", Json()}, {"value", Json()}, {"rounded", Json()}};
  if (const Bounds* const bounds = depth.bounds()) return enclosed_length(of_distance ? Bounds{-bounds->high, -bounds->low} : *bounds);
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

Json optima_array(const SignedDepth& depth, const std::vector<AlongNormal>& translations) {
  Json result = Json::array();
  if (depth.status() != Status::penetrating) return result;
  const Penetration* const cores = of_cores(depth);
  for (std::size_t i = 0; i < translations.size(); ++i)
    result.push_back({{"direction", exact(translations[i].normal)},
                      {"translation", vector_object(translations[i])},
                      {"contact", cores ? contact_object(cores->optima[i].contact) : Json()}});
  return result;
}

Json translation_object(const SignedDepth& depth, const std::vector<AlongNormal>& translations) {
  if (depth.status() == Status::touching || depth.status() == Status::disjoint) return exact(Point{});
  return translations.empty() ? Json() : vector_object(translations.front());
}

Json distance_object(const SignedDepth& depth, const std::vector<AlongNormal>& translations, const std::optional<unsigned>& digits) {
  Json result = length_of(depth, true, digits);
  result["direction"] = exact(depth.direction());
  result["translation"] = translations.empty() ? Json() : vector_object(translations.front());
  const std::optional<RoundedWitness> witness = depth.witness();
  result["witness"] = witness ? witness_object(*witness) : Json();
  return result;
}

// ---- text ----

std::string value_text(const SignedDepth& depth, int sign_of_it) {
  if (const Surd* const exactly = depth.exact()) return surd_text(sign_of_it > 0 ? *exactly : negated(*exactly));
  const double low = depth.low_binary64(), high = depth.high_binary64();
  return sign_of_it > 0 ? fmt::format("from {} to {}", low, high) : fmt::format("from {} to {}", -high, -low);
}

bool is_one_ray(const OptimalCone& cone) { return cone.lineality == Lineality::none && cone.rays.size() == 1; }

std::string cone_text(const OptimalCone& cone) {
  std::vector<std::string> parts;
  if (cone.lineality == Lineality::all) parts.emplace_back("every direction");
  if (cone.lineality == Lineality::plane) parts.push_back("the plane orthogonal to " + direction_text(cone.axis));
  if (cone.lineality == Lineality::line) parts.push_back("the line of " + direction_text(cone.axis));
  for (const Vector& ray : cone.rays) parts.push_back(direction_text(ray));
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
  rows.emplace_back("depth", apart || status == Status::touching ? "0" : value_text(depth, 1));
  if (apart) rows.emplace_back("distance", value_text(depth, -1));
  if (const Surd* const exactly = depth.exact()) {
    const Surd length = apart ? negated(*exactly) : *exactly;
    rows.emplace_back("exactly", exact_surd_text(length));
    if (request.digits) {
      const Enclosure enclosure = enclose(length, *request.digits);
      rows.emplace_back("enclosure", fmt::format("[{}, {}]", enclosure.low, enclosure.high));
    }
  }
}

void add_places(std::vector<Row>& rows, const SignedDepth& depth) {
  const std::vector<AlongNormal> translations = depth.translations();
  const bool apart = depth.status() == Status::disjoint;
  rows.emplace_back("direction", direction_text(depth.direction()));
  if (!translations.empty() && depth.status() != Status::touching)
    rows.emplace_back(apart ? "A to B" : "translation", vector_text(translations.front()));
  if (const Penetration* const cores = of_cores(depth)) rows.emplace_back("contact", contact_text(cores->optima.front().contact));
  if (const std::optional<RoundedWitness> witness = depth.witness())
    rows.emplace_back(apart ? "nearest" : "witness",
                      fmt::format("{} of A, {} of B", rounded_point_text(witness->a), rounded_point_text(witness->b)));
  if (depth.cone && !is_one_ray(*depth.cone)) rows.emplace_back("ties", cone_text(*depth.cone));
  if (const Penetration* const cores = of_cores(depth); cores && cores->optima.size() > 1)
    rows.emplace_back("ties", fmt::format("{} nearest facets; the first is shown, --json lists all", cores->optima.size()));
}

}  // namespace

std::string shape_json(const ShapeAnswer& answer, const Request& request) {
  const SignedDepth& depth = answer.depth;
  const std::vector<AlongNormal> translations = depth.translations();
  const Penetration* const cores = of_cores(depth);
  Json result = result_head(request, answer.id, status_name(depth));
  result["signed_depth"] = signed_depth_object(depth);
  result["depth"] = length_of(depth, false, request.digits);
  result["translation"] = translation_object(depth, translations);
  result["direction"] = exact(depth.direction());
  result["contact"] = cores && depth.status() == Status::penetrating ? contact_object(cores->optima.front().contact) : Json();
  const std::optional<RoundedWitness> witness = depth.status() == Status::disjoint ? std::nullopt : depth.witness();
  result["witness"] = witness ? witness_object(*witness) : Json();
  result["optima"] = optima_array(depth, translations);
  if (request.optima) result["optima_count"] = cores ? cores->optima.size() + cores->unlisted : translations.size();
  if (depth.cone) result["optimal_cone"] = cone_object(*depth.cone);
  if (depth.status() == Status::disjoint) result["distance"] = distance_object(depth, translations, request.digits);
  result["flat"] = flat_array(answer.facts);
  result["method"] = method_of(depth);
  if (request.embed_certificate) result["certificate"] = answer.certificate;
  return result.text();
}

std::string shape_block(const ShapeAnswer& answer, const Request& request) {
  std::vector<Row> rows;
  add_length(rows, answer.depth, request);
  add_places(rows, answer.depth);
  rows.emplace_back("method", method_of(answer.depth));
  if (const std::string flat = flat_text(answer.facts); !flat.empty()) rows.emplace_back("flat", flat);
  return aligned(std::string(status_name(answer.depth)), rows);
}

std::string shape_line(const ShapeAnswer& answer, const Request& request) {
  std::vector<Row> rows;
  add_length(rows, answer.depth, request);
  rows.emplace_back("direction", direction_text(answer.depth.direction()));
  std::vector<std::string> parts{std::string(status_name(answer.depth))};
  for (const auto& [label, text] : rows)
    if (label != "exactly" || text.size() <= longest_in_line) parts.push_back(label + " " + text);
  return fmt::format("{}: {}", safe_id(answer.id), fmt::join(parts, "; "));
}

}  // namespace fathom::cli
