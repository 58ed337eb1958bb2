// SPDX-License-Identifier: GPL-3.0-or-later
// The method `certificate` against the pipeline, field by field; and how often it closes, per family, with the sizes of its proofs.
#include "reference/depth/certified_depth.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "reference/certificate/certificate.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/catalogue.hpp"

namespace fathom {
namespace {

Options certificate_method() {
  Options options;
  options.method = Method::certificate;
  return options;
}

void expect_same(const Depth& x, const Depth& y) {
  EXPECT_EQ(x.status(), y.status());
  EXPECT_EQ(x.squared(), y.squared());
  EXPECT_EQ(x.optima(), y.optima());
  EXPECT_EQ(x.direction(), y.direction());
  EXPECT_EQ(x.translation(), y.translation());
  EXPECT_EQ(x.contact(), y.contact());
  EXPECT_EQ(x.witness(), y.witness());
  EXPECT_EQ(x.flat_a, y.flat_a);
  EXPECT_EQ(x.flat_b, y.flat_b);
}

TEST(CertifiedDepth, IsTheAnswerOfThePipeline) {
  std::vector<Case> cases;
  for (const unsigned size : {7U, 16U, 40U})
    for (const families::Family& family : families::families()) cases.push_back(family.make(size, size));
  for (const families::CatalogueEntry& entry : families::catalogue()) cases.push_back(entry.pair);
  std::size_t closed = 0;
  for (const Case& input : cases) {
    SCOPED_TRACE(input.id);
    const Depth exact = penetration_depth(input.a.points, input.b.points);
    Options options = certificate_method();
    options.validate = true;
    const Depth certified = penetration_depth(input.a.points, input.b.points, options);
    expect_same(certified, exact);
    EXPECT_EQ(certified.inner.has_value(), certified.method == Method::certificate);
    EXPECT_FALSE(exact.inner.has_value());
    EXPECT_EQ(exact.method, Method::exact);
    closed += certified.inner ? 1U : 0U;
  }
  EXPECT_GT(closed, 120U);
}

TEST(CertifiedDepth, LeavesTheRestToThePipeline) {
  const Case input = families::find_family("crossed_patch")->make(1, 16);
  Options options = certificate_method();
  options.expansion_budget = 3;
  const Depth depth = penetration_depth(input.a.points, input.b.points, options);
  EXPECT_EQ(depth.method, Method::exact);
  EXPECT_GT(depth.extreme_a, 0U) << "hulls were taken";
  expect_same(depth, penetration_depth(input.a.points, input.b.points));
}

TEST(CertifiedDepth, CanBeStopped) {
  const Case input = families::find_family("random_sphere")->make(1, 20);
  Options options = certificate_method();
  options.progress = [](const std::string&, double) { return false; };
  EXPECT_THROW(penetration_depth(input.a.points, input.b.points, options), Interrupted);
}

// Bits of the numbers beside the points: the directions and the claimed depth.
std::size_t bits_of(const Certificate& certificate) {
  std::size_t bits = mpz_sizeinbase(certificate.low.get_num_mpz_t(), 2) + mpz_sizeinbase(certificate.low.get_den_mpz_t(), 2);
  for (const Vector& n : certificate.directions)
    for (const mpz_class* c : {&n.x, &n.y, &n.z}) bits += mpz_sizeinbase(c->get_mpz_t(), 2);
  return bits;
}

TEST(CertifiedDepth, ClosesWithinItsBudgetAlmostAlways) {
  std::printf("size 30: closed within the budget of those that penetrate; the greatest numbers\n%-34s %8s %8s %8s %8s %8s\n", "family",
              "closed", "points", "facets", "bits", "bytes");
  std::size_t all = 0, closed = 0;
  for (const families::Family& family : families::families()) {
    std::size_t here = 0, within = 0, points = 0, facets = 0, bits = 0, bytes = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const Case input = family.make(seed, 30);
      const Depth depth = penetration_depth(input.a.points, input.b.points, certificate_method());
      if (depth.status() != Status::penetrating) continue;
      const Certificate certificate = make_certificate(input.a.points, input.b.points, depth);
      ++here;
      within += depth.inner ? 1U : 0U;
      points = std::max<std::size_t>(points, depth.counters.expansions);
      facets = std::max(facets, certificate.inner.facets.size());
      bits = std::max(bits, bits_of(certificate));
      bytes = std::max(bytes, certificate_text(certificate).size());
    }
    if (here > 0)
      std::printf("%-34s %4zu/%-3zu %8zu %8zu %8zu %8zu\n", std::string(family.name).c_str(), within, here, points, facets, bits, bytes);
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
}  // namespace fathom
