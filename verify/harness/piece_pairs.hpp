// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a case of unions, as a subject sees it, which takes convex bodies.
// Output  an answer about the unions as engines have it: the deepest of the answers about the pairs of pieces.     [verify/PROTOCOL.md]
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "verify/harness/outcome.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/harness/seen_case.hpp"

namespace fathom::harness {

/// Puts a pair of pieces, as a case of its own with the id of pair_id. Sets the answer, or returns an outcome with verdict and detail.
using AskPair = std::function<Outcome(const Case& pair, std::optional<SubjectAnswer>& answer)>;

/// "key[0,2]": piece 0 of A and piece 2 of B.
std::string pair_id(const std::string& id, std::uint32_t a, std::uint32_t b);
/// Whether the text is the id of a pair of pieces of this case.
bool is_pair_of(std::string_view text, const Case& pair);

/// Why a case cannot be put to the subject, which sees lengths times 2^exponent: it is one of unions, and the subject rounds bodies; or it
/// rounds them by a radius beside which its answers cannot tell bodies of this size, whatever they are. Empty if it can be.
std::string obstacle_to(const Case& seen, const SubjectInfo& info, long exponent);
/// Whether the subject is asked about the case by its pairs of pieces.
bool is_asked_in_pairs(const Case& seen, const SubjectInfo& info);

/// Asks about each pair of pieces, row by row, until there is no answer to one: then that is the outcome. What was declined makes the case
/// declined, once all have been asked. Else the answer is
///   of replies that claim an overlap, if any do, the deepest; or the first, if none has a depth;
///   else "apart", with the least distance if every reply has one.
/// A number that is not finite is deeper than any, and nearer. The answer is judged as one about the unions, and as one about its pair.
Outcome examine_pairs(const Case& seen, long exponent, const SubjectInfo& info, const Judging& judging, const AskPair& ask);

}  // namespace fathom::harness
