// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies and what an implementation answered about them.
// Output  the verdict, with its residuals: exact squares, and differences correctly rounded.             [verify/judge/VERDICTS.md]
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/depth.hpp"
#include "verify/judge/reply.hpp"
#include "verify/judge/verdict.hpp"

namespace fathom {

/// How wrong an answer may be: by the largest of relative * depth, absolute * extent, ulps * ulp(depth). The extent is the longest side of
/// the bodies' boxes, the larger of the two; an ulp is that of the subject's precision at the depth. Below 0 counts as 0.
/// Besides, an answer may be off by what rounding each of its numbers to nearest costs, or an error of `ulps` in each.
struct Tolerance {
  mpq_class relative{1, 1000};
  mpq_class absolute{1, 1'000'000};
  unsigned long ulps = 0;
};

/// The best class that a right depth is in.
enum class Accuracy { correctly_rounded, ulps_4, u_r_16, millionth, tolerance };
/// "correctly rounded", "4 ulp", "16 uR", "1e-6", "tolerance".
std::string_view name(Accuracy accuracy);

/// Two bodies as the subject saw them, and the exact answer.
struct Truth {
  std::vector<Point> a, b;
  Depth depth;
};

/// The points rounded to the precision (to nearest), which is what a subject of that precision sees. Nothing if one overflows.
std::optional<std::vector<Point>> seen(const std::vector<Point>& points, Precision precision);

/// Throws std::invalid_argument when a body is empty, and Interrupted.
Truth truth_about(std::vector<Point> a, std::vector<Point> b, const Options& options = {});

struct Judgement {
  Verdict verdict = Verdict::garbage;
  std::vector<Verdict> findings;     ///< everything that is wrong with the answer, in order of rank
  std::optional<Accuracy> accuracy;  ///< of a pass with a depth

  Status status = Status::disjoint;  ///< the truth
  mpq_class depth_squared;           ///< the truth; 0 unless penetrating
  mpq_class distance_squared;        ///< the truth; 0 unless disjoint

  // Residuals are those of the claim as it stands, conventions undone, whatever the verdict; infinite beyond binary64.
  // Of a claimed depth, correctly rounded to nearest: how much it is too deep (below 0: too shallow).
  std::optional<double> error, error_ulps, error_relative, error_u_r;  ///< no relative error and no ulps of depth 0
  // Of a claimed direction u: by the plane across it, and along it. Signed squares: negative where the bodies are apart.
  std::optional<mpq_class> price_squared;   ///< h(u)^2 / <u,u>: A moved so far along u lies behind a plane across u
  std::optional<mpq_class> travel_squared;  ///< squared length of the shortest way along u after which the interiors are disjoint
  std::optional<double> inconsistency;      ///< the claimed depth less the price
  std::optional<double> overlap_left;       ///< travel less the claimed depth, where that is positive
  // Of witness points: squared distances from their bodies, exact, and the length of (b - a) - translation, rounded;
  // where no direction is claimed, | |b - a| - depth |.
  std::optional<mpq_class> witness_a_squared, witness_b_squared;
  std::optional<double> witness_gap;

  std::string sentence;  ///< for people, one line: "too deep by 0.4392: 1.0392 is claimed, the depth is 0.6; ..."
};

/// Total: any numbers in `reply` are judged. The definitions are those of verify/judge/VERDICTS.md.
Judgement judge(const Truth& truth, const Reply& reply, const Conventions& conventions = {}, Precision precision = Precision::binary64,
                const Tolerance& tolerance = {});

/// The same for points in binary64, all of it in one call; they are rounded to the precision first. Throws std::invalid_argument when a
/// body is empty, or a coordinate is not finite or beyond the precision.
Judgement judge(const std::vector<Triple>& a, const std::vector<Triple>& b, const Reply& reply, const Conventions& conventions = {},
                Precision precision = Precision::binary64, const Tolerance& tolerance = {});

}  // namespace fathom
