// SPDX-License-Identifier: GPL-3.0-or-later
// Rationals that are not as GMP wants them (2/4, 1/-2, 1/0) are refused by all that takes points:
// no crash, no wrong answer.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <stdexcept>

#include "fathom/approximate.hpp"
#include "fathom/certificate.hpp"
#include "fathom/depth.hpp"
#include "fathom/union.hpp"
#include "kernels/number/rational.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/polytope/lattice.hpp"
#include "tests/judge/pairs.hpp"
#include "verify/study/study.hpp"

namespace fathom {
namespace {

using testing::cube;
using Points = std::vector<Point>;

/// As the constructor leaves it, which does not look.
mpq_class raw(long numerator, long denominator) {
  mpq_class result;
  result.get_num() = numerator;
  result.get_den() = denominator;
  return result;
}

const std::vector<mpq_class>& no_numbers() {
  static const std::vector<mpq_class> result{raw(2, 4), raw(1, -2), raw(-1, -2), raw(6, 9), raw(4, 1 << 20),
                                             raw(0, 5), raw(0, -1), raw(1, 0),   raw(0, 0)};
  return result;
}

TEST(LowestTerms, AreAskedExactly) {
  for (const mpq_class& q : no_numbers())
    EXPECT_FALSE(kernels::in_lowest_terms(q)) << q.get_num() << ' ' << q.get_den();
  for (const mpq_class& q : {raw(0, 1), raw(-3, 1), raw(1, 2), raw(-7, 1 << 20), raw(8, 9), raw(-10, 21)}) {
    EXPECT_TRUE(kernels::in_lowest_terms(q)) << q;
    EXPECT_NO_THROW(kernels::require_lowest_terms(q));
  }
}

using Door = std::function<void(const Points& a, const Points& b)>;

Door depth_by(Method method) {
  return [method](const Points& a, const Points& b) { penetration_depth(a, b, {.method = method}); };
}

const std::map<std::string, Door>& doors() {
  static const std::map<std::string, Door> result{
      {"automatic", depth_by(Method::automatic)},
      {"exact", depth_by(Method::exact)},
      {"naive", depth_by(Method::naive)},
      {"certificate", depth_by(Method::certificate)},
      {"shallow", [](const Points& a, const Points& b) { shallow_depth(a, b); }},
      {"approx", [](const Points& a, const Points& b) { approx_depth(a, b, mpq_class(1, 8)); }},
      {"ray",
       [](const Points& a, const Points& b) {
         directional_depth(a, b, {1, 0, 0});
       }},
      {"growth", [](const Points& a, const Points& b) { growth_distance(a, b); }},
      {"growth about centers",
       [](const Points& a, const Points& b) {
         growth_distance(a, b, Point{0, 0, 0}, Point{mpq_class(1, 2), 0, 0});
       }},
      {"metric",
       [](const Points& a, const Points& b) {
         metric_depth(a, b, unit_ball(cube(mpq_class(-1, 2), mpq_class(-1, 2), mpq_class(-1, 2))));
       }},
      {"bounds", [](const Points& a, const Points& b) { make_bounds_certificate(a, b, 0, 9); }},
      {"gap",
       [](const Points& a, const Points& b) {
         second_nearest_squared(a, b, *penetration_depth(cube(0), cube(mpq_class(1, 2))).penetration());
       }},
      {"gap, naive", [](const Points& a, const Points& b) { depth::second_nearest_squared_naive(a, b); }},
      {"study", [](const Points& a, const Points& b) { study(a, b); }},
      {"placed", [](const Points& a, const Points& b) { polytope::place(a, b); }},
      {"truth", [](const Points& a, const Points& b) { truth_about(a, b); }},
      {"judge",
       [](const Points& a, const Points& b) {
         judge(Truth{a, b, testing::cubes().depth}, testing::overlap(0.5));
       }},
      {"unions",
       [](const Points& a, const Points& b) {
         union_depth({cube(5), a}, {b, cube(9)});
       }},
      {"truth of unions", [](const Points& a, const Points& b) { truth_about(Pieces{a}, Pieces{b}); }},
      {"judge of unions",
       [](const Points& a, const Points& b) {
         judge(UnionTruth{{a}, {b}, union_depth({cube(0)}, {cube(mpq_class(1, 2))})}, testing::overlap(0.5));
       }},
      {"width", [](const Points& a, const Points& b) { width(a), width(b); }},
      {"approximate width",
       [](const Points& a, const Points& b) { approx_width(a, mpq_class(1, 8)), approx_width(b, mpq_class(1, 8)); }},
      {"seen", [](const Points& a, const Points& b) { seen(a, Precision::binary64), seen(b, Precision::binary32); }},
      {"unit ball", [](const Points& a, const Points& b) {
         const auto around = [](Points ball) {
           for (const Point& p : cube(-2, -2, -2)) ball.push_back(p), ball.push_back({-p.x, -p.y, -p.z});
           unit_ball(ball);
         };
         around(a), around(b);
       }}};
  return result;
}

TEST(LowestTerms, AreRequiredOfPointsAtEveryDoor) {
  for (const auto& [name, enter] : doors()) {
    EXPECT_NO_THROW(enter(cube(0), cube(mpq_class(1, 2)))) << name;
    for (const mpq_class& q : no_numbers()) {
      for (const auto axis : {&Point::x, &Point::y, &Point::z}) {
        for (const std::size_t i : {0, 7}) {
          Points a = cube(0), b = cube(mpq_class(1, 2));
          std::destroy_at(&(a[i].*axis));  // GMP's own assignment crashes at a denominator below 0
          std::construct_at(&(a[i].*axis), q);
          EXPECT_THROW(enter(a, b), std::invalid_argument)
              << name << ": " << q.get_num() << " over " << q.get_den() << " in A";
          EXPECT_THROW(enter(b, a), std::invalid_argument)
              << name << ": " << q.get_num() << " over " << q.get_den() << " in B";
        }
      }
    }
  }
}

// Whether or not the proof has to be sought in the bodies.
TEST(LowestTerms, AreRequiredOfBodiesThatGetACertificate) {
  struct Answered {
    mpq_class at;
    Method method;
  };
  for (const auto& [at, method] :
       {Answered{mpq_class(1, 2), Method::exact}, Answered{mpq_class(1, 2), Method::automatic},
        Answered{1, Method::exact}, Answered{2, Method::exact}}) {
    const Points a = cube(0), b = cube(at);
    const Depth answer = penetration_depth(a, b, {.method = method});
    EXPECT_NO_THROW(make_certificate(a, b, answer));
    EXPECT_THROW(make_certificate({}, b, answer), std::invalid_argument);
    Points bad = b;
    std::destroy_at(&bad[7].z);
    std::construct_at(&bad[7].z, raw(2, 4));
    EXPECT_THROW(make_certificate(a, bad, answer), std::invalid_argument) << name(answer.status());
    EXPECT_THROW(make_certificate(bad, a, answer), std::invalid_argument) << name(answer.status());
  }
}

TEST(LowestTerms, AreRequiredOfDirectionsAndNumbers) {
  const Points a = cube(0), b = cube(mpq_class(1, 2));
  for (const mpq_class& q : no_numbers()) {
    EXPECT_THROW(directional_depth(a, b, {q, 1, 1}), std::invalid_argument);
    EXPECT_THROW(directional_depth(a, b, {1, 1, q}), std::invalid_argument);
    EXPECT_THROW(growth_distance(a, b, Point{q, 0, 0}), std::invalid_argument);
    EXPECT_THROW(growth_distance(a, b, std::nullopt, Point{0, 0, q}), std::invalid_argument);
    EXPECT_THROW(approx_depth(a, b, q), std::invalid_argument);
    EXPECT_THROW(approx_width(a, q), std::invalid_argument);
    EXPECT_THROW(shallow_depth(a, b, {}, q), std::invalid_argument);
    EXPECT_THROW(make_bounds_certificate(a, b, q, 9), std::invalid_argument);
    EXPECT_THROW(make_bounds_certificate(a, b, 0, q), std::invalid_argument);
    EXPECT_THROW(judge(testing::cubes(), {}, {}, Precision::binary64, {q, 0, 0}), std::invalid_argument);
    EXPECT_THROW(judge(testing::cubes(), {}, {}, Precision::binary64, {0, q, 0}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace fathom
