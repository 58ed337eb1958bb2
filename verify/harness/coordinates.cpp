// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fathom/numbers.hpp"

namespace fathom::harness {

mpq_class scaled(const mpq_class& value, long exponent) {
  mpq_class result;
  if (exponent >= 0) mpq_mul_2exp(result.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else mpq_div_2exp(result.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return result;
}

long exponent_of(const mpq_class& value) {
  const long guess =
      static_cast<long>(mpz_sizeinbase(value.get_num_mpz_t(), 2)) - static_cast<long>(mpz_sizeinbase(value.get_den_mpz_t(), 2));
  return abs(value) < scaled(1, guess) ? guess - 1 : guess;  // 2^(guess-1) < |value| < 2^(guess+1)
}

long lowest_bit(const mpq_class& value) {
  if (value.get_den() != 1) return 1 - static_cast<long>(mpz_sizeinbase(value.get_den_mpz_t(), 2));
  return static_cast<long>(mpz_scan1(value.get_num_mpz_t(), 0));
}

std::optional<mpq_class> rounded(const mpq_class& value, Precision precision) {
  const double nearest =
      precision == Precision::binary32 ? static_cast<double>(round_binary32(value, Rounding::rn)) : round_binary64(value, Rounding::rn);
  if (!std::isfinite(nearest)) return std::nullopt;
  return exact_value(nearest);
}

namespace {

/// Applies use(mpq_class&) to the numbers that are no lengths: turns, matrices, normals.
void for_each_slope(files::NamedBody& words, const std::function<void(mpq_class&)>& use) {
  if (words.matrix) {
    for (auto& row : *words.matrix)
      for (std::size_t k = 0; k < 3; ++k) use(row[k]);
  } else {
    for (mpq_class* value : {&words.turn.w, &words.turn.x, &words.turn.y, &words.turn.z}) use(*value);
  }
  if (const auto normal = words.fields.numbers.find("normal"); normal != words.fields.numbers.end())
    for (mpq_class& value : normal->second) use(value);
  for (files::NamedBody& term : words.terms) for_each_slope(term, use);
}

/// The plain name, without a margin of 0.
void make_plain(files::NamedBody& words) {
  words.shape = files::named_shape(words.shape).shape->name;
  const auto margin = words.fields.numbers.find("margin");
  if (margin != words.fields.numbers.end() && margin->second.front() == 0) words.fields.numbers.erase(margin);
  for (files::NamedBody& term : words.terms) make_plain(term);
}

}  // namespace

void for_each_length(files::NamedBody& words, const std::function<void(mpq_class&)>& use) {
  for (auto& [name, values] : words.fields.numbers)
    if (name != "normal")
      for (mpq_class& value : values) use(value);
  for (Point& p : words.fields.vertices)
    for (mpq_class* value : {&p.x, &p.y, &p.z}) use(*value);
  for (std::size_t axis = 0; axis < 3; ++axis) use(place_along(words, axis));
  for (files::NamedBody& term : words.terms) for_each_length(term, use);
}

mpq_class& place_along(files::NamedBody& words, std::size_t axis) {
  if (words.matrix) return (*words.matrix)[axis][3];
  return axis == 0 ? words.place.x : axis == 1 ? words.place.y : words.place.z;
}

std::optional<files::NamedBody> rounded(files::NamedBody words, Precision precision) {
  bool fits = true;
  const auto round = [&](mpq_class& value) {
    const std::optional<mpq_class> nearest = rounded(value, precision);
    fits = fits && nearest;
    if (nearest) value = *nearest;
  };
  for_each_length(words, round);
  for_each_slope(words, round);
  make_plain(words);
  return fits ? std::optional(std::move(words)) : std::nullopt;
}

bool representable(const mpq_class& value, Precision precision) { return rounded(value, precision) == value; }

mpq_class largest_coordinate(const Case& pair) {
  mpq_class largest = 0;
  for_each_coordinate(pair, [&](const mpq_class& value) { largest = std::max(largest, mpq_class(abs(value))); });
  return largest;
}

}  // namespace fathom::harness
