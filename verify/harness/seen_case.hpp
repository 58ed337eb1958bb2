// SPDX-License-Identifier: GPL-3.0-or-later
// A case on its way through the harness: as the subject sees it, and as it is judged.
#pragma once

#include <optional>
#include <string>

#include "verify/harness/outcome.hpp"
#include "verify/harness/protocol.hpp"

namespace fathom::harness {

/// Returns the case with its points rounded to the precision; nullopt if a coordinate overflows it.
std::optional<Case> as_seen(const Case& pair, Precision precision);

/// A hash of the points in 16 hexadecimal digits: FNV-1a over their exact text.
std::string digest_of(const Case& pair);

/// An outcome without a verdict, for the case as it is seen.
Outcome outcome_for(const Case& seen);
/// The outcome of a case that the subject's precision cannot hold.
Outcome overflowed(const Case& pair, Precision precision);

/// Solves the case exactly and fills in verdict, detail, reply and judgement. `stop` ends it with Interrupted.
void judge_answer(Outcome& outcome, const Case& seen, const SubjectAnswer& answer, const SubjectInfo& info, const Tolerance& tolerance,
                  const std::function<bool()>& stop);

}  // namespace fathom::harness
