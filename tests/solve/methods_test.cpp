// SPDX-License-Identifier: GPL-3.0-or-later
// The methods against each other, field by field; and how often the expansion closes, per family,
// with the sizes of its proofs.
#include <gtest/gtest.h>

#include <cstdio>

#include "fathom/certificate.hpp"
#include "fathom/depth.hpp"
#include "reference/solve/depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/monitors.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/same_answer.hpp"
#include "verify/families/catalogue.hpp"

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
