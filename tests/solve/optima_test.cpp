// SPDX-License-Identifier: GPL-3.0-or-later
// Answers that count all optima and list the first few: otherwise those that list all, by every
// method.
#include <gtest/gtest.h>

#include "fathom/approximate.hpp"
#include "fathom/certificate.hpp"
#include "reference/certificate/certificate.hpp"
#include "verify/families/families.hpp"
#include "verify/families/solids.hpp"

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
