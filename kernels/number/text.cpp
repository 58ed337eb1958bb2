// SPDX-License-Identifier: GPL-3.0-or-later
// Reading: one scan serves decimals and hex floats: digits, point, digits, exponent. GMP sees
// nothing but checked digits. Writing: an integer becomes chunks of 19 digits, which are less than
// a word, and these become text.
#include "kernels/number/text.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cfenv>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/messages.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/number/word_integer.hpp"

namespace fathom::kernels {

// GMP takes and yields longs. Exponents up to 10^15 are longs here, and 64-bit numbers go into GMP
// as longs in other rooms.
static_assert(std::numeric_limits<long>::digits >= 63,
              "fathom needs a long of 64 bits; verify/check alone does without");

namespace {

bool is_hex_digit(char c) { return is_decimal_digit(c) || (lower(c) >= 'a' && lower(c) <= 'f'); }
bool is_sign(char c) { return c == '+' || c == '-'; }

ParsedNumber refused(std::string reason) { return {std::nullopt, std::move(reason)}; }

/// Removes and returns the longest prefix of `rest` that consists of digits.
std::string_view take_digits(std::string_view& rest, bool (*is_digit)(char)) {
  const auto length = static_cast<std::size_t>(std::ranges::find_if_not(rest, is_digit) - rest.begin());
  const std::string_view digits = rest.substr(0, length);
  rest.remove_prefix(length);
  return digits;
}

mpz_class whole_number(std::string_view digits, int base) { return mpz_class(std::string(digits), base); }

/// digits[.digits][e|p exponent]: stands for digits * base^-places * (10 or 2)^exponent.
struct Scan {
  std::string digits;  ///< of both sides of the point
  long places = 0;     ///< digits after the point
  bool has_point = false, has_exponent = false;
  long exponent = 0;  ///< saturated far beyond every limit
  std::string fault;  ///< empty unless the token is malformed
};

/// The exponent with these digits, saturated at 10^15: no token is so long that its places could
/// make up for that.
long saturated_exponent(bool negative, std::string_view digits) {
  constexpr long bound = 1'000'000'000'000'000;
  long value = 0;
  for (const char c : digits) value = std::min(bound, value * 10 + (c - '0'));
  return negative ? -value : value;
}

Scan malformed(std::string fault) {
  Scan result;
  result.fault = std::move(fault);
  return result;
}

Scan scan(std::string_view rest, bool (*is_digit)(char), char exponent_letter) {
  Scan result;
  result.digits = take_digits(rest, is_digit);
  if (!rest.empty() && rest.front() == '.') {
    result.has_point = true;
    rest.remove_prefix(1);
    const std::string_view fraction = take_digits(rest, is_digit);
    result.digits += fraction;
    result.places = static_cast<long>(fraction.size());
  }
  if (!result.digits.empty() && !rest.empty() && lower(rest.front()) == exponent_letter) {
    result.has_exponent = true;
    const std::string letter(rest.substr(0, 1));
    rest.remove_prefix(1);
    const bool negative = !rest.empty() && rest.front() == '-';
    if (!rest.empty() && is_sign(rest.front())) rest.remove_prefix(1);
    const std::string_view digits = take_digits(rest, is_decimal_digit);
    if (digits.empty()) return malformed("no digits in the exponent after '" + letter + "'");
    result.exponent = saturated_exponent(negative, digits);
  }
  if (!rest.empty()) return malformed("unexpected " + shown(rest.substr(0, 1)));
  if (result.digits.empty()) return malformed("no digits");
  return result;
}

mpz_class power(unsigned long base, long exponent) {
  mpz_class result;
  mpz_ui_pow_ui(result.get_mpz_t(), base, static_cast<unsigned long>(exponent));
  return result;
}

/// digits * 10^exponent, not in lowest terms. No digits: zero.
struct Decimal {
  std::string digits;  ///< neither the first nor the last is '0'
  long exponent;

  explicit Decimal(Scan scanned) : digits(std::move(scanned.digits)), exponent(scanned.exponent - scanned.places) {
    const std::size_t last = digits.find_last_not_of('0');
    const std::size_t kept = last == std::string::npos ? 0 : last + 1;
    exponent += static_cast<long>(digits.size() - kept);
    digits.resize(kept);
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
  }
  [[nodiscard]] mpq_class fraction() const {
    const mpz_class significand = digits.empty() ? mpz_class(0) : whole_number(digits, 10);
    if (exponent >= 0) return mpq_class(significand * power(10, exponent));
    return {significand, power(10, -exponent)};
  }
  /// The value lies in [10^(k-1), 10^k).
  [[nodiscard]] long magnitude() const { return static_cast<long>(digits.size()) + exponent; }
};

ParsedNumber exact_decimal(Scan scanned) {
  if (std::abs(scanned.exponent) > largest_decimal_exponent) {
    return refused("the decimal exponent is beyond " + std::to_string(largest_decimal_exponent));
  }
  mpq_class value = Decimal(std::move(scanned)).fraction();
  value.canonicalize();
  return {std::move(value), {}};
}

ParsedNumber binary64_decimal(Scan scanned) {
  const Decimal decimal(std::move(scanned));
  // Far outside the range of binary64 the answer is known without the power of ten, which may be
  // huge.
  if (decimal.digits.empty() || decimal.magnitude() < -330) return {mpq_class(0), {}};
  const double rounded = decimal.magnitude() > 310 ? HUGE_VAL : round_binary64(decimal.fraction(), Rounding::rn);
  if (std::isinf(rounded)) return refused("beyond binary64");
  return {exact_value(rounded), {}};
}

ParsedNumber parse_decimal(std::string_view text, Decimals decimals) {
  Scan scanned = scan(text, is_decimal_digit, 'e');
  if (!scanned.fault.empty()) return refused(std::move(scanned.fault));
  if (!scanned.has_point && !scanned.has_exponent) return {mpq_class(whole_number(scanned.digits, 10)), {}};
  return decimals == Decimals::exact ? exact_decimal(std::move(scanned)) : binary64_decimal(std::move(scanned));
}

ParsedNumber parse_hex(std::string_view text) {
  const Scan scanned = scan(text, is_hex_digit, 'p');
  if (!scanned.fault.empty()) return refused(scanned.fault == "no digits" ? "no digits after '0x'" : scanned.fault);
  if (std::abs(scanned.exponent) > largest_binary_exponent) {
    return refused("the binary exponent is beyond " + std::to_string(largest_binary_exponent));
  }
  mpq_class value(whole_number(scanned.digits, 16));
  const long shift = scanned.exponent - 4 * scanned.places;
  if (shift >= 0) {
    value <<= static_cast<mp_bitcnt_t>(shift);
  } else {
    value >>= static_cast<mp_bitcnt_t>(-shift);  // exact on rationals, and in lowest terms
  }
  return {std::move(value), {}};
}

ParsedNumber parse_ratio(std::string_view numerator, std::string_view denominator) {
  const auto all_digits = [](std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, is_decimal_digit);
  };
  if (!all_digits(numerator)) return refused("expected digits only before '/'");
  if (!all_digits(denominator)) return refused("expected digits only after '/'");
  mpq_class value(whole_number(numerator, 10), whole_number(denominator, 10));
  if (value.get_den() == 0) return refused("the denominator is zero");
  value.canonicalize();
  return {std::move(value), {}};
}

bool starts_with_name(std::string_view text, std::string_view name) {
  return text.size() >= name.size() && std::ranges::equal(text.substr(0, name.size()), name, {}, lower);
}

ParsedNumber parse_unsigned(std::string_view text, Decimals decimals) {
  if (text.empty()) return refused("no digits");
  if (is_sign(text.front())) return refused("more than one sign");
  if (starts_with_name(text, "inf") || starts_with_name(text, "nan")) return refused("not finite");
  if (starts_with_name(text, "0x")) return parse_hex(text.substr(2));
  const std::size_t slash = text.find('/');
  if (slash != std::string_view::npos) return parse_ratio(text.substr(0, slash), text.substr(slash + 1));
  return parse_decimal(text, decimals);
}

}  // namespace

// std::from_chars rounds correctly, but some of its shortcuts follow the rounding mode that an
// interval filter may have set. Falls back to parse_number for inf, nan, integers over 53 bits and
// underflow.
std::optional<double> quick_number(std::string_view token, Decimals decimals) {
  constexpr long exact_up_to = 1L << 53;
  constexpr std::size_t short_enough = 64;
  if (token.size() > short_enough) return std::nullopt;
  const char* const end = token.data() + token.size();
  long integer = 0;
  const auto [stop, fault] = std::from_chars(token.data(), end, integer);
  if (fault == std::errc() && stop == end) {
    const bool is_double = -exact_up_to <= integer && integer <= exact_up_to;
    return is_double ? std::optional(static_cast<double>(integer)) : std::nullopt;
  }
  if (decimals != Decimals::binary64 || token.find_first_of(".eE") == std::string_view::npos) return std::nullopt;
  double nearest = 0;
  const auto [double_stop, double_fault] = std::from_chars(token.data(), end, nearest);
  if (double_fault != std::errc() || double_stop != end || !std::isfinite(nearest) || std::fegetround() != FE_TONEAREST)
    return std::nullopt;
  return nearest;
}

double nearest_binary64(std::string_view decimal) {
  double nearest = 0;
  if (std::from_chars(decimal.data(), decimal.data() + decimal.size(), nearest).ec == std::errc()) return nearest;
  const bool is_negative = decimal.starts_with('-');
  const bool is_large = Decimal(scan(decimal.substr(is_negative ? 1 : 0), is_decimal_digit, 'e')).magnitude() > 0;
  return !is_large ? 0 : is_negative ? -HUGE_VAL : HUGE_VAL;
}

// ---- words divided ----
namespace {

constexpr std::uint64_t low_word(Uint128 n) { return static_cast<std::uint64_t>(n); }
constexpr std::uint64_t high_word(Uint128 n) { return static_cast<std::uint64_t>(n >> 64); }

struct Divided {
  std::uint64_t quotient, rest;
};

/// A word of at least 2^63, and floor((2^128 - 1) / it) - 2^64, by which a multiplication divides.
///                     [Moeller, Granlund, Improved division by invariant integers, algorithm 4]
class Divisor {
 public:
  explicit constexpr Divisor(std::uint64_t word) : word_(word), reciprocal_(low_word(~Uint128{0} / word)) {}

  /// n / word, which is less than 2^64.
  [[nodiscard]] constexpr Divided divided(Uint128 n) const {
    const Uint128 guess = Uint128{reciprocal_} * high_word(n) + n;
    std::uint64_t quotient = high_word(guess) + 1, rest = low_word(n) - quotient * word_;
    const std::uint64_t over = rest > low_word(guess) ? ~std::uint64_t{0} : 0;  // no branch: it could not be guessed
    quotient += over, rest += over & word_;
    if (rest >= word_) ++quotient, rest -= word_;
    return {quotient, rest};
  }

 private:
  std::uint64_t word_, reciprocal_;
};

// ---- decimals of one word ----

constexpr std::ptrdiff_t most_places = 19;  // and digits: they fit a word

/// A power of 5 below 2^63, times the power of 2 that gives it 64 bits.
struct PowerOf5 {
  Divisor divisor;
  int shift;
};
constexpr PowerOf5 power_of_5(std::size_t i) {
  std::uint64_t power = 1;
  for (; i > 0; --i) power *= 5;
  const int shift = std::countl_zero(power);
  return {Divisor(power << shift), shift};
}
template <std::size_t... i>
constexpr std::array<PowerOf5, sizeof...(i)> powers_of_5(std::index_sequence<i...>) {
  return {power_of_5(i)...};
}

/// digits / 10^places, rounded to nearest, which the float environment must say too.
double nearest_quotient(std::uint64_t digits, std::ptrdiff_t places) {
  static constexpr auto powers = powers_of_5(std::make_index_sequence<most_places + 1>());
  if (digits == 0) return 0;
  const auto& [divisor, shift] = powers[static_cast<std::size_t>(places)];
  const int up = std::countl_zero(digits);
  const auto [quotient, rest] = divisor.divided(Uint128{digits << up} << 63);
  // At least 62 bits, the last of which says what follows: a signed word, converted at once.
  const auto leading = static_cast<double>(static_cast<std::int64_t>(quotient >> 1 | (quotient & 1) | (rest != 0)));
  const std::int64_t exponent = shift - 62 - up - places;
  return leading * std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
}

/// Appends the digits that begin at `at` to the number; returns where they end.
const char* take_digits(const char* at, const char* end, std::uint64_t& number) {
  for (; at != end && is_decimal_digit(*at); ++at) number = 10 * number + static_cast<std::uint64_t>(*at - '0');
  return at;
}

/// The same, of many digits: eight at once, where all are digits.
const char* take_many_digits(const char* at, const char* end, std::uint64_t& number) {
  for (; end - at >= 8; at += 8) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, at, sizeof eight);
    if constexpr (std::endian::native == std::endian::big) eight = __builtin_bswap64(eight);
    if (((eight & (eight + 0x0606060606060606)) & 0xf0f0f0f0f0f0f0f0) != 0x3030303030303030) break;
    eight = (eight & 0x0f0f0f0f0f0f0f0f) * (10 * 256 + 1) >> 8;  // pairs, then fours
    eight = (eight & 0x00ff00ff00ff00ff) * (100 * 65536 + 1) >> 16;
    eight = (eight & 0x0000ffff0000ffff) * (10000 * (1ULL << 32) + 1) >> 32;
    number = 100'000'000 * number + eight;
  }
  return take_digits(at, end, number);
}

}  // namespace

const char* leading_number(const char* begin, const char* end, double& nearest) {
  const bool is_negative = begin != end && *begin == '-';
  const char* const integer = begin + is_negative;
  std::uint64_t digits = 0;
  const char* at = take_digits(integer, end, digits);
  std::ptrdiff_t count = at - integer, places = 0;
  if (count == 0 || (*integer == '0' && count > 1)) return nullptr;
  if (at != end && *at == '.') {
    const char* const fraction = at + 1;
    at = take_many_digits(fraction, end, digits);
    places = at - fraction;
    if (places == 0) return nullptr;
    count += places - (*integer == '0');
  }
  const bool has_exponent = at != end && lower(*at) == 'e';
  if (!has_exponent && count <= most_places) {
    const auto size = std::bit_cast<std::uint64_t>(nearest_quotient(digits, places));
    nearest = std::bit_cast<double>(size | std::uint64_t{is_negative} << 63);
    return at;
  }
  if (has_exponent) {
    ++at;
    if (at != end && is_sign(*at)) ++at;
    if (at == end || !is_decimal_digit(*at)) return nullptr;
    at = std::find_if_not(at, end, is_decimal_digit);
  }
  return std::from_chars(begin, at, nearest).ec == std::errc() ? at : nullptr;
}

// ---- integers as digits ----
namespace {

constexpr std::uint64_t chunk = 10'000'000'000'000'000'000U;
constexpr Divisor by_chunk(chunk);
constexpr std::size_t chunk_digits = 19;

/// At least log(2) / log(10^19) chunks for each bit.
constexpr std::size_t chunks_for(std::size_t words) { return (words * 64 * 159 + 9999) / 10000; }

/// A number in chunks, the lowest first; the highest is not zero.
template <std::size_t words>
struct Chunks {
  std::array<std::uint64_t, chunks_for(words)> digits;
  std::size_t size = 0;

  constexpr void multiply(std::uint64_t factor) {
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const Divided product = by_chunk.divided(Uint128{digits[i]} * factor + carry);
      digits[i] = product.rest;
      carry = product.quotient;
    }
    push(carry);
  }
  /// Of a word.
  constexpr void push(std::uint64_t n) {
    if (n >= chunk) digits[size++] = n % chunk, n /= chunk;
    else if (n == 0) return;
    digits[size++] = n;
  }
};

// ---- text ----

/// All eight digits of a number below 10^8. Each step splits numbers in two: the whole in fours,
/// these in pairs, these in digits.
void put_eight(char* at, std::uint32_t n) {
  const std::uint64_t fours = n / 10000 | std::uint64_t{n % 10000} << 32;
  const std::uint64_t hundreds = (fours * 10486 >> 20) & 0x0000007f0000007f;
  const std::uint64_t pairs = hundreds | (fours - 100 * hundreds) << 16;
  const std::uint64_t tens = (pairs * 103 >> 10) & 0x000f000f000f000f;
  std::uint64_t digits = (tens | (pairs - 10 * tens) << 8) | 0x3030303030303030;
  if constexpr (std::endian::native == std::endian::big) digits = __builtin_bswap64(digits);
  std::memcpy(at, &digits, sizeof digits);
}

/// All digits of a chunk.
void put_chunk(char* at, std::uint64_t n) {
  const std::uint64_t below = n % 10'000'000'000'000'000U;
  const auto above = static_cast<unsigned>(n / 10'000'000'000'000'000U);
  at[0] = static_cast<char>('0' + above / 100);
  at[1] = static_cast<char>('0' + above / 10 % 10);
  at[2] = static_cast<char>('0' + above % 10);
  put_eight(at + 3, static_cast<std::uint32_t>(below / 100'000'000));
  put_eight(at + 11, static_cast<std::uint32_t>(below % 100'000'000));
}

char* put(char* at, std::span<const std::uint64_t> chunks) {
  at = put_digits(at, chunks.back());
  for (std::size_t i = chunks.size() - 1; i-- > 0; at += chunk_digits) put_chunk(at, chunks[i]);
  return at;
}

// ---- powers of 2 ----

constexpr std::size_t most_words_of_power = 17;  // 2^1074 is the largest denominator in binary64

/// 2^(64 i) for i from 1 on.
constexpr auto powers = [] {
  std::array<Chunks<most_words_of_power + 1>, most_words_of_power> result{};
  Chunks<most_words_of_power + 1> power{};
  power.push(std::uint64_t{1} << 32);
  for (auto& entry : result) {
    power.multiply(std::uint64_t{1} << 32);
    entry = power;
    power.multiply(std::uint64_t{1} << 32);
  }
  return result;
}();

/// n 2^shift, both not zero, where the shift is less than 64 (most_words_of_power + 1).
char* put_shifted(char* at, std::uint64_t n, unsigned long shift) {
  constexpr std::size_t most = most_words_of_power + 2;
  Chunks<most> chunks;
  const unsigned words = static_cast<unsigned>(shift / 64), rest = static_cast<unsigned>(shift % 64);
  if (words == 0) {
    chunks.push(n);
  } else {
    const auto& power = powers[words - 1];
    chunks.size = power.size;
    std::copy_n(power.digits.begin(), power.size, chunks.digits.begin());
    if (n >> (63 - rest) >> 1 == 0) {
      chunks.multiply(n << rest);
      return put(at, {chunks.digits.data(), chunks.size});
    }
    chunks.multiply(n);
  }
  if (rest > 0) chunks.multiply(std::uint64_t{1} << rest);
  return put(at, {chunks.digits.data(), chunks.size});
}

// ---- any number ----

constexpr std::size_t few = 24;  // words; more are for GMP, whose time does not grow with their square

char* put_words(char* at, const mp_limb_t* words, std::size_t size) {
  std::array<std::uint64_t, few> rest;
  std::copy_n(words, size, rest.begin());
  Chunks<few> chunks;
  while (size > 0) {
    std::uint64_t last = 0;
    for (std::size_t i = size; i-- > 0;) {
      const Divided step = by_chunk.divided(Uint128{last} << 64 | rest[i]);
      rest[i] = step.quotient;
      last = step.rest;
    }
    chunks.digits[chunks.size++] = last;
    if (rest[size - 1] == 0) --size;  // a chunk is longer than 63 bits, so that is all
  }
  return put(at, {chunks.digits.data(), chunks.size});
}

}  // namespace

char* put_digits(char* at, const Dyadic& n) {
  if (n.mantissa < 0) *at++ = '-';
  const std::uint64_t size =
      n.mantissa < 0 ? -static_cast<std::uint64_t>(n.mantissa) : static_cast<std::uint64_t>(n.mantissa);
  return n.exponent == 0 ? put_digits(at, size) : put_shifted(at, size, static_cast<unsigned long>(n.exponent));
}

char* put_digits(char* at, mpz_srcptr n) {
  const std::size_t size = mpz_size(n);
  const mp_limb_t* const words = mpz_limbs_read(n);
  if (mpz_sgn(n) < 0) *at++ = '-';
  if (size <= 1) return put_digits(at, size == 0 ? std::uint64_t{0} : words[0]);
  std::size_t zeros = 0;
  while (words[zeros] == 0) ++zeros;
  if (size - zeros == 1 && zeros <= most_words_of_power) return put_shifted(at, words[zeros], 64 * zeros);
  if (size - zeros == 2 && zeros <= most_words_of_power) {
    const Uint128 both = Uint128{words[zeros + 1]} << 64 | words[zeros];
    const int shift = std::countr_zero(words[zeros]);
    if (high_word(both >> shift) == 0)
      return put_shifted(at, low_word(both >> shift), 64 * zeros + static_cast<unsigned long>(shift));
  }
  if (size <= few) return put_words(at, words, size);
  if (mpz_sgn(n) < 0) --at;
  mpz_get_str(at, 10, n);
  return at + std::strlen(at);
}

void append_digits(mpz_srcptr n, std::string& text) {
  if (mpz_size(n) <= few) {
    std::array<char, 20 * few + 1> digits;
    text.append(digits.data(), put_digits(digits.data(), n));
    return;
  }
  const std::size_t begin = text.size();
  text.resize(begin + most_digits(n));
  text.resize(static_cast<std::size_t>(put_digits(text.data() + begin, n) - text.data()));
}

void append_exact(const mpq_class& value, std::string& text) {
  append_digits(value.get_num_mpz_t(), text);
  if (mpz_cmp_ui(value.get_den_mpz_t(), 1) == 0) return;
  text += '/';
  append_digits(value.get_den_mpz_t(), text);
}

void append_hex(double value, std::string& text) {
  constexpr int fraction_bits = 52, bias = 1023;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(value);
  std::uint64_t fraction = bits & ((std::uint64_t{1} << fraction_bits) - 1);
  const int biased = static_cast<int>(bits >> fraction_bits) & 0x7ff;
  if (biased == 0x7ff && fraction != 0) {
    text += "nan";
    return;
  }
  std::array<char, 32> digits;
  char* at = digits.data();
  const auto put = [&at](std::string_view part) { at = std::copy(part.begin(), part.end(), at); };
  if (bits >> 63 != 0) *at++ = '-';
  if (biased == 0x7ff) put("inf");
  else if (biased == 0 && fraction == 0) put("0x0p+0");
  else {
    put(biased == 0 ? "0x0" : "0x1");
    if (fraction != 0) *at++ = '.';
    for (; fraction != 0; fraction = (fraction << 4) & ((std::uint64_t{1} << fraction_bits) - 1))
      *at++ = "0123456789abcdef"[fraction >> (fraction_bits - 4)];
    const int exponent = biased == 0 ? 1 - bias : biased - bias;
    put(exponent < 0 ? "p" : "p+");
    at = std::to_chars(at, digits.data() + digits.size(), exponent).ptr;
  }
  text.append(digits.data(), at);
}

}  // namespace fathom::kernels

namespace fathom {

ParsedNumber parse_number(std::string_view token, Decimals decimals) {
  if (token.empty()) return kernels::refused("expected a number, found nothing");
  if (token.size() > longest_number) {
    return kernels::refused("expected a number, found " + kernels::shown(token) + ": longer than " +
                            std::to_string(longest_number) + " characters");
  }
  const bool negative = token.front() == '-';
  ParsedNumber result = kernels::parse_unsigned(token.substr(kernels::is_sign(token.front()) ? 1 : 0), decimals);
  if (!result.value) return kernels::refused("expected a number, found " + kernels::shown(token) + ": " + result.error);
  if (negative) mpq_neg(result.value->get_mpq_t(), result.value->get_mpq_t());
  return result;
}

mpq_class exact_value(double value) {
  // By its bits: where subnormal numbers count as zero, GMP takes them for zero.
  if ((std::bit_cast<std::uint64_t>(value) >> 52 & 0x7ff) == 0x7ff)
    throw std::invalid_argument("a number that is not finite has no exact value");
  const kernels::Dyadic odd = kernels::dyadic(value);
  mpq_class result(static_cast<long>(odd.mantissa));
  mpz_class& shifted = odd.exponent >= 0 ? result.get_num() : result.get_den();
  shifted <<= static_cast<mp_bitcnt_t>(std::abs(odd.exponent));
  return result;
}

std::string exact_text(const mpq_class& value) {
  std::string text;
  kernels::append_exact(value, text);
  return text;
}

std::string hex_text(double value) {
  std::string text;
  kernels::append_hex(value, text);
  return text;
}

}  // namespace fathom
