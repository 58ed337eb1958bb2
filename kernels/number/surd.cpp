// SPDX-License-Identifier: GPL-3.0-or-later
// Rounding by an enclosure that is refined until both of its ends round alike (Ziv's strategy). This ends, since an irrational number never
// lies on the border between two roundings; a rational one is rounded directly.                              [proofs/number.md]
#include <cmath>
#include <optional>
#include <stdexcept>

#include "kernels/float_environment.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/number/rational.hpp"

namespace fathom::kernels {
namespace {

long bit_length(const mpz_class& n) { return static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2)); }

/// value * 2^exponent.
mpq_class shifted(const mpz_class& value, long exponent) {
  mpq_class result(value);
  if (exponent >= 0) mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return result;
}

/// Around sqrt(x), x > 0, to `bits` bits or one more.
RationalInterval enclosed_root(const mpq_class& x, long bits) {
  const long shift = bits - (bit_length(x.get_num()) - bit_length(x.get_den())) / 2;
  mpz_class numerator = x.get_num(), denominator = x.get_den();
  if (shift >= 0) numerator <<= static_cast<mp_bitcnt_t>(2 * shift);
  else denominator <<= static_cast<mp_bitcnt_t>(-2 * shift);
  const mpz_class square = numerator / denominator, root = sqrt(square);
  return {shifted(root, -shift), shifted(mpz_class(root + 1), -shift)};
}

/// Around a value with an irrational root.
RationalInterval enclosed_irrational(const Surd& value, long bits) {
  const RationalInterval root = enclosed_root(abs(value.root), bits);
  if (sgn(value.root) > 0) return {value.rational + root.low, value.rational + root.high};
  return {value.rational - root.high, value.rational - root.low};
}

/// What both ends of an enclosure round to, up to the sign of a zero.
template <class Round>
auto refined(const Surd& value, const Round& round) {
  for (long bits = 128;; bits *= 2) {
    const RationalInterval range = enclosed_irrational(value, bits);
    const auto low = round(range.low);
    if (low == round(range.high)) return low;
  }
}

template <class Round>
auto rounded(const Surd& value, const Round& round) {
  if (const auto number = rational_value(value)) return round(*number);
  const auto result = refined(value, round);
  return result == 0 ? std::copysign(result, sign(value) < 0 ? decltype(result){-1} : decltype(result){1}) : result;
}

}  // namespace

std::optional<mpq_class> rational_root(const mpq_class& x) {
  const mpz_class n = abs(x.get_num());
  if (!mpz_perfect_square_p(n.get_mpz_t()) || !mpz_perfect_square_p(x.get_den_mpz_t())) return std::nullopt;
  const mpq_class root = ratio(sqrt(n), sqrt(x.get_den()));
  return sgn(x) < 0 ? mpq_class(-root) : root;
}

RationalInterval quotient(const RationalInterval& x, const RationalInterval& y) {
  return {x.low / (sgn(x.low) < 0 ? y.low : y.high), x.high / (sgn(x.high) < 0 ? y.high : y.low)};
}

RationalInterval enclosed(const Surd& value, unsigned bits) {
  if (const std::optional<mpq_class> known = rational_value(value)) return {*known, *known};
  return enclosed_irrational(value, bits);
}

std::optional<mpq_class> rational_value(const Surd& value) {
  const std::optional<mpq_class> root = rational_root(value.root);
  return root ? std::optional<mpq_class>(value.rational + *root) : std::nullopt;
}

std::string exact_surd_text(const Surd& value) {
  if (const std::optional<mpq_class> number = rational_value(value)) return exact_text(*number);
  const std::string root = (sgn(value.root) < 0 ? "-sqrt(" : "sqrt(") + exact_text(abs(value.root)) + ")";
  if (value.rational == 0) return root;
  return root + (value.rational < 0 ? " - " : " + ") + exact_text(abs(value.rational));
}

int sign_of_sum(const mpq_class& rational, const mpq_class& x, const mpq_class& y) {
  const int a = sgn(rational), b = sgn(mpq_class(x + y));  // the signed root is increasing and odd
  if (a * b >= 0) return a != 0 ? a : b;
  const int larger = sign({rational * rational - abs(x) - abs(y), -4 * x * y});
  return larger == 0 ? 0 : larger > 0 ? a : b;
}

double nearest_binary64(const Surd& value) { return round_binary64(value) + 0.0; }  // -0 becomes 0

double nearest_root_binary64(const Surd& value) {
  if (sign(value) < 0) throw std::domain_error("the square root of a negative number was asked for");
  const auto round = [](const mpq_class& x) { return sgn(x) > 0 ? root_binary64(x, Rounding::rn) : 0.0; };
  return rounded(value, round) + 0.0;
}

}  // namespace fathom::kernels

namespace fathom {

int sign(const Surd& value) {
  const int a = sgn(value.rational), b = sgn(value.root);
  if (a * b >= 0) return a != 0 ? a : b;
  const int larger = cmp(mpq_class(value.rational * value.rational), abs(value.root));
  return larger == 0 ? 0 : larger > 0 ? a : b;
}

int compare(const Surd& left, const mpq_class& right) { return sign({left.rational - right, left.root}); }

int compare(const Surd& left, const Surd& right) { return kernels::sign_of_sum(left.rational - right.rational, left.root, -right.root); }

double round_binary64(const Surd& value, Rounding mode) {
  const kernels::DefaultFloatEnvironment environment;
  return kernels::rounded(value, [&](const mpq_class& x) { return round_binary64(x, mode); });
}

float round_binary32(const Surd& value, Rounding mode) {
  const kernels::DefaultFloatEnvironment environment;
  return kernels::rounded(value, [&](const mpq_class& x) { return round_binary32(x, mode); });
}

}  // namespace fathom
