// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/json_values.hpp"

#include <cmath>

#include "fathom/numbers.hpp"

namespace fathom::cli {
namespace {

/// null unless the number is finite and tells a positive value from 0: the exact fields speak then.
Json nearest_binary64(double value, int sign) {
  if (!std::isfinite(value) || (value == 0 && sign != 0)) return nullptr;
  return value;
}

template <class Round>
Json in_every_direction(Round round) {
  return {{"rn", hex_text(round(Rounding::rn))}, {"rd", hex_text(round(Rounding::rd))}, {"ru", hex_text(round(Rounding::ru))}};
}

}  // namespace

Json exact(const Point& p) { return Json::array({exact_text(p.x), exact_text(p.y), exact_text(p.z)}); }

Json exact(const Vector& v) { return Json::array({v.x.get_str(), v.y.get_str(), v.z.get_str()}); }

Json length(const mpq_class& squared, const std::optional<unsigned>& digits) {
  Json result = {{"squared", exact_text(squared)}, {"value", nearest_binary64(root_binary64(squared, Rounding::rn), sgn(squared))}};
  result["rounded"] = {{"f64", in_every_direction([&](Rounding mode) { return root_binary64(squared, mode); })},
                       {"f32", in_every_direction([&](Rounding mode) { return root_binary32(squared, mode); })}};
  if (digits) {
    const Enclosure enclosure = enclose_root(squared, *digits);
    result["enclosure"] = Json::array({enclosure.low, enclosure.high});
  }
  return result;
}

Json number(const mpq_class& value) {
  Json result = {{"exact", exact_text(value)}, {"value", nearest_binary64(round_binary64(value, Rounding::rn), sgn(value))}};
  result["rounded"] = {{"f64", in_every_direction([&](Rounding mode) { return round_binary64(value, mode); })},
                       {"f32", in_every_direction([&](Rounding mode) { return round_binary32(value, mode); })}};
  return result;
}

Json contact_object(const Contact& contact) { return {{"kind", name(contact.kind)}, {"a", Json(contact.a)}, {"b", Json(contact.b)}}; }

Json witness_object(const Witness& witness) { return {{"a", exact(witness.a)}, {"b", exact(witness.b)}}; }

Json flat_array(const BodyFacts& facts) {
  Json result = Json::array();
  if (facts.flat_a) result.push_back("a");
  if (facts.flat_b) result.push_back("b");
  return result;
}

std::string error_object(std::string_view schema, const std::string& id, std::size_t line, std::string_view error) {
  return Json{{"schema", schema}, {"id", id}, {"line", line}, {"error", error}}.text();
}

}  // namespace fathom::cli
