// SPDX-License-Identifier: GPL-3.0-or-later
// A case on its way through the harness: as the subject sees it, and as it is judged.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "verify/harness/outcome.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/harness/two_ways.hpp"

namespace fathom::harness {

/// Returns the case with its points rounded to the precision; nullopt if a coordinate overflows it.
std::optional<Case> as_seen(const Case& pair, Precision precision);

/// A hash of the points in 16 hexadecimal digits: FNV-1a over their exact text.
std::string digest_of(const Case& pair);

/// An outcome without a verdict, for the case as it is seen.
Outcome outcome_for(const Case& seen);
/// The outcome of a case that the subject's precision cannot hold.
Outcome overflowed(const Case& pair, Precision precision);

/// How answers are judged.
struct Judging {
  Tolerance tolerance = {};
  std::vector<Solver> second = {};       ///< ways to find the truth and the judgement again
  std::function<bool()> stop = nullptr;  ///< ends the work with Interrupted; may be empty
  Workspace* workspace = nullptr;        ///< of the thread that judges; may be null
};

/// Solves the case exactly and fills in verdict, detail, reply and judgement. Throws Disagreement if one of the second ways leads to
/// another truth, or to another judgement in any field.
void judge_answer(Outcome& outcome, const Case& seen, const SubjectAnswer& answer, const SubjectInfo& info, const Judging& judging);

}  // namespace fathom::harness
