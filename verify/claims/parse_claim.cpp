// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/printable.hpp"
#include "verify/claims/claims.hpp"

namespace fathom::claims {
namespace {

using Json = nlohmann::json;

/// A number as it was written.
struct Written {
  mpq_class value, unit;
};

/// Thrown and caught here: what is wrong with a field of the claim.
struct Fault {
  std::string sentence;
};

// The shortest decimal is what was written, up to trailing zeros.
Written written(const Json& number, const std::string& field) {
  if (!number.is_number()) throw Fault{"claim." + field + ": expected a number, found " + kernels::printable(number.dump(), 40)};
  const std::string text = number.dump();
  Written result{*parse_number(text, Decimals::exact).value, 1};
  const std::size_t exponent_at = text.find('e'), point = text.find('.');
  const std::string mantissa = text.substr(0, exponent_at);
  long places = point == std::string::npos ? 0 : static_cast<long>(mantissa.size() - point - 1);
  if (exponent_at != std::string::npos) places -= std::stol(text.substr(exponent_at + 1));
  const mpz_class power = [&] {
    mpz_class ten;
    mpz_ui_pow_ui(ten.get_mpz_t(), 10, static_cast<unsigned long>(std::labs(places)));
    return ten;
  }();
  result.unit = places >= 0 ? mpq_class(1, power) : mpq_class(power);
  return result;
}

Point axis(int i) { return {i == 0 ? 1 : 0, i == 1 ? 1 : 0, i == 2 ? 1 : 0}; }

// "x", "-x", "+-x" are one line; "axis" is any of the three.
void read_direction(const Json& direction, PublishedClaim& claim) {
  claim.line_text = direction.is_string() ? direction.get<std::string>() : direction.dump();
  if (direction.is_string()) {
    const std::string& text = claim.line_text;
    if (text == "axis") claim.lines = {axis(0), axis(1), axis(2)};
    for (const int i : {0, 1, 2})
      if (!text.empty() && text.back() == "xyz"[i] && text.find_first_not_of("+-") == text.size() - 1) claim.lines = {axis(i)};
  } else if (direction.is_array() && direction.size() == 3) {
    const auto component = [&](std::size_t i) {
      if (!direction[i].is_number()) throw Fault{"claim.direction: expected three numbers, found " + claim.line_text};
      return exact_value(direction[i].get<double>());
    };
    const Point line{component(0), component(1), component(2)};
    if (line != Point{}) claim.lines = {line};
  }
  if (claim.lines.empty()) throw Fault{"claim.direction: expected three numbers, an axis, or 'axis', found " + claim.line_text};
}

void read_statements(const Json& stated, PublishedClaim& claim) {
  if (!stated.is_object()) throw Fault{"claim: expected an object, found " + kernels::printable(stated.dump(), 40)};
  if (stated.contains("status") && stated["status"].is_string()) claim.status = status_named(stated["status"].get<std::string>());
  const auto length = [&](const char* field, std::optional<mpq_class>& value, mpq_class& unit) {
    if (!stated.contains(field)) return;
    Written number = written(stated[field], field);
    value = std::move(number.value);
    unit = std::move(number.unit);
  };
  mpq_class unit;
  length("depth", claim.depth, claim.depth_unit);
  length("distance", claim.distance, claim.distance_unit);
  length("depth_below", claim.below, unit);
  if (stated.contains("tol") && stated["tol"].is_number()) length("tol", claim.tolerance, unit);
  if (stated.contains("direction")) read_direction(stated["direction"], claim);
}

std::string text_of(const Json& object, const char* field) {
  return object.contains(field) && object[field].is_string() ? object[field].get<std::string>() : "";
}

}  // namespace

std::variant<PublishedClaim, InputError> parse_claim(const std::string& text, const std::string& name, std::size_t line) {
  CaseItem item = parse_case(text, name, line);
  if (!item.ok()) return item.error();
  const kernels::DefaultFloatEnvironment environment;
  const Json json = Json::parse(text);  // it is JSON, as it was a case
  PublishedClaim claim;
  claim.bodies = std::get<Case>(std::move(item.outcome));
  claim.source = text_of(json, "source");
  claim.kind = text_of(json, "kind");
  claim.note = text_of(json, "note");
  if (json.contains("numeric") && json["numeric"].is_object()) {
    const Json& found = json["numeric"];
    if (found.contains("signed_penetration") && found["signed_penetration"].is_number())
      claim.numeric = found["signed_penetration"].get<double>();
  }
  if (!json.contains("claim")) return InputError(name, line, "expected a field 'claim', found none");
  try {
    read_statements(json["claim"], claim);
  } catch (const Fault& fault) {
    return InputError(name, line, fault.sentence);
  }
  return claim;
}

}  // namespace fathom::claims
