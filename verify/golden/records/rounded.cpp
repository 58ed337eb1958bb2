// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/rounded.hpp"

#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/number/ratio.hpp"
#include "kernels/number/roundings.hpp"

namespace fathom::golden {
namespace {

Rounded in_order(const kernels::Roundings& roundings) {
  const auto& [rn, rd, ru] = roundings.binary64;
  const auto& [rn32, rd32, ru32] = roundings.binary32;
  return {{rn, rd, ru}, {rn32, rd32, ru32}};
}

Rounded mirrored(Rounded rounded) {
  for (std::array<double, 3>* values : {&rounded.binary64, &rounded.binary32}) {
    for (double& value : *values) value = -value;
    std::swap((*values)[1], (*values)[2]);
  }
  return rounded;
}

Rounded signed_root(const mpz_class& component, const mpz_class& norm) {
  if (component == 0) return {};
  const Rounded root = rounded_root(kernels::ratio(component * component, norm));
  return component < 0 ? mirrored(root) : root;
}

}  // namespace

Rounded rounded_value(const mpq_class& value) { return in_order(kernels::roundings(value)); }

Rounded rounded_root(const mpq_class& squared) { return in_order(kernels::roundings_of_root(squared)); }

RoundedVector rounded_unit(const Vector& n) {
  const mpz_class norm = dot(n, n);
  return {signed_root(n.x, norm), signed_root(n.y, norm), signed_root(n.z, norm)};
}

RoundedVector rounded_point(const Point& p) { return {rounded_value(p.x), rounded_value(p.y), rounded_value(p.z)}; }

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

RoundedVector rounded_along(const AlongNormal& vector) {
  const mpz_class norm = dot(vector.normal, vector.normal);
  const auto component = [&](const mpz_class& n) {
    const mpq_class along = vector.beta * n;
    return rounded_surd({vector.alpha * n, along * abs(along) / norm});
  };
  return {component(vector.normal.x), component(vector.normal.y), component(vector.normal.z)};
}

}  // namespace fathom::golden
