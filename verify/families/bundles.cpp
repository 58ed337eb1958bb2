// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "verify/families/polytope_pairs.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {

namespace {

unsigned at_least(unsigned least, unsigned n) { return std::max(least, n); }

/// n distinct integers in [low, high], ascending.
std::set<std::int64_t> distinct(Random& random, unsigned n, std::int64_t low, std::int64_t high) {
  std::set<std::int64_t> chosen;
  while (chosen.size() < n) chosen.insert(random.between(low, high));
  return chosen;
}

/// The point of the unit circle at k / n of a turn, moved down so that the top of the circle has height 0.
ChainPoint on_circle(std::uint64_t k, std::uint64_t n) {
  constexpr long bits = 52;
  const CirclePoint p = circle_point(k, n, bits);
  return {times_power_of_two(p.cosine, -bits), mpq_class(times_power_of_two(p.sine, -bits) - 1)};
}

/// Random angles within 45 degrees of the top. They are multiples of 2 pi / 2^24, far enough apart for strict convexity on the grid.
Chain random_circle_chain(Random& random, unsigned n) {
  constexpr std::int64_t turn = std::int64_t{1} << 24;
  Chain chain;
  for (const std::int64_t k : distinct(random, n, turn / 8, 3 * turn / 8)) chain.push_back(on_circle(static_cast<std::uint64_t>(k), turn));
  return chain;
}

Chain random_parabola_chain(Random& random, unsigned n) {
  constexpr long bits = 26;  // squares fit into a binary64
  Chain chain;
  for (const std::int64_t t : distinct(random, n, -(std::int64_t{1} << bits), std::int64_t{1} << bits)) {
    const mpq_class along = times_power_of_two(t, -bits);
    chain.push_back({along, mpq_class(-along * along)});
  }
  return chain;
}

/// The fan over the parabola z = -y^2, its chain bent sideways to x = y^3 / 16: points at random, one in each of n equal parts.
Body twisted_fan(Random& random, unsigned n) {
  constexpr long bits = 26, fine = 50;
  Chain chain;
  for (const mpz_class& t : spread_slopes(random, n, 1)) {
    const mpq_class along = times_power_of_two(mpq_class(mpz_class(t >> (slope_bits - bits))), -bits);
    chain.push_back({along, mpq_class(-along * along)});
  }
  Body body = fan(chain, 2, 8);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const mpz_class t = times_power_of_two(chain[i].along, bits).get_num();
    body.points.edit()[i].x = times_power_of_two(mpq_class(mpz_class((t * t * t) >> (3 * bits + 4 - fine))), -fine);
  }
  return body;
}

/// n - 2 points a fixed step apart on the circle, symmetric about the top, of half width pi / 202 (about 1/64); then one point on each
/// side, at the half width 2, on the line of what would be the next edge: only the patch comes near O.
Chain patch_chain(unsigned n) {
  const std::int64_t inner = n - 2, quarter = 101 * (inner - 1);  // angles are counted in half steps, `quarter` to the right angle
  const auto point = [&](std::int64_t i) {
    return on_circle(static_cast<std::uint64_t>(quarter + inner - 1 - 2 * i), static_cast<std::uint64_t>(4 * quarter));
  };
  const auto prolonged = [&](std::int64_t from, std::int64_t next) {
    const ChainPoint p = point(from), q = point(next);
    const std::int64_t reach = 2 * quarter * 113 / 355;  // about 2 / step, with 355 / 113 for pi
    return ChainPoint{mpq_class(p.along + reach * (q.along - p.along)), mpq_class(p.height + reach * (q.height - p.height))};
  };
  Chain chain{prolonged(0, -1)};
  for (std::int64_t i = 0; i < inner; ++i) chain.push_back(point(i));
  chain.push_back(prolonged(inner - 1, inner));
  return chain;
}

/// The prism over n points of the unit circle: eight at equal angles, so that no large part of the circle is missing, the others at random.
/// With n < 8 all are at equal angles.
Body random_prism(Random& random, unsigned n, const mpq_class& half_height) {
  constexpr std::int64_t turn = std::int64_t{1} << 24;
  constexpr long bits = 50;
  std::set<std::int64_t> angles;
  const std::int64_t even = std::min<std::int64_t>(n, 8);
  for (std::int64_t i = 0; i < even; ++i) angles.insert(i * turn / even);
  while (angles.size() < n) angles.insert(random.between(0, turn - 1));
  Body body;
  for (const std::int64_t k : angles) {
    const CirclePoint p = circle_point(static_cast<std::uint64_t>(k), turn, bits);
    const mpq_class x = times_power_of_two(p.cosine, -bits), y = times_power_of_two(p.sine, -bits);
    for (const int sign : {-1, 1}) body.points.push_back({x, y, mpq_class(sign * half_height)});
  }
  return body;
}

/// A point of the band around the unit circle in the xy-plane.
Point band_point(Random& random) {
  constexpr long bits = 30;
  const CirclePoint p = circle_point(static_cast<std::uint64_t>(random.between(0, (1 << bits) - 1)), 1 << bits, bits);
  const std::int64_t off = random.between(-(1 << 12), 1 << 12);
  return {times_power_of_two(p.cosine, -bits), times_power_of_two(p.sine, -bits), times_power_of_two(off, -bits)};
}

}  // namespace

Bodies crossed_fans(Random& random, unsigned n) {
  const Chain a = random_circle_chain(random, at_least(2, n));
  const Chain b = random_circle_chain(random, at_least(2, n));
  Point top = random_shift(random, 1);
  top = {mpq_class(top.x / 16), mpq_class(top.y / 16), mpq_class(ratio(1, 2) + top.z / 4)};
  return crossed(a, b, 2, 4, top);
}

Bodies crossed_parabolas(Random&, unsigned n) {
  const std::int64_t count = at_least(3, n), first = -((count - 1) / 2);
  const mpz_class extent = count - 1 + first;
  const mpq_class unit = extent * extent;  // the image of 1
  Chain chain;
  for (std::int64_t i = first; i < first + count; ++i) chain.push_back({mpq_class(i * extent), mpq_class(-mpz_class(i) * i)});
  return crossed(chain, chain, mpq_class(2 * unit), mpq_class(8 * unit), {0, 0, unit});
}

Bodies crossed_random_parabolas(Random& random, unsigned n) {
  const Chain a = random_parabola_chain(random, at_least(2, n));
  const Chain b = random_parabola_chain(random, at_least(2, n));
  return crossed(a, b, 2, 8, {0, 0, 1});
}

Bodies crossed_twists(Random& random, unsigned n) {
  const Body a = twisted_fan(random, at_least(2, n)), b = twisted_fan(random, at_least(2, n));
  Bodies bodies{{}, translated(b, {0, 0, 1})};
  for (const Point& p : a.points) bodies.a.points.push_back({p.y, p.x, mpq_class(-p.z)});
  return bodies;
}

Bodies crossed_patch(Random&, unsigned n) {
  const Chain chain = patch_chain(at_least(4, n));
  return crossed(chain, chain, 2, 4, {0, 0, 1});
}

Bodies crossed_prisms(Random& random, unsigned n) {
  const Body upright = prism(at_least(3, n), 1);
  Bodies bodies;
  for (const Point& p : upright.points) bodies.a.points.push_back({p.x, p.z, p.y});
  for (const Point& p : upright.points) bodies.b.points.push_back({p.z, p.x, p.y});
  // In direction (1,1,1) both rims together reach about (1.71, 1.71, 1.41); O goes about 1/4 below that point of P.
  const Point jitter = random_shift(random, 1);
  const Point shift{mpq_class(jitter.x / 16 - ratio(25, 16)), mpq_class(jitter.y / 16 - ratio(25, 16)),
                    mpq_class(jitter.z / 16 - ratio(5, 4))};
  bodies.b = translated(bodies.b, shift);
  return bodies;
}

Bodies crossed_random_prisms(Random& random, unsigned n) {
  const mpq_class height_a = ratio(random.between(8, 32), 16), height_b = ratio(random.between(8, 32), 16);
  Bodies bodies;
  for (const Point& p : random_prism(random, at_least(3, n), height_a).points) bodies.a.points.push_back({p.x, p.z, p.y});
  for (const Point& p : random_prism(random, at_least(3, n), height_b).points) bodies.b.points.push_back({p.z, p.x, p.y});
  const Point jitter = random_shift(random, 1);
  const Point shift{mpq_class(jitter.x / 16 - height_b - ratio(9, 16)), mpq_class(jitter.y / 16 - height_a - ratio(9, 16)),
                    mpq_class(jitter.z / 16 - ratio(5, 4))};
  bodies.b = translated(bodies.b, shift);
  return bodies;
}

Bodies crossed_bands(Random& random, unsigned n) {
  Bodies bodies;
  for (unsigned i = 0; i < n; ++i) {
    const Point p = band_point(random);
    bodies.a.points.push_back({p.x, p.z, p.y});
  }
  for (unsigned i = 0; i < n; ++i) {
    const Point p = band_point(random);
    bodies.b.points.push_back({p.z, p.x, p.y});
  }
  const Point shift = random_shift(random, 1);
  bodies.b = translated(bodies.b, {mpq_class(shift.x / 2), mpq_class(shift.y / 2), mpq_class(shift.z / 2)});
  return bodies;
}

}  // namespace fathom::families
