// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies on small lattices, and what an inner polytope is by definition: for the tests of the
// expanding polytope.

#include "reference/expanding/expanding_polytope.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/filters/plane.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/predicates/direction.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/expanding/surface.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "tests/expanding/same_expansion.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/rounding_modes.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::expanding {
namespace {

using Random = std::mt19937_64;

/// Few points on a small lattice: ties, coplanar and collinear points, flat bodies everywhere.
std::vector<Vector> small_body(Random& random, long reach) {
  std::vector<Vector> points(1 + random() % 9);
  const auto coordinate = [&] {
    return mpz_class(static_cast<long>(random() % static_cast<unsigned long>(2 * reach + 1)) - reach);
  };
  for (Vector& p : points) p = {coordinate(), coordinate(), coordinate()};
  return points;
}

/// Q by definition: corners of its facets are all vertices on the facet's plane, and these are all
/// facets of the hull of its vertices.
void expect_hull(const InnerPolytope& inner, const kernels::PointCloud& a, const kernels::PointCloud& b) {
  std::vector<Vector> vertices;
  for (const auto& [i, j] : inner.vertices) vertices.push_back(b[j] - a[i]);
  const polytope::Polytope hull = polytope::convex_hull(vertices);
  ASSERT_EQ(hull.vertices.size(), vertices.size()) << "a vertex is not extreme";
  std::vector<std::vector<std::uint32_t>> found = inner.facets, expected;
  for (std::vector<std::uint32_t>& facet : found)
    std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
  for (const polytope::Facet& facet : hull.facets)
    expected.emplace_back(hull.corners.begin() + facet.begin, hull.corners.begin() + facet.end);
  std::sort(found.begin(), found.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(found, expected);
}

// The expanding polytope against the hull of all differences.

std::vector<Vector> directions(const kernels::NearestPlanes& nearest) {
  return {nearest.directions().begin(), nearest.directions().end()};
}

TEST(ExpandingPolytope, FindsTheNearestFacetsOfTheHullOfDifferences) {
  kernels::Context context;
  Random random(1);
  std::size_t penetrating = 0, ties = 0;
  for (int i = 0; i < 1500; ++i) {
    const std::vector<Vector> a = small_body(random, 1 + i % 4), b = i % 3 == 0 ? a : small_body(random, 2 + i % 5);
    const polytope::PlacedPair clouds = polytope::place_integers(a, b);
    const depth::NaiveDepth naive = depth::naive_depth(a, b);
    const Expansion expansion = nearest_by_expansion(context, clouds.a, clouds.b);
    ASSERT_EQ(expansion.end, naive.status == Status::penetrating ? ExpansionEnd::proved : ExpansionEnd::not_inside)
        << i;
    if (naive.status != Status::penetrating) continue;
    ++penetrating;
    ties += naive.directions.size() > 1 ? 1U : 0U;
    EXPECT_EQ(directions(expansion.nearest), naive.directions) << i;
    EXPECT_EQ(kernels::ratio(expansion.nearest.numerator(), expansion.nearest.denominator()), naive.squared) << i;
    expect_hull(expansion.inner, clouds.a, clouds.b);
  }
  EXPECT_GT(penetrating, 300U);
  EXPECT_GT(ties, 100U);
}

TEST(ExpandingPolytope, GrowsOnFamiliesToAHullThatHoldsTheBall) {
  kernels::Context context;
  for (const Case& input : testing::cases_of_all_families(2, 24)) {
    const polytope::PlacedPair clouds = polytope::place(input.a.points, input.b.points);
    const Expansion expansion = nearest_by_expansion(context, clouds.a, clouds.b);
    if (expansion.end != ExpansionEnd::proved) continue;
    SCOPED_TRACE(input.id);
    expect_hull(expansion.inner, clouds.a, clouds.b);
    const kernels::Report report = validate(expansion, clouds.a, clouds.b);
    EXPECT_TRUE(report.ok()) << testing::text(report);
  }
}

TEST(ExpandingPolytope, ValidateSeesEachKindOfFault) {
  kernels::Context context;
  const Case input = families::find_family("crossed_fans")->make(1, 12);
  const polytope::PlacedPair clouds = polytope::place(input.a.points, input.b.points);
  const Expansion right = nearest_by_expansion(context, clouds.a, clouds.b);
  ASSERT_TRUE(validate(right, clouds.a, clouds.b).ok());
  using Change = void (*)(Expansion&);
  const Change changes[] = {
      [](Expansion& e) { e.end = ExpansionEnd::spent; },
      [](Expansion& e) { e.nearest = {}; },
      [](Expansion& e) {
        e.nearest.offer({1, 2, 3}, 1);
      },
      [](Expansion& e) {
        const mpz_class numerator = e.nearest.numerator();
        e.nearest = {};
        e.nearest.offer({1, 0, 0}, numerator);
      },
      [](Expansion& e) { e.inner.facets.pop_back(); },
      [](Expansion& e) { e.inner.facets.push_back(e.inner.facets.front()); },
      [](Expansion& e) { std::reverse(e.inner.facets.front().begin(), e.inner.facets.front().end()); },
      [](Expansion& e) { e.inner.facets.front().pop_back(); },
      [](Expansion& e) { e.inner.facets.front().front() = 1000; },
      [](Expansion& e) { e.inner.vertices.front().second = 1000; },
      [](Expansion& e) { std::swap(e.inner.vertices[0], e.inner.vertices[1]); },
      [](Expansion& e) {
        e.inner.vertices.push_back({0, 0});
      },
  };
  for (std::size_t i = 0; i < std::size(changes); ++i) {
    Expansion wrong = right;
    changes[i](wrong);
    EXPECT_FALSE(validate(wrong, clouds.a, clouds.b).ok()) << "change " << i;
  }
}

TEST(ExpandingPolytope, GivesUpAtItsBudgetAndAsksAtEachStepWhetherToGoOn) {
  const Case input = families::find_family("crossed_patch")->make(1, 20);
  const polytope::PlacedPair clouds = polytope::place(input.a.points, input.b.points);
  struct Steps final : Monitor {
    void report(std::string_view, double) override {}
    bool stopped() override { return ++asked > most; }
    std::size_t asked = 0, most = unlimited;
  } steps;
  kernels::Context context(&steps);
  const Expansion whole = nearest_by_expansion(context, clouds.a, clouds.b);
  ASSERT_EQ(whole.end, ExpansionEnd::proved);
  EXPECT_GE(steps.asked, whole.points);
  EXPECT_GT(whole.points, 50U);
  EXPECT_EQ(nearest_by_expansion(context, clouds.a, clouds.b, whole.points - 1).end, ExpansionEnd::spent);
  EXPECT_EQ(nearest_by_expansion(context, clouds.a, clouds.b, whole.points).end, ExpansionEnd::proved);
  steps = {};
  steps.most = whole.points / 2;
  EXPECT_THROW(nearest_by_expansion(context, clouds.a, clouds.b), Interrupted);
  EXPECT_EQ(steps.asked, steps.most + 1);
}

TEST(ExpandingPolytope, ABallIsHeldExactlyIfItFits) {
  kernels::Context context;
  Random random(3);
  for (int i = 0; i < 400; ++i) {
    const std::vector<Vector> a = small_body(random, 3), b = small_body(random, 4);
    const polytope::PlacedPair clouds = polytope::place_integers(a, b);
    const depth::NaiveDepth naive = depth::naive_depth(a, b);
    if (naive.status != Status::penetrating) continue;
    const mpq_class little(1, 1000), q = naive.squared;
    for (const mpq_class& low : {mpq_class(0), mpq_class(q / 2), q, mpq_class(q * (1 + little))}) {
      for (const mpq_class& high : {mpq_class(q * (1 - little)), q, mpq_class(q * 3)}) {
        const BallExpansion ball = expand_to_ball(context, clouds.a, clouds.b, low, high);
        ASSERT_EQ(ball.end, ExpansionEnd::proved);
        EXPECT_EQ(ball.low_holds, low <= q);
        EXPECT_EQ(ball.high_holds, high >= q);
        if (ball.low_holds) expect_hull(ball.inner, clouds.a, clouds.b);
      }
    }
    const Vector& n = naive.directions.front();
    EXPECT_EQ(expand_to_ball(context, clouds.a, clouds.b, 0, q, n).direction, n) << "the hint is used";
    EXPECT_EQ(expand_to_ball(context, clouds.a, clouds.b, 0, q, Vector{0, 0, 0}).high_holds, true)
        << "a useless hint does no harm";
  }
}

TEST(ExpandingPolytope, RefusesCloudsThatDoNotBelongTogether) {
  kernels::Context context;
  const kernels::PointCloud none, one({{1, 2, 3}}), fine({{1, 2, 3}}, 10);
  EXPECT_THROW(nearest_by_expansion(context, none, one), std::invalid_argument);
  EXPECT_THROW(nearest_by_expansion(context, one, fine), std::invalid_argument);
}

// Where an expanding polytope starts, and its surface, with integers of both kinds.

TEST(StartingTetrahedron, IsFoundExactlyIfPIsSolidAndTheSameWithAllIntegers) {
  Random random(4);
  std::size_t solid = 0, flat = 0;
  kernels::ScanMemory memory;
  for (int i = 0; i < 2000; ++i) {
    const std::vector<Vector> a = small_body(random, i % 3), b = small_body(random, i % 2);
    const polytope::PlacedPair clouds = polytope::place_integers(a, b);
    std::vector<Vector> differences;
    for (const Vector& p : a)
      for (const Vector& q : b) differences.push_back(q - p);
    polytope::Differences search{clouds.a, clouds.b};
    const auto start = starting_tetrahedron(search);
    ASSERT_EQ(start.has_value(), polytope::affine_rank(differences) == 3) << i;
    auto narrow = polytope::differences_in<polytope::NarrowInteger>(clouds.a, clouds.b, memory);
    ASSERT_EQ(starting_tetrahedron(narrow), start) << i;
    ++(start ? solid : flat);
    if (!start) continue;
    const Vector p = search[(*start)[0]];
    EXPECT_NE(det(search[(*start)[1]] - p, search[(*start)[2]] - p, search[(*start)[3]] - p), 0);
  }
  EXPECT_GT(solid, 200U);
  EXPECT_GT(flat, 200U);
}

template <class Integer>
class SurfaceOf : public ::testing::Test {
 public:
  static SurfaceVertex<Integer> vertex(const Vector& v, std::uint32_t name = 0) {
    const Vec3<Integer> exact{Integer(v.x), Integer(v.y), Integer(v.z)};
    return {{0, name}, exact, kernels::image(exact, 4)};
  }
};
using AllIntegers = ::testing::Types<mpz_class, polytope::NarrowInteger>;
TYPED_TEST_SUITE(SurfaceOf, AllIntegers);

TYPED_TEST(SurfaceOf, IsTheHullWhateverTheOrderOfThePoints) {
  Random random(5);
  Surface<TypeParam> surface;
  MergeMemory memory;
  for (int i = 0; i < 1500; ++i) {
    std::vector<Vector> points;
    const std::size_t reach = 2 + i % 3;
    const auto coordinate = [&] { return mpz_class(static_cast<unsigned long>(random() % reach)); };
    for (int k = 0; k < 14; ++k) points.push_back({coordinate(), coordinate(), coordinate()});
    const auto vertex = [&](std::uint32_t j) { return this->vertex(points[j], j); };
    if (det(Vector(points[1] - points[0]), Vector(points[2] - points[0]), Vector(points[3] - points[0])) == 0) continue;
    surface.start({vertex(0), vertex(1), vertex(2), vertex(3)});
    for (std::uint32_t j = 4; j < points.size(); ++j) {
      for (const TriangleId t : surface.triangles().ids()) {
        if (!surface.triangles()[t].alive || surface.side(t, vertex(j)) <= 0) continue;
        for (const TriangleId fresh : surface.insert(vertex(j), t)) ASSERT_FALSE(is_zero(surface.plane(fresh).normal));
        break;
      }
    }
    expect_hull(inner_polytope(surface, memory), kernels::PointCloud({{0, 0, 0}}), kernels::PointCloud(points));
  }
}

TYPED_TEST(SurfaceOf, RefusesAFlatStartAndPointsThatAreNotAbove) {
  const auto vertex = [](long x, long y, long z) { return SurfaceOf<TypeParam>::vertex({x, y, z}); };
  Surface<TypeParam> surface;
  EXPECT_THROW(surface.start({vertex(0, 0, 0), vertex(1, 0, 0), vertex(0, 1, 0), vertex(1, 1, 0)}), std::logic_error);
  surface.start({vertex(0, 0, 0), vertex(4, 0, 0), vertex(0, 4, 0), vertex(0, 0, 4)});
  EXPECT_EQ(surface.alive(), 4U);
  for (const TriangleId t : surface.triangles().ids()) {
    EXPECT_EQ(surface.side(t, vertex(1, 1, 1)), -1);
    EXPECT_THROW(surface.insert(vertex(1, 1, 1), t), std::logic_error);
  }
}

// The expanding polytope with integers of fixed size against its twin in mpz_class: the same steps,
// hence the same in every field. And where binary64 is nearly wrong: points that are coplanar
// within 2^-50, in every rounding mode.

TEST(FixedIntegers, TakeTheStepsOfMpzOnEveryFamily) {
  Workspace workspace;
  std::size_t proved = 0, narrow = 0;
  for (const unsigned size : {5U, 12U, 30U}) {
    for (const Case& input : testing::cases_of_all_families(2, size)) {
      const auto [end, placed] = expect_same_expansions(input, workspace);
      proved += end == ExpansionEnd::proved ? 1U : 0U;
      narrow += placed ? 1U : 0U;
    }
  }
  EXPECT_GT(proved, 200U);
  EXPECT_GT(narrow, 200U);
}

/// Lattices of all widths, up to and past those of fixed integers; a third of the bodies are
/// lattice boxes, full of coplanar points.
TEST(FixedIntegers, TakeTheStepsOfMpzOnLatticesOfEveryWidth) {
  Workspace workspace;
  kernels::Context context;
  Random random(2);
  for (int i = 0; i < 1500; ++i) {
    const unsigned long bits = 1 + random() % 330;
    std::vector<Vector> a(4 + random() % 12), b(4 + random() % 12);
    for (std::vector<Vector>* body : {&a, &b}) {
      for (Vector& p : *body) {
        p = testing::random_vector(random, i % 3 == 0 ? 2 : bits);
        if (i % 3 == 0) p = {p.x << (bits - 1), p.y << (bits - 1), p.z << (bits - 1)};
      }
    }
    const polytope::PlacedPair clouds = polytope::place_integers(a, b);
    const Expansion fixed = nearest_by_expansion(context, clouds.a, clouds.b, unlimited, &workspace);
    const Expansion twin = nearest_by_expansion_in<mpz_class>(context, clouds.a, clouds.b, unlimited, &workspace);
    expect_same(fixed, twin);
    expect_same(nearest_by_expansion_in<kernels::LazyInteger>(context, clouds.a, clouds.b, unlimited, &workspace),
                twin);
    if (HasFailure()) FAIL() << i << ", " << bits << " bits";
  }
}

/// The largest coordinates that are allowed, in all signs: every bound on bits is met here.
TEST(FixedIntegers, HoldTheLargestNumbers) {
  kernels::Context context;
  Random random(3);
  const mpz_class most = testing::power_of_two(polytope::most_narrow_bits);
  for (int i = 0; i < 300; ++i) {
    std::vector<Vector> a, b;
    const auto coordinate = [&](unsigned negative) {
      const mpz_class size = random() % 3 == 0 ? mpz_class(most - 1) : most;
      return negative != 0 ? mpz_class(-size) : size;
    };
    for (unsigned corner = 0; corner < 8; ++corner) {
      a.push_back({coordinate(corner & 1U), coordinate(corner & 2U), coordinate(corner & 4U)});
      b.push_back({coordinate(corner & 1U), coordinate(corner & 2U), coordinate(corner & 4U)});
    }
    const polytope::PlacedPair clouds = polytope::place_integers(a, b);
    ASSERT_EQ(clouds.exponent(), polytope::most_narrow_bits);
    const Expansion fixed = nearest_by_expansion(context, clouds.a, clouds.b);
    ASSERT_EQ(fixed.end, ExpansionEnd::proved);
    expect_same(fixed, nearest_by_expansion_in<mpz_class>(context, clouds.a, clouds.b));
  }
}

/// The same for integers of two words and of four; the first point of B is amid the others, so that
/// it may be the origin, and the next one is a unit away, so that this is the unit.
TEST(WordIntegers, HoldTheLargestNumbers) {
  kernels::Context context;
  Workspace workspace;
  Random random(4);
  for (const auto& [bits, kinds] : {std::pair(polytope::most_bits_for<kernels::Integer127>, 3),
                                    std::pair(polytope::most_bits_for<kernels::Integer127> + 1, 2),
                                    std::pair(polytope::most_bits_for<kernels::Integer255>, 2),
                                    std::pair(polytope::most_bits_for<kernels::Integer255> + 1, 1)}) {
    // Of 2^61 itself the lattice makes no word.
    const mpz_class most = testing::power_of_two(static_cast<unsigned long>(bits)) - (bits > 60 ? 1 : 0);
    for (int i = 0; i < 200; ++i) {
      std::vector<Point> a, b{{0, 0, 0}, {1, 0, 0}};
      const auto coordinate = [&](unsigned negative) {
        const mpq_class size = random() % 3 == 0 ? mpz_class(most - 1) : most;
        return negative != 0 ? mpq_class(-size) : size;
      };
      // Of some pairs alternate corners alone: their differences span the largest triangles.
      for (unsigned corner = 0; corner < 8; ++corner) {
        if (i % 2 == 1 && std::popcount(corner) % 2 == 0) continue;
        const Point p{coordinate(corner & 1U), coordinate(corner & 2U), coordinate(corner & 4U)};
        a.push_back(i % 4 == 1 ? -p : p);
        b.push_back(p);
      }
      polytope::NarrowMemory placed;
      ASSERT_TRUE(polytope::place_narrow(a, b, placed));
      ASSERT_EQ(placed.exponent, bits);
      const polytope::PlacedPair clouds = polytope::place(a, b);
      const Expansion twin = nearest_by_expansion_in<mpz_class>(context, clouds.a, clouds.b);
      ASSERT_EQ(twin.end, ExpansionEnd::proved);
      ASSERT_EQ(expect_same_in_all_integers(placed, a, b, unlimited, workspace, twin), kinds);
      expect_same(nearest_by_expansion(context, clouds.a, clouds.b, unlimited, &workspace), twin);
      if (HasFailure()) FAIL() << i << ", " << bits << " bits";
    }
  }
}

/// Every coordinate has its own size; some points share coordinates, some lie in a plane or on a
/// line with others.
std::vector<Vector> wild_body(Random& random, unsigned long spread) {
  std::vector<Vector> points;
  const auto coordinate = [&] {
    return mpz_class(testing::random_integer(random, 1 + random() % 60) << random() % spread);
  };
  const auto any = [&] { return points[random() % points.size()]; };
  const std::size_t size = 4 + random() % 12;
  while (points.size() < size) {
    if (points.size() > 2 && random() % 4 == 0) points.push_back(any() + any() - any());
    else if (points.size() > 2 && random() % 4 == 0) points.push_back({any().x, any().y, coordinate()});
    else points.push_back({coordinate(), coordinate(), coordinate()});
  }
  return points;
}

TEST(LazyIntegers, TakeTheStepsOfMpzWhereCoordinatesDifferInSize) {
  Workspace workspace;
  kernels::Context context;
  Random random(5);
  int proved = 0;
  for (int i = 0; i < 1200; ++i) {
    const unsigned long spread = 1 + random() % 1200;
    const polytope::PlacedPair clouds = polytope::place_integers(wild_body(random, spread), wild_body(random, spread));
    const testing::RoundingMode mode(testing::rounding_modes[i % 4]);
    const Expansion twin = nearest_by_expansion_in<mpz_class>(context, clouds.a, clouds.b, 300, &workspace);
    expect_same(nearest_by_expansion_in<kernels::LazyInteger>(context, clouds.a, clouds.b, 300, &workspace), twin);
    proved += twin.end == ExpansionEnd::proved ? 1 : 0;
    if (HasFailure()) FAIL() << i << ", " << spread;
  }
  EXPECT_GT(proved, 300);
}

/// Work, in counts: binary64 cannot tell most sides of such bodies, and few numbers are computed.
TEST(LazyIntegers, AreHardlyComputed) {
  kernels::Context context;
  for (const auto& [family, most] : {std::pair("uneven_coordinates", 12U), std::pair("wild_coordinates", 40U)}) {
    std::uint64_t exact = 0, computed = 0, pairs = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const Case input = families::find_family(family)->make(seed, 20);
      const polytope::PlacedPair clouds = polytope::place(input.a.points, input.b.points);
      const Expansion found = nearest_by_expansion(context, clouds.a, clouds.b);
      if (found.end != ExpansionEnd::proved) continue;
      ++pairs;
      exact += found.sides_exact;
      computed += found.computed;
    }
    EXPECT_GT(pairs, 30U) << family;
    EXPECT_GT(exact, 60 * pairs) << family << ": binary64 decides too much for this test to be hard";
    EXPECT_LT(computed, most * pairs) << family;
  }
}

/// A search that ends anywhere leaves a workspace that is as good as a new one.
TEST(Workspace, IsUsableAfterAnInterruption) {
  const Case input = families::find_family("random_sphere")->make(1, 30);
  const polytope::PlacedPair clouds = polytope::place(input.a.points, input.b.points);
  kernels::Context undisturbed;
  const Expansion whole = nearest_by_expansion(undisturbed, clouds.a, clouds.b);
  ASSERT_EQ(whole.end, ExpansionEnd::proved);
  ASSERT_GT(whole.points, 3U);
  Workspace workspace;
  for (std::size_t most = 0; most < whole.points; ++most) {
    struct Stop final : Monitor {
      explicit Stop(std::size_t n) : left(n) {}
      void report(std::string_view, double) override {}
      bool stopped() override { return left-- == 0; }
      std::size_t left;
    } stop(most);
    kernels::Context context(&stop);
    EXPECT_THROW(nearest_by_expansion(context, clouds.a, clouds.b, unlimited, &workspace), Interrupted);
    EXPECT_EQ(nearest_by_expansion(undisturbed, clouds.a, clouds.b, most, &workspace).end, ExpansionEnd::spent);
    expect_same(nearest_by_expansion(undisturbed, clouds.a, clouds.b, unlimited, &workspace), whole);
  }
}

/// Points in binary64 that lie in a common plane but for a few units in the last place: facets of P
/// with many corners, which differ from a plane by 2^-50 of the size or less.
std::vector<Vector> nearly_coplanar_body(Random& random, const Vec3<double>& normal, double offset) {
  std::vector<Vector> points;
  const auto lattice = [](double c) { return mpz_class(std::ldexp(c, 53)); };
  for (int side = 0; side < 2; ++side) {
    for (int k = 0; k < 7; ++k) {
      const double angle = 0.9 * k + 0.1 * side, x = 0.5 * std::cos(angle), y = 0.5 * std::sin(angle);
      const double z = (side == 0 ? offset : offset - 0.7) - normal.x * x - normal.y * y;
      Vector p{lattice(x), lattice(y), lattice(z)};
      p.z += static_cast<long>(random() % 5) - 2;
      points.push_back(p);
    }
  }
  return points;
}

TEST(ErrorBounds, HoldWherePointsAreCoplanarWithinTheLastPlacesInEveryRoundingMode) {
  kernels::Context context;
  Random random(4);
  std::uint64_t unsure = 0;
  for (int i = 0; i < 200; ++i) {
    const auto slope = [&] { return std::ldexp(static_cast<double>(random() % 1024) - 512, -12); };
    const Vec3<double> normal{slope(), slope(), 1};
    const std::vector<Vector> a = nearly_coplanar_body(random, normal, 0.35),
                              b = nearly_coplanar_body(random, normal, 0.25);
    const polytope::PlacedPair clouds = polytope::place_integers(a, b);
    const depth::NaiveDepth truth = depth::naive_depth(a, b);  // no filter of ours
    ASSERT_EQ(truth.status, Status::penetrating);
    for (const int rounding : testing::rounding_modes) {
      const testing::RoundingMode mode(rounding);
      const Expansion found = nearest_by_expansion(context, clouds.a, clouds.b);
      ASSERT_EQ(found.end, ExpansionEnd::proved);
      const auto& directions = found.nearest.directions();
      ASSERT_EQ(std::vector<Vector>(directions.begin(), directions.end()), truth.directions)
          << i << ", rounding " << rounding;
      ASSERT_TRUE(validate(found, clouds.a, clouds.b).ok()) << i << ", rounding " << rounding;
      unsure += found.sides_exact;
    }
  }
  EXPECT_GT(unsure, 800U) << "binary64 decides too much for this test to be hard";
}

/// Work, in counts: binary64 decides nearly all sides of bodies in general position.
TEST(ErrorBounds, LeaveFewSidesToIntegers) {
  kernels::Context context;
  std::uint64_t sides = 0, exact = 0, points = 0, pairs = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Case input = families::find_family("random_sphere")->make(seed, 20);
    const polytope::PlacedPair clouds = polytope::place(input.a.points, input.b.points);
    const Expansion found = nearest_by_expansion(context, clouds.a, clouds.b);
    if (found.end != ExpansionEnd::proved) continue;
    ++pairs;
    sides += found.sides;
    exact += found.sides_exact;
    points += found.points;
  }
  EXPECT_GT(pairs, 150U);
  EXPECT_LT(sides, 300 * pairs);
  EXPECT_LT(exact, 12 * pairs)
      << "the few are: is a candidate above its plane, and which triangles of the nearest facet are coplanar";
  EXPECT_LT(points, 15 * pairs);
}

}  // namespace
}  // namespace fathom::expanding
