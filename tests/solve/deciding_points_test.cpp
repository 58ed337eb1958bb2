// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies whose denominators share few factors. The oracle is the same pair times a common
// denominator: integers, which are placed directly.

#include <fmt/format.h>
#include <gmp.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "fathom/certificate.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/solve/depth.hpp"
#include "tests/solve/same_depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/prepared.hpp"
#include "verify/check/check.hpp"
#include "verify/families/families.hpp"

namespace fathom::solve {
namespace {

/// Numbers near those that are asked for, over random odd denominators of 32 bits.
class Unlike {
 public:
  explicit Unlike(std::uint64_t seed) : random_(seed) {}

  mpq_class near(double x) {
    const mpz_class denominator = static_cast<unsigned long>(random_() >> 32 | std::uint64_t{1} << 31 | 1);
    mpq_class q(mpz_class(mpf_class(x, 64) * denominator), denominator);
    q.canonicalize();
    return q;
  }
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-52 - 1; }

  /// Points near the sphere of radius 1 about (x, 0, 0).
  std::vector<Point> sphere(int n, double x) {
    std::vector<Point> points;
    while (static_cast<int>(points.size()) < n) {
      const double p = unit(), q = unit(), r = unit(), length = std::sqrt(p * p + q * q + r * r);
      if (length < 0.1 || length > 1) continue;
      points.push_back({near(p / length + x), near(q / length), near(r / length)});
    }
    return points;
  }
  /// Points of a square of side 2 parallel to the plane of y and z, at one x.
  std::vector<Point> square(int n, const mpq_class& x) {
    std::vector<Point> points;
    for (int i = 0; i < n; ++i) points.push_back({x, near(unit()), near(unit())});
    for (const int y : {-1, 1})
      for (const int z : {-1, 1}) points.push_back({x, y, z});
    return points;
  }

 private:
  std::mt19937_64 random_;
};

using Points = std::vector<Point>;

Points times(const Points& points, const mpq_class& factor) {
  Points result;
  for (const Point& p : points) result.push_back({p.x * factor, p.y * factor, p.z * factor});
  return result;
}

Point times(const Point& p, const mpq_class& factor) { return times(Points{p}, factor).front(); }

void expect_same(const Depth& depth, const Depth& large, const mpq_class& factor) {
  EXPECT_EQ(depth.status(), large.status());
  EXPECT_EQ(depth.squared() * factor * factor, large.squared());
  EXPECT_EQ(depth.flat_a, large.flat_a);
  EXPECT_EQ(depth.flat_b, large.flat_b);
  EXPECT_EQ(times(depth.translation(), factor), large.translation());
  ASSERT_EQ(depth.optima().size(), large.optima().size());
  for (std::size_t i = 0; i < depth.optima().size(); ++i) {
    EXPECT_EQ(depth.optima()[i].direction, large.optima()[i].direction);
    EXPECT_EQ(times(depth.optima()[i].translation(), factor), large.optima()[i].translation());
    EXPECT_EQ(depth.optima()[i].contact, large.optima()[i].contact);
  }
  if (depth.status() == Status::penetrating) {
    EXPECT_EQ(depth.direction(), large.direction());
    EXPECT_EQ(times(depth.witness()->a, factor), large.witness()->a);
    EXPECT_EQ(times(depth.witness()->b, factor), large.witness()->b);
  }
  ASSERT_EQ(!depth.distance(), !large.distance());
  if (!depth.distance()) return;
  EXPECT_EQ(depth.distance()->squared * factor * factor, large.distance()->squared);
  EXPECT_EQ(depth.distance()->direction, large.distance()->direction);
  EXPECT_EQ(times(depth.distance()->translation, factor), large.distance()->translation);
}

/// By every method, against integers; with the proof.
void expect_right(const Points& a, const Points& b, Status status) {
  ASSERT_FALSE(polytope::place_if_slim(a, b));
  const mpz_class factor = polytope::place(a, b).denominator * b[0].x.get_den() * b[0].y.get_den() * b[0].z.get_den();
  const Depth large = penetration_depth(times(a, factor), times(b, factor));
  EXPECT_EQ(large.status(), status);
  for (const Method method : {Method::automatic, Method::exact, Method::certificate, Method::naive}) {
    const Depth depth = penetration_depth(a, b, {.method = method, .validate = true});
    expect_same(depth, large, factor);
    const fathom_check::Verdict verdict = fathom_check::verify(certificate_text(make_certificate(a, b, depth)));
    EXPECT_TRUE(verdict.accepted()) << verdict.reason;
  }
}

TEST(DecidingPoints, SpheresThatPenetrate) {
  for (std::uint64_t seed = 1; seed < 3; ++seed) {
    Unlike some(seed);
    expect_right(some.sphere(100, 0), some.sphere(100, 1.3), Status::penetrating);
  }
}

TEST(DecidingPoints, SpheresApart) {
  Unlike some(5);
  expect_right(some.sphere(100, 0), some.sphere(100, 2.5), Status::disjoint);
}

TEST(DecidingPoints, ABodyAgainstItselfTies) {
  Unlike some(6);
  const Points a = some.sphere(200, 0);
  expect_right(a, a, Status::penetrating);
}

TEST(DecidingPoints, AFaceOfManyPointsIsListedWhole) {
  Unlike some(7);
  Points a = some.sphere(100, 0), b = some.square(30, mpq_class(1, 3));
  expect_right(a, b, Status::penetrating);
  const Points far = some.square(100, mpq_class(7, 3));
  b.insert(b.end(), far.begin(), far.end());
  expect_right(a, b, Status::penetrating);
}

TEST(DecidingPoints, FlatBodiesAndBodiesThatTouch) {
  Unlike some(8);
  const Points flat = some.square(100, mpq_class(1, 7));
  expect_right(flat, some.sphere(100, 0.2), Status::penetrating);
  Points a = some.sphere(100, 3);
  a.push_back({mpq_class(1, 7), 0, 0});
  expect_right(flat, a, Status::touching);
}

// Seen from the grid, the bodies are needles.
TEST(DecidingPoints, WhatTheGridDoesNotShowIsFoundAllTheSame) {
  Unlike some(9);
  Points a = some.sphere(100, 0), b = some.sphere(100, 0.3);
  for (Points* body : {&a, &b})
    for (Point& p : *body) p.y /= mpq_class(mpz_class(1) << 150);
  expect_right(a, b, Status::penetrating);
}

TEST(DecidingPoints, MostPointsNeverMeetTheOthersDenominators) {
  Unlike some(10);
  const Points a = some.sphere(1000, 0), b = some.sphere(1000, 1.3);
  const Counters counters = testing::exact_depth(a, b).counters;
  EXPECT_GT(counters.vertices_a + counters.vertices_b, 8U);
  EXPECT_LT(counters.vertices_a + counters.vertices_b, 200U);  // of 2000
}

TEST(DecidingPoints, DenominatorsThatRepeatAreNoReason) {
  std::vector<Point> a, b;
  for (int i = 0; i < 2000; ++i) {
    a.push_back({mpq_class(i, 101), mpq_class(i * i, 103), mpq_class(1, i % 10 + 1)});
    for (mpq_class* c : {&a.back().x, &a.back().y}) c->canonicalize();
  }
  b = a;
  EXPECT_TRUE(polytope::place_if_slim(a, b));
}

TEST(DecidingPoints, ALatticeBeyondAllBoundsIsRefused) {
  Unlike some(11);
  const Points a = some.sphere(9000, 0);
  try {
    static_cast<void>(polytope::place(a, a));
    FAIL() << "no refusal";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "input: the denominators of the 18000 points share too little: over a common one all coordinates "
                 "together would pass 256 MB");
  }
}

// Bodies given in binary64 against the same exact points: equal answers and certificates; and on
// the way from the text of a case to its answer no point becomes rational. GMP's allocations are
// counted.

std::size_t allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  return std::malloc(size);
}
void* counted_again(void* memory, std::size_t, std::size_t size) {
  ++allocations;
  return std::realloc(memory, size);
}
void freed(void* memory, std::size_t) { std::free(memory); }

/// The points, rounded to binary64; nullopt if one overflows.
std::optional<Body> rounded(const Body& body) {
  std::vector<std::array<double, 3>> points;
  for (const Point& p : body.points) {
    points.push_back({round_binary64(p.x), round_binary64(p.y), round_binary64(p.z)});
    for (const double c : points.back())
      if (!std::isfinite(c)) return std::nullopt;
  }
  return Body{GivenPoints(std::move(points))};
}

std::vector<Case> cases_in_binary64() {
  std::vector<Case> result;
  for (const Case& input : testing::cases_of_all_families(2, 9)) {
    const std::optional<Body> a = rounded(input.a), b = rounded(input.b);
    if (a && b) result.push_back({input.id, *a, *b});
  }
  return result;
}

TEST(GivenBodies, AreAnsweredAsTheirExactPoints) {
  std::size_t apart = 0;
  for (const Case& input : cases_in_binary64()) {
    SCOPED_TRACE(input.id);
    const std::vector<Point>&a = input.a.points, &b = input.b.points;
    const Depth depth = penetration_depth(input.a, input.b), exact = penetration_depth(a, b);
    expect_equal(depth, exact);
    EXPECT_EQ(certificate_text(input.a, input.b, depth, "id"), certificate_text(a, b, exact, "id"));
    const Body a_alone{a};  // the other body is in binary64
    expect_equal(penetration_depth(a_alone, input.b), exact);
    EXPECT_EQ(certificate_text(a_alone, input.b, exact, "id"), certificate_text(a, b, exact, "id"));
    apart += depth.status() != Status::penetrating ? 1U : 0U;
    if (!exact.penetration()) continue;
    EXPECT_EQ(second_nearest_squared(input.a, input.b, *exact.penetration()),
              second_nearest_squared(a, b, *exact.penetration()));
  }
  EXPECT_GT(apart, 10U);
}

std::string vertices(const Body& body) {
  std::string text;
  for (const auto& [x, y, z] : body.points.binary64())
    text += fmt::format("{}[{},{},\"{}\"]", text.empty() ? "" : ",", x, y, hex_text(z));
  return "{\"vertices\":[" + text + "]}";
}

TEST(GivenBodies, BecomeNoRationalsOnTheWayToAnAnswer) {
  mp_set_memory_functions(counted, counted_again, freed);
  Options options;
  Workspace workspace;
  options.workspace = &workspace;
  std::size_t narrow = 0;
  for (const Case& input : cases_in_binary64()) {
    SCOPED_TRACE(input.id);
    const std::string plain = fmt::format(R"({{"a":{},"b":{}}})", vertices(input.a), vertices(input.b));
    const CaseItem item = parse_case(plain, "case");
    ASSERT_TRUE(item.ok()) << plain;
    const Case& read = item.value();
    ASSERT_TRUE(read.a.points.in_binary64() && read.b.points.in_binary64());
    EXPECT_TRUE(read.a.points == input.a.points && read.b.points == input.b.points);
    const auto cost = [&](const auto& ask) {
      const std::size_t before = allocations;
      const Depth depth = ask();
      static_cast<void>(certificate_text(read.a, read.b, depth));
      narrow += depth.method == Method::certificate ? 1U : 0U;
      return allocations - before;
    };
    cost([&] { return penetration_depth(read.a, read.b, options); });  // memory grows
    const std::size_t by_bodies = cost([&] { return penetration_depth(read.a, read.b, options); });
    const std::size_t by_doubles =
        cost([&] { return penetration_depth(read.a.points.binary64(), read.b.points.binary64(), options); });
    EXPECT_EQ(by_bodies, by_doubles);
  }
  EXPECT_GT(narrow, 100U);
}

TEST(GivenBodies, AreReadFromPlainNumbersWithoutGmp) {
  mp_set_memory_functions(counted, counted_again, freed);
  const std::string text =
      R"({"a":{"vertices":[[0.1,2,-3e-7],[1e300,5e-300,0]]},"b":{"vertices":[[1,2,3]]},"pose_rounding":"binary64"})";
  const std::size_t before = allocations;
  const CaseItem item = parse_case(text, "case");
  EXPECT_EQ(allocations, before);
  ASSERT_TRUE(item.ok());
  EXPECT_EQ(item.value().a.points[0].x, mpq_class(0.1));
  EXPECT_GT(allocations, before) << "exact points were asked for";
}

Depth depth_of(const Case& pair) { return penetration_depth(pair.a.points, pair.b.points); }

/// Four optima.
Depth penetrating() {
  const Body square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}}};
  return depth_of({"square prisms", square, square});
}
Depth touching() {
  return depth_of({"touching", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{0, 0, 0}, {-1, 0, 0}, {0, -1, 1}}}});
}
Depth disjoint() { return depth_of({"disjoint", {{{0, 0, 0}, {1, 0, 0}}}, {{{0, 2, 1}, {1, 3, 1}}}}); }

/// Changes one field; the sentence must begin with its name.
struct Change {
  const char* field;
  std::function<void(Depth&)> change;
};

void expect_named(const std::function<Depth()>& make, const std::vector<Change>& changes) {
  const Depth right = make();
  EXPECT_EQ(disagreement(right, right), std::nullopt);
  for (const Change& change : changes) {
    Depth wrong = right;
    change.change(wrong);
    for (const auto& sentence : {disagreement(right, wrong), disagreement(wrong, right)})
      EXPECT_TRUE(sentence && sentence->starts_with(std::string(change.field) + ": "))
          << change.field << " / " << sentence.value_or("none");
  }
}

Penetration& in(Depth& depth) { return std::get<Penetration>(depth.outcome); }
Witness& with_another_witness(Depth& depth) { return in(depth).meeting.emplace<Witness>(in(depth).witness()); }

TEST(Disagreement, NamesTheFieldOfPenetration) {
  ASSERT_EQ(penetrating().optima().size(), 4u);
  expect_named(penetrating,
               {{"status",
                 [](Depth& d) {
                   d.outcome = Touch{{1, 0, 0}, {0, 0, 0}};
                 }},
                {"flat_a", [](Depth& d) { d.flat_a = true; }},
                {"flat_b", [](Depth& d) { d.flat_b = true; }},
                {"squared", [](Depth& d) { in(d).optima[0].support += mpq_class(1, 1000); }},
                {"number of optima", [](Depth& d) { in(d).optima.pop_back(); }},
                {"optima[3].direction", [](Depth& d) { in(d).optima[3].direction.z += 1; }},
                {"optima[2].translation", [](Depth& d) { in(d).optima[2].support += 1; }},
                {"optima[1].contact", [](Depth& d) { in(d).optima[1].contact.kind = ContactKind::edge_edge; }},
                {"optima[0].contact", [](Depth& d) { in(d).optima[0].contact.a.pop_back(); }},
                {"optima[0].contact", [](Depth& d) { in(d).optima[0].contact.b.front() += 9; }},
                {"witness", [](Depth& d) { with_another_witness(d).a.y += 1; }},
                {"witness", [](Depth& d) { with_another_witness(d).b.z += 1; }}});
}

TEST(Disagreement, NamesTheFieldOfTouchingAndDisjointBodies) {
  ASSERT_EQ(touching().status(), Status::touching);
  expect_named(touching, {{"direction", [](Depth& d) { std::get<Touch>(d.outcome).direction.x += 1; }},
                          {"witness", [](Depth& d) { std::get<Touch>(d.outcome).point.x += 1; }}});
  ASSERT_EQ(disjoint().status(), Status::disjoint);
  expect_named(disjoint, {{"direction", [](Depth& d) { std::get<Distance>(d.outcome).direction.x += 1; }},
                          {"distance.squared", [](Depth& d) { std::get<Distance>(d.outcome).squared += 1; }},
                          {"distance.translation", [](Depth& d) { std::get<Distance>(d.outcome).translation.x += 1; }},
                          {"distance.witness", [](Depth& d) { std::get<Distance>(d.outcome).witness.a.x += 1; }}});
}

TEST(Disagreement, DoesNotMindWhatDependsOnTheMethod) {
  const Case pair = families::find_family("random_ball")->make(1, 12);
  const Depth x = depth_of(pair), y = penetration_depth(pair.a.points, pair.b.points, {.method = Method::exact});
  ASSERT_NE(x.method, y.method);
  ASSERT_NE(x.extreme_a, y.extreme_a);
  EXPECT_EQ(disagreement(x, y), std::nullopt);
}

TEST(Disagreement, SaysBothValues) {
  Depth wrong = penetrating();
  in(wrong).optima[0].support = mpq_class(1, 2);
  EXPECT_EQ(disagreement(penetrating(), wrong), "squared: 1 and 1/4");
  wrong = penetrating();
  in(wrong).optima[0].contact.a.pop_back();
  const std::string kind = "facet-facet: points ";
  EXPECT_EQ(disagreement(penetrating(), wrong),
            "optima[0].contact: " + kind + "1 2 5 6 of A, 0 3 4 7 of B and " + kind + "1 2 5 of A, 0 3 4 7 of B");
}

TEST(SecondMethod, IsExactOrNaive) {
  EXPECT_EQ(second_method("exact"), Method::exact);
  EXPECT_EQ(second_method("naive"), Method::naive);
  for (const char* word : {"automatic", "auto", "certificate", "", "Exact"}) EXPECT_FALSE(second_method(word)) << word;
}

}  // namespace
}  // namespace fathom::solve
