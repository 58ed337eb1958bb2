// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "verify/families/polytope_pairs.hpp"

namespace fathom::families {

namespace {

/// numerator / denominator, rounded to an integer; denominator > 0.
mpz_class rounded(const mpz_class& numerator, const mpz_class& denominator) {
  const mpz_class twice = 2 * numerator + denominator, divisor = 2 * denominator;
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), twice.get_mpz_t(), divisor.get_mpz_t());
  return result;
}

mpz_class rounded(const mpq_class& value) { return rounded(value.get_num(), value.get_den()); }

/// numerator / denominator * 2^-scale, rounded to a multiple of 2^-bits; bits <= scale.
mpq_class on_grid(const mpz_class& numerator, const mpz_class& denominator, long scale, long bits) {
  return times_power_of_two(mpq_class(rounded(numerator, mpz_class(denominator << static_cast<mp_bitcnt_t>(scale - bits)))), -bits);
}

/// Neighbouring slopes differ by width / count at least, and edges are as long as that: rounded edges turn in the right direction if the
/// grid is a few times finer than the square of it.
long grid_bits(std::size_t count, const mpq_class& width, long least) {
  const mpq_class steps = mpq_class(count) / width;
  const mpz_class square = rounded(mpq_class(steps * steps));
  return std::max<long>(least, static_cast<long>(mpz_sizeinbase(square.get_mpz_t(), 2)) + 2);
}

}  // namespace

Body fan(const Chain& chain, const mpq_class& side, const mpq_class& below) {
  Body body;
  body.points.reserve(chain.size() + 2);
  for (const ChainPoint& p : chain) body.points.push_back({0, p.along, p.height});
  body.points.push_back({side, 0, mpq_class(-below)});
  body.points.push_back({mpq_class(-side), 0, mpq_class(-below)});
  return body;
}

Body opposing_fan(const Chain& chain, const mpq_class& side, const mpq_class& below) {
  Body body = fan(chain, side, below);
  for (Point& p : body.points.edit()) p = {p.y, p.x, mpq_class(-p.z)};
  return body;
}

Bodies crossed(const Chain& a, const Chain& b, const mpq_class& side, const mpq_class& below, const Point& top) {
  return {opposing_fan(a, side, below), translated(fan(b, side, below), top)};
}

std::vector<mpz_class> spread_slopes(Random& random, unsigned count, const mpq_class& width) {
  const mpz_class half = rounded(times_power_of_two(width, slope_bits));
  std::vector<mpz_class> slopes;
  slopes.reserve(count);
  constexpr long part_bits = 20;
  for (unsigned i = 0; i < count; ++i) {
    // From the middle of the part: -half + 2 half (i + share) / count, with the share between 1/4 and 3/4.
    const std::int64_t share = random.between(std::int64_t{1} << (part_bits - 2), std::int64_t{3} << (part_bits - 2));
    const mpz_class place = (mpz_class(i) << part_bits) + share;
    slopes.push_back(mpz_class(2 * half * place / (mpz_class(count) << part_bits) - half));
  }
  return slopes;
}

Chain tangent_chain(const Outline& outline, const std::vector<mpz_class>& slopes, const mpq_class& width, const mpq_class& reach,
                    long least_bits) {
  // Support values at the slopes, as multiples of 2^-scale; the outline's coefficients are rounded to 2^-slope_bits.
  constexpr long scale = 5 * slope_bits;
  const mpz_class quadratic = rounded(times_power_of_two(outline.quadratic, slope_bits - 1));
  const mpz_class quartic = rounded(times_power_of_two(outline.quartic, slope_bits));
  const auto support = [&](const mpz_class& x) {
    const mpz_class square = x * x;
    return mpz_class(((quadratic * square) << (2 * slope_bits)) + quartic * square * square);
  };
  const long bits = grid_bits(slopes.size(), width, least_bits);
  const auto cut_off = [&](const mpz_class& x, const mpq_class& at) {
    const mpq_class height = support(x) - times_power_of_two(mpq_class(x * at), scale - slope_bits);
    return ChainPoint{at, on_grid(height.get_num(), height.get_den(), scale, bits)};
  };
  Chain chain{cut_off(slopes.front(), mpq_class(-reach))};
  chain.reserve(slopes.size() + 1);
  mpz_class g = support(slopes.front());
  for (std::size_t i = 0; i + 1 < slopes.size(); ++i) {
    const mpz_class &x = slopes[i], &y = slopes[i + 1];
    const mpz_class h = support(y), gap = y - x;
    chain.push_back({on_grid(mpz_class(h - g), gap, scale - slope_bits, bits), on_grid(mpz_class(g * y - h * x), gap, scale, bits)});
    g = h;
  }
  chain.push_back(cut_off(slopes.back(), reach));
  return chain;
}

}  // namespace fathom::families
