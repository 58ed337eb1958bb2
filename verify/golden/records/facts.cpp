// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/facts.hpp"

#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/number/rounding.hpp"

namespace fathom::golden {

// ---- numbers ----

namespace {

Rounded in_order(const kernels::Roundings& roundings) {
  const auto& [rn, rd, ru] = roundings.binary64;
  const auto& [rn32, rd32, ru32] = roundings.binary32;
  return {{rn, rd, ru}, {rn32, rd32, ru32}};
}

Rounded signed_root(const mpz_class& component, const mpz_class& norm) {
  if (component == 0) return {};
  Rounded root = rounded_root(kernels::ratio(component * component, norm));
  if (component > 0) return root;
  for (std::array<double, 3>* values : {&root.binary64, &root.binary32}) {
    for (double& value : *values) value = -value;
    std::swap((*values)[1], (*values)[2]);
  }
  return root;
}

}  // namespace

Rounded rounded_value(const mpq_class& value) { return in_order(kernels::roundings(value)); }

Rounded rounded_surd(const Surd& value) {
  if (value.root == 0) return rounded_value(value.rational);
  Rounded result{};
  constexpr std::array modes{Rounding::rn, Rounding::rd, Rounding::ru};
  for (std::size_t i = 0; i < modes.size(); ++i) {
    result.binary64[i] = round_binary64(value, modes[i]);
    result.binary32[i] = double{round_binary32(value, modes[i])};
  }
  return result;
}

Rounded rounded_root(const mpq_class& squared) { return in_order(kernels::roundings_of_root(squared)); }

RoundedVector rounded_unit(const Vector& n) {
  const mpz_class norm = dot(n, n);
  return {signed_root(n.x, norm), signed_root(n.y, norm), signed_root(n.z, norm)};
}

RoundedVector rounded_point(const Point& p) { return {rounded_value(p.x), rounded_value(p.y), rounded_value(p.z)}; }

RoundedVector rounded_along(const AlongNormal& vector) {
  const mpz_class norm = dot(vector.normal, vector.normal);
  const auto component = [&](const mpz_class& n) {
    const mpq_class along = vector.beta * n;
    return rounded_surd({vector.alpha * n, along * abs(along) / norm});
  };
  return {component(vector.normal.x), component(vector.normal.y), component(vector.normal.z)};
}

// ---- truth ----

HullStatement truth_of(const HullPair& hulls, Depth answer, Monitor* monitor, Workspace* workspace) {
  HullStatement truth;
  truth.depth = rounded_root(answer.squared());
  for (const Optimum& optimum : answer.optima()) {
    truth.units.push_back(rounded_unit(optimum.direction));
    truth.translations.push_back(rounded_point(optimum.translation()));
  }
  if (const Penetration* const penetration = answer.penetration())
    truth.gap = second_nearest_squared(hulls.a, hulls.b, *penetration, monitor, workspace);
  else truth.units.push_back(rounded_unit(answer.direction()));
  if (const Distance* const distance = answer.distance()) {
    truth.distance = rounded_root(distance->squared);
    truth.translations.push_back(rounded_point(distance->translation));
  }
  truth.answer = std::move(answer);
  truth.flags = flags_of(hulls, truth);
  return truth;
}

ShapeStatement truth_of(const SignedDepth& answer) {
  return {answer.exact() ? std::variant<Surd, Bounds>(*answer.exact()) : *answer.bounds(), answer.direction(), answer.translations(),
          answer.cone};
}

UnionStatement truth_of(const UnionDepth& answer) {
  UnionStatement truth{answer.status, answer.squared(), {}, std::nullopt};
  if (answer.status == Status::penetrating)
    for (const UnionOptimum& optimum : answer.optima) truth.optima.push_back(optimum.translation);
  if (answer.apart) truth.gap = {answer.apart->distance.squared, answer.apart->a, answer.apart->b, answer.apart->distance.translation};
  return truth;
}

SignedDepth answer_about(const Shape& a, const Shape& b, const Options& options) {
  constexpr unsigned first_bits = 40, most_bits = 80;
  SignedDepthOptions asked;
  asked.cores = options;
  for (asked.bits = first_bits;; asked.bits *= 2) {
    SignedDepth answer = signed_depth(a, b, asked);
    if (answer.status() || asked.bits == most_bits) return answer;
  }
}

UnionDepth answer_about(const Pieces& a, const Pieces& b, Monitor* monitor) {
  UnionOptions options;
  options.monitor = monitor;
  options.bounds = false;
  UnionDepth answer = union_depth(a, b, options);
  if (!answer.complete) throw Interrupted();
  return answer;
}

// ---- records ----

Facts facts_of(const Recipe& recipe, FormedCase made, RecordStatement truth, std::string certificate_sha256) {
  Facts facts{recipe, std::move(made), false, false, std::move(truth), std::move(certificate_sha256)};
  if (auto* const hulls = std::get_if<HullPair>(&facts.made.bodies))
    for (Body* body : {&hulls->a, &hulls->b}) body->points = in_simplest_form(body->points);
  facts.in_binary64 = in_format(facts.made.bodies, Form::binary64);
  facts.in_binary32 = facts.in_binary64 && in_format(facts.made.bodies, Form::binary32);
  return facts;
}

}  // namespace fathom::golden
