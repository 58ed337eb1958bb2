// SPDX-License-Identifier: GPL-3.0-or-later
// In the plane, in units of r: features reach out by 1/2 to 3/2 and hold O, the rims by 3 to 5 along each axis. So for a direction at the
// angle t to n or -n, with d the distance there, h >= d cos t + c r sin t, with the least reach c of the features' sum; and from the rims
// h > 6 r sin t - r cos t. Where the first is not well above r the second is, except for angles near 0, and no facet but the chosen ones
// has such an angle.
#include <algorithm>
#include <array>

#include "kernels/vector.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace fathom::families {

namespace {

struct PlanePoint {
  mpq_class x, y;
};

/// Two directions orthogonal to n and to each other, of length about `unit`: multiples of powers of 2.
struct Frame {
  Point x, y;
};

mpq_class square(const Vector& v) { return {dot(v, v)}; }

/// sqrt(numerator / denominator) to eight significant bits, from below.
mpq_class short_quotient_of_roots(const mpq_class& numerator, const mpq_class& denominator) {
  const mpq_class quotient = numerator / denominator;
  const long scale = 8 - binary_logarithm(quotient) / 2;
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

/// A vertex at O, an edge through O or a polygon around it, with up to `more` points beyond three. Edges of A lie near the first axis,
/// those of B near the second.
std::vector<PlanePoint> feature_points(FeatureKind feature, bool of_a, std::int64_t more, Random& random) {
  if (feature == FeatureKind::vertex) return {{0, 0}};
  const mpq_class one = reach(random), other = reach(random), lean = ratio(random.between(-4, 4), 16);
  if (feature == FeatureKind::edge) {
    if (of_a) return {{one, mpq_class(one * lean)}, {mpq_class(-other), mpq_class(-other * lean)}};
    return {{mpq_class(one * lean), one}, {mpq_class(-other * lean), mpq_class(-other)}};
  }
  const mpq_class third = reach(random);
  std::vector<PlanePoint> points{
      {one, 0}, {mpq_class(-other / 2), mpq_class(other * ratio(7, 8))}, {mpq_class(-third / 2), mpq_class(-third * ratio(7, 8))}};
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
  const long bits = 6 - binary_logarithm(unit);
  const mpq_class scaled_up = times_power_of_two(value, bits);
  mpz_class whole;
  mpz_fdiv_q(whole.get_mpz_t(), scaled_up.get_num_mpz_t(), scaled_up.get_den_mpz_t());
  return times_power_of_two(mpq_class(whole), -bits);
}

class Lens {
 public:
  Lens(const Vector& n, const Frame& frame, unsigned points, Random& random) : n_(n), frame_(frame), points_(points), random_(random) {}

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
    body.points.push_back(
        {coordinate(frame_.x.x, frame_.y.x, n_.x), coordinate(frame_.x.y, frame_.y.y, n_.y), coordinate(frame_.x.z, frame_.y.z, n_.z)});
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

long binary_logarithm(const mpq_class& x) {
  return static_cast<long>(mpz_sizeinbase(x.get_num_mpz_t(), 2)) - static_cast<long>(mpz_sizeinbase(x.get_den_mpz_t(), 2));
}

Vector random_integer_direction(Random& random, long bound) {
  for (;;) {
    const std::int64_t x = random.between(-bound, bound), y = random.between(-bound, bound), z = random.between(-bound, bound);
    if (x != 0 || y != 0 || z != 0) return {x, y, z};
  }
}

mpq_class quotient_of_roots(const mpq_class& square, const mpq_class& other, long bits) {
  const mpq_class quotient = times_power_of_two(mpq_class(square / other), 2 * bits);
  const mpz_class whole = quotient.get_num() / quotient.get_den();
  return times_power_of_two(mpq_class(mpz_class(sqrt(whole))), -bits);
}

}  // namespace fathom::families
