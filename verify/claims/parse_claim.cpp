// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/messages.hpp"
#include "verify/claims/claims.hpp"

namespace fathom::claims {
namespace {

using Json = nlohmann::json;

constexpr std::size_t readable = 40;  // what a message shows of a text

/// The numbers of the claim with their digits, by their places: "/claim/depth", "/claim/direction/0". The JSON value has them as doubles.
class Tokens : public nlohmann::json_sax<Json> {
 public:
  explicit Tokens(const std::string& text) { Json::sax_parse(text, this); }
  [[nodiscard]] const std::string& at(const std::string& place) const { return tokens_.at(place); }

  bool null() override { return next(); }
  bool boolean(bool) override { return next(); }
  bool string(std::string&) override { return next(); }
  bool binary(binary_t&) override { return next(); }
  bool number_integer(number_integer_t value) override { return keep(std::to_string(value)); }
  bool number_unsigned(number_unsigned_t value) override { return keep(std::to_string(value)); }
  bool number_float(number_float_t, const std::string& text) override { return keep(text); }
  bool start_object(std::size_t) override { return enter(false); }
  bool start_array(std::size_t) override { return enter(true); }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }
  bool key(std::string& name) override {
    levels_.back().key = name;
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override { return false; }

 private:
  struct Level {
    bool is_array;
    std::size_t index;
    std::string key;
  };

  bool keep(std::string token) {
    if (!levels_.empty() && levels_.front().key == "claim") {
      Json::json_pointer place;
      for (const Level& level : levels_) place /= level.is_array ? std::to_string(level.index) : level.key;
      tokens_[place.to_string()] = std::move(token);
    }
    return next();
  }
  bool next() {
    if (!levels_.empty()) ++levels_.back().index;
    return true;
  }
  bool enter(bool is_array) {
    levels_.push_back({is_array, 0, {}});
    return true;
  }
  bool leave() {
    levels_.pop_back();
    return next();
  }

  std::vector<Level> levels_;
  std::map<std::string, std::string> tokens_;
};

/// Thrown and caught here: what is wrong with a field of the claim.
struct Fault {
  std::string sentence;
};

WrittenNumber written(const std::string& token, const std::string& field) {
  ParsedNumber parsed = parse_number(token, Decimals::exact);
  if (!parsed.value) throw Fault{"claim." + field + ": " + parsed.error};
  const std::size_t exponent_at = token.find_first_of("eE"), point = token.find('.');
  const std::size_t mantissa = std::min(exponent_at, token.size());
  long places = point == std::string::npos ? 0 : static_cast<long>(mantissa - point - 1);
  if (exponent_at != std::string::npos) places -= std::stol(token.substr(exponent_at + 1));
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::labs(places)));
  return {token, *std::move(parsed.value), places >= 0 ? mpq_class(1, power) : mpq_class(power)};
}

Point axis(int i) { return {i == 0 ? 1 : 0, i == 1 ? 1 : 0, i == 2 ? 1 : 0}; }

// "x", "-x", "+-x" are one line; "axis" is any of the three.
void read_direction(const Json& direction, const Tokens& tokens, PublishedClaim& claim) {
  if (direction.is_string()) {
    const std::string& text = claim.line_text = direction.get<std::string>();
    if (text == "axis") claim.lines = {axis(0), axis(1), axis(2)};
    for (const int i : {0, 1, 2})
      if (!text.empty() && text.back() == "xyz"[i] && text.find_first_not_of("+-") == text.size() - 1) claim.lines = {axis(i)};
  } else if (direction.is_array() && direction.size() == 3 && std::ranges::all_of(direction, &Json::is_number)) {
    const auto component = [&](std::size_t i) { return exact_value(direction[i].get<double>()); };
    const auto token = [&](int i) { return tokens.at("/claim/direction/" + std::to_string(i)); };
    claim.line_text = "[" + token(0) + "," + token(1) + "," + token(2) + "]";
    if (const Point line{component(0), component(1), component(2)}; line != Point{}) claim.lines = {line};
  }
  if (claim.lines.empty()) {
    const std::string found = direction.is_string() ? direction.get<std::string>() : direction.dump();
    throw Fault{"claim.direction: expected three numbers, an axis, or 'axis', found " + kernels::printable(found, readable)};
  }
}

void read_statements(const Json& stated, const Tokens& tokens, PublishedClaim& claim) {
  if (!stated.is_object()) throw Fault{"claim: expected an object, found " + kernels::printable(stated.dump(), readable)};
  if (stated.contains("status") && stated["status"].is_string()) claim.status = status_named(stated["status"].get<std::string>());
  const auto length = [&](const std::string& field) -> std::optional<WrittenNumber> {
    if (!stated.contains(field)) return std::nullopt;
    if (!stated[field].is_number())
      throw Fault{"claim." + field + ": expected a number, found " + kernels::printable(stated[field].dump(), readable)};
    return written(tokens.at("/claim/" + field), field);
  };
  claim.depth = length("depth");
  claim.distance = length("distance");
  claim.below = length("depth_below");
  if (stated.contains("tol") && stated["tol"].is_number()) claim.tolerance = length("tol")->value;
  if (stated.contains("direction")) read_direction(stated["direction"], tokens, claim);
}

bool is_halfspace(const Body& body) { return body.shape && std::holds_alternative<HalfSpace>(body.shape->core); }

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
  const Body &a = claim.bodies.a, &b = claim.bodies.b;
  if (a.pieces || b.pieces) return InputError(name, line, "expected convex bodies, found a union of pieces");
  if (is_halfspace(a) && is_halfspace(b)) return InputError(name, line, "expected one half-space at most, found two: they have no depth");
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
    read_statements(json["claim"], Tokens(text), claim);
  } catch (const Fault& fault) {
    return InputError(name, line, fault.sentence);
  }
  return claim;
}

}  // namespace fathom::claims
