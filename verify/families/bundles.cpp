// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/families/bundles.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "verify/families/circle.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {

namespace {

/// A point of a convex chain: abscissa and height, concave as a function of the abscissa.
struct ChainPoint {
  mpq_class along, height;
};
using Chain = std::vector<ChainPoint>;

/// The chain in the yz-plane, closed by (+-side, 0, -below). Every edge of the chain is an edge of the hull as long as the chain lies
/// above the two points, and its arc reaches as far across the plane as slope below / side.
Body fan(const Chain& chain, const mpq_class& side, const mpq_class& below) {
  Body body;
  for (const ChainPoint& p : chain) body.points.push_back({0, p.along, p.height});
  body.points.push_back({side, 0, mpq_class(-below)});
  body.points.push_back({mpq_class(-side), 0, mpq_class(-below)});
  return body;
}

/// A's fan: the same in the xz-plane, upside down, so that it is -A that has its chain on top.
Body opposing_fan(const Chain& chain, const mpq_class& side, const mpq_class& below) {
  Body body = fan(chain, side, below);
  for (Point& p : body.points) p = {p.y, p.x, mpq_class(-p.z)};
  return body;
}

/// B's fan moved so that the highest point of P, where both chains have height 0, is at `top`.
Bodies crossed(const Chain& a, const Chain& b, const mpq_class& side, const mpq_class& below, const Point& top) {
  return {opposing_fan(a, side, below), translated(fan(b, side, below), top)};
}

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

/// n - 2 points a fixed step apart on the circle, symmetric about the top, of half width pi / 202 (about 1/64); then one point on each side,
/// on the prolongation of what would be the next edge, at the half width 2: nothing but the patch comes near O.
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
