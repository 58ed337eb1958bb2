// SPDX-License-Identifier: GPL-3.0-or-later
// Surds, cosines and sines: each is enclosed, and the enclosure refined until both of its ends
// round alike (Ziv's strategy). This ends,
// since an irrational number never lies on the border between two roundings; a rational one is
// rounded directly.  [proofs/number.md]
#include "kernels/number/irrational.hpp"

#include <mpfr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"

namespace fathom::kernels {
namespace {

// Surds.

/// Around sqrt(x), x > 0, to `bits` bits or one more.
RationalInterval enclosed_root(const mpq_class& x, long bits) {
  const long shift = bits - binary_order(x) / 2;
  mpz_class numerator = x.get_num(), denominator = x.get_den();
  if (shift >= 0) numerator <<= static_cast<mp_bitcnt_t>(2 * shift);
  else denominator <<= static_cast<mp_bitcnt_t>(-2 * shift);
  const mpz_class square = numerator / denominator, root = sqrt(square);
  return {times_power_of_two(mpq_class(root), -shift), times_power_of_two(mpq_class(root + 1), -shift)};
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

/// Of a root alone: one integer root in the place of an enclosure. `round` takes its square.
template <class Float>
Float round_signed_root(const mpq_class& root, Rounding mode, Float (*round)(const mpq_class&, Rounding)) {
  if (sgn(root) == 0) return 0;
  return sgn(root) > 0 ? round(root, mode) : -round(mpq_class(-root), mirrored(mode));
}

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

/// MPFR's exponent range belongs to the thread and may have been narrowed: the whole range for a
/// while.
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

// Decimals around a surd. MPFR, always rounding down, yields the digits of a number just below the
// value; the exact comparison with two neighbouring decimals then decides. Nothing returned from
// here rests on a floating-point result.

/// digits * 10^exponent, of a given number of digits.
struct CountedDecimal {
  mpz_class digits;
  long exponent;
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

/// A decimal of exactly `count` digits below or at the value > 0; the next one or the one after is
/// above it if the precision suffices: see proofs/number.md.
std::optional<CountedDecimal> decimal_below(const Surd& value, std::size_t count, mpfr_prec_t precision) {
  const WholeRange range;
  Mpfr below(precision);
  set_below(below, value, precision);
  if (mpfr_sgn(below.get()) <= 0) return std::nullopt;
  mpfr_exp_t point = 0;
  char* const text = mpfr_get_str(nullptr, &point, 10, count, below.get(), MPFR_RNDD);
  if (text == nullptr) throw std::logic_error("MPFR gave no digits");
  CountedDecimal result{mpz_class(text, 10), static_cast<long>(point) - static_cast<long>(count)};
  mpfr_free_str(text);
  return result;
}

mpz_class power_of_ten(std::size_t exponent) {
  mpz_class result;
  mpz_ui_pow_ui(result.get_mpz_t(), 10, exponent);
  return result;
}

/// The next decimal of `count` digits.
CountedDecimal next(CountedDecimal decimal, std::size_t count) {
  ++decimal.digits;
  if (decimal.digits == power_of_ten(count)) {
    decimal.digits = power_of_ten(count - 1);
    ++decimal.exponent;
  }
  return decimal;
}

/// The sign of value - decimal. In integers, over the common denominator of the decimal and the
/// rational part.
int compare(const Surd& value, const CountedDecimal& decimal) {
  const mpz_class power =
      power_of_ten(static_cast<std::size_t>(decimal.exponent < 0 ? -decimal.exponent : decimal.exponent));
  mpz_class unit = value.rational.get_den(), rational = value.rational.get_num(), digits = decimal.digits * unit;
  if (decimal.exponent < 0) (unit *= power, rational *= power);
  else digits *= power;
  rational -= digits;
  const int a = sgn(rational), b = sgn(value.root);
  if (a * b >= 0) return a != 0 ? a : b;
  const int larger =
      cmp(mpz_class(rational * rational * value.root.get_den()), mpz_class(abs(value.root.get_num()) * unit * unit));
  return larger == 0 ? 0 : larger > 0 ? a : b;
}

/// In plain notation unless that takes many zeros.
std::string text_of(const CountedDecimal& decimal, bool keep_zeros) {
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
  CountedDecimal low, high;  // low <= value < high
};

/// Around a value > 0, proved; nullopt if the precision did not suffice.
std::optional<Neighbours> neighbours(const Surd& value, std::size_t digits, mpfr_prec_t precision) {
  std::optional<CountedDecimal> low = decimal_below(value, digits, precision);
  if (!low) return std::nullopt;
  CountedDecimal high = next(*low, digits);
  if (compare(value, high) >= 0) low = std::exchange(high, next(high, digits));
  if (compare(value, *low) < 0) throw std::logic_error("MPFR's digits failed their exact check");
  if (compare(value, high) >= 0) return std::nullopt;
  return Neighbours{std::move(*low), std::move(high)};
}

/// For a value > 0.
Enclosure decimals_around(const Surd& value, std::size_t digits) {
  const auto bits = static_cast<mpfr_prec_t>(digits * 10 / 3 + 64);  // 10/3 > log2(10), and 64 bits to spare
  // Where the two parts nearly cancel it takes more.
  for (mpfr_prec_t precision = bits;; precision *= 2) {
    const std::optional<Neighbours> found = neighbours(value, digits, precision);
    if (!found) continue;
    const bool exact = compare(value, found->low) == 0;
    return {text_of(found->low, !exact), text_of(exact ? found->low : found->high, !exact)};
  }
}

// By Niven's theorem the sine of a rational number of degrees is rational at odd multiples of 30
// and at multiples of 90 alone, hence the cosine at multiples of 60 and of 90; of a rational number
// of radians both are transcendental but at 0 (Lindemann). Elsewhere a value is therefore no number
// of 53 bits, nor between two such in the middle, and enough precision tells to which it is
// nearest.

using Function = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

constexpr mpfr_prec_t binary64_precision = 53;

/// Neighbours of the angle in radians on both sides, unless it is that number.
void set_radians(Mpfr& result, const mpq_class& angle, AngleUnit unit, mpfr_rnd_t mode) {
  if (unit == AngleUnit::radians) {
    mpfr_set_q(result.get(), angle.get_mpq_t(), mode);
    return;
  }
  const mpfr_rnd_t away = sgn(angle) < 0 ? (mode == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD) : mode;  // of pi > 0
  mpfr_const_pi(result.get(), away);
  mpfr_mul_q(result.get(), result.get(), mpq_class(angle / 180).get_mpq_t(), mode);
}

/// The nearest number of 53 bits, if this precision tells it.
std::optional<mpq_class> rounded_at(Function function, const mpq_class& angle, AngleUnit unit, mpfr_prec_t precision) {
  Mpfr low(precision), high(precision), width(precision), value(precision);
  set_radians(low, angle, unit, MPFR_RNDD);
  set_radians(high, angle, unit, MPFR_RNDU);
  mpfr_sub(width.get(), high.get(), low.get(), MPFR_RNDU);  // neither function changes faster than its argument
  std::array<mpq_class, 2> ends;
  for (std::size_t i = 0; i < 2; ++i) {
    const mpfr_rnd_t mode = i == 0 ? MPFR_RNDD : MPFR_RNDU;
    function(value.get(), low.get(), mode);
    if (i == 0) mpfr_sub(value.get(), value.get(), width.get(), mode);
    else mpfr_add(value.get(), value.get(), width.get(), mode);
    Mpfr end(binary64_precision);
    mpfr_set(end.get(), value.get(), MPFR_RNDN);
    mpfr_get_q(ends[i].get_mpq_t(), end.get());
  }
  return ends[0] == ends[1] ? std::optional(ends[0]) : std::nullopt;
}

mpq_class nearest(Function function, const mpq_class& angle, AngleUnit unit) {
  for (mpfr_prec_t precision = 128;; precision *= 2)
    if (const std::optional<mpq_class> value = rounded_at(function, angle, unit, precision)) return *value;
}

/// The angle but for whole turns.
mpq_class within_a_turn(const mpq_class& degrees) {
  mpz_class turns;
  mpz_fdiv_q(turns.get_mpz_t(), degrees.get_num_mpz_t(), mpz_class(degrees.get_den() * 360).get_mpz_t());
  return degrees - turns * 360;
}

/// The sine of 30 degrees times `count`, if it is rational.
std::optional<mpq_class> rational_sine(unsigned long count) {
  constexpr std::array<int, 12> halves = {0, 1, 3, 2, 3, 1, 0, -1, 3, -2, 3, -1};  // 3: irrational
  const int value = halves[count % 12];
  return value == 3 ? std::nullopt : std::optional(mpq_class(value) / 2);
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

CosineAndSine cosine_and_sine(const mpq_class& angle, AngleUnit unit) {
  if (unit == AngleUnit::radians) {
    if (angle == 0) return {1, 0};
    return {nearest(mpfr_cos, angle, unit), nearest(mpfr_sin, angle, unit)};
  }
  const mpq_class degrees = within_a_turn(angle), thirties = degrees / 30;
  std::optional<mpq_class> cosine, sine;
  if (thirties.get_den() == 1) {
    const unsigned long count = thirties.get_num().get_ui();
    cosine = rational_sine(count + 3);
    sine = rational_sine(count);
  }
  return {cosine ? *cosine : nearest(mpfr_cos, degrees, unit), sine ? *sine : nearest(mpfr_sin, degrees, unit)};
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

int compare(const Surd& left, const Surd& right) {
  return kernels::sign_of_sum(left.rational - right.rational, left.root, -right.root);
}

double round_binary64(const Surd& value, Rounding mode) {
  if (sgn(value.rational) == 0) return kernels::round_signed_root<double>(value.root, mode, root_binary64);
  const kernels::DefaultFloatEnvironment environment;
  return kernels::rounded(value, [&](const mpq_class& x) { return round_binary64(x, mode); });
}

float round_binary32(const Surd& value, Rounding mode) {
  if (sgn(value.rational) == 0) return kernels::round_signed_root<float>(value.root, mode, root_binary32);
  const kernels::DefaultFloatEnvironment environment;
  return kernels::rounded(value, [&](const mpq_class& x) { return round_binary32(x, mode); });
}

Enclosure enclose(const Surd& value, std::size_t digits) {
  const kernels::DefaultFloatEnvironment environment;
  if (digits < 1 || digits > most_root_digits) {
    throw std::invalid_argument("the number of digits must lie between 1 and " + std::to_string(most_root_digits));
  }
  const int sign_of_value = sign(value);
  if (sign_of_value == 0) return {"0", "0"};
  if (sign_of_value > 0) return kernels::decimals_around(value, digits);
  const Enclosure mirrored = kernels::decimals_around({-value.rational, -value.root}, digits);
  return {"-" + mirrored.high, "-" + mirrored.low};
}

Enclosure enclose_root(const mpq_class& squared, std::size_t digits) {
  const kernels::DefaultFloatEnvironment environment;
  if (sgn(squared) < 0) throw std::domain_error("the square root of a negative number was asked for");
  return enclose({0, squared}, digits);
}

}  // namespace fathom
