// SPDX-License-Identifier: GPL-3.0-or-later
// MPFR, always rounding down, yields the digits of a number just below the root; the exact squares of two neighbouring decimals
// then decide. Nothing returned from here rests on a floating-point result.
#include <mpfr.h>

#include <stdexcept>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/float_environment.hpp"

namespace fathom::kernels {
namespace {

/// digits * 10^exponent.
struct Decimal {
  mpz_class digits;
  long exponent;
};

class Mpfr {
 public:
  explicit Mpfr(mpfr_prec_t precision) { mpfr_init2(value_, precision); }
  ~Mpfr() { mpfr_clear(value_); }
  Mpfr(const Mpfr&) = delete;
  Mpfr& operator=(const Mpfr&) = delete;
  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

/// MPFR's exponent range belongs to the thread and may have been narrowed: the whole range for a while.
class WholeRange {
 public:
  WholeRange() : least_(mpfr_get_emin()), greatest_(mpfr_get_emax()) {
    mpfr_set_emin(mpfr_get_emin_min());
    mpfr_set_emax(mpfr_get_emax_max());
  }
  ~WholeRange() {
    mpfr_set_emin(least_);
    mpfr_set_emax(greatest_);
  }
  WholeRange(const WholeRange&) = delete;
  WholeRange& operator=(const WholeRange&) = delete;

 private:
  mpfr_exp_t least_, greatest_;
};

/// A decimal of exactly `count` digits, at most the root of q > 0 and less than two units below it: see proofs/number.md.
Decimal decimal_below_root(const mpq_class& q, std::size_t count) {
  const WholeRange range;
  Mpfr root(static_cast<mpfr_prec_t>(count * 10 / 3 + 64));  // 10/3 > log2(10), and 64 bits to spare
  mpfr_set_q(root.get(), q.get_mpq_t(), MPFR_RNDD);
  mpfr_sqrt(root.get(), root.get(), MPFR_RNDD);
  mpfr_exp_t point = 0;
  char* const text = mpfr_get_str(nullptr, &point, 10, count, root.get(), MPFR_RNDD);
  if (text == nullptr) throw std::logic_error("MPFR gave no digits");
  Decimal result{mpz_class(text, 10), static_cast<long>(point) - static_cast<long>(count)};
  mpfr_free_str(text);
  return result;
}

mpz_class power_of_ten(std::size_t exponent) {
  mpz_class result;
  mpz_ui_pow_ui(result.get_mpz_t(), 10, exponent);
  return result;
}

/// The next decimal of `count` digits.
Decimal next(Decimal decimal, std::size_t count) {
  ++decimal.digits;
  if (decimal.digits == power_of_ten(count)) {
    decimal.digits = power_of_ten(count - 1);
    ++decimal.exponent;
  }
  return decimal;
}

/// The sign of decimal^2 - q.
int compare_square(const Decimal& decimal, const mpq_class& q) {
  mpz_class left = decimal.digits * decimal.digits * q.get_den(), right = q.get_num();
  const long twice = 2 * decimal.exponent;
  (twice < 0 ? right : left) *= power_of_ten(static_cast<std::size_t>(twice < 0 ? -twice : twice));
  return cmp(left, right);
}

/// In plain notation unless that takes many zeros.
std::string text_of(const Decimal& decimal, bool keep_zeros) {
  std::string digits = decimal.digits.get_str();
  const long leading = static_cast<long>(digits.size()) - 1 + decimal.exponent;  // the value is d.ddd * 10^leading
  if (!keep_zeros) digits.resize(digits.find_last_not_of('0') + 1);
  const long size = static_cast<long>(digits.size());
  if (leading < -6 || leading >= std::max(size, 17L)) {
    if (size > 1) digits.insert(1, 1, '.');
    return digits + "e" + std::to_string(leading);
  }
  if (leading < 0) return "0." + std::string(static_cast<std::size_t>(-leading - 1), '0') + digits;
  if (leading + 1 >= size) return digits + std::string(static_cast<std::size_t>(leading + 1 - size), '0');
  digits.insert(static_cast<std::size_t>(leading + 1), 1, '.');
  return digits;
}

}  // namespace

}  // namespace fathom::kernels

namespace fathom {

Enclosure enclose_root(const mpq_class& squared, std::size_t digits) {
  const kernels::DefaultFloatEnvironment environment;
  if (digits < 1 || digits > most_root_digits) {
    throw std::invalid_argument("the number of digits must lie between 1 and " + std::to_string(most_root_digits));
  }
  if (sgn(squared) < 0) throw std::domain_error("the square root of a negative number was asked for");
  if (sgn(squared) == 0) return {"0", "0"};
  kernels::Decimal low = kernels::decimal_below_root(squared, digits);
  kernels::Decimal high = kernels::next(low, digits);
  if (kernels::compare_square(high, squared) <= 0) {
    low = std::exchange(high, kernels::next(high, digits));
  }
  const int low_sign = kernels::compare_square(low, squared);
  if (low_sign > 0 || kernels::compare_square(high, squared) <= 0) throw std::logic_error("MPFR's root failed its exact check");
  if (low_sign == 0) return {kernels::text_of(low, false), kernels::text_of(low, false)};
  return {kernels::text_of(low, true), kernels::text_of(high, true)};
}

}  // namespace fathom
