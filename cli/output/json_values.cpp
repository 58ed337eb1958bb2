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

template <class Float>
Json in_every_direction(const kernels::EveryMode<Float>& rounded) {
  return {{"rn", Json::plain(hex_text(rounded.rn))}, {"rd", Json::plain(hex_text(rounded.rd))}, {"ru", Json::plain(hex_text(rounded.ru))}};
}

/// The fields of a number that is printed exactly as `key`.
Json rounded_number(std::string_view key, const mpq_class& exactly, const kernels::Roundings& rounded) {
  return {{key, Json::plain(exact_text(exactly))},
          {"value", nearest_binary64(rounded.binary64.rn, sgn(exactly))},
          {"rounded", {{"f64", in_every_direction(rounded.binary64)}, {"f32", in_every_direction(rounded.binary32)}}}};
}

}  // namespace

Json exact(const Point& p) {
  return Json::array({Json::plain(exact_text(p.x)), Json::plain(exact_text(p.y)), Json::plain(exact_text(p.z))});
}

Json exact(const Vector& v) { return Json::array({Json::plain(v.x.get_str()), Json::plain(v.y.get_str()), Json::plain(v.z.get_str())}); }

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
