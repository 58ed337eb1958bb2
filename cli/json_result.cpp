// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/json_result.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/counts.hpp"
#include "kernels/infinitesimal.hpp"
#include "kernels/number/enclosure.hpp"
#include "kernels/number/parse.hpp"
#include "kernels/number/rounding.hpp"

namespace fathom::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* schema = "fathom/result/1";

Json exact(const Point& p) { return Json::array({exact_text(p.x), exact_text(p.y), exact_text(p.z)}); }

Json exact(const Vector& v) { return Json::array({v.x.get_str(), v.y.get_str(), v.z.get_str()}); }

/// null unless the number is finite and tells a positive length from 0: the exact fields speak then.
Json nearest_binary64(const mpq_class& squared) {
  const double value = root_binary64(squared, Rounding::rn);
  if (!std::isfinite(value) || (value == 0 && sgn(squared) != 0)) return nullptr;
  return value;
}

template <class Round>
Json in_every_direction(Round round) {
  return {{"rn", hex_text(round(Rounding::rn))}, {"rd", hex_text(round(Rounding::rd))}, {"ru", hex_text(round(Rounding::ru))}};
}

Json length(const mpq_class& squared, const std::optional<unsigned>& digits) {
  Json result = {{"squared", exact_text(squared)}, {"value", nearest_binary64(squared)}};
  result["rounded"] = {{"f64", in_every_direction([&](Rounding mode) { return root_binary64(squared, mode); })},
                       {"f32", in_every_direction([&](Rounding mode) { return root_binary32(squared, mode); })}};
  if (digits) {
    const Enclosure enclosure = enclose_root(squared, *digits);
    result["enclosure"] = {enclosure.low, enclosure.high};
  }
  return result;
}

Json contact_object(const Contact& contact) { return {{"kind", name(contact.kind)}, {"a", Json(contact.a)}, {"b", Json(contact.b)}}; }

Json optima_array(const Depth& depth) {
  Json result = Json::array();
  for (const Optimum& optimum : depth.optima) {
    result.push_back({{"direction", exact(optimum.direction)},
                      {"translation", exact(optimum.translation)},
                      {"contact", contact_object(optimum.contact)}});
  }
  return result;
}

Json flat_array(const Depth& depth) {
  Json result = Json::array();
  if (depth.flat_a) result.push_back("a");
  if (depth.flat_b) result.push_back("b");
  return result;
}

Json counters_object(const Counters& counters) {
  Json result;
  for_each_count(counters, [&](std::string_view what, std::uint64_t count) { result[std::string(what)] = count; });
  Json& predicates = result["predicates"] = Json::object();
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    const TierCounts& tiers = counters.predicates[i];
    Json decided = Json::object();
    for (const auto& [packed, count] : tiers.decided) decided[Monomial::unpacked(packed).text()] = count;
    predicates[std::string(predicate_names[i])] = {
        {"calls", tiers.calls}, {"exact", tiers.exact}, {"zero", tiers.zero}, {"decided_by", std::move(decided)}};
  }
  return result;
}

/// Ids and file names may hold any bytes; what is not UTF-8 is replaced, never an error.
std::string one_line(const Json& object) { return object.dump(-1, ' ', true, Json::error_handler_t::replace); }

}  // namespace

std::string json_result(const Answer& answer, const Request& request) {
  const Depth& depth = answer.depth;
  Json result = {{"schema", schema}, {"id", answer.id}, {"status", name(depth.status)}};
  result["depth"] = length(depth.squared, request.digits);
  result["translation"] = exact(depth.translation);
  result["direction"] = depth.direction ? exact(*depth.direction) : Json();
  result["contact"] = depth.contact ? contact_object(*depth.contact) : Json();
  result["witness"] = depth.witness ? Json({{"a", exact(depth.witness->a)}, {"b", exact(depth.witness->b)}}) : Json();
  result["optima"] = optima_array(depth);
  result["flat"] = flat_array(depth);
  result["method"] = name(depth.method);
  if (request.counters) result["counters"] = counters_object(depth.counters);
  if (request.embed_certificate) result["certificate"] = answer.certificate;
  if (request.command == Command::width) result["width"] = result["depth"];
  return one_line(result);
}

std::string json_error(const std::string& id, std::size_t line, std::string_view error) {
  return one_line({{"schema", schema}, {"id", id}, {"line", line}, {"error", error}});
}

}  // namespace fathom::cli
