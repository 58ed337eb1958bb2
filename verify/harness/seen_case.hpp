// SPDX-License-Identifier: GPL-3.0-or-later
// A case on its way through the harness: as the subject sees it, and as it is judged.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "verify/harness/outcome.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/harness/two_ways.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::harness {

/// Returns the case as a subject of this format sees it, in the unit of the case, which takes bodies by the names in `shapes`. A body that
/// was given by such a name has its parameters, its margin and its pose rounded, and is the body of these. Any other has its points
/// rounded, and no words. Returns nullopt, and the reason in `why`, if a number overflows the format, rounding leaves no body, a body is no
/// polytope and its name is not in `shapes`, or both are half-spaces. What was seen is seen again as it is. If a body is a union, both are
/// seen as pieces, without words; then nullopt is returned too if rounding leaves a piece without interior.
std::optional<Case> as_seen(const Case& pair, const NumberFormat& format, const std::set<std::string>& shapes = {},
                            std::string* why = nullptr);

/// Returns the k for which the extent of the bodies times 2^k is less than `size`, and at least half of it; 0 without a size, and for a
/// point on a point. The size is above 0.
long exponent_to_fit(const Case& pair, const std::optional<mpq_class>& size);

/// The lengths of the bodies, those of shapes rounded up.
judging::Sizes sizes_of(const Case& pair);

/// Whether a body of the case is a union of pieces.
inline bool has_union(const Case& pair) { return pair.a.pieces || pair.b.pieces; }

/// Whether a body of the case has words, by which a subject is given it.
inline bool has_words(const Case& pair) { return pair.a.words || pair.b.words; }

/// A hash of the bodies in 16 hexadecimal digits: FNV-1a over the exact text of their points, or of their words.
std::string digest_of(const Case& pair);

/// An outcome without a verdict, for the case as it is seen, with all lengths times 2^exponent.
Outcome outcome_for(const Case& seen, long exponent = 0);
/// The outcome of a case that is not put to the subject, for that reason.
Outcome declined(const Case& pair, const std::string& why);

/// How answers are judged.
struct Judging {
  Tolerance tolerance = {};
  std::vector<Solver> second = {};       ///< ways to find the truth and the judgement again
  std::function<bool()> stop = nullptr;  ///< ends the work with Interrupted; may be empty
  Workspace* workspace = nullptr;        ///< of the thread that judges; may be null
};

/// Solves the case exactly and fills in verdict, detail, reply and judgement. Throws Disagreement if one of the second ways leads to
/// another truth, or to another judgement in any field. Of shapes there is one second way, whatever was asked for: the certificate of the
/// truth, which the checker must accept as a proof of it, or std::logic_error is thrown; and so it is of unions.
void judge_answer(Outcome& outcome, const Case& seen, const SubjectAnswer& answer, const SubjectInfo& info, const Judging& judging);

/// Adds to the judgement that the reply lacks what the hello promises, if it does.
void hold_to_promises(Judgement& judgement, const Reply& reply, const std::set<std::string>& promises);

}  // namespace fathom::harness
