// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/number/rational.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/word_integer.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

bool in_lowest_terms(const mpq_class& value) {
  const mpz_class &n = value.get_num(), &d = value.get_den();
  if (sgn(d) <= 0) return false;
  if (d == 1) return true;
  if (mpz_scan1(d.get_mpz_t(), 0) == mpz_sizeinbase(d.get_mpz_t(), 2) - 1)
    return mpz_odd_p(n.get_mpz_t()) != 0;  // a power of 2
  return gcd(n, d) == 1;
}

[[noreturn]] static void throw_not_lowest() {
  throw std::invalid_argument(
      "a number is not in lowest terms over a positive denominator: mpq_class::canonicalize makes it so");
}

void require_lowest_terms(const mpq_class& value) {
  if (in_lowest_terms(value)) return;
  if (value.get_den() == 0) throw std::invalid_argument("the denominator of a number is 0");
  throw_not_lowest();
}

bool Divisors::add(const ShortRational& number) {
  auto known = std::ranges::find(products_, number.divisor, &std::pair<std::uint64_t, std::uint64_t>::first);
  if (known == products_.end()) {
    if (products_.size() == most) return false;
    known = products_.insert(known, {number.divisor, 1});
  }
  const auto numerator = static_cast<std::uint64_t>(std::abs(number.mantissa));
  known->second = static_cast<std::uint64_t>(Uint128{known->second} * numerator % known->first);
  return true;
}

bool Divisors::in_lowest_terms() const {
  return std::ranges::all_of(products_, [](const auto& p) { return std::gcd(p.first, p.second) == 1; });
}

void Divisors::require_lowest_terms() const {
  if (!in_lowest_terms()) throw_not_lowest();
}

std::optional<std::uint64_t> Divisors::common(long bits) const {
  std::uint64_t common = 1;
  for (const auto& [divisor, product] : products_) {
    const Uint128 multiple = Uint128{common / std::gcd(common, divisor)} * divisor;
    if (multiple >> bits != 0) return std::nullopt;
    common = static_cast<std::uint64_t>(multiple);
  }
  return common;
}

double nearest_binary32(double value) { return static_cast<double>(static_cast<float>(value)); }

long binary_order(const mpq_class& q) { return bit_length(q.get_num()) - bit_length(q.get_den()); }

// Numbers of the format are m 2^e with |m| < 2^53, e >= -1074 and |m 2^e| < 2^1024.
std::optional<double> in_binary64(const mpq_class& value) {
  const mpz_srcptr n = value.get_num_mpz_t(), d = value.get_den_mpz_t();
  if (mpz_sgn(n) == 0) return 0;
  if (mpz_popcount(d) != 1) return std::nullopt;
  const auto length = static_cast<long>(mpz_sizeinbase(n, 2)), zeros = static_cast<long>(mpz_scan1(n, 0));
  const auto shift = static_cast<long>(mpz_sizeinbase(d, 2)) - 1;
  if (length - zeros > 53 || zeros - shift < -1074 || length - shift > 1024) return std::nullopt;
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, n);
  return std::ldexp(mantissa, static_cast<int>(exponent - shift));
}

// Rounding by cutting: floor(v / 2^e) with at least one bit more than the significand has, and
// whether anything was cut off. These two decide every mode. For a root, floor(sqrt(x)) =
// isqrt(floor(x)) makes the same cut exact.

namespace {

// What is left of |n|, not zero, without its trailing zeros, and their number; nullopt if that has
// more than 63 bits.
std::optional<std::pair<std::uint64_t, long>> odd_part(mpz_srcptr n) {
  const mp_limb_t* limbs = mpz_limbs_read(n);
  const std::size_t size = mpz_size(n);
  std::size_t i = 0;
  while (limbs[i] == 0) ++i;
  const int shift = std::countr_zero(limbs[i]);
  std::uint64_t odd = limbs[i] >> shift;
  if (i + 1 < size) {
    const mp_limb_t above = limbs[i + 1];
    if (i + 2 < size || shift == 0 || above >> shift != 0) return std::nullopt;
    odd |= above << (64 - shift);
  }
  if (odd >> 63 != 0) return std::nullopt;
  return std::pair(odd, static_cast<long>(64 * i) + shift);
}

/// A binary format: its finite numbers are m 2^e with |m| < 2^precision, e >= least_exponent and |m
/// 2^e| < 2^top.
struct Format {
  long precision, least_exponent, top;
};
constexpr Format binary64{53, -1074, 1024};
constexpr Format binary32{24, -149, 128};

/// Stands for a value v >= 0 with bits 2^exponent <= v < (bits + 1) 2^exponent; `rest` tells
/// whether v is not the left end. `bits` has at most two bits more than the precision.
struct Cut {
  std::uint64_t bits;
  long exponent;
  bool rest;
};

/// floor(|q| / 2^exponent). `rest` tells whether q / 2^exponent is not an integer.
mpz_class scaled_floor(const mpq_class& q, long exponent, bool& rest) {
  mpz_class numerator = abs(q.get_num()), denominator = q.get_den(), quotient, remainder;
  if (exponent < 0) numerator <<= static_cast<mp_bitcnt_t>(-exponent);
  if (exponent > 0) denominator <<= static_cast<mp_bitcnt_t>(exponent);
  mpz_tdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
  rest = remainder != 0;
  return quotient;
}

// The same of few words, without a call for memory: scaled_floor is for all that is longer.

constexpr mp_size_t few_limbs = 16;  // numerator, denominator and quotient, scaled

struct ShortFloor {
  std::array<mp_limb_t, few_limbs + 1> limbs;
  mp_size_t size;  // without leading zeros
  bool rest;
};

/// |n| 2^shift, without leading zeros; its size. There is room for it.
mp_size_t scaled_limbs(mpz_srcptr n, long shift, mp_limb_t* to) {
  const mp_size_t size = static_cast<mp_size_t>(mpz_size(n)), words = shift / GMP_NUMB_BITS;
  std::fill_n(to, words, 0);
  if (size == 0) return 0;
  const auto bits = static_cast<unsigned>(shift % GMP_NUMB_BITS);
  if (bits == 0) {
    mpn_copyi(to + words, mpz_limbs_read(n), size);
    return words + size;
  }
  to[words + size] = mpn_lshift(to + words, mpz_limbs_read(n), size, bits);
  return words + size + (to[words + size] != 0 ? 1 : 0);
}

std::optional<ShortFloor> short_floor(const mpq_class& q, long exponent) {
  const auto fits = [](mpz_srcptr n, long shift) {
    return static_cast<mp_size_t>(mpz_size(n)) + shift / GMP_NUMB_BITS < few_limbs;
  };
  const mpz_srcptr n = q.get_num_mpz_t(), d = q.get_den_mpz_t();
  const long up = std::max(-exponent, 0L), down = std::max(exponent, 0L);
  if (!fits(n, up) || !fits(d, down)) return std::nullopt;
  std::array<mp_limb_t, few_limbs> above, below, remainder;
  const mp_size_t size = scaled_limbs(n, up, above.data()), size_below = scaled_limbs(d, down, below.data());
  ShortFloor floor{{}, 0, size > 0};
  if (size < size_below) return floor;
  mpn_tdiv_qr(floor.limbs.data(), remainder.data(), 0, above.data(), size, below.data(), size_below);
  floor.size = size - size_below + 1;
  while (floor.size > 0 && floor.limbs[static_cast<std::size_t>(floor.size - 1)] == 0) --floor.size;
  floor.rest = mpn_zero_p(remainder.data(), size_below) == 0;
  return floor;
}

/// The exponent for a cut of v >= 2^low: precision + 1 bits or more, but nothing finer than half of
/// the format's least number.
long cut_exponent(long low, const Format& format) {
  return std::max(low - format.precision, format.least_exponent - 1);
}

static_assert(sizeof(unsigned long) >= sizeof(Cut::bits), "get_ui() would lose bits");

/// Of |q|.
Cut cut_value(const mpq_class& q, const Format& format) {
  Cut cut{0, cut_exponent(binary_order(q) - 1, format), false};
  if (const std::optional<ShortFloor> floor = short_floor(q, cut.exponent))
    return {floor->size > 0 ? floor->limbs[0] : 0, cut.exponent, floor->rest};
  cut.bits = scaled_floor(q, cut.exponent, cut.rest).get_ui();
  return cut;
}

Cut cut_root(const mpq_class& q, const Format& format) {
  // sqrt(q) > 2^((k-1)/2); the shift halves towards minus infinity.
  Cut cut{0, cut_exponent((binary_order(q) - 1) >> 1, format), false};
  if (const std::optional<ShortFloor> square = short_floor(q, 2 * cut.exponent)) {
    std::array<mp_limb_t, few_limbs> root{}, rest;
    if (square->size == 0) return {0, cut.exponent, square->rest};
    const mp_size_t of_rest = mpn_sqrtrem(root.data(), rest.data(), square->limbs.data(), square->size);
    return {root[0], cut.exponent, square->rest || of_rest != 0};
  }
  bool rest_of_floor = false;
  const mpz_class square = scaled_floor(q, 2 * cut.exponent, rest_of_floor);
  mpz_class root, rest_of_root;
  mpz_sqrtrem(root.get_mpz_t(), rest_of_root.get_mpz_t(), square.get_mpz_t());
  cut.bits = root.get_ui();
  cut.rest = rest_of_floor || rest_of_root != 0;
  return cut;
}

/// The significand that `cut` rounds to, ulps of 2^(exponent of the result); `exponent` receives
/// it. The cut may be one for a finer format.
std::uint64_t rounded_significand(const Cut& cut, const Format& format, Rounding mode, long& exponent) {
  // The half bit, and what lies below it.
  const long dropped =
      std::max(static_cast<long>(std::bit_width(cut.bits)) - format.precision, format.least_exponent - cut.exponent);
  exponent = cut.exponent + dropped;
  if (dropped > std::numeric_limits<std::uint64_t>::digits)
    return mode == Rounding::ru && (cut.bits != 0 || cut.rest) ? 1 : 0;
  const std::uint64_t half_bit = std::uint64_t{1} << (dropped - 1);
  std::uint64_t significand = cut.bits / half_bit / 2;
  const bool half = (cut.bits & half_bit) != 0, below = cut.rest || (cut.bits & (half_bit - 1)) != 0,
             odd = significand % 2 != 0;
  if (mode == Rounding::ru ? half || below : mode == Rounding::rn && half && (below || odd)) ++significand;
  return significand;
}

/// For a cut of a positive value. The double is exact: at most 53 bits, and never finer than the
/// format.
double assemble(const Cut& cut, const Format& format, Rounding mode) {
  long exponent = 0;
  const std::uint64_t significand = rounded_significand(cut, format, mode, exponent);
  if (static_cast<long>(std::bit_width(significand)) + exponent <= format.top)
    return std::ldexp(static_cast<double>(significand), static_cast<int>(exponent));
  if (mode != Rounding::rd) return std::numeric_limits<double>::infinity();
  const std::uint64_t largest = (std::uint64_t{1} << format.precision) - 1;
  return std::ldexp(static_cast<double>(largest), static_cast<int>(format.top - format.precision));
}

double round_value(const mpq_class& value, const Format& format, Rounding mode) {
  const int sign = sgn(value);
  if (sign == 0) return 0.0;
  if (sign < 0) return -assemble(cut_value(value, format), format, mirrored(mode));
  return assemble(cut_value(value, format), format, mode);
}

void require_square(const mpq_class& squared) {
  if (sgn(squared) < 0) throw std::domain_error("the square root of a negative number was asked for");
}

double round_root(const mpq_class& squared, const Format& format, Rounding mode) {
  require_square(squared);
  return sgn(squared) == 0 ? 0.0 : assemble(cut_root(squared, format), format, mode);
}

template <class Float>
EveryMode<Float> every_mode(const Cut& cut, const Format& format) {
  const auto rounded = [&](Rounding mode) { return static_cast<Float>(assemble(cut, format, mode)); };
  return {rounded(Rounding::rn), rounded(Rounding::rd), rounded(Rounding::ru)};
}

Roundings roundings_of(const Cut& cut) { return {every_mode<double>(cut, binary64), every_mode<float>(cut, binary32)}; }

template <class Float>
EveryMode<Float> negative(const EveryMode<Float>& positive) {
  return {-positive.rn, -positive.ru, -positive.rd};
}

}  // namespace

std::optional<ShortRational> short_rational(const mpq_class& value) {
  const mpz_srcptr n = value.get_num_mpz_t(), d = value.get_den_mpz_t();
  if (mpz_sgn(d) <= 0) return std::nullopt;
  if (mpz_sgn(n) == 0) return mpz_cmp_ui(d, 1) == 0 ? std::optional(ShortRational{}) : std::nullopt;
  const auto above = odd_part(n), below = odd_part(d);
  if (!above || !below || (above->second > 0 && below->second > 0)) return std::nullopt;
  const auto mantissa = static_cast<std::int64_t>(above->first);
  return ShortRational{{mpz_sgn(n) < 0 ? -mantissa : mantissa, above->second - below->second}, below->first};
}

Roundings roundings(const mpq_class& value) {
  const DefaultFloatEnvironment environment;
  if (sgn(value) == 0) return {};
  const Roundings positive = roundings_of(cut_value(value, binary64));
  if (sgn(value) > 0) return positive;
  return {negative(positive.binary64), negative(positive.binary32)};
}

Roundings roundings_of_root(const mpq_class& squared) {
  const DefaultFloatEnvironment environment;
  require_square(squared);
  return sgn(squared) == 0 ? Roundings{} : roundings_of(cut_root(squared, binary64));
}

}  // namespace fathom::kernels

namespace fathom {

double round_binary64(const mpq_class& value, Rounding mode) {
  const kernels::DefaultFloatEnvironment environment;
  return kernels::round_value(value, kernels::binary64, mode);
}

float round_binary32(const mpq_class& value, Rounding mode) {
  const kernels::DefaultFloatEnvironment environment;
  return static_cast<float>(kernels::round_value(value, kernels::binary32, mode));
}

double root_binary64(const mpq_class& squared, Rounding mode) {
  const kernels::DefaultFloatEnvironment environment;
  return kernels::round_root(squared, kernels::binary64, mode);
}

float root_binary32(const mpq_class& squared, Rounding mode) {
  const kernels::DefaultFloatEnvironment environment;
  return static_cast<float>(kernels::round_root(squared, kernels::binary32, mode));
}

}  // namespace fathom
