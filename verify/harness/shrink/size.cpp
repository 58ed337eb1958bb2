// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cstdlib>

#include "verify/harness/coordinates.hpp"
#include "verify/harness/shrink/search.hpp"

namespace fathom::harness {
namespace {

constexpr std::size_t small_bits = 10;

std::size_t bits(const mpz_class& value) { return mpz_sizeinbase(value.get_mpz_t(), 2); }

std::size_t parts_of(const files::NamedBody& words) {
  std::size_t parts = words.fields.vertices.size() + words.fields.numbers.size() + (words.matrix ? 1 : 0);
  for (const files::NamedBody& term : words.terms) parts += 1 + parts_of(term);
  return parts;
}

std::size_t parts_of(const Body& body) { return body.words ? parts_of(*body.words) : body.points.size(); }

}  // namespace

std::size_t cost(const mpq_class& value) {
  if (value == 0) return 0;
  if (value.get_den() == 1 && bits(value.get_num()) <= small_bits) return bits(value.get_num());
  const std::size_t odd = bits(value.get_num()) - mpz_scan1(value.get_num_mpz_t(), 0);
  return small_bits + odd + static_cast<std::size_t>(std::bit_width(static_cast<unsigned long>(std::labs(exponent_of(value)))));
}

Size size_of(const Case& pair) {
  Size size{parts_of(pair.a) + parts_of(pair.b), 0, 0};
  for_each_number(pair, [&](const mpq_class& value) {
    size.bits += cost(value);
    size.signs += value < 0 ? 1 : 0;
  });
  return size;
}

}  // namespace fathom::harness
