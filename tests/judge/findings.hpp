// SPDX-License-Identifier: GPL-3.0-or-later
// What the judge finds wrong with an answer, for tests about any kind of bodies.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fathom/judge.hpp"

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

}  // namespace fathom::testing
