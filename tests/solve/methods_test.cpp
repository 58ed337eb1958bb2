// SPDX-License-Identifier: GPL-3.0-or-later
// The methods against each other, field by field; and how often the expansion closes, per family,
// with the sizes of its proofs.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

#include "fathom/approximate.hpp"
#include "fathom/certificate.hpp"
#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "reference/certificate/certificate.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/solve/depth.hpp"
#include "tests/oracles/width_oracle.hpp"
#include "tests/solve/same_depth.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/monitors.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/same_answer.hpp"
#include "verify/families/families.hpp"
#include "verify/families/solids.hpp"

namespace fathom::solve {
namespace {

bool has_proof(const Depth& depth) { return depth.penetration() && depth.penetration()->inner; }

TEST(Methods, AgreeInEveryField) {
  std::vector<Case> cases;
  for (const unsigned size : {7U, 16U, 40U})
    for (const families::Family& family : families::families()) cases.push_back(family.make(size, size));
  for (const families::CatalogueEntry& entry : families::catalogue()) cases.push_back(entry.pair);
  std::size_t closed = 0;
  for (const Case& input : cases) {
    SCOPED_TRACE(input.id);
    const Depth exact = testing::exact_depth(input.a.points, input.b.points);
    EXPECT_EQ(exact.method, Method::exact);
    EXPECT_FALSE(has_proof(exact));
    const Depth automatic = penetration_depth(input.a.points, input.b.points, {.validate = true});
    testing::expect_same_answer(automatic, exact);
    EXPECT_EQ(has_proof(automatic), automatic.method == Method::certificate);
    EXPECT_TRUE(has_proof(automatic) || automatic.method == Method::exact);
    closed += has_proof(automatic) ? 1U : 0U;
    const Depth naive = penetration_depth(input.a.points, input.b.points, {.method = Method::naive});
    testing::expect_same_answer(naive, exact);
    EXPECT_EQ(naive.method, Method::naive);
    EXPECT_EQ(naive.extreme_a, exact.extreme_a);
    EXPECT_EQ(naive.extreme_b, exact.extreme_b);
  }
  EXPECT_GT(closed, 120U);
}

TEST(Methods, AutomaticIsExactPastItsBudgetAndCertificateGoesOn) {
  const Case input = families::find_family("crossed_patch")->make(1, 16);
  const Depth exact = testing::exact_depth(input.a.points, input.b.points);
  const Depth automatic = penetration_depth(input.a.points, input.b.points, {.expansion_budget = 3});
  EXPECT_EQ(automatic.method, Method::exact);
  EXPECT_GT(automatic.extreme_a, 0U) << "hulls were taken";
  testing::expect_same_answer(automatic, exact);
  const Depth certified =
      penetration_depth(input.a.points, input.b.points, {.method = Method::certificate, .expansion_budget = 3});
  EXPECT_EQ(certified.method, Method::certificate);
  testing::expect_same_answer(certified, exact);
}

TEST(Methods, AutomaticIsExactWhereAnEngineIsAskedFor) {
  const Case input = families::find_family("random_sphere")->make(1, 20);
  EXPECT_EQ(penetration_depth(input.a.points, input.b.points).method, Method::certificate);
  EXPECT_EQ(penetration_depth(input.a.points, input.b.points, {.closest_lines = ClosestLines::naive}).method,
            Method::exact);
}

TEST(Methods, AllCanBeStopped) {
  const Case input = families::find_family("random_sphere")->make(1, 20);
  for (const Method method : {Method::automatic, Method::exact, Method::naive, Method::certificate}) {
    testing::Recorder impatient(0);
    EXPECT_THROW(penetration_depth(input.a.points, input.b.points, {.method = method, .monitor = &impatient}),
                 Interrupted)
        << name(method);
  }
}

// Bits of the numbers beside the points: the directions and the claimed depth.
std::size_t bits_of(const Certificate& certificate) {
  std::size_t bits =
      mpz_sizeinbase(certificate.low.get_num_mpz_t(), 2) + mpz_sizeinbase(certificate.low.get_den_mpz_t(), 2);
  for (const Vector& n : certificate.directions)
    for (const mpz_class* c : {&n.x, &n.y, &n.z}) bits += mpz_sizeinbase(c->get_mpz_t(), 2);
  return bits;
}

TEST(Methods, TheExpansionClosesWithinItsBudgetAlmostAlways) {
  std::printf(
      "size 30: closed within the budget of those that penetrate; the greatest numbers\n%-34s %8s %8s %8s %8s %8s\n",
      "family", "closed", "points", "facets", "bits", "bytes");
  std::size_t all = 0, closed = 0;
  for (const families::Family& family : families::families()) {
    std::size_t here = 0, within = 0, points = 0, facets = 0, bits = 0, bytes = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const Case input = family.make(seed, 30);
      const Depth depth = penetration_depth(input.a.points, input.b.points);
      if (depth.status() != Status::penetrating) continue;
      const Certificate certificate = make_certificate(input.a.points, input.b.points, depth);
      ++here;
      within += has_proof(depth) ? 1U : 0U;
      points = std::max<std::size_t>(points, depth.counters.expansions);
      facets = std::max(facets, certificate.inner.facets.size());
      bits = std::max(bits, bits_of(certificate));
      bytes = std::max(bytes, certificate_text(certificate).size());
    }
    if (here > 0)
      std::printf("%-34s %4zu/%-3zu %8zu %8zu %8zu %8zu\n", std::string(family.name).c_str(), within, here, points,
                  facets, bits, bytes);
    if (!family.name.starts_with("crossed_")) {
      EXPECT_EQ(within, here) << family.name << ": only bundles may tie too often";
    }
    all += here;
    closed += within;
  }
  std::printf("%zu of %zu\n", closed, all);
  EXPECT_GT(all, 150U);
  EXPECT_GE(closed * 10, all * 9);
}

}  // namespace
}  // namespace fathom::solve

// Answers that count all optima and list the first few: otherwise those that list all, by every
// method.

namespace fathom {
namespace {

Options listing(std::size_t n, Method method = Method::automatic) {
  Options options;
  options.method = method;
  options.optima = n;
  return options;
}

// `cut` lists the first optima of `whole`, and is the same in all else.
void expect_first(const Depth& cut, const Depth& whole, std::size_t listed) {
  ASSERT_EQ(cut.status(), whole.status());
  EXPECT_EQ(cut.squared(), whole.squared());
  EXPECT_EQ(cut.optima_count(), whole.optima().size());
  ASSERT_EQ(cut.optima().size(), std::min(listed, whole.optima().size()));
  EXPECT_TRUE(std::equal(cut.optima().begin(), cut.optima().end(), whole.optima().begin()));
  EXPECT_EQ(cut.direction(), whole.direction());
  EXPECT_EQ(cut.witness(), whole.witness());
}

TEST(Optima, TheFirstAreListedAndAllAreCounted) {
  std::size_t cuts = 0;
  for (const char* name :
       {"exact_ties", "platonic_aligned", "boxes_aligned", "random_sphere", "touching_edge_edge", "random_disjoint"}) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
      const Case input = families::find_family(name)->make(seed, 12);
      for (const Method method : {Method::automatic, Method::exact, Method::naive, Method::certificate}) {
        const Depth whole = penetration_depth(input.a.points, input.b.points, {.method = method});
        EXPECT_EQ(whole.optima_count(), whole.optima().size());
        for (const std::size_t n : {1U, 2U, 5U, 1000U}) {
          SCOPED_TRACE(input.id + ", " + std::string(fathom::name(method)) + ", " + std::to_string(n));
          const Depth cut = penetration_depth(input.a.points, input.b.points, listing(n, method));
          expect_first(cut, whole, n);
          cuts += cut.optima_count() > n;
        }
      }
    }
  }
  EXPECT_GT(cuts, 50U);
}

TEST(Optima, OfTheShallowMethodToo) {
  const Case input = families::find_family("platonic_aligned")->make(2, 12);
  const Depth whole = shallow_depth(input.a.points, input.b.points);
  Options options;
  options.optima = 1;
  expect_first(shallow_depth(input.a.points, input.b.points, options), whole, 1);
}

// Bodies without a slim common lattice: the few points that decide are found by all optima, listed
// or not.
TEST(Optima, OfBodiesOverManyDenominators) {
  Body body;
  const auto add = [&](long x, long y, long z, const mpq_class& size) {
    body.points.push_back({mpq_class(x * size), mpq_class(y * size), mpq_class(z * size)});
  };
  for (const long s : {1L, -1L}) {
    add(s, 0, 0, 1);
    add(0, s, 0, 1);
    add(0, 0, s, 1);
  }
  // Points inside, of which no two share a factor of their denominators.
  gmp_randclass random(gmp_randinit_default);
  for (int i = 0; i < 400; ++i) {
    mpz_class prime;
    mpz_nextprime(prime.get_mpz_t(), mpz_class(random.get_z_bits(128) + (mpz_class(1) << 127)).get_mpz_t());
    mpq_class share(random.get_z_range(prime / 8), prime);
    share.canonicalize();
    add(1, i % 2, -1, share);
  }
  const Depth whole = penetration_depth(body.points, body.points);
  ASSERT_EQ(whole.optima_count(), 8U);
  EXPECT_EQ(whole.extreme_a, 0U) << "not the way for many denominators";
  expect_first(penetration_depth(body.points, body.points, listing(3, Method::exact)), whole, 3);
}

TEST(Optima, ACertificateOfACutListClaimsTheDepthAlone) {
  const Body cube = families::cube();
  for (const Method method : {Method::certificate, Method::exact}) {
    const Depth cut = penetration_depth(cube.points, cube.points, listing(2, method));
    const Certificate some = make_certificate(cube.points, cube.points, cut);
    EXPECT_FALSE(some.complete);
    EXPECT_EQ(some.directions.size(), 2U);
    EXPECT_TRUE(certificate::validate(some).ok());
    EXPECT_NE(certificate_text(some).find("directions 2 some\n"), std::string::npos);
    const Certificate all =
        make_certificate(cube.points, cube.points, penetration_depth(cube.points, cube.points, listing(6, method)));
    EXPECT_TRUE(all.complete);
    EXPECT_NE(certificate_text(all).find("directions 6 all\n"), std::string::npos);
    Certificate claims_all = some;
    claims_all.complete = true;
    EXPECT_FALSE(certificate::validate(claims_all).ok());
  }
}

// A list that is one short, or a count that is one off, is noticed when a proof is found anew.
TEST(Optima, ACertificateContradictsAWrongCount) {
  const Body cube = families::cube();
  Depth wrong = penetration_depth(cube.points, cube.points, listing(2, Method::exact));
  ++std::get<Penetration>(wrong.outcome).unlisted;
  EXPECT_THROW((void)make_certificate(cube.points, cube.points, wrong), std::logic_error);
}

TEST(Optima, WhatNeedsThemAllRefusesACutList) {
  const Body cube = families::cube();
  const Depth cut = penetration_depth(cube.points, cube.points, listing(2));
  EXPECT_THROW((void)second_nearest_squared(cube.points, cube.points, *cut.penetration()), std::invalid_argument);
  EXPECT_THROW((void)penetration_depth(cube.points, cube.points, listing(0)), std::invalid_argument);
  EXPECT_THROW((void)shallow_depth(cube.points, cube.points, listing(0)), std::invalid_argument);
}

}  // namespace
}  // namespace fathom

// AGHRS, Proposition 2.1 against rotating calipers.

namespace fathom::solve {
namespace {

TEST(Width, EqualsCgalsCalipers) {
  std::size_t solids = 0;
  for (const Case& input : testing::cases_of_all_families(2, 14)) {
    const Depth depth = width(input.a.points, {.method = Method::exact});
    const kernels::Report report = testing::check(depth, input.a.points, input.a.points);
    EXPECT_TRUE(report.ok()) << input.id << "\n" << testing::text(report);
    if (depth.flat_a) {
      EXPECT_EQ(depth.status(), Status::touching) << input.id;
      continue;
    }
    const oracles::OracleAnswer oracle = oracles::width_oracle(input.a.points);
    EXPECT_EQ(depth.squared(), oracle.squared) << input.id;
    ++solids;
  }
  EXPECT_GT(solids, 60U);
}

// Larger bodies, by both methods.
TEST(Width, EqualsCgalsCalipersUpTo200Vertices) {
  for (const char* name : {"random_sphere", "crossed_fans", "prisms_posed"}) {
    for (const unsigned size : {100U, 200U}) {
      const Case input = families::find_family(name)->make(1, size);
      const mpq_class calipers = oracles::width_oracle(input.a.points).squared;
      for (const Method method : {Method::exact, Method::automatic})
        EXPECT_EQ(width(input.a.points, {.method = method}).squared(), calipers) << input.id;
    }
  }
}

// The optima of a body against itself come in opposite pairs, with the faces exchanged.
TEST(Width, OptimaComeInOppositePairs) {
  for (const Case& input : testing::cases_of_all_families(1, 14)) {
    const Depth depth = width(input.a.points, {.method = Method::exact});
    const std::size_t n = depth.optima().size();
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_EQ(depth.optima()[i].direction, -depth.optima()[n - 1 - i].direction) << input.id;
      EXPECT_EQ(depth.optima()[i].contact.a, depth.optima()[n - 1 - i].contact.b) << input.id;
    }
  }
}

TEST(Width, OfABoxIsItsShortestSide) {
  std::vector<Point> box;
  for (int i = 0; i < 8; ++i) box.push_back({i & 1 ? mpq_class(5, 2) : mpq_class(0), i & 2 ? 3 : 0, i & 4 ? 4 : 0});
  EXPECT_EQ(width(box).squared(), mpq_class(25, 4));
}

// The answer on a narrow lattice against its naive twin, the same method on any lattice, and
// against the exact method; points given as doubles against the same points as rationals.

using Doubles = std::vector<std::array<double, 3>>;

/// The points, rounded to binary64.
Doubles doubles(const Body& body) {
  Doubles result;
  for (const Point& p : body.points) result.push_back({round_binary64(p.x), round_binary64(p.y), round_binary64(p.z)});
  return result;
}

bool finite(const Doubles& body) {
  for (const std::array<double, 3>& p : body)
    for (const double c : p)
      if (!std::isfinite(c)) return false;
  return true;
}

TEST(NarrowDepth, EqualsTheTwinOnEveryFamily) {
  Workspace workspace;
  std::map<Status, std::size_t> answered;
  for (const unsigned size : {5U, 14U}) {
    for (const Case& input : testing::cases_of_all_families(3, size)) {
      SCOPED_TRACE(input.id);
      kernels::Context context;
      Options options;
      const NarrowResult narrow = depth_on_narrow_lattice(context, input.a.points, input.b.points, options);
      options.workspace = &workspace;
      const NarrowResult again = depth_on_narrow_lattice(context, input.a.points, input.b.points, options);
      EXPECT_EQ(narrow.depth.has_value(), again.depth.has_value());
      EXPECT_EQ(narrow.pair.has_value(), again.pair.has_value());
      if (!narrow.depth) continue;
      ++answered[narrow.depth->status()];
      kernels::Context other;
      expect_equal(*narrow.depth, depth_by_method(other, polytope::place(input.a.points, input.b.points), {}));
      expect_equal(*again.depth, *narrow.depth);
    }
  }
  EXPECT_GT(answered[Status::penetrating], 300U);
  for (const Status status : {Status::touching, Status::disjoint}) EXPECT_GT(answered[status], 30U);
}

TEST(NarrowDepth, DoublesStandForTheirExactValues) {
  Workspace workspace;
  std::size_t penetrating = 0, others = 0;
  for (const Case& input : testing::cases_of_all_families(3, 10)) {
    const Doubles a = doubles(input.a), b = doubles(input.b);
    if (!finite(a) || !finite(b)) continue;
    SCOPED_TRACE(input.id);
    Options options;
    options.workspace = &workspace;
    const std::vector<Point> exact_a = polytope::exact_points(a), exact_b = polytope::exact_points(b);
    const Depth depth = penetration_depth(a, b, options);
    ++(depth.penetration() ? penetrating : others);
    expect_equal(depth, penetration_depth(exact_a, exact_b));
    testing::expect_same_answer(depth, testing::exact_depth(exact_a, exact_b));
    const std::string text = certificate_text(make_certificate(exact_a, exact_b, depth));
    EXPECT_EQ(certificate_text(a, b, depth), text);
    EXPECT_EQ(certificate_text(exact_a, exact_b, depth), text);
  }
  EXPECT_GT(penetrating, 80U);
  EXPECT_GT(others, 5U);
}

TEST(NarrowDepth, HandsOverWhatItCannotAnswer) {
  enum End { answered, failed, not_tried };
  kernels::Context context;
  const Doubles cube = doubles(families::cube()), point{{5, 0, 0}}, corner{{1, 0, 0}},
                far{{0x1p900, 0, 0}, {0x1p-900, 0, 0}};
  const auto end = [&](const Doubles& a, const Doubles& b, const Options& options = {}) {
    const NarrowResult result = depth_on_narrow_lattice(context, a, b, options);
    EXPECT_FALSE(result.depth && result.pair);
    return result.depth ? answered : result.pair ? failed : not_tried;
  };
  EXPECT_EQ(end(cube, cube), answered);
  EXPECT_EQ(end(cube, point), answered) << "disjoint";
  EXPECT_EQ(end(cube, corner), answered) << "touching";
  EXPECT_EQ(end(cube, far), not_tried) << "a lattice of 1800 bits";
  Options options;
  options.expansion_budget = 0;
  EXPECT_EQ(end(cube, cube, options), failed) << "no budget";
  options.method = Method::certificate;
  EXPECT_EQ(end(cube, cube, options), answered) << "which has none";
  for (const Method method : {Method::exact, Method::naive}) {
    options.method = method;
    EXPECT_EQ(end(cube, cube, options), not_tried);
  }
  for (const Doubles& apart : {point, corner}) EXPECT_EQ(penetration_depth(cube, apart).method, Method::exact);
  EXPECT_EQ(penetration_depth(cube, point).status(), Status::disjoint);
  EXPECT_EQ(penetration_depth(cube, corner).status(), Status::touching);
  EXPECT_EQ(penetration_depth(cube, far).status(), Status::penetrating);
}

TEST(NarrowDepth, RefusesBadInput) {
  const Doubles cube = doubles(families::cube()), none, bad{{0, std::nan(""), 0}};
  EXPECT_THROW(penetration_depth(cube, none), std::invalid_argument);
  EXPECT_THROW(penetration_depth(none, cube), std::invalid_argument);
  EXPECT_THROW(penetration_depth(cube, bad), std::invalid_argument);
  EXPECT_THROW(penetration_depth(bad, cube), std::invalid_argument);
}

}  // namespace
}  // namespace fathom::solve
