// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the position of O share: small sets, the brute-force twin, bodies with a chosen
// feature in front.

#include "reference/polytope/position.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "kernels/number/rational.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/property.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::polytope::position_test {
namespace {

using Small = Vec3<long>;
using SmallSet = std::vector<Small>;

bool none(const Small& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

// The naive twin. u is admissible if u != 0 and <u, p> <= 0 for all differences p. If the
// differences span R^3, the admissible u form a cone without lines, whose extreme rays are normal
// to two differences each: list them all. If they do not, they do together with +-n for a basis n
// of their orthogonal complement, which only keeps the admissible u of their span. O is outside iff
// the sum of the rays is negative on every difference (some admissible u must be, and it is a sum
// of rays).
Position position_naive(const SmallSet& a, const SmallSet& b) {
  SmallSet differences, basis;
  for (const Small& p : a)
    for (const Small& q : b) differences.push_back(q - p);
  const auto independent = [&basis](const Small& v) {
    return basis.empty()       ? !none(v)
           : basis.size() == 1 ? !none(cross(basis[0], v))
                               : basis.size() == 2 && det(basis[0], basis[1], v) != 0;
  };
  for (const Small& p : differences)
    if (independent(p)) basis.push_back(p);
  const bool flat = basis.size() < 3;
  SmallSet constraints = differences;
  const auto add_line = [&](const Small& n) {
    constraints.push_back(n);
    constraints.push_back(-n);
    basis.push_back(n);
  };
  if (basis.empty()) return Position::boundary;
  if (basis.size() == 1) {
    const Small e = none(cross(basis[0], Small{1, 0, 0})) ? Small{0, 1, 0} : Small{1, 0, 0};
    add_line(cross(basis[0], e));
  }
  if (basis.size() == 2) {
    add_line(cross(basis[0], basis[1]));
  }
  Small sum{0, 0, 0};
  bool admissible = false;
  for (const Small& p : constraints) {
    for (const Small& q : constraints) {
      const Small u = cross(p, q);
      if (none(u) ||
          std::any_of(constraints.begin(), constraints.end(), [&u](const Small& r) { return dot(u, r) > 0; }))
        continue;
      admissible = true;
      sum = sum + u;
    }
  }
  if (std::all_of(differences.begin(), differences.end(), [&sum](const Small& p) { return dot(sum, p) < 0; }))
    return Position::outside;
  return flat || admissible ? Position::boundary : Position::inside;
}

Vector exact(const Small& p) { return {p.x, p.y, p.z}; }

std::vector<Vector> exact(const SmallSet& set) {
  std::vector<Vector> points;
  for (const Small& p : set) points.push_back(exact(p));
  return points;
}

/// What `search` says in integers of fixed size, where these are for the bodies, is the answer.
template <class Answer, class Search>
void expect_in_fixed_integers(const Answer& answer, const std::vector<Vector>& a, const std::vector<Vector>& b,
                              Search search) {
  const PlacedPair placed = place_integers(a, b);
  kernels::ScanMemory memory;
  if (a.size() + b.size() > most_points_without_samples || placed.exponent() > most_narrow_bits) return;
  EXPECT_TRUE(search(differences_in<NarrowInteger>(placed.a, placed.b, memory)) == answer);
}

// Solves in both kinds of integers, checks the proof, and returns the answer.
PositionOfOrigin proved(const std::vector<Vector>& a, const std::vector<Vector>& b) {
  const long exponent = std::max(kernels::binary_exponent(a), kernels::binary_exponent(b));
  const kernels::PointCloud cloud_a(a, exponent), cloud_b(b, exponent);
  const PositionOfOrigin answer = position_of_origin(cloud_a, cloud_b);
  for (const std::string& fault : validate(answer, a, b).faults) ADD_FAILURE() << fault;
  if (answer.position == Position::inside) {
    EXPECT_GE(answer.surrounding.size(), 4U);
    EXPECT_LE(answer.surrounding.size(), 6U) << "law: Steinitz";
  }
  expect_in_fixed_integers(answer, a, b, [](auto differences) { return position_of_origin(differences); });
  const std::optional<NearestPoints> nearest = nearest_points_if_apart(Differences{cloud_a, cloud_b});
  EXPECT_EQ(nearest.has_value(), answer.position == Position::outside) << "law: nearest points are those of sets apart";
  expect_in_fixed_integers(nearest, a, b, [](auto differences) { return nearest_points_if_apart(differences); });
  return answer;
}

Position position(const SmallSet& a, const SmallSet& b) {
  const PositionOfOrigin answer = proved(exact(a), exact(b));
  SmallSet surrounding;
  for (const auto& [i, j] : answer.surrounding) surrounding.push_back(b[j] - a[i]);
  if (answer.position == Position::inside) {
    EXPECT_EQ(position_naive({{0, 0, 0}}, surrounding), Position::inside);
  }
  return answer.position;
}

rc::Gen<SmallSet> lattice_set() {
  const auto c = rc::gen::element(-2L, -1L, 0L, 1L, 2L);
  const auto point = rc::gen::map(rc::gen::tuple(c, c, c), [](const auto& t) {
    return Small{std::get<0>(t), std::get<1>(t), std::get<2>(t)};
  });
  return rc::gen::mapcat(rc::gen::element<std::size_t>(1, 2, 3, 4, 5, 6),
                         [point](std::size_t n) { return rc::gen::container<SmallSet>(n, point); });
}

// Each kind of feature as a face of a solid body that lies in z <= 0 (A), or in z >= 0 when
// mirrored (B).
SmallSet solid_with(const std::string& feature) {
  if (feature == "vertex") return {{0, 0, 0}, {3, 0, -3}, {-3, 2, -3}, {-3, -2, -3}};
  if (feature == "edge") return {{-4, -1, 0}, {4, 1, 0}, {1, -4, -3}, {-1, 4, -3}};
  return {{-4, -3, 0}, {4, -3, 0}, {1, 4, 0}, {0, 0, -5}};
}

SmallSet mirrored(const SmallSet& set, long lift) {
  SmallSet r;
  for (const Small& p : set) r.push_back({-p.y, p.x, lift - p.z});
  return r;
}

// The position of O against a brute-force twin on small lattices, under exact linear maps, in every
// kind of touching; growth.

TEST(PositionOfOrigin, AgreesWithTheNaiveTwinOnSmallLattices) {
  std::array<int, 3> seen{};
  EXPECT_TRUE(holds({.seed = 20240229, .runs = 6000}, [&seen] {
    const SmallSet a = *lattice_set(), b = *lattice_set();
    const Position expected = position_naive(a, b);
    ++seen[static_cast<std::size_t>(expected)];
    RC_ASSERT(position(a, b) == expected);
  }));
  for (const int count : seen) EXPECT_GT(count, 300) << "every position must have been met often";
}

// Bodies shifted so that a random pair of points coincides: O is never outside, and on the boundary
// in every dimension of face.
TEST(PositionOfOrigin, AgreesWithTheNaiveTwinOnSharedPoints) {
  EXPECT_TRUE(holds({.seed = 20240229, .runs = 3000}, [] {
    SmallSet a = *lattice_set();
    const SmallSet b = *lattice_set();
    const Small shift = b[*rc::gen::inRange<std::size_t>(0, b.size())] - a[*rc::gen::inRange<std::size_t>(0, a.size())];
    for (Small& p : a) p = p + shift;
    RC_ASSERT(position(a, b) == position_naive(a, b));
  }));
}

struct Affine {
  std::array<Vector, 3> rows;
  Vector shift;
  Vector operator()(const Small& s) const {
    const Vector p = exact(s);
    return Vector{dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)} + shift;
  }
};

mpz_class wild(std::mt19937_64& random, unsigned long bits) {
  mpz_class r = static_cast<unsigned long>(random() % 1000);
  r <<= random() % bits;
  r += static_cast<unsigned long>(random() % 1000);
  return random() & 1 ? r : mpz_class(-r);
}

// An invertible affine map keeps the position; its entries have up to thousands of bits, so images
// in binary64 decide nothing.
TEST(PositionOfOrigin, IsInvariantUnderExactAffineMaps) {
  std::mt19937_64 random(1);
  int repeat = 0;
  EXPECT_TRUE(holds({.seed = 20240229, .runs = 600}, [&] {
    const SmallSet a = *lattice_set(), b = *lattice_set();
    const unsigned long bits = ++repeat % 10 == 0 ? 3000 : 60;
    Affine map;
    do {
      for (Vector& row : map.rows) row = {wild(random, bits), wild(random, bits), wild(random, bits)};
    } while (det(map.rows[0], map.rows[1], map.rows[2]) == 0);
    map.shift = {wild(random, bits), wild(random, bits), wild(random, bits)};
    std::vector<Vector> mapped_a, mapped_b;
    for (const Small& p : a) mapped_a.push_back(map(p));
    for (const Small& p : b) mapped_b.push_back(map(p));
    RC_ASSERT(proved(mapped_a, mapped_b).position == position_naive(a, b));
    RC_ASSERT(proved(mapped_b, mapped_a).position == position_naive(a, b));
  }));
}

TEST(PositionOfOrigin, AllNineKindsOfTouching) {
  for (const std::string a : {"vertex", "edge", "facet"}) {
    for (const std::string b : {"vertex", "edge", "facet"}) {
      EXPECT_EQ(position(solid_with(a), mirrored(solid_with(b), 0)), Position::boundary) << a << " against " << b;
      EXPECT_EQ(position(solid_with(a), mirrored(solid_with(b), 1)), Position::outside) << a << " against " << b;
      EXPECT_EQ(position(solid_with(a), mirrored(solid_with(b), -1)), Position::inside) << a << " against " << b;
    }
  }
}

TEST(PositionOfOrigin, HairThinGapsAndOverlaps) {
  mpz_class scale = 1;
  scale <<= 3000;
  for (const std::string a : {"vertex", "edge", "facet"}) {
    for (const std::string b : {"vertex", "edge", "facet"}) {
      for (const int gap : {-1, 0, 1}) {
        std::vector<Vector> points_a, points_b;
        for (const Small& p : solid_with(a)) points_a.push_back({scale * p.x, scale * p.y, scale * p.z});
        for (const Small& p : mirrored(solid_with(b), 0))
          points_b.push_back({scale * p.x, scale * p.y, scale * p.z + gap});
        const Position expected = gap < 0 ? Position::inside : gap == 0 ? Position::boundary : Position::outside;
        EXPECT_EQ(proved(points_a, points_b).position, expected) << a << " against " << b << ", gap " << gap;
      }
    }
  }
}

TEST(PositionOfOrigin, FlatBodies) {
  const SmallSet point{{0, 0, 0}}, segment{{-1, 0, 0}, {1, 0, 0}}, across{{0, -1, 0}, {0, 1, 0}};
  const SmallSet upright{{0, 0, -1}, {0, 0, 1}}, square{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  const SmallSet cube{{-2, -2, -2}, {2, -2, -2}, {-2, 2, -2}, {2, 2, -2},
                      {-2, -2, 2},  {2, -2, 2},  {-2, 2, 2},  {2, 2, 2}};
  const SmallSet apart{{9, 0, 0}}, far_segment{{5, 1, 0}, {6, 2, 0}};
  for (const SmallSet& s : {point, segment, across, upright, square}) {
    EXPECT_EQ(position(s, s), Position::boundary);
    EXPECT_EQ(position(point, s), Position::boundary);
    EXPECT_EQ(position(s, point), Position::boundary);
    EXPECT_EQ(position(s, cube), Position::inside);
    EXPECT_EQ(position(cube, s), Position::inside);
    EXPECT_EQ(position(s, apart), Position::outside);
    EXPECT_EQ(position(far_segment, s), Position::outside);
  }
  EXPECT_EQ(position(segment, across), Position::boundary);
  EXPECT_EQ(position(square, segment), Position::boundary);
  EXPECT_EQ(position(square, upright), Position::inside) << "P is solid though both bodies are flat";
  EXPECT_EQ(position(square, {{0, 0, 0}, {0, 0, 1}}), Position::boundary);
  EXPECT_EQ(position({{2, 2, 2}}, cube), Position::boundary);
  EXPECT_EQ(position({{2, 2, 0}}, cube), Position::boundary);
  EXPECT_EQ(position({{2, 0, 0}}, cube), Position::boundary);
  EXPECT_EQ(position(cube, cube), Position::inside) << "identical bodies";
}

TEST(PositionOfOrigin, RefusesWhatItCannotAnswer) {
  const std::vector<Vector> some{{1, 2, 3}};
  EXPECT_THROW(position_of_origin(kernels::PointCloud(), kernels::PointCloud(some)), std::invalid_argument);
  EXPECT_THROW(position_of_origin(kernels::PointCloud(some), kernels::PointCloud()), std::invalid_argument);
  EXPECT_THROW(position_of_origin(kernels::PointCloud(some, 5), kernels::PointCloud(some, 6)), std::invalid_argument);
}

TEST(PositionOfOrigin, IsDeterministic) {
  const std::vector<Vector> a = exact(solid_with("edge")), b = exact(mirrored(solid_with("facet"), -1));
  EXPECT_EQ(proved(a, b).surrounding, proved(a, b).surrounding);
}

enum class Shape { ball, lattice, paraboloid };

// Points of a body that lies in z <= 0 and touches z = 0 in O. lattice: heavy ties; paraboloid:
// every point extreme.
std::vector<Vector> hanging(std::mt19937_64& random, std::size_t n, Shape shape) {
  const double unit = shape == Shape::lattice ? 8 : std::ldexp(1.0, 40);
  const auto coordinate = [&random] { return std::ldexp(static_cast<double>(random() >> 11), -52) - 1; };
  std::vector<Vector> points{{0, 0, 0}};
  while (points.size() < n) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    const double square = x * x + y * y;
    if (shape == Shape::ball && square + z * z > 1) continue;
    const double height = shape == Shape::paraboloid ? -square : z - 1;
    points.push_back(
        {mpz_class(std::round(unit * x)), mpz_class(std::round(unit * y)), mpz_class(std::round(unit * height))});
  }
  return points;
}

// B: the same kind of body, standing on z = 0, raised by `lift`.
std::vector<Vector> standing(std::mt19937_64& random, std::size_t n, Shape shape, long lift) {
  std::vector<Vector> points = hanging(random, n, shape);
  for (Vector& p : points) p.z = lift - p.z;
  return points;
}

// Linear expected time, in its machine-independent part: scans do not grow with the number of
// points.
TEST(PositionOfOrigin, ScansStayFewOnLargeInput) {
  std::mt19937_64 random(7);
  const std::array<std::pair<long, Position>, 3> cases{
      {{1, Position::outside}, {0, Position::boundary}, {-1, Position::inside}}};
  for (const Shape shape : {Shape::ball, Shape::lattice, Shape::paraboloid}) {
    for (const std::size_t n : {500UL, 3000UL, 20000UL}) {
      for (const auto& [lift, expected] : cases) {
        const PositionOfOrigin answer = proved(hanging(random, n, shape), standing(random, n, shape, lift));
        EXPECT_EQ(answer.position, expected)
            << n << " points a side of shape " << static_cast<int>(shape) << ", lift " << lift;
        EXPECT_LE(answer.scans, 30U);
      }
    }
  }
}

TEST(PositionOfOrigin, ScansStayFewOnAMillionPointsASide) {
  std::mt19937_64 random(8);
  constexpr std::size_t n = 1000000;
  constexpr long exponent = 41;
  const kernels::PointCloud a(hanging(random, n, Shape::ball), exponent),
      b(standing(random, n, Shape::ball, 0), exponent);
  const PositionOfOrigin touching = position_of_origin(a, b);
  EXPECT_EQ(touching.position, Position::boundary);
  EXPECT_LE(touching.scans, 30U);
  const PositionOfOrigin overlapping = position_of_origin(a, a);
  EXPECT_EQ(overlapping.position, Position::inside);
  EXPECT_LE(overlapping.scans, 30U);
  std::cerr << "scans of a million points a side: " << touching.scans << " touching, " << overlapping.scans
            << " inside\n";
}

// Forged proofs of the position of O are refused, whatever the answer that they claim.

struct Solved {
  std::vector<Vector> a, b;
  PositionOfOrigin answer;
  [[nodiscard]] bool accepted() const { return validate(answer, a, b).ok(); }
};

Solved solved(const SmallSet& a, const SmallSet& b) { return {exact(a), exact(b), proved(exact(a), exact(b))}; }

template <class Change>
bool accepted_after(Solved s, Change change) {
  change(s.answer);
  return s.accepted();
}

TEST(PositionProof, ForgedProofsAreRefused) {
  const Solved inside = solved(solid_with("facet"), mirrored(solid_with("facet"), -1));
  const Solved boundary = solved(solid_with("facet"), mirrored(solid_with("vertex"), 0));
  const Solved outside = solved(solid_with("facet"), mirrored(solid_with("edge"), 1));
  ASSERT_TRUE(inside.accepted() && boundary.accepted() && outside.accepted());
  for (const Solved& s : {inside, boundary, outside}) {
    for (const Position claim : {Position::inside, Position::boundary, Position::outside})
      EXPECT_EQ(accepted_after(s, [&](auto& x) { x.position = claim; }), claim == s.answer.position);
  }
  for (const Solved& s : {boundary, outside}) {
    EXPECT_FALSE(accepted_after(s, [](auto& x) { x.normal.reset(); }));
    EXPECT_FALSE(accepted_after(s, [](auto& x) { x.normal = Vector{0, 0, 0}; }));
    EXPECT_FALSE(accepted_after(s, [](auto& x) { x.normal = -*x.normal; }));
    EXPECT_FALSE(accepted_after(s, [](auto& x) { x.normal = *x.normal + *x.normal; }));
  }
  for (const Solved& s : {inside, boundary}) {
    EXPECT_FALSE(accepted_after(s, [](auto& x) { x.a.clear(); }));
    EXPECT_FALSE(accepted_after(s, [](auto& x) { x.b.front().weight += mpq_class(1, 7); }));
    EXPECT_FALSE(accepted_after(s, [](auto& x) { x.a.front().index = 99; }));
    EXPECT_FALSE(accepted_after(s, [](auto& x) { x.a.push_back({x.a.front().index, 0}); }));
    EXPECT_FALSE(accepted_after(s, [](auto& x) {
      for (Weight& w : x.a) w.weight *= 2;
      for (Weight& w : x.b) w.weight *= 2;
    })) << "facets touch at z = 0, but 2 is not 1";
    EXPECT_FALSE(accepted_after(s, [](auto& x) {
      x.a.push_back({x.a.front().index, -1});
      x.a.push_back({x.a.front().index, 1});
    }));
  }
  EXPECT_FALSE(accepted_after(inside, [](auto& x) { x.surrounding.pop_back(); }));
  EXPECT_FALSE(accepted_after(inside, [](auto& x) { x.surrounding.front().second = 99; }));
  EXPECT_FALSE(accepted_after(inside, [](auto& x) { x.surrounding.assign(5, x.surrounding.front()); }));
  EXPECT_FALSE(accepted_after(inside, [](auto& x) { x.normal = Vector{0, 0, 1}; }));
  EXPECT_FALSE(accepted_after(boundary, [](auto& x) { x.surrounding.emplace_back(0, 0); }));
  EXPECT_FALSE(accepted_after(outside, [](auto& x) { x.a.push_back({0, 1}); }));
}

// The checker of `surrounding` alone: it complains exactly when O is not in the interior of the
// hull.
TEST(PositionProof, SurroundingIsJudgedLikeTheNaiveTwinDoes) {
  EXPECT_TRUE(holds({.seed = 20240229, .runs = 4000}, [] {
    const SmallSet b = *lattice_set();
    PositionOfOrigin claim;
    claim.position = Position::inside;
    for (std::uint32_t j = 0; j < b.size(); ++j) claim.surrounding.emplace_back(0, j);
    bool refused = false;
    for (const std::string& fault : validate(claim, std::vector<Vector>{{0, 0, 0}}, exact(b)).faults)
      refused = refused || fault.find("surrounding") != std::string::npos;
    RC_ASSERT(refused == (position_naive({{0, 0, 0}}, b) != Position::inside));
  }));
}

}  // namespace
}  // namespace fathom::polytope::position_test

// Distances of disjoint bodies against brute force, and one signed function across contact.

namespace fathom::polytope {
namespace {

using testing::random_vector;
using testing::text;

/// By definition: the nearest feature of P is a vertex, an edge or a facet, so the least distance
/// of O to the hulls of one, two or three differences is the answer, whether or not these lie on
/// the boundary of P.
mpq_class brute_force(std::span<const Vector> a, std::span<const Vector> b) {
  std::vector<Vector> p;
  for (const Vector& x : a)
    for (const Vector& y : b) p.push_back(y - x);
  mpq_class best = dot(p[0], p[0]);
  const auto offer = [&](const mpz_class& numerator, const mpz_class& denominator) {
    best = std::min(best, kernels::ratio(numerator, denominator));
  };
  for (std::size_t i = 0; i < p.size(); ++i) {
    offer(dot(p[i], p[i]), 1);
    for (std::size_t j = 0; j < i; ++j) {
      const Vector e = p[j] - p[i];
      const mpz_class square = dot(e, e), w = -dot(p[i], e);
      if (w <= 0 || w >= square) continue;
      const Vector moment = cross(p[i], e);
      offer(dot(moment, moment), square);
    }
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const Vector e = p[j] - p[i], f = p[k] - p[i], n = cross(e, f);
        if (is_zero(n)) continue;
        const mpz_class v = det(-p[i], f, n), u = det(e, -p[i], n), whole = dot(n, n), height = dot(n, p[i]);
        if (v >= 0 && u >= 0 && v + u <= whole) offer(height * height, whole);
      }
    }
  }
  return best;
}

NearestPoints solve(const std::vector<Vector>& a, const std::vector<Vector>& b) {
  const PlacedPair placed = place_integers(a, b);
  NearestPoints answer = nearest_points(placed.a, placed.b);
  position_test::expect_in_fixed_integers(answer, a, b, [](auto differences) { return nearest_points(differences); });
  return answer;
}

// Corners of the largest cube, and points next to them, make the longest numbers that there are:
// one that did not fit would be thrown at.
TEST(FixedIntegers, HoldAllNumbersOfTheLargestLattice) {
  std::mt19937_64 random(9);
  const mpz_class most = mpz_class(1) << most_narrow_bits;
  const auto corner = [&] {
    Vector v;
    for (mpz_class* c : {&v.x, &v.y, &v.z}) *c = (random() % 2 == 0 ? 1 : -1) * mpz_class(most - random() % 3);
    return v;
  };
  std::size_t found[3] = {};
  for (int round = 0; round < 2000; ++round) {
    std::vector<Vector> a(1 + random() % 5), b(1 + random() % 5);
    for (std::vector<Vector>* body : {&a, &b}) std::ranges::generate(*body, corner);
    const Position where = position_test::proved(a, b).position;
    ++found[static_cast<std::size_t>(where)];
    if (where == Position::outside) solve(a, b);
  }
  for (const std::size_t count : found) EXPECT_GT(count, 3U);
}

mpq_class squared(const NearestPoints& z) { return kernels::ratio(z.height * z.height, dot(z.normal, z.normal)); }

std::vector<Vector> random_points(std::mt19937_64& random, std::size_t n, unsigned bits, const Vector& shift) {
  std::vector<Vector> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back(random_vector(random, bits) + shift);
  return points;
}

TEST(NearestPoints, EqualsBruteForceOnSmallBodies) {
  std::mt19937_64 random(5);
  std::size_t kinds[4] = {};
  for (int round = 0; round < 400; ++round) {
    const unsigned bits = round % 2 == 0 ? 2 : 40;  // a small lattice is full of ties
    mpz_class far = 1;
    far <<= bits;
    const std::vector<Vector> a = random_points(random, 1 + random() % 4, bits, {0, 0, 0});
    const std::vector<Vector> b =
        random_points(random, 1 + random() % 4, bits, random_vector(random, bits) + Vector{far, far, 0});
    const PlacedPair placed = place_integers(a, b);
    if (position_of_origin(placed.a, placed.b).position != Position::outside) {
      EXPECT_THROW(solve(a, b), std::invalid_argument);
      ++kinds[0];
      continue;
    }
    const NearestPoints z = solve(a, b);
    const kernels::Report report = validate(z, a, b);
    EXPECT_TRUE(report.ok()) << text(report);
    EXPECT_EQ(squared(z), brute_force(a, b)) << round;
    ++kinds[std::min<std::size_t>(3, std::max(z.a.size(), z.b.size()))];
  }
  for (const std::size_t count : kinds) EXPECT_GT(count, 3U);
}

TEST(NearestPoints, ManyPoints) {
  std::mt19937_64 random(6);
  for (const std::size_t n : {100U, 3000U}) {
    const std::vector<Vector> a = random_points(random, n, 30, {0, 0, 0});
    mpz_class far = 3;
    far <<= 30;
    const std::vector<Vector> b = random_points(random, n, 30, {far, 17, -far});
    const NearestPoints z = solve(a, b);
    const kernels::Report report = validate(z, a, b);
    EXPECT_TRUE(report.ok()) << text(report);
    EXPECT_LT(z.scans, 60U);
  }
}

// Every fault that an answer can have is found.
TEST(NearestPoints, ValidateHasTeeth) {
  const std::vector<Vector> a{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, b{{1, 1, 5}, {2, 3, 9}};
  const NearestPoints good = solve(a, b);
  ASSERT_TRUE(validate(good, a, b).ok());
  const auto broken = [&](auto change) {
    NearestPoints wrong = good;
    change(wrong);
    return !validate(wrong, a, b).ok();
  };
  EXPECT_TRUE(broken([](NearestPoints& z) { z.normal = -z.normal; }));
  EXPECT_TRUE(broken([](NearestPoints& z) { z.normal = {0, 0, 0}; }));
  EXPECT_TRUE(broken([](NearestPoints& z) { z.normal = {0, 0, -2}; }));
  EXPECT_TRUE(broken([](NearestPoints& z) { z.normal = {0, 1, -9}; }));
  EXPECT_TRUE(broken([](NearestPoints& z) { z.height += 1; }));
  EXPECT_TRUE(broken([](NearestPoints& z) { z.a[0].weight += 1; }));
  EXPECT_TRUE(broken([](NearestPoints& z) { z.a[0].index = 7; }));
  EXPECT_TRUE(broken([](NearestPoints& z) { z.b[0].index = 1; }));
}

Depth depth_of(const Case& pair) { return testing::exact_depth(pair.a.points, pair.b.points); }

Case moved(Case pair, const Point& t) {
  for (Point& p : pair.a.points.edit()) p = {p.x + t.x, p.y + t.y, p.z + t.z};
  return pair;
}

// Over all families, each body A moved away far enough: the laws of the result, and what moving A
// by the translation does.
TEST(Distance, TranslationBringsTheBodiesIntoTouch) {
  std::size_t disjoint = 0;
  for (Case input : testing::cases_of_all_families(2, 9)) {
    if (depth_of(input).status() != Status::disjoint) input = moved(input, {mpq_class(7, 3), 1, 40});
    const Depth depth = depth_of(input);
    EXPECT_EQ(depth.distance() != nullptr, depth.status() == Status::disjoint) << input.id;
    if (!depth.distance()) continue;
    ++disjoint;
    const Distance& d = *depth.distance();
    const Point& t = d.translation;
    EXPECT_EQ(t.x * t.x + t.y * t.y + t.z * t.z, d.squared) << input.id;
    EXPECT_EQ(signed_square(depth), -d.squared) << input.id;
    const mpq_class h = testing::support(input.a.points, input.b.points, d.direction);
    EXPECT_LT(h, 0) << input.id;
    EXPECT_EQ(h * h, d.squared * dot(d.direction, d.direction)) << input.id;
    const Point &a = d.witness.a, &b = d.witness.b;
    EXPECT_EQ((Point{b.x - a.x, b.y - a.y, b.z - a.z}), t) << input.id;
    EXPECT_TRUE(testing::in_hull(a, input.a.points, testing::all_of(input.a.points))) << input.id;
    EXPECT_TRUE(testing::in_hull(b, input.b.points, testing::all_of(input.b.points))) << input.id;
    EXPECT_EQ(depth_of(moved(input, t)).status(), Status::touching) << input.id;
    const mpq_class half(1, 2);
    EXPECT_EQ(signed_square(depth_of(moved(input, {half * t.x, half * t.y, half * t.z}))), -d.squared / 4) << input.id;
  }
  EXPECT_GT(disjoint, 60U);
}

// Two unit cubes on a line: the signed distance is linear all the way.
TEST(Distance, OneSignedFunctionAcrossContact) {
  std::vector<Point> a, b;
  for (int i = 0; i < 8; ++i) a.push_back({i & 1, i >> 1 & 1, i >> 2 & 1});
  for (int step = -4; step <= 4; ++step) {
    const mpq_class gap = kernels::ratio(step, 9);
    b = a;
    for (Point& p : b) p.x += 1 + gap;
    const Depth depth = penetration_depth(a, b);
    EXPECT_EQ(signed_square(depth), step > 0 ? mpq_class(-gap * gap) : mpq_class(gap * gap));
    EXPECT_EQ(depth.status(), step > 0 ? Status::disjoint : step == 0 ? Status::touching : Status::penetrating);
    if (step > 0) {
      EXPECT_EQ(depth.distance()->direction, (Vector{-1, 0, 0}));
    }
  }
}

}  // namespace
}  // namespace fathom::polytope
