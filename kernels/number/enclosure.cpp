// SPDX-License-Identifier: GPL-3.0-or-later
// MPFR, always rounding down, yields the digits of a number just below the value; the exact comparison with two neighbouring decimals
// then decides. Nothing returned from here rests on a floating-point result.
#include <mpfr.h>

#include <algorithm>
#include <optional>
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

/// At most `value`, and as near to it as one likes with enough precision.
void set_below(Mpfr& result, const Surd& value, mpfr_prec_t precision) {
  const mpfr_rnd_t of_root = sgn(value.root) < 0 ? MPFR_RNDU : MPFR_RNDD;
  Mpfr root(precision);
  mpfr_set_q(root.get(), mpq_class(abs(value.root)).get_mpq_t(), of_root);
  mpfr_sqrt(root.get(), root.get(), of_root);
  mpfr_set_q(result.get(), value.rational.get_mpq_t(), MPFR_RNDD);
  if (sgn(value.root) < 0) mpfr_sub(result.get(), result.get(), root.get(), MPFR_RNDD);
  else mpfr_add(result.get(), result.get(), root.get(), MPFR_RNDD);
}

/// A decimal of exactly `count` digits below or at the value > 0; the next one or the one after is above it if the precision suffices:
/// see proofs/number.md.
std::optional<Decimal> decimal_below(const Surd& value, std::size_t count, mpfr_prec_t precision) {
  const WholeRange range;
  Mpfr below(precision);
  set_below(below, value, precision);
  if (mpfr_sgn(below.get()) <= 0) return std::nullopt;
  mpfr_exp_t point = 0;
  char* const text = mpfr_get_str(nullptr, &point, 10, count, below.get(), MPFR_RNDD);
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

/// The sign of value - decimal. In integers, over the common denominator of the decimal and the rational part.
int compare(const Surd& value, const Decimal& decimal) {
  const mpz_class power = power_of_ten(static_cast<std::size_t>(decimal.exponent < 0 ? -decimal.exponent : decimal.exponent));
  mpz_class unit = value.rational.get_den(), rational = value.rational.get_num(), digits = decimal.digits * unit;
  if (decimal.exponent < 0) (unit *= power, rational *= power);
  else digits *= power;
  rational -= digits;
  const int a = sgn(rational), b = sgn(value.root);
  if (a * b >= 0) return a != 0 ? a : b;
  const int larger = cmp(mpz_class(rational * rational * value.root.get_den()), mpz_class(abs(value.root.get_num()) * unit * unit));
  return larger == 0 ? 0 : larger > 0 ? a : b;
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

struct Neighbours {
  Decimal low, high;  // low <= value < high
};

/// Around a value > 0, proved; nullopt if the precision did not suffice.
std::optional<Neighbours> neighbours(const Surd& value, std::size_t digits, mpfr_prec_t precision) {
  std::optional<Decimal> low = decimal_below(value, digits, precision);
  if (!low) return std::nullopt;
  Decimal high = next(*low, digits);
  if (compare(value, high) >= 0) low = std::exchange(high, next(high, digits));
  if (compare(value, *low) < 0) throw std::logic_error("MPFR's digits failed their exact check");
  if (compare(value, high) >= 0) return std::nullopt;
  return Neighbours{std::move(*low), std::move(high)};
}

/// For a value > 0.
Enclosure enclosed(const Surd& value, std::size_t digits) {
  const auto bits = static_cast<mpfr_prec_t>(digits * 10 / 3 + 64);  // 10/3 > log2(10), and 64 bits to spare
  // Where the two parts nearly cancel it takes more.
  for (mpfr_prec_t precision = bits;; precision *= 2) {
    const std::optional<Neighbours> found = neighbours(value, digits, precision);
    if (!found) continue;
    const bool exact = compare(value, found->low) == 0;
    return {text_of(found->low, !exact), text_of(exact ? found->low : found->high, !exact)};
  }
}

}  // namespace

}  // namespace fathom::kernels

namespace fathom {

Enclosure enclose(const Surd& value, std::size_t digits) {
  const kernels::DefaultFloatEnvironment environment;
  if (digits < 1 || digits > most_root_digits) {
    throw std::invalid_argument("the number of digits must lie between 1 and " + std::to_string(most_root_digits));
  }
  const int sign_of_value = sign(value);
  if (sign_of_value == 0) return {"0", "0"};
  if (sign_of_value > 0) return kernels::enclosed(value, digits);
  const Enclosure mirrored = kernels::enclosed({-value.rational, -value.root}, digits);
  return {"-" + mirrored.high, "-" + mirrored.low};
}

Enclosure enclose_root(const mpq_class& squared, std::size_t digits) {
  const kernels::DefaultFloatEnvironment environment;
  if (sgn(squared) < 0) throw std::domain_error("the square root of a negative number was asked for");
  return enclose({0, squared}, digits);
}

}  // namespace fathom
