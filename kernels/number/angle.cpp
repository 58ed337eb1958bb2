// SPDX-License-Identifier: GPL-3.0-or-later
// By Niven's theorem the sine of a rational number of degrees is rational at odd multiples of 30 and at multiples of 90 alone, hence the
// cosine at multiples of 60 and of 90; of a rational number of radians both are transcendental but at 0 (Lindemann). Elsewhere a value is
// therefore no number of 53 bits, nor between two such in the middle, and enough precision tells to which it is nearest.
#include <mpfr.h>

#include <array>
#include <optional>

#include "kernels/number/irrational.hpp"

namespace fathom::kernels {
namespace {

class Real {
 public:
  explicit Real(mpfr_prec_t precision) { mpfr_init2(value_, precision); }
  ~Real() { mpfr_clear(value_); }
  Real(const Real&) = delete;
  Real& operator=(const Real&) = delete;
  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

using Function = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

constexpr mpfr_prec_t bits = 53;

/// Neighbours of the angle in radians on both sides, unless it is that number.
void set_radians(Real& result, const mpq_class& angle, AngleUnit unit, mpfr_rnd_t mode) {
  if (unit == AngleUnit::radians) {
    mpfr_set_q(result.get(), angle.get_mpq_t(), mode);
    return;
  }
  const mpfr_rnd_t away = sgn(angle) < 0 ? (mode == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD) : mode;  // of pi > 0
  mpfr_const_pi(result.get(), away);
  mpfr_mul_q(result.get(), result.get(), mpq_class(angle / 180).get_mpq_t(), mode);
}

mpq_class rational(mpfr_srcptr value) {
  mpq_class result;
  mpfr_get_q(result.get_mpq_t(), value);
  return result;
}

/// The nearest number of 53 bits, if this precision tells it.
std::optional<mpq_class> rounded(Function function, const mpq_class& angle, AngleUnit unit, mpfr_prec_t precision) {
  Real low(precision), high(precision), width(precision), value(precision);
  set_radians(low, angle, unit, MPFR_RNDD);
  set_radians(high, angle, unit, MPFR_RNDU);
  mpfr_sub(width.get(), high.get(), low.get(), MPFR_RNDU);  // neither function changes faster than its argument
  std::array<mpq_class, 2> ends;
  for (std::size_t i = 0; i < 2; ++i) {
    const mpfr_rnd_t mode = i == 0 ? MPFR_RNDD : MPFR_RNDU;
    function(value.get(), low.get(), mode);
    if (i == 0) mpfr_sub(value.get(), value.get(), width.get(), mode);
    else mpfr_add(value.get(), value.get(), width.get(), mode);
    Real end(bits);
    mpfr_set(end.get(), value.get(), MPFR_RNDN);
    ends[i] = rational(end.get());
  }
  return ends[0] == ends[1] ? std::optional(ends[0]) : std::nullopt;
}

mpq_class nearest(Function function, const mpq_class& angle, AngleUnit unit) {
  for (mpfr_prec_t precision = 128;; precision *= 2)
    if (const std::optional<mpq_class> value = rounded(function, angle, unit, precision)) return *value;
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
