// SPDX-License-Identifier: GPL-3.0-or-later
// What the judge finds wrong with an answer, for tests about any kind of bodies.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fathom/judge.hpp"
#include "verify/judge/claim.hpp"
#include "verify/judge/manifold.hpp"

namespace fathom::testing {

inline constexpr Triple left{-1, 0, 0}, right{1, 0, 0}, up{0, 0, 1};

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

inline const Tolerance none{0, 0, 0};  // half an ulp of each number

using Findings = std::vector<Verdict>;

inline Reply with_witness(Reply reply, std::optional<Triple> a, std::optional<Triple> b) {
  reply.witness_a = a;
  reply.witness_b = b;
  return reply;
}

/// The sentence has to be one line, and the verdict the first of what is found.
template <class AnyTruth>
Findings findings(const AnyTruth& truth, const Reply& reply, const Conventions& conventions = {},
                  const Tolerance& tolerance = {}) {
  const Judgement result = judge(truth, reply, conventions, Precision::binary64, tolerance);
  EXPECT_EQ(result.sentence.find('\n'), std::string::npos);
  EXPECT_FALSE(result.sentence.empty());
  const Verdict right_verdict = result.status == Status::touching ? Verdict::touching_by_convention : Verdict::pass;
  EXPECT_EQ(result.verdict, result.findings.empty() ? right_verdict : result.findings.front());
  return result.findings;
}

/// The judge of an answer's contacts, with all that it looks at.
struct OwnedContactJudge {
  judging::Claim claim;
  judging::Allowances allowed;
  judging::ContactJudge judge;

  OwnedContactJudge(const Truth& truth, const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                    const Tolerance& tolerance)
      : claim(judging::exact_claim(reply, conventions, format.exponent)),
        allowed(judging::sizes_of(truth.a, truth.b), truth.depth.squared(), format, tolerance),
        judge(truth, claim, allowed, conventions.manifold, format.exponent, tolerance.patch_slack) {}
  OwnedContactJudge(const OwnedContactJudge&) = delete;
  OwnedContactJudge& operator=(const OwnedContactJudge&) = delete;
  ~OwnedContactJudge() = default;
};

}  // namespace fathom::testing
