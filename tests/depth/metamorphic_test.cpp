// SPDX-License-Identifier: GPL-3.0-or-later
// Laws that relate the answers to two inputs: no oracle needed, so they reach sizes and numbers
// that oracles do not.
#include <gtest/gtest.h>

#include <functional>

#include "fathom/depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/prepared.hpp"
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
