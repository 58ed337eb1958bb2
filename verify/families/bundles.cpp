// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies whose Gaussian diagrams are bundles of arcs, and pairs of them whose bundles cross like a
// grid.

#include <algorithm>
#include <set>
#include <utility>

#include "verify/families/polytope_pairs.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {

// ---- fans ----

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
  return times_power_of_two(
      mpq_class(rounded(numerator, mpz_class(denominator << static_cast<mp_bitcnt_t>(scale - bits)))), -bits);
}

/// Neighbouring slopes differ by width / count at least, and edges are as long as that: rounded
/// edges turn in the right direction if the grid is a few times finer than the square of it.
long grid_bits_for(std::size_t count, const mpq_class& width, long least) {
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
    // From the middle of the part: -half + 2 half (i + share) / count, with the share between 1/4
    // and 3/4.
    const std::int64_t share = random.between(std::int64_t{1} << (part_bits - 2), std::int64_t{3} << (part_bits - 2));
    const mpz_class place = (mpz_class(i) << part_bits) + share;
    slopes.push_back(mpz_class(2 * half * place / (mpz_class(count) << part_bits) - half));
  }
  return slopes;
}

Chain tangent_chain(const Outline& outline, const std::vector<mpz_class>& slopes, const mpq_class& width,
                    const mpq_class& reach, long least_bits) {
  // Support values at the slopes, as multiples of 2^-scale; the outline's coefficients are rounded
  // to 2^-slope_bits.
  constexpr long scale = 5 * slope_bits;
  const mpz_class quadratic = rounded(times_power_of_two(outline.quadratic, slope_bits - 1));
  const mpz_class quartic = rounded(times_power_of_two(outline.quartic, slope_bits));
  const auto support = [&](const mpz_class& x) {
    const mpz_class square = x * x;
    return mpz_class(((quadratic * square) << (2 * slope_bits)) + quartic * square * square);
  };
  const long bits = grid_bits_for(slopes.size(), width, least_bits);
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
    chain.push_back({on_grid(mpz_class(h - g), gap, scale - slope_bits, bits),
                     on_grid(mpz_class(g * y - h * x), gap, scale, bits)});
    g = h;
  }
  chain.push_back(cut_off(slopes.back(), reach));
  return chain;
}

// ---- bundles across each other ----

namespace {

unsigned at_least(unsigned least, unsigned n) { return std::max(least, n); }

/// n distinct integers in [low, high], ascending.
std::set<std::int64_t> distinct_integers(Random& random, unsigned n, std::int64_t low, std::int64_t high) {
  std::set<std::int64_t> chosen;
  while (chosen.size() < n) chosen.insert(random.between(low, high));
  return chosen;
}

/// The point of the unit circle at k / n of a turn, moved down so that the top of the circle has
/// height 0.
ChainPoint on_circle(std::uint64_t k, std::uint64_t n) {
  constexpr long bits = 52;
  const CirclePoint p = circle_point(k, n, bits);
  return {times_power_of_two(p.cosine, -bits), mpq_class(times_power_of_two(p.sine, -bits) - 1)};
}

/// Random angles within 45 degrees of the top. They are multiples of 2 pi / 2^24, far enough apart
/// for strict convexity on the grid.
Chain random_circle_chain(Random& random, unsigned n) {
  constexpr std::int64_t turn = std::int64_t{1} << 24;
  Chain chain;
  for (const std::int64_t k : distinct_integers(random, n, turn / 8, 3 * turn / 8))
    chain.push_back(on_circle(static_cast<std::uint64_t>(k), turn));
  return chain;
}

Chain random_parabola_chain(Random& random, unsigned n) {
  constexpr long bits = 26;  // squares fit into a binary64
  Chain chain;
  for (const std::int64_t t : distinct_integers(random, n, -(std::int64_t{1} << bits), std::int64_t{1} << bits)) {
    const mpq_class along = times_power_of_two(t, -bits);
    chain.push_back({along, mpq_class(-along * along)});
  }
  return chain;
}

/// The fan over the parabola z = -y^2, its chain bent sideways to x = y^3 / 16: points at random,
/// one in each of n equal parts.
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

/// n - 2 points a fixed step apart on the circle, symmetric about the top, of half width pi / 202
/// (about 1/64); then one point on each side, at the half width 2, on the line of what would be the
/// next edge: only the patch comes near O.
Chain patch_chain(unsigned n) {
  const std::int64_t inner = n - 2,
                     quarter = 101 * (inner - 1);  // angles are counted in half steps, `quarter` to the right angle
  const auto point = [&](std::int64_t i) {
    return on_circle(static_cast<std::uint64_t>(quarter + inner - 1 - 2 * i), static_cast<std::uint64_t>(4 * quarter));
  };
  const auto prolonged = [&](std::int64_t from, std::int64_t next) {
    const ChainPoint p = point(from), q = point(next);
    const std::int64_t reach = 2 * quarter * 113 / 355;  // about 2 / step, with 355 / 113 for pi
    return ChainPoint{mpq_class(p.along + reach * (q.along - p.along)),
                      mpq_class(p.height + reach * (q.height - p.height))};
  };
  Chain chain{prolonged(0, -1)};
  for (std::int64_t i = 0; i < inner; ++i) chain.push_back(point(i));
  chain.push_back(prolonged(inner - 1, inner));
  return chain;
}

/// The prism over n points of the unit circle: eight at equal angles, so that no large part of the
/// circle is missing, the others at random. With n < 8 all are at equal angles.
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
  for (std::int64_t i = first; i < first + count; ++i)
    chain.push_back({mpq_class(i * extent), mpq_class(-mpz_class(i) * i)});
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
  // In direction (1,1,1) both rims together reach about (1.71, 1.71, 1.41); O goes about 1/4 below
  // that point of P.
  const Point jitter = random_shift(random, 1);
  const Point shift{mpq_class(jitter.x / 16 - ratio(25, 16)), mpq_class(jitter.y / 16 - ratio(25, 16)),
                    mpq_class(jitter.z / 16 - ratio(5, 4))};
  bodies.b = translated(bodies.b, shift);
  return bodies;
}

Bodies crossed_random_prisms(Random& random, unsigned n) {
  const mpq_class height_a = ratio(random.between(8, 32), 16), height_b = ratio(random.between(8, 32), 16);
  Bodies bodies;
  for (const Point& p : random_prism(random, at_least(3, n), height_a).points)
    bodies.a.points.push_back({p.x, p.z, p.y});
  for (const Point& p : random_prism(random, at_least(3, n), height_b).points)
    bodies.b.points.push_back({p.z, p.x, p.y});
  const Point jitter = random_shift(random, 1);
  const Point shift{mpq_class(jitter.x / 16 - height_b - ratio(9, 16)),
                    mpq_class(jitter.y / 16 - height_a - ratio(9, 16)), mpq_class(jitter.z / 16 - ratio(5, 4))};
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

// ---- bundles with ties ----

namespace {

/// Five times the body, turned about the z-axis by the angle with the sine 4/5: exact, and the arcs
/// of fans are neither upright nor level.
Body askew(const Body& body) {
  Body result;
  result.points.reserve(body.points.size());
  for (const Point& p : body.points)
    result.points.push_back({mpq_class(3 * p.x - 4 * p.y), mpq_class(4 * p.x + 3 * p.y), mpq_class(5 * p.z)});
  return result;
}

/// The chains reach out to 2 along their tangents, where P is farther from O than 1 in every
/// direction but the patch's.
Bodies tie_patch(Random& random, unsigned n, const mpq_class& width, long least_bits = 50) {
  const Outline outline{mpq_class(1 - width * width / 4), ratio(-1, 8)};
  const Chain a = tangent_chain(outline, spread_slopes(random, n, width), width, 2, least_bits);
  const Chain b = tangent_chain(outline, spread_slopes(random, n, width), width, 2, least_bits);
  const Bodies bodies = crossed(a, b, 2, 4, {0, 0, 1});
  return {askew(bodies.a), askew(bodies.b)};
}

unsigned edges_of(unsigned n) { return std::max(3U, n); }

}  // namespace

Bodies crossed_ties(Random& random, unsigned n) { return tie_patch(random, edges_of(n), ratio(1, 32)); }

Bodies crossed_shrinking_ties(Random& random, unsigned n) {
  const unsigned edges = edges_of(n);
  const mpz_class square = (mpz_class(1) << (2 * slope_bits)) / (2 * edges);
  return tie_patch(random, edges, times_power_of_two(mpq_class(sqrt(square)), -slope_bits));
}

Bodies crossed_vanishing_ties(Random& random, unsigned n) {
  const unsigned edges = edges_of(n);
  return tie_patch(random, edges, ratio(1, edges));
}

Bodies crossed_noisy_ties(Random& random, unsigned n) {
  const unsigned edges = edges_of(n);
  const long bits = random.between(50, 90);
  return tie_patch(random, edges, ratio(1, edges), bits);
}

// ---- fillets ----

namespace {

/// The corners of the rounded edge's cross-section, in units of 1/256: abscissa across the chain,
/// and height. The arc of a chain edge is cut where the slope across the chain is 1 and -1.
constexpr std::pair<int, int> cross_section[] = {{-1, -1}, {0, 0}, {1, -1}};
constexpr long unit_bits = 8;

/// The bar over the chain in the yz-plane.
Body bar(const Chain& chain) {
  Body body = fan({}, 1, 4);
  body.points.reserve(3 * chain.size() + 2);
  for (const auto& [across, height] : cross_section) {
    const mpq_class x = times_power_of_two(across, -unit_bits), z = times_power_of_two(height, -unit_bits);
    for (const ChainPoint& p : chain) body.points.push_back({x, p.along, mpq_class(p.height + z)});
  }
  return body;
}

/// Turned about the z-axis, and stretched by the square root of 10 across it: the y-axis goes to
/// (x, y, 0).
Body laid_along(const Body& body, int x, int y) {
  Body result;
  result.points.reserve(body.points.size());
  for (const Point& p : body.points)
    result.points.push_back({mpq_class(y * p.x + x * p.y), mpq_class(y * p.y - x * p.x), p.z});
  return result;
}

Body upside_down(Body body) {
  for (Point& p : body.points.edit()) p.z = -p.z;
  return body;
}

/// The height falls off along the bar as that of a parabola with the curvature 1/5 does, in its
/// stretched unit; the bisectors of (3, 1) and (1, 3) meet this as curvatures of 4/5 and 16/5.
Chain arc(Random& random, unsigned edges, const mpq_class& quartic) {
  const mpq_class width = 2;
  return tangent_chain({ratio(1, 5), quartic}, spread_slopes(random, edges, width), width, ratio(1, 2));
}

}  // namespace

Bodies crossed_fillets(Random& random, unsigned n) {
  const unsigned edges = std::max(2U, (n + 1) / 2);
  const Body a = bar(arc(random, edges, ratio(-1, 1024))), b = bar(arc(random, edges, ratio(1, 1024)));
  Point top = random_shift(random, 1);
  top = {times_power_of_two(top.x, -16), times_power_of_two(top.y, -16), 1};
  return {upside_down(laid_along(a, 3, 1)), translated(laid_along(b, 1, 3), top)};
}

}  // namespace fathom::families
