// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs made from their answer: lenses, near ties, depths that are hard to round, and extremes of
// shape.

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/approximate/shallow_surface.hpp"
#include "reference/polytope/lattice.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace fathom::families {

// ---- lenses ----

// In the plane, in units of r: features reach out by 1/2 to 3/2 and hold O, the rims by 3 to 5
// along each axis. So for a direction at the angle t to n or -n, with d the distance there, h >= d
// cos t + c r sin t, with the least reach c of the features' sum; and from the rims h > 6 r sin t -
// r cos t. Where the first is not well above r the second is, except for angles near 0, and no
// facet but the chosen ones has such an angle.
namespace {

struct PlanePoint {
  mpq_class x, y;
};

/// Two directions orthogonal to n and to each other, of length about `unit`: multiples of powers of
/// 2.
struct Frame {
  Point x, y;
};

mpq_class square(const Vector& v) { return {dot(v, v)}; }

/// sqrt(numerator / denominator) to eight significant bits, from below.
mpq_class short_quotient_of_roots(const mpq_class& numerator, const mpq_class& denominator) {
  const mpq_class quotient = numerator / denominator;
  const long scale = 8 - kernels::binary_order(quotient) / 2;
  const mpq_class scaled_up = times_power_of_two(quotient, 2 * scale);
  const mpz_class whole = scaled_up.get_num() / scaled_up.get_den();
  return times_power_of_two(mpq_class(mpz_class(sqrt(whole))), -scale);
}

Frame frame_of(const Vector& n, const mpq_class& squared_unit) {
  const std::array<Vector, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::array<mpz_class, 3> sizes{abs(n.x), abs(n.y), abs(n.z)};
  const Vector& axis = axes[static_cast<std::size_t>(std::ranges::min_element(sizes) - sizes.begin())];
  const Vector x = primitive(cross(axis, n)), y = primitive(cross(n, x));
  return {short_quotient_of_roots(squared_unit, square(x)) * x, short_quotient_of_roots(squared_unit, square(y)) * y};
}

mpq_class reach(Random& random) { return ratio(random.between(8, 24), 16); }

/// A vertex at O, an edge through O or a polygon around it, with up to `more` points beyond three.
/// Edges of A lie near the first axis, those of B near the second.
std::vector<PlanePoint> feature_points(FeatureKind feature, bool of_a, std::int64_t more, Random& random) {
  if (feature == FeatureKind::vertex) return {{0, 0}};
  const mpq_class one = reach(random), other = reach(random), lean = ratio(random.between(-4, 4), 16);
  if (feature == FeatureKind::edge) {
    if (of_a) return {{one, mpq_class(one * lean)}, {mpq_class(-other), mpq_class(-other * lean)}};
    return {{mpq_class(one * lean), one}, {mpq_class(-other * lean), mpq_class(-other)}};
  }
  const mpq_class third = reach(random);
  std::vector<PlanePoint> points{{one, 0},
                                 {mpq_class(-other / 2), mpq_class(other * ratio(7, 8))},
                                 {mpq_class(-third / 2), mpq_class(-third * ratio(7, 8))}};
  for (std::int64_t i = random.between(0, more); i > 0; --i) {
    const mpq_class x = ratio(random.between(-16, 16), 16), y = ratio(random.between(-16, 16), 16);
    points.push_back({x, y});
  }
  return points;
}

/// To eight significant bits.
mpq_class rough(const mpq_class& positive) { return short_quotient_of_roots(mpq_class(positive * positive), 1); }

/// Down to a multiple of a power of 2 of about unit / 64.
mpq_class snapped(const mpq_class& value, const mpq_class& unit) {
  const long bits = 6 - kernels::binary_order(unit);
  const mpq_class scaled_up = times_power_of_two(value, bits);
  mpz_class whole;
  mpz_fdiv_q(whole.get_mpz_t(), scaled_up.get_num_mpz_t(), scaled_up.get_den_mpz_t());
  return times_power_of_two(mpq_class(whole), -bits);
}

class Lens {
 public:
  Lens(const Vector& n, const Frame& frame, unsigned points, Random& random)
      : n_(n), frame_(frame), points_(points), random_(random) {}

  void add_feature(FeatureKind feature, bool of_a, const mpq_class& height) {
    for (const PlanePoint& p : feature_points(feature, of_a, points_ < 12 ? 0 : 3, random_)) add(p, height);
  }

  /// At least four points, one in each quadrant, in the middle half between two heights.
  void add_rim(const mpq_class& exact_bottom, const mpq_class& exact_thickness) {
    const mpq_class bottom = snapped(exact_bottom, exact_thickness), thickness = rough(exact_thickness);
    for (unsigned i = 0; i < (points_ < 12 ? 4 : points_ - 8); ++i) {
      const int x = i % 2 ? 1 : -1, y = i / 2 % 2 ? 1 : -1;
      const mpq_class across = 3 + ratio(random_.between(0, 32), 16), along = 3 + ratio(random_.between(0, 32), 16);
      const mpq_class share = ratio(random_.between(16, 48), 64);
      add({mpq_class(x * across), mpq_class(y * along)}, mpq_class(bottom + share * thickness));
    }
  }

  Body body;

 private:
  void add(const PlanePoint& p, const mpq_class& height) {
    const auto coordinate = [&](const mpq_class& x, const mpq_class& y, const mpz_class& n) {
      return mpq_class(p.x * x + p.y * y + height * n);
    };
    body.points.push_back({coordinate(frame_.x.x, frame_.y.x, n_.x), coordinate(frame_.x.y, frame_.y.y, n_.y),
                           coordinate(frame_.x.z, frame_.y.z, n_.z)});
  }

  const Vector& n_;
  const Frame& frame_;
  unsigned points_;
  Random& random_;
};

}  // namespace

Meeting random_meeting(Random& random) {
  constexpr Meeting kinds[] = {{FeatureKind::face, FeatureKind::vertex}, {FeatureKind::vertex, FeatureKind::face},
                               {FeatureKind::face, FeatureKind::edge},   {FeatureKind::edge, FeatureKind::face},
                               {FeatureKind::face, FeatureKind::face},   {FeatureKind::edge, FeatureKind::edge}};
  return kinds[random.between(0, 5)];
}

Bodies lenses(const Lenses& plan, Random& random, unsigned points) {
  const mpq_class height = plan.a_top - plan.b_bottom;
  const Frame frame = frame_of(plan.n, mpq_class(height * height * square(plan.n)));
  Lens a(plan.n, frame, points, random), b(plan.n, frame, points, random);
  b.add_feature(plan.above.b, false, plan.b_top);
  a.add_feature(plan.above.a, true, plan.a_bottom);
  b.add_feature(plan.below.b, false, plan.b_bottom);
  a.add_feature(plan.below.a, true, plan.a_top);
  b.add_rim(plan.b_bottom, mpq_class(plan.b_top - plan.b_bottom));
  a.add_rim(plan.a_bottom, mpq_class(plan.a_top - plan.a_bottom));
  return {a.body, b.body};
}

Vector random_integer_direction(Random& random, long bound) {
  for (;;) {
    const std::int64_t x = random.between(-bound, bound), y = random.between(-bound, bound),
                       z = random.between(-bound, bound);
    if (x != 0 || y != 0 || z != 0) return {x, y, z};
  }
}

mpq_class quotient_of_roots(const mpq_class& square, const mpq_class& other, long bits) {
  const mpq_class quotient = times_power_of_two(mpq_class(square / other), 2 * bits);
  const mpz_class whole = quotient.get_num() / quotient.get_den();
  return times_power_of_two(mpq_class(mpz_class(sqrt(whole))), -bits);
}

// ---- near ties of facets that lie opposite, and of facets that share an edge ----

namespace {

/// Distances of about |n|, in direction -n larger by the factor 1 + excess.
Lenses plan(const Meeting& above, const Meeting& below, const mpq_class& excess, Random& random) {
  Lenses result{random_integer_direction(random, 40), above, below, {}, {}, {}, {}};
  const mpq_class height = 1 + ratio(random.between(0, 1023), 1024), place = ratio(random.between(-64, 64), 64);
  result.a_bottom = place;
  result.b_top = place + height;
  result.b_bottom = place + ratio(random.between(8, 24), 64);
  result.a_top = result.b_bottom + height * (1 + excess);
  return result;
}

}  // namespace

Bodies inverse(FeatureKind a, FeatureKind b, Random& random, unsigned n) {
  const mpq_class excess = times_power_of_two(1, -random.between(8, 200));
  const Meeting below = random_meeting(random);
  return lenses(plan({a, b}, below, excess, random), random, n);
}

Bodies inverse_tie(Random& random, unsigned n) {
  const Meeting above = random_meeting(random);
  Meeting below = random_meeting(random);
  while (above.a == below.a && above.b == below.b) below = random_meeting(random);
  return lenses(plan(above, below, 0, random), random, n);
}

// With p in the middle of the edge, O goes to p - x, where x = s n1 + t n2 has the heights that are
// wanted over both planes.

namespace {

/// An edge of P, half way between its ends, and the normals of the facets beside it.
struct Ridge {
  Vector twice_middle, left, right;
};

std::vector<polytope::VertexId> extreme_face(const polytope::Polytope& p, const Vector& u) {
  return kernels::to_ids<polytope::VertexId>(kernels::extreme_points(kernels::PointCloud(p.vertices), u));
}

/// After a few steps from a facet of B against a vertex of A.
Ridge any_ridge(const polytope::Polytope& a, const polytope::Polytope& b, Random& random) {
  const approximate::SumSurface surface(a, b);
  const Vector n =
      b.facets.at(static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(b.facets.size()) - 1))).normal;
  approximate::SumFacet facet = surface.facet(extreme_face(a, -n), extreme_face(b, n), n);
  std::uint64_t steps = 0;
  for (int i = 0; i < 8; ++i) {
    const std::vector<approximate::SumEdge> edges = surface.edges(facet);
    facet = surface.across(any_of(edges, random), &steps);
  }
  const std::vector<approximate::SumEdge> edges = surface.edges(facet);
  const approximate::SumEdge& edge = any_of(edges, random);
  return {surface.from(edge) + surface.to(edge), facet.normal, surface.across(edge, &steps).normal};
}

/// x with <left, x> = on_left and <right, x> = on_right, in the plane of both normals, rounded to
/// multiples of 2^-bits.
Point between(const Ridge& ridge, const mpq_class& on_left, const mpq_class& on_right, long bits) {
  const mpq_class left(dot(ridge.left, ridge.left)), right(dot(ridge.right, ridge.right)),
      mixed(dot(ridge.left, ridge.right));
  const mpq_class divisor = left * right - mixed * mixed;
  const mpq_class s = (on_left * right - on_right * mixed) / divisor, t = (on_right * left - on_left * mixed) / divisor;
  const auto component = [&](const mpz_class& l, const mpz_class& r) {
    const mpq_class scaled_up = times_power_of_two(mpq_class(s * l + t * r), bits);
    return times_power_of_two(mpq_class(mpz_class(scaled_up.get_num() / scaled_up.get_den())), -bits);
  };
  return {component(ridge.left.x, ridge.right.x), component(ridge.left.y, ridge.right.y),
          component(ridge.left.z, ridge.right.z)};
}

/// Whether the left facet is the nearest one, and the next one farther by the factor 1 + 2^-k,
/// nearly.
bool as_planned(const Bodies& bodies, const Ridge& ridge, long k) {
  const Depth depth = penetration_depth(bodies.a.points, bodies.b.points);
  const auto* found = std::get_if<Penetration>(&depth.outcome);
  if (!found || found->optima.size() != 1 || found->optima.front().direction != ridge.left) return false;
  const std::optional<mpq_class> next = second_nearest_squared(bodies.a.points, bodies.b.points, *found);
  if (!next) return false;
  const mpq_class gap = quotient_of_roots(*next, found->squared(), k + 24) - 1;
  return abs(mpq_class(times_power_of_two(gap, k) - 1)) < ratio(1, 1 << 17);
}

}  // namespace

Bodies inverse_ridge(Random& random, unsigned n) {
  const Body a = random_sphere_body(random, std::max(4u, n)), b = random_sphere_body(random, std::max(4u, n));
  const long k = random.between(8, 200);
  const polytope::PlacedPair pair = polytope::place(a.points, b.points);
  const polytope::Polytope hull_a = polytope::convex_hull(pair.a.points()),
                           hull_b = polytope::convex_hull(pair.b.points());
  for (long closer = 3; closer < 24 && hull_a.rank == 3 && hull_b.rank == 3; ++closer) {
    const Ridge ridge = any_ridge(hull_a, hull_b, random);
    const mpq_class left_squared(dot(ridge.left, ridge.left)), right_squared(dot(ridge.right, ridge.right));
    const mpq_class distance = times_power_of_two(mpq_class(pair.denominator), -closer);  // radii are 1
    const long bits = k + 40 + closer;
    const mpq_class on_left = distance * quotient_of_roots(left_squared, 1, bits);
    const mpq_class on_right = distance * (1 + times_power_of_two(1, -k)) * quotient_of_roots(right_squared, 1, bits);
    const Point x = between(ridge, on_left, on_right, bits);
    const auto shift = [&](const mpq_class& from_middle, const mpz_class& twice_middle) {
      return mpq_class((from_middle - ratio(twice_middle, 2)) / mpq_class(pair.denominator));
    };
    Bodies result{a, translated(b, {shift(x.x, ridge.twice_middle.x), shift(x.y, ridge.twice_middle.y),
                                    shift(x.z, ridge.twice_middle.z)})};
    if (as_planned(result, ridge, k)) return result;
  }
  return {a, b};
}

// ---- depths that are hard to round ----

namespace {

/// A point where rounding changes: `whole` units, and perhaps half a unit more.
struct Boundary {
  mpz_class whole;
  bool halfway;
  long unit;  ///< an ulp is 2^unit
  [[nodiscard]] mpq_class value() const {
    return times_power_of_two(2 * mpq_class(whole) + (halfway ? 1 : 0), unit - 1);
  }
};

Boundary at_the_ends(const FloatFormat& format, Random& random) {
  const mpz_class least = 1, full = (mpz_class(1) << format.digits) - 1, normal = mpz_class(1) << (format.digits - 1);
  const long low = format.least_exponent - format.digits + 1, high = format.greatest_exponent - format.digits + 1;
  switch (random.between(0, 5)) {
    case 0: return {0, true, low};  // half of the least subnormal number
    case 1: return {least, true, low};
    case 2:
      return {mpz_class(normal - 1), true, low};  // between the greatest subnormal number and the least normal one
    case 3: return {normal, false, low};
    case 4: return {full, false, high};  // the greatest number
    default: return {full, true, high};  // from here on rn gives infinity
  }
}

Boundary boundary(const FloatFormat& format, Random& random) {
  if (random.between(0, 7) == 0) return at_the_ends(format, random);
  const long exponent = random.between(-20, 20);
  const std::int64_t first = std::int64_t{1} << (format.digits - 1);
  const bool last = random.between(0, 7) == 0;  // next to a power of 2
  const std::int64_t whole = last ? 2 * first - 1 : random.between(first, 2 * first - 1);
  return {whole, random.coin(), exponent - format.digits + 1};
}

Lenses along_an_axis(const Boundary& b, int side, Random& random) {
  const long k = random.between(1, 50);
  const mpq_class step = times_power_of_two(1, b.unit);
  const mpq_class offset = step * ((b.halfway ? ratio(1, 2) : mpq_class(0)) + side * times_power_of_two(1, -k));
  constexpr std::array<std::array<int, 3>, 6> axes{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
  const std::array<int, 3>& axis = axes[static_cast<std::size_t>(random.between(0, 5))];
  Lenses result{{axis[0], axis[1], axis[2]}, random_meeting(random), random_meeting(random), {}, {}, {}, {}};
  result.b_top = step * b.whole;
  result.a_bottom = -offset;
  return result;
}

/// Integer vectors of integer length.
Vector direction_of_integer_length(Random& random) {
  constexpr std::array<std::array<int, 3>, 8> some{
      {{1, 2, 2}, {2, 3, 6}, {1, 4, 8}, {4, 4, 7}, {2, 6, 9}, {6, 6, 7}, {3, 4, 12}, {2, 5, 14}}};
  std::array<int, 3> v = some[static_cast<std::size_t>(random.between(0, 7))];
  std::swap(v[0], v[static_cast<std::size_t>(random.between(0, 2))]);
  for (int& x : v) x = random.coin() ? x : -x;
  return {v[0], v[1], v[2]};
}

/// With a distance from the boundary of 3/4 * 2^-k ulp, up to a small fraction of that.
Lenses in_any_direction(const Boundary& b, int side, Random& random) {
  const long k = random.between(1, 200);
  const Vector n = side == 0 ? direction_of_integer_length(random) : random_integer_direction(random, 40);
  Lenses result{n, random_meeting(random), random_meeting(random), {}, {}, {}, {}};
  const mpq_class depth = b.value() + side * times_power_of_two(ratio(3, 4), b.unit - k), length_squared(dot(n, n));
  if (side == 0) {
    const mpz_class length = sqrt(mpz_class(dot(n, n)));
    result.b_top = depth / length;
  } else {
    result.b_top = quotient_of_roots(mpq_class(depth * depth), length_squared, k - b.unit + 16);  // |n| < 2^7
  }
  result.a_bottom = 0;
  return result;
}

}  // namespace

Bodies rounding_boundary(const FloatFormat& format, Random& random, unsigned n) {
  const Boundary b = boundary(format, random);
  const bool below_smallest = b.whole == 0;  // half of the least number has no number below it but 0
  const int side = static_cast<int>(random.between(-1, 1));
  const bool axis = random.coin() && !below_smallest;
  Lenses plan = axis ? along_an_axis(b, side, random) : in_any_direction(b, side, random);
  // The way out in direction -n is longer by six percent at least.
  const mpq_class height = plan.b_top - plan.a_bottom;
  const long log = kernels::binary_order(height);
  plan.b_bottom = times_power_of_two(1, log - 3);
  plan.a_top =
      plan.b_bottom + quotient_of_roots(mpq_class(height * height), 1, 10 - log) + times_power_of_two(1, log - 3);
  return lenses(plan, random, n);
}

// ---- extremes of depth and of shape ----

namespace {

/// The overlap is a share of the distance in the other direction; negative: a gap.
Bodies hair(const Meeting& above, const mpq_class& overlap, Random& random, unsigned n) {
  const Vector direction = random_integer_direction(random, 40);
  const mpq_class thickness = 1 + ratio(random.between(-16, 16), 64);
  const Meeting below = random_meeting(random);
  return lenses({direction, above, below, 0, mpq_class(-thickness), 1, mpq_class(-overlap)}, random, n);
}

mpq_class power_of_ten(long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
  return power;
}

/// Extents 1, s, 10^-j with s between: 10^-j for a needle, 1 for a plate.
Body stretched_body(Random& random, unsigned n) {
  const Body sphere = random_sphere_body(random, std::max(4u, n));
  const long ratio_exponent = random.between(4, 9), middle = random.between(0, 2);
  const mpq_class between = 1 / power_of_ten(middle == 0   ? ratio_exponent
                                             : middle == 1 ? 0
                                                           : random.between(1, ratio_exponent - 1));
  return rotated(scaled(sphere, 1, between, mpq_class(1 / power_of_ten(ratio_exponent))), random_rotation(random));
}

}  // namespace

Bodies deep(Random& random, unsigned n) {
  const Body a = random_sphere_body(random, std::max(4u, n)), b = random_sphere_body(random, std::max(4u, n));
  return {a, scaled(b, times_power_of_two(1, -random.between(0, 10)))};
}

Bodies hair_overlap(Random& random, unsigned n) {
  const Meeting above = random_meeting(random);
  const mpq_class overlap = times_power_of_two(1, -random.between(41, 200));
  return hair(above, overlap, random, n);
}

Bodies hair_gap(Random& random, unsigned n) {
  constexpr FeatureKind features[] = {FeatureKind::vertex, FeatureKind::edge, FeatureKind::face};
  const FeatureKind a = features[random.between(0, 2)], b = features[random.between(0, 2)];
  const mpq_class gap = times_power_of_two(1, -random.between(61, 200));
  return hair({a, b}, mpq_class(-gap), random, n);
}

Bodies stretched(Random& random, unsigned n) {
  const Body a = stretched_body(random, n);
  return {a, stretched_body(random, n)};
}

}  // namespace fathom::families
