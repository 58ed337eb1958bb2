// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/shrink/size.hpp"

#include <bit>
#include <cstdlib>

#include "verify/harness/coordinates.hpp"

namespace fathom::harness {
namespace {

constexpr std::size_t small_bits = 10;

std::size_t bits(const mpz_class& value) { return mpz_sizeinbase(value.get_mpz_t(), 2); }

}  // namespace

std::size_t cost(const mpq_class& value) {
  if (value == 0) return 0;
  if (value.get_den() == 1 && bits(value.get_num()) <= small_bits) return bits(value.get_num());
  const std::size_t odd = bits(value.get_num()) - mpz_scan1(value.get_num_mpz_t(), 0);
  return small_bits + odd + static_cast<std::size_t>(std::bit_width(static_cast<unsigned long>(std::labs(exponent_of(value)))));
}

Size size_of(const Case& pair) {
  Size size{pair.a.points.size() + pair.b.points.size(), 0, 0};
  for_each_coordinate(pair, [&](const mpq_class& value) {
    size.bits += cost(value);
    size.signs += value < 0 ? 1 : 0;
  });
  return size;
}

}  // namespace fathom::harness
