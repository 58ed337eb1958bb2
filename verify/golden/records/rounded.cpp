// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/rounded.hpp"

#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/number/ratio.hpp"

namespace fathom::golden {
namespace {

constexpr std::array modes{Rounding::rn, Rounding::rd, Rounding::ru};

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

Rounded rounded_value(const mpq_class& value) {
  Rounded result{};
  for (std::size_t i = 0; i < modes.size(); ++i) {
    result.binary64[i] = round_binary64(value, modes[i]);
    result.binary32[i] = round_binary32(value, modes[i]);
  }
  return result;
}

Rounded rounded_root(const mpq_class& squared) {
  Rounded result{};
  for (std::size_t i = 0; i < modes.size(); ++i) {
    result.binary64[i] = root_binary64(squared, modes[i]);
    result.binary32[i] = root_binary32(squared, modes[i]);
  }
  return result;
}

RoundedVector rounded_unit(const Vector& n) {
  const mpz_class norm = dot(n, n);
  return {signed_root(n.x, norm), signed_root(n.y, norm), signed_root(n.z, norm)};
}

RoundedVector rounded_point(const Point& p) { return {rounded_value(p.x), rounded_value(p.y), rounded_value(p.z)}; }

}  // namespace fathom::golden
