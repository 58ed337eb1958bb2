// SPDX-License-Identifier: GPL-3.0-or-later
// An integer becomes chunks of 19 digits, which are less than a word, and these become text.
#include "kernels/number/decimal.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>

#include "kernels/number/word_integer.hpp"

namespace fathom::kernels {
namespace {

constexpr std::uint64_t chunk = 10'000'000'000'000'000'000U;  // above 2^63, as a quick division wants it
constexpr std::size_t chunk_digits = 19;

constexpr std::uint64_t low_word(Uint128 n) { return static_cast<std::uint64_t>(n); }
constexpr std::uint64_t high_word(Uint128 n) { return static_cast<std::uint64_t>(n >> 64); }

struct Divided {
  std::uint64_t quotient, rest;
};

/// n / chunk, which is less than 2^64, by a multiplication with floor((2^128 - 1) / chunk) - 2^64.
///                     [Moeller, Granlund, Improved division by invariant integers, algorithm 4]
constexpr Divided divided(Uint128 n) {
  constexpr std::uint64_t reciprocal = low_word(~Uint128{0} / chunk);
  const Uint128 guess = Uint128{reciprocal} * high_word(n) + n;
  std::uint64_t quotient = high_word(guess) + 1, rest = low_word(n) - quotient * chunk;
  if (rest > low_word(guess)) --quotient, rest += chunk;
  if (rest >= chunk) ++quotient, rest -= chunk;
  return {quotient, rest};
}

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
      const Divided product = divided(Uint128{digits[i]} * factor + carry);
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
      const Divided step = divided(Uint128{last} << 64 | rest[i]);
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

}  // namespace fathom::kernels
