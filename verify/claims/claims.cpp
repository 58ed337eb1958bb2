// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/claims/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/messages.hpp"
#include "kernels/number/irrational.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/shapes/core.hpp"
#include "reference/text/json_value.hpp"

namespace fathom::claims {
namespace {

using Json = text::JsonValue;

constexpr std::size_t readable = 40;  // characters of a text that a message shows

std::string shown(const Json& value) { return kernels::printable(value.written().text(), readable); }

std::string text_of(const Json& object, std::string_view field) {
  const Json* const value = object.find(field);
  return value && value->is_string() ? value->text() : "";
}

/// What is wrong with a field of the claim. Thrown and caught in this file.
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

// "x", "-x" and "+-x" name the same line; "axis" allows any of the three.
void read_direction(const Json& direction, PublishedClaim& claim) {
  if (direction.is_string()) {
    const std::string& text = claim.line_text = direction.text();
    if (text == "axis") claim.lines = {axis(0), axis(1), axis(2)};
    for (const int i : {0, 1, 2})
      if (!text.empty() && text.back() == "xyz"[i] && text.find_first_not_of("+-") == text.size() - 1)
        claim.lines = {axis(i)};
  } else if (direction.is_array() && direction.items().size() == 3 &&
             std::ranges::all_of(direction.items(), &Json::is_number)) {
    const Json &x = direction.at(0), &y = direction.at(1), &z = direction.at(2);
    claim.line_text = "[" + x.text() + "," + y.text() + "," + z.text() + "]";
    const Point line{exact_value(x.number()), exact_value(y.number()), exact_value(z.number())};
    if (line != Point{}) claim.lines = {line};
  }
  if (claim.lines.empty()) {
    throw Fault{"claim.direction: expected three numbers, an axis, or 'axis', found " +
                (direction.is_string() ? kernels::printable(direction.text(), readable) : shown(direction))};
  }
}

/// Returns the field if it is a number, else null.
const Json* number_in(const Json& object, std::string_view field) {
  const Json* const value = object.find(field);
  return value && value->is_number() ? value : nullptr;
}

void read_statements(const Json& stated, PublishedClaim& claim) {
  if (!stated.is_object()) throw Fault{"claim: expected an object, found " + shown(stated)};
  claim.status = status_named(text_of(stated, "status"));
  const auto length = [&](const std::string& field) -> std::optional<WrittenNumber> {
    const Json* const value = stated.find(field);
    if (!value) return std::nullopt;
    if (!value->is_number()) throw Fault{"claim." + field + ": expected a number, found " + shown(*value)};
    return written(value->text(), field);
  };
  claim.depth = length("depth");
  claim.distance = length("distance");
  claim.below = length("depth_below");
  if (number_in(stated, "tol")) claim.tolerance = length("tol")->value;
  if (const Json* const direction = stated.find("direction")) read_direction(*direction, claim);
}

constexpr std::size_t digits = 40;  // of the enclosures to compare with; claims have 17 digits at most

/// low <= value <= high.
using Interval = Bounds;

mpq_class rational(const std::string& decimal) { return *parse_number(decimal, Decimals::exact).value; }

Interval interval(const Surd& exact) {
  if (const std::optional<mpq_class> value = kernels::rational_value(exact)) return {*value, *value};
  const Enclosure enclosure = enclose(exact, digits);
  return {rational(enclosure.low), rational(enclosure.high)};
}

Interval interval(const SignedDepth& depth) { return depth.bounds() ? *depth.bounds() : interval(*depth.exact()); }

Interval positive_part(const Interval& x) { return {std::max(x.low, mpq_class(0)), std::max(x.high, mpq_class(0))}; }
Interval operator-(const Interval& x, const Interval& y) { return {x.low - y.high, x.high - y.low}; }
Interval operator+(const Interval& x, const Interval& y) { return {x.low + y.low, x.high + y.high}; }
Interval negated(const Interval& x) { return {-x.high, -x.low}; }
Interval lesser(const Interval& x, const Interval& y) { return {std::min(x.low, y.low), std::min(x.high, y.high)}; }

Finding at_most(const Interval& x, const mpq_class& bound) {
  return x.high <= bound ? Finding::right : x.low > bound ? Finding::wrong : Finding::open;
}

Finding both(Finding x, Finding y) {
  if (x == Finding::wrong || y == Finding::wrong) return Finding::wrong;
  return x == Finding::open || y == Finding::open ? Finding::open : Finding::right;
}

Finding within(const Interval& x, const mpq_class& target, const mpq_class& tolerance) {
  return both(at_most(x, target + tolerance), at_most(negated(x), tolerance - target));
}

// Numbers for sentences, rounded without proof: verdicts do not depend on them.
std::string text(const mpq_class& value) { return fmt::format("{:.6g}", round_binary64(value)); }

std::string text(const Interval& x) {
  const std::string low = text(x.low), high = text(x.high);
  return low == high ? low : fmt::format("between {} and {}", low, high);
}

Statement length(const std::string& what, const Interval& truth, const WrittenNumber& claimed,
                 const std::optional<mpq_class>& tolerance) {
  const Interval excess{truth.low - claimed.value, truth.high - claimed.value};
  std::string said = fmt::format("the {} is {}", what, text(truth));
  if (excess.low > 0) said += fmt::format(", {} more", text(excess));
  if (excess.high < 0) said += fmt::format(", {} less", text(negated(excess)));
  return {fmt::format("{} {}", what, claimed.text), within(truth, claimed.value, tolerance.value_or(claimed.unit / 2)),
          said};
}

/// Returns the separating distance along one sense of u: h(u)/|u| + rho. Each body is measured
/// against a half-space across u.
Interval separating_distance(const Shape& a, const Shape& b, const Point& u) {
  const Point opposite{-u.x, -u.y, -u.z};
  return interval(signed_depth(a, halfspace(u, 0))) + interval(signed_depth(b, halfspace(opposite, 0)));
}

Interval lesser_separating_distance(const Shape& a, const Shape& b, const Point& u) {
  return lesser(separating_distance(a, b, u), separating_distance(a, b, {-u.x, -u.y, -u.z}));
}

bool on_an_axis(const Point& u) { return (u.x == 0) + (u.y == 0) + (u.z == 0) == 2; }

/// Returns how far rounding the components of a unit vector to binary64 may move the separating
/// distance.
mpq_class rounding_slack(const Shape& a, const Shape& b, const std::vector<Point>& lines) {
  if (std::all_of(lines.begin(), lines.end(), on_an_axis)) return 0;
  mpq_class largest = 0;
  for (const Point& axis : {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}})
    for (const Interval& side :
         {separating_distance(a, b, axis), separating_distance(a, b, {-axis.x, -axis.y, -axis.z})})
      largest = std::max({largest, mpq_class(abs(side.low)), mpq_class(abs(side.high))});
  return largest / (mpz_class(1) << 52);
}

Statement direction(const PublishedClaim& claim, const Shape& a, const Shape& b, const Interval& truth) {
  Interval cheapest = lesser_separating_distance(a, b, claim.lines.front());
  for (const Point& line : claim.lines) cheapest = lesser(cheapest, lesser_separating_distance(a, b, line));
  const Interval excess = cheapest - truth;
  const mpq_class allowed = claim.tolerance.value_or(0) + rounding_slack(a, b, claim.lines);
  std::string said = fmt::format("leaving along it costs {}", text(cheapest));
  if (excess.low > 0) said += fmt::format(", {} more than the least", text(excess));
  return {"direction " + claim.line_text, at_most(excess, allowed), said};
}

mpq_class product(const Point& u, const Point& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }

/// Judges a direction out of a half-space: along a line at the angle t to the normal the way is 1 /
/// cos t times the least one.
Statement direction(const PublishedClaim& claim, const HalfSpace& half, const Interval& truth) {
  const mpq_class explained(1, mpz_class(1) << 104);  // sin^2 t, if both unit vectors were rounded: proofs/judge.md
  mpq_class cosine = 0;                               // squared, of the line that is nearest to the normal
  for (const Point& line : claim.lines) {
    const mpq_class along = product(line, half.normal);
    cosine = std::max(cosine, mpq_class(along * along / (product(line, line) * product(half.normal, half.normal))));
  }
  const Interval least = truth.high < 0 ? negated(truth) : truth;
  Statement judged{"direction " + claim.line_text, Finding::right, fmt::format("the way along it is {}", text(least))};
  if (1 - cosine <= explained) return judged;
  if (cosine == 0 || least.low <= 0) return {judged.text, Finding::wrong, "it is not across the plane"};
  const Interval factor = interval(Surd{0, 1 / cosine});
  const Interval excess{least.low * (factor.low - 1), least.high * (factor.high - 1)};
  judged.finding = at_most(excess, claim.tolerance.value_or(0));
  judged.truth = fmt::format("the way along it is {}, {} more than the least", text(least + excess), text(excess));
  return judged;
}

const HalfSpace* half_space(const Shape& a, const Shape& b) {
  const auto* const half = std::get_if<HalfSpace>(&a.core);
  return half ? half : std::get_if<HalfSpace>(&b.core);
}

/// Judges with bounds of the truth that have `bits` bits.
JudgedClaim judge_with(unsigned bits, const PublishedClaim& claim) {
  const Shape a = files::shape_of(claim.bodies.a), b = files::shape_of(claim.bodies.b);
  SignedDepthOptions options;
  options.bits = bits;
  JudgedClaim judged{signed_depth(a, b, options), {}};
  const Interval truth = interval(judged.truth);
  const std::optional<Status> status = judged.truth.status();
  if (claim.status) {
    const Finding finding = !status ? Finding::open : *status == *claim.status ? Finding::right : Finding::wrong;
    const std::string by = truth.low > 0 ? " by " + text(truth) : truth.high < 0 ? " by " + text(negated(truth)) : "";
    judged.statements.push_back(
        {std::string(name(*claim.status)), finding, fmt::format("they are {}{}", name(status), by)});
  }
  if (claim.depth) judged.statements.push_back(length("depth", positive_part(truth), *claim.depth, claim.tolerance));
  if (claim.distance)
    judged.statements.push_back(length("distance", positive_part(negated(truth)), *claim.distance, claim.tolerance));
  if (claim.below)
    judged.statements.push_back({"depth below " + claim.below->text,
                                 truth.high < claim.below->value   ? Finding::right
                                 : truth.low >= claim.below->value ? Finding::wrong
                                                                   : Finding::open,
                                 "the signed depth is " + text(truth)});
  if (const HalfSpace* const half = half_space(a, b); half && !claim.lines.empty())
    judged.statements.push_back(direction(claim, *half, truth));
  else if (!claim.lines.empty()) judged.statements.push_back(direction(claim, a, b, truth));
  return judged;
}

}  // namespace

std::variant<PublishedClaim, InputError> parse_claim(const std::string& text, const std::string& name,
                                                     std::size_t line) {
  CaseItem item = parse_case(text, name, line);
  if (!item.ok()) return item.error();
  const kernels::DefaultFloatEnvironment environment;
  const Json json = text::read_json(text).value;  // it is JSON, as it was a case
  PublishedClaim claim;
  claim.bodies = std::get<Case>(std::move(item.outcome));
  const Body &a = claim.bodies.a, &b = claim.bodies.b;
  if (a.pieces || b.pieces)
    return InputError(
        name, line,
        "expected convex bodies, found a union of pieces: claims are about the signed depth of convex ones");
  if (a.dimension == 2) return InputError(name, line, "expected bodies of space, found bodies of the plane");
  if (shapes::is_halfspace(a) && shapes::is_halfspace(b))
    return InputError(name, line, "expected one half-space at most, found two: they have no depth");
  claim.source = text_of(json, "source");
  claim.kind = text_of(json, "kind");
  claim.note = text_of(json, "note");
  if (const Json* const numeric = json.find("numeric"))
    if (const Json* const found = number_in(*numeric, "signed_penetration")) claim.numeric = found->number();
  const Json* const stated = json.find("claim");
  if (!stated) return InputError(name, line, "expected a field 'claim', found none");
  try {
    read_statements(*stated, claim);
  } catch (const Fault& fault) {
    return InputError(name, line, fault.sentence);
  }
  return claim;
}

std::optional<Finding> JudgedClaim::finding() const {
  if (statements.empty()) return std::nullopt;
  Finding all = Finding::right;
  for (const Statement& statement : statements) all = both(all, statement.finding);
  return all;
}

std::string_view verdict_name(const std::optional<Finding>& finding) {
  if (!finding) return "not-judgeable";
  return *finding == Finding::right ? "right" : *finding == Finding::wrong ? "wrong" : "undecided";
}

JudgedClaim judge_claim(const PublishedClaim& claim) {
  constexpr unsigned usual_bits = 40, more_bits = 100;
  const kernels::DefaultFloatEnvironment environment;
  JudgedClaim judged = judge_with(usual_bits, claim);
  const bool open = std::any_of(judged.statements.begin(), judged.statements.end(),
                                [](const Statement& s) { return s.finding == Finding::open; });
  return open ? judge_with(more_bits, claim) : judged;
}

}  // namespace fathom::claims
