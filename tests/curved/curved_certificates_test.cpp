// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of random pairs of all kinds, a half-space among them, by the public functions and
// the independent checker.
#include <gtest/gtest.h>

#include <string>

#include "fathom/certificate.hpp"
#include "fathom/signed_depth.hpp"
#include "tests/support/random_shapes.hpp"
#include "verify/check/check.hpp"

namespace fathom::curved {
namespace {

using testing::ShapeMaker;

struct Counts {
  int pairs = 0, penetrating = 0, disjoint = 0, long_ones = 0;
};

void check(const Shape& a, const Shape& b, const std::string& what, Counts& counts) {
  SignedDepthOptions options;
  options.support_calls = 600;
  const SignedDepth depth = signed_depth(a, b, options);
  const std::string text = certificate_text(a, b, depth, "pair");
  const fathom_check::Verdict verdict = fathom_check::verify(text);
  const std::string line = fathom_check::verdict_line(verdict, "pair"),
                    status = depth.status() ? std::string(name(*depth.status())) : "undecided";
  EXPECT_EQ(line.substr(0, 11 + status.size()), "s VERIFIED " + status) << what << ": " << line;
  if (const Bounds* bounds = depth.bounds()) {
    const std::string proved = "signed_depth_in=[" + exact_text(bounds->low) + "," + exact_text(bounds->high) + "]";
    EXPECT_NE(line.find(proved), std::string::npos) << what << ": " << line;
  }
  ++counts.pairs;
  counts.penetrating += depth.status() == Status::penetrating ? 1 : 0;
  counts.disjoint += depth.status() == Status::disjoint ? 1 : 0;
  counts.long_ones += text.size() > 30'000 ? 1 : 0;
}

TEST(CurvedCertificates, OfAllKindsAreVerified) {
  Counts counts;
  for (const unsigned bits : {3U, 20U, 50U}) {
    ShapeMaker make{families::Random(bits), bits};
    for (const std::string_view kind_a : ShapeMaker::kinds) {
      for (const std::string_view kind_b : ShapeMaker::kinds) {
        const std::string what = std::string(kind_a) + " and " + std::string(kind_b);
        for (const std::int64_t reach : {1, 2, 4}) {
          const Shape a = make.posed(make.shape(kind_a), 0), b = make.posed(make.shape(kind_b), reach);
          check(a, b, what, counts);
        }
      }
      const Shape half = halfspace(make.point(1), make.length()), body = make.posed(make.shape(kind_a), 2);
      check(half, body, "half-space and " + std::string(kind_a), counts);
      check(body, half, std::string(kind_a) + " and half-space", counts);
    }
  }
  EXPECT_GT(counts.pairs, 1100);
  EXPECT_GT(counts.penetrating, 300);
  EXPECT_GT(counts.disjoint, 300);
  EXPECT_LT(counts.long_ones, counts.pairs / 50);
}

}  // namespace
}  // namespace fathom::curved
