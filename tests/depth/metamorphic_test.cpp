// SPDX-License-Identifier: GPL-3.0-or-later
// Laws that relate the answers to two inputs: no oracle needed, so they reach sizes and numbers
// that oracles do not.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "fathom/depth.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/files/shape_names.hpp"
#include "tests/oracles/brute_oracle.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/property.hpp"
#include "tests/support/stated_cases.hpp"
#include "verify/families/random.hpp"

namespace fathom::depth {
namespace {

using families::Random;
using families::ratio;
using testing::cases_of_all_families;

using Map = std::function<Point(const Point&)>;

Depth solve(const std::vector<Point>& a, const std::vector<Point>& b) { return testing::exact_depth(a, b); }

std::vector<Point> image(const std::vector<Point>& points, const Map& map) {
  std::vector<Point> result;
  for (const Point& p : points) result.push_back(map(p));
  return result;
}

// Directions as the primitive vectors of their images under a linear map that scales all lengths
// alike.
std::vector<Vector> directions(const Depth& depth, const Map& linear) {
  std::vector<Vector> result;
  for (const Optimum& o : depth.optima()) {
    const Point q = linear({o.direction.x, o.direction.y, o.direction.z});
    const mpz_class common = lcm(lcm(q.x.get_den(), q.y.get_den()), q.z.get_den());
    const mpq_class x = q.x * common, y = q.y * common, z = q.z * common;
    result.push_back(primitive({x.get_num(), y.get_num(), z.get_num()}));
  }
  std::ranges::sort(result, lexicographically_less);
  return result;
}

Map identity() {
  return [](const Point& p) { return p; };
}

// Under a similarity x -> s R x + c of both bodies the squared depth is multiplied by s^2 and
// directions are turned by R.
void expect_similar(const Case& input, const Map& linear, const Map& affine, const mpq_class& squared_scale,
                    const char* law) {
  const Depth before = solve(input.a.points, input.b.points);
  const Depth after = solve(image(input.a.points, affine), image(input.b.points, affine));
  EXPECT_EQ(after.status(), before.status()) << law << " " << input.id;
  EXPECT_EQ(after.squared(), mpq_class(before.squared() * squared_scale)) << law << " " << input.id;
  EXPECT_EQ(directions(after, identity()), directions(before, linear)) << law << " " << input.id;
}

TEST(Metamorphic, SwappingTheBodiesNegatesTheDirections) {
  const Map negation = [](const Point& p) { return Point{-p.x, -p.y, -p.z}; };
  for (const Case& input : cases_of_all_families(2, 12)) {
    const Depth before = solve(input.a.points, input.b.points), after = solve(input.b.points, input.a.points);
    EXPECT_EQ(after.status(), before.status()) << input.id;
    EXPECT_EQ(after.squared(), before.squared()) << input.id;
    EXPECT_EQ(directions(after, identity()), directions(before, negation)) << input.id;
  }
}

TEST(Metamorphic, TranslatingBothChangesNothing) {
  const Map shift = [](const Point& p) { return Point{p.x + mpq_class(1, 7), p.y - 1000003, p.z + mpq_class(22, 3)}; };
  for (const Case& input : cases_of_all_families(2, 12)) expect_similar(input, identity(), shift, 1, "translation");
}

TEST(Metamorphic, SignedAxisPermutationsTurnTheDirections) {
  const std::vector<Map> maps{[](const Point& p) {
                                return Point{p.y, p.z, p.x};
                              },
                              [](const Point& p) {
                                return Point{-p.x, p.z, p.y};
                              },
                              [](const Point& p) {
                                return Point{p.z, -p.y, -p.x};
                              }};
  for (const Case& input : cases_of_all_families(1, 12)) {
    for (const Map& map : maps) expect_similar(input, map, map, 1, "signed permutation");
  }
}

// The rotation of the quaternion (w, x, y, z), with rational entries.
Map rotation(long w, long x, long y, long z) {
  const mpq_class n = w * w + x * x + y * y + z * z;
  const auto dot = [](const mpq_class& a, const mpq_class& b, const mpq_class& c, const Point& p) -> mpq_class {
    return a * p.x + b * p.y + c * p.z;
  };
  return [=](const Point& p) {
    return Point{dot((w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n, p),
                 dot(2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n, p),
                 dot(2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n, p)};
  };
}

TEST(Metamorphic, RationalRotationsTurnTheDirections) {
  const Map turn = rotation(3, 1, -2, 5);
  for (const Case& input : cases_of_all_families(1, 12)) expect_similar(input, turn, turn, 1, "rotation");
}

TEST(Metamorphic, ScalingMultipliesTheDepth) {
  for (const mpq_class& s : {mpq_class(7, 3), mpq_class(1, 1000), families::times_power_of_two(mpq_class(1), 900)}) {
    const Map scale = [&](const Point& p) { return Point{s * p.x, s * p.y, s * p.z}; };
    for (const Case& input : cases_of_all_families(1, 9)) expect_similar(input, identity(), scale, s * s, "scaling");
  }
}

TEST(Metamorphic, DuplicatesInteriorPointsAndOrderChangeNothing) {
  Random random(5);
  for (const Case& input : cases_of_all_families(2, 12)) {
    const Depth before = solve(input.a.points, input.b.points);
    std::vector<Point> a = input.a.points, b = input.b.points;
    for (std::vector<Point>* body : {&a, &b}) {
      const std::size_t n = body->size();
      for (int i = 0; i < 5; ++i) {
        const Point p = (*body)[random.next() % n], q = (*body)[random.next() % n];
        const mpq_class t = ratio(random.between(0, 8), 8);
        body->push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)});
      }
      for (std::size_t i = body->size(); i > 1; --i) std::swap((*body)[i - 1], (*body)[random.next() % i]);
    }
    const Depth after = solve(a, b);
    EXPECT_EQ(after.status(), before.status()) << input.id;
    EXPECT_EQ(after.squared(), before.squared()) << input.id;
    EXPECT_EQ(directions(after, identity()), directions(before, identity())) << input.id;
  }
}

// Moving A by the translation makes the bodies touch; a little less leaves them penetrating.
TEST(Metamorphic, TheTranslationSeparates) {
  for (const Case& input : cases_of_all_families(2, 12)) {
    const Depth depth = solve(input.a.points, input.b.points);
    for (const Optimum& o : depth.optima()) {
      const auto moved = [&](const mpq_class& s) {
        return image(input.a.points, [&](const Point& p) {
          const Point t = o.translation();
          return Point{p.x + s * t.x, p.y + s * t.y, p.z + s * t.z};
        });
      };
      EXPECT_EQ(solve(moved(1), input.b.points).status(), Status::touching) << input.id;
      EXPECT_EQ(solve(moved(mpq_class(1023, 1024)), input.b.points).status(), Status::penetrating) << input.id;
      EXPECT_EQ(solve(moved(mpq_class(1025, 1024)), input.b.points).status(), Status::disjoint) << input.id;
    }
  }
}

}  // namespace
}  // namespace fathom::depth

// The hull of all differences against brute force on small lattices, where every degeneracy is
// frequent, and the laws that hold for any answer.

namespace {

using namespace fathom;
using Points = std::vector<Vector>;

/// 1 to 8 points of a box of integers around O with half extents 0 to 3; half extent 0 makes a flat
/// body.
rc::Gen<Points> lattice_points() {
  return rc::gen::resize(rc::kNominalSize, rc::gen::exec([] {
                           const int x = *rc::gen::inRange(0, 4), y = *rc::gen::inRange(0, 4),
                                     z = *rc::gen::inRange(0, 4);
                           const int count = *rc::gen::inRange(1, 9);
                           Points points;
                           for (int i = 0; i < count; ++i) {
                             const int px = *rc::gen::inRange(-x, x + 1), py = *rc::gen::inRange(-y, y + 1),
                                       pz = *rc::gen::inRange(-z, z + 1);
                             points.push_back({px, py, pz});
                           }
                           return points;
                         }));
}

std::vector<Point> rational_points(const Points& points) {
  std::vector<Point> result;
  for (const Vector& v : points) result.push_back({v.x, v.y, v.z});
  return result;
}

template <class Map>
Points mapped(Points points, Map map) {
  for (Vector& v : points) v = map(v);
  return points;
}

Points sorted(Points directions) {
  std::ranges::sort(directions, lexicographically_less);
  return directions;
}

TEST(NaiveDepth, RefusesEmptyBodies) {
  const Points point{{0, 0, 0}};
  EXPECT_THROW(depth::naive_depth({}, point), std::invalid_argument);
  EXPECT_THROW(depth::naive_depth(point, {}), std::invalid_argument);
}

TEST(NaiveDepth, EqualsBruteForceOnSmallLattices) {
  EXPECT_TRUE(holds({.seed = 41, .runs = 1000}, [] {
    const Points a = *lattice_points(), b = *lattice_points();
    const depth::NaiveDepth naive = depth::naive_depth(a, b);
    const oracles::OracleAnswer brute = oracles::brute_oracle(rational_points(a), rational_points(b));
    RC_CLASSIFY(naive.status == Status::penetrating, "penetrating");
    RC_CLASSIFY(naive.status == Status::touching, "touching");
    RC_ASSERT(naive.status == brute.status);
    RC_ASSERT(naive.squared == brute.squared);
    RC_ASSERT(naive.directions == brute.directions);
  }));
}

TEST(NaiveDepth, SwappedBodiesReverseTheDirections) {
  EXPECT_TRUE(holds({.seed = 41, .runs = 1000}, [] {
    const Points a = *lattice_points(), b = *lattice_points();
    depth::NaiveDepth expected = depth::naive_depth(a, b);
    expected.directions = sorted(mapped(expected.directions, [](const Vector& v) { return -v; }));
    RC_ASSERT(depth::naive_depth(b, a) == expected);
  }));
}

TEST(NaiveDepth, SimilarityScalesTheDepth) {
  EXPECT_TRUE(holds({.seed = 41, .runs = 1000}, [] {
    const Points a = *lattice_points(), b = *lattice_points();
    const auto turned = [](const Vector& v) { return Vector{v.y, -v.z, v.x}; };
    const auto placed = [&](const Vector& v) { return turned({3 * v.x + 10, 3 * v.y - 7, 3 * v.z + 1000}); };
    depth::NaiveDepth expected = depth::naive_depth(a, b);
    expected.squared *= 9;
    expected.directions = sorted(mapped(expected.directions, turned));
    RC_ASSERT(depth::naive_depth(mapped(a, placed), mapped(b, placed)) == expected);
  }));
}

TEST(NaiveDepth, OrderAndRepetitionOfPointsDoNotMatter) {
  EXPECT_TRUE(holds({.seed = 41, .runs = 1000}, [] {
    const Points a = *lattice_points(), b = *lattice_points();
    Points again(a.rbegin(), a.rend());
    again.insert(again.end(), a.begin(), a.end());
    RC_ASSERT(depth::naive_depth(again, b) == depth::naive_depth(a, b));
  }));
}

}  // namespace

// Pairs from issue trackers and test suites: 63 of collision libraries, with answers that two
// independent programs found, and 141 of public reports of all who need depths and distances.
// Sources stand in tests/data/real_cases.jsonl and report_cases.jsonl.

namespace fathom::depth {
namespace {

using Json = nlohmann::json;
using testing::stated_cases;

Json translations(const Depth& depth) {
  std::vector<Point> result;
  for (const Optimum& o : depth.optima()) result.push_back(o.translation());
  return testing::translation_texts(result);
}

TEST(RealCases, OfPointsHaveTheStatedAnswers) {
  std::size_t cases = 0;
  for (const auto& [pair, line, answer] : stated_cases()) {
    const std::vector<Point>&a = pair.a.points, &b = pair.b.points;
    if (a.empty() || b.empty()) continue;
    SCOPED_TRACE(pair.id);
    const Depth depth = testing::exact_depth(a, b, {.validate = true});
    EXPECT_EQ(name(depth.status()), answer["status"]);
    EXPECT_EQ(depth.squared().get_str(), answer["depth_squared"]);
    EXPECT_EQ(translations(depth), answer["translations"]);
    const kernels::Report report = testing::check(depth, a, b);
    EXPECT_TRUE(report.ok()) << testing::text(report);
    EXPECT_EQ(fathom::penetration_depth(a, b, {.method = Method::naive}).optima(), depth.optima());
    ++cases;
  }
  EXPECT_EQ(cases, 63U + 93U);
}

/// Exact, or between the same two doubles.
void expect_value(const SignedDepth& depth, const Json& answer) {
  ASSERT_TRUE(depth.status());
  EXPECT_EQ(name(*depth.status()), answer["status"]);
  const Json& value = answer["signed_depth"];
  EXPECT_EQ(depth.low_binary64(), value["low"].get<double>());
  EXPECT_EQ(depth.high_binary64(), value["high"].get<double>());
  ASSERT_EQ(depth.exact() != nullptr, value.contains("exact"));
  if (!depth.exact()) return;
  const auto number = [&](const char* field) { return mpq_class(value["exact"][field].get<std::string>()); };
  EXPECT_EQ(compare(*depth.exact(), Surd{number("plus"), number("root") * value["exact"]["sign"].get<int>()}), 0);
}

TEST(RealCases, OfConvexBodiesHaveTheStatedAnswersByEveryMethod) {
  std::size_t cases = 0, exact = 0;
  for (const auto& [pair, line, answer] : stated_cases()) {
    if (!answer.contains("signed_depth") || pair.a.pieces || pair.b.pieces) continue;
    SCOPED_TRACE(pair.id);
    const Shape a = files::shape_of(pair.a), b = files::shape_of(pair.b);
    for (const Method method : {Method::automatic, Method::exact, Method::naive}) {
      SignedDepthOptions options;
      options.cores.method = method;
      expect_value(signed_depth(a, b, options), answer);
    }
    ++cases;
    exact += answer["signed_depth"].contains("exact") ? 1 : 0;
  }
  EXPECT_EQ(cases, 132U);
  EXPECT_EQ(exact, 128U);
}

}  // namespace
}  // namespace fathom::depth
