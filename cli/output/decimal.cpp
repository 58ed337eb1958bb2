// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/decimal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "fathom/numbers.hpp"
#include "kernels/number/rational.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t longest_triple = 72;  // characters; beyond, nobody reads the digits
constexpr std::size_t few = 9;              // digits of an approximate component
constexpr std::size_t beyond_binary64_digits = 17;

bool speaks(double value) { return std::isfinite(value) && value != 0; }

/// To nine digits, or truncated to as many where binary64 ends.
std::string few_digits(const mpq_class& value) {
  if (sgn(value) == 0) return "0";
  if (const double rounded = round_binary64(value, Rounding::rn); speaks(rounded))
    return fmt::format("{:.{}g}", rounded, few);
  return fmt::format("{}{}", sgn(value) < 0 ? "-" : "", enclose_root(value * value, few).low);
}

/// Component / length, from its exact square.
std::string unit_component(const mpz_class& component, const mpz_class& squared_length) {
  const mpq_class squared = kernels::ratio(component * component, squared_length);
  if (sgn(squared) == 0) return "0";
  const double rounded = root_binary64(squared, Rounding::rn);
  return fmt::format("{}{}", sgn(component) < 0 ? "-" : "",
                     speaks(rounded) ? fmt::format("{:.{}g}", rounded, few) : enclose_root(squared, few).low);
}

std::string triple(std::string_view mark, const std::string& x, const std::string& y, const std::string& z) {
  return fmt::format("{}({}, {}, {})", mark, x, y, z);
}

}  // namespace

std::string root_text(const mpq_class& squared) {
  if (sgn(squared) == 0) return "0";
  if (const double rounded = root_binary64(squared, Rounding::rn); speaks(rounded)) return fmt::format("{}", rounded);
  return enclose_root(squared, beyond_binary64_digits).low;
}

std::string surd_text(const Surd& value) {
  if (sign(value) == 0) return "0";
  if (const double rounded = round_binary64(value); speaks(rounded)) return fmt::format("{}", rounded);
  return enclose(value, beyond_binary64_digits).low;
}

std::string point_text(const Point& p) {
  const std::string exact = triple("", exact_text(p.x), exact_text(p.y), exact_text(p.z));
  if (exact.size() <= longest_triple) return exact;
  return triple("~", few_digits(p.x), few_digits(p.y), few_digits(p.z));
}

std::string direction_text(const Vector& n) {
  const std::string exact = triple("", n.x.get_str(), n.y.get_str(), n.z.get_str());
  if (exact.size() <= longest_triple) return exact;
  const mpz_class squared_length = dot(n, n);
  return triple("~", unit_component(n.x, squared_length), unit_component(n.y, squared_length),
                unit_component(n.z, squared_length));
}

}  // namespace fathom::cli
