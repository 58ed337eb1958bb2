// SPDX-License-Identifier: GPL-3.0-or-later
// A case on its way through the harness: as the subject sees it, as it is judged, and of unions in
// pairs of pieces.
//                                                    [verify/PROTOCOL.md; verify/judge/VERDICTS.md]
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/harness/outcome.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/harness/two_ways.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::harness {

/// Returns the case as a subject of this format sees it, in the unit of the case, which takes
/// bodies by the names in `shapes`. A body that was given by such a name has its parameters, its
/// margin and its pose rounded, and is the body of these. Any other has its points rounded, and no
/// words. Returns nullopt, and the reason in `why`, if a number overflows the format, rounding
/// leaves no body, a body is no polytope and its name is not in `shapes`, or both are half-spaces.
/// Applying `as_seen` twice changes nothing. If a body is a union, both are seen as pieces, without
/// words; then nullopt is returned too if rounding leaves a piece without interior.
std::optional<Case> as_seen(const Case& pair, const NumberFormat& format, const std::set<std::string>& shapes = {},
                            std::string* why = nullptr);

/// Returns the k for which the extent of the bodies times 2^k is less than `size`, and at least
/// half of it; 0 without a size, and for a point on a point. The size is above 0.
long exponent_to_fit(const Case& pair, const std::optional<mpq_class>& size);

/// The lengths of the bodies, those of shapes rounded up.
judging::Sizes sizes_of(const Case& pair);

/// Whether a body of the case has words, by which a subject is given it.
inline bool has_words(const Case& pair) { return pair.a.words || pair.b.words; }

/// A hash of the bodies in 16 hexadecimal digits: FNV-1a over the exact text of their points, or of
/// their words.
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

/// Solves the case exactly and fills in verdict, detail, reply and judgement. Throws Disagreement
/// if one of the second ways leads to another truth, or to another judgement in any field. Of
/// shapes there is one second way, whatever was asked for: the certificate of the truth, which the
/// checker must accept as a proof of it, or std::logic_error is thrown; and so it is of unions.
void judge_answer(Outcome& outcome, const Case& seen, const SubjectAnswer& answer, const SubjectInfo& info,
                  const Judging& judging);

// ---- the bodies that an answer is judged on, where they are not the ones that were asked ----

/// Returns the bodies, each grown by the ball of the radius that the subject declares for it, whose
/// lengths are 2^exponent times those of the case. What has a radius is a shape without words.
/// Unions are as they are: see rounds_pieces.
Case judged_bodies(const Case& seen, const SubjectInfo& info, long exponent);

/// Returns the radius by which the subject rounds such a body, in the subject's unit.
mpq_class rounding_radius(const Body& body, const SubjectInfo& info);

/// Throws ProtocolError if the answer tells the hull of a body that was not sent as vertices: as a
/// shape, or in pieces.
void demand_sent_as_vertices(const Case& seen, const SubjectAnswer& answer);

/// Returns the square of the largest distance of a vertex of `from` from the body of the same
/// letter in `to`, over the bodies whose hulls the answer tells.
mpq_class squared_way(const Case& from, const Case& to, const SubjectAnswer& answer);

// ---- unions put to a subject that takes convex bodies: the deepest of the answers about the pairs
// of pieces ----

/// Puts a pair of pieces, as a case of its own with the id of pair_id. Sets the answer, or returns
/// an outcome with verdict and detail.
using AskPair = std::function<Outcome(const Case& pair, std::optional<SubjectAnswer>& answer)>;

/// Whether the text is the id of a pair of pieces of this case.
bool is_pair_of(std::string_view text, const Case& pair);

/// Why a case cannot be put to the subject, which sees lengths times 2^exponent: it is one of
/// unions, and the subject rounds bodies; or it rounds them by a radius beside which its answers
/// cannot tell bodies of this size, whatever they are. Empty if it can be.
std::string obstacle_to(const Case& seen, const SubjectInfo& info, long exponent);
/// Whether the subject is asked about the case by its pairs of pieces.
bool is_asked_in_pairs(const Case& seen, const SubjectInfo& info);

/// Asks about each pair of pieces, row by row, until there is no answer to one: then that is the
/// outcome. What was declined makes the case declined, once all have been asked. Else the answer is
///   of replies that claim an overlap, if any do, the deepest; or the first, if none has a depth;
///   else "apart", with the least distance if every reply has one. A number that is not finite is
///   deeper than any, and nearer. The derivative is the largest of those in replies that are as
///   deep, or as near. The answer is judged as one about the unions, and as one about its pair.
Outcome examine_pairs(const Case& seen, long exponent, const SubjectInfo& info, const Judging& judging,
                      const AskPair& ask);

}  // namespace fathom::harness
