// SPDX-License-Identifier: GPL-3.0-or-later
// The forms of a case in the harness: as it is put to the subject, as it is judged, and for unions
// in pairs of pieces.
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
#include "verify/judge/truth.hpp"

namespace fathom::harness {

/// Returns the case as a subject of this format gets it, in the unit of the case; `shapes` are the
/// names by which it takes bodies. A body described by such a name has its parameters, its margin
/// and its pose rounded, and is the body of these. Any other body has its points rounded, and no
/// description. Returns nullopt, and the reason in `why`, if a number overflows the format,
/// rounding leaves no body, a body is no polytope and its name is not in `shapes`, or both are
/// half-spaces. Applying `as_seen` twice changes nothing. If a body is a union, both are returned
/// as pieces, without descriptions; then nullopt is returned too if rounding leaves a piece without
/// interior. Rounds the radius and the core of a body of the plane. `dimension`: of the
/// bodies that the subject takes, if that matters; then nullopt is returned for others.
std::optional<Case> as_seen(const Case& pair, const NumberFormat& format, const std::set<std::string>& shapes = {},
                            std::string* why = nullptr, std::optional<unsigned> dimension = std::nullopt);

/// Returns the k for which the extent of the bodies times 2^k is less than `size`, and at least
/// half of it; 0 without a size, and for a point on a point. The size is above 0.
long exponent_to_fit(const Case& pair, const std::optional<mpq_class>& size);

/// Returns whether a piece of a union has no interior, exactly: in the plane, no area.
bool is_flat_piece(const Body& body, std::size_t piece);

/// Returns the sizes of the bodies, those of shapes rounded up.
judging::Sizes sizes_of(const Case& pair);

/// Returns whether a body of the case has a description by name.
inline bool has_words(const Case& pair) { return pair.a.words || pair.b.words; }

/// Returns a hash of the bodies in 16 hexadecimal digits: FNV-1a over the exact text of their
/// points, or of their descriptions.
std::string digest_of(const Case& pair);

/// Returns an outcome without a verdict, for the case as it is put, with all lengths times
/// 2^exponent.
Outcome outcome_for(const Case& seen, long exponent = 0);
/// Returns the outcome of a case that is not put to the subject, with the reason.
Outcome declined(const Case& pair, const std::string& why);

/// The parameters of judging.
struct Judging {
  Tolerance tolerance = {};
  std::vector<Solver> second = {};       ///< second solvers for the truth and the judgement
  std::function<bool()> stop = nullptr;  ///< ends the work with Interrupted; may be empty
  Workspace* workspace = nullptr;        ///< of the thread that judges; may be null
};

/// Solves the case exactly and sets verdict, detail, reply and judgement. Throws Disagreement if
/// one of the second solvers leads to another truth, or to another judgement in any field. For
/// shapes and for unions there is one second way, whichever were asked for: the checker must accept
/// the certificate of the truth as a proof of it, or std::logic_error is thrown.
void judge_answer(Outcome& outcome, const Case& seen, const SubjectAnswer& answer, const SubjectInfo& info,
                  const Judging& judging);

// ---- the bodies that an answer is judged by, if they are not the given ones ----

/// Returns the bodies, each grown by a ball with the radius that the subject declares for it. The
/// subject gets lengths times 2^exponent. A body with a radius is a shape without description.
/// Unions are unchanged: see rounds_pieces.
Case judged_bodies(const Case& seen, const SubjectInfo& info, long exponent);

/// Returns the truth about these bodies.
judging::AnyTruth truth_to_judge_by(const Case& seen, const SubjectInfo& info, long exponent, const Judging& judging,
                                    Monitor* monitor = nullptr);

/// Returns the radius by which the subject rounds this body, in the subject's unit.
mpq_class rounding_radius(const Body& body, const SubjectInfo& info);

/// Throws ProtocolError if the answer reports the hull of a body that was sent as a shape or in
/// pieces.
void demand_sent_as_vertices(const Case& seen, const SubjectAnswer& answer);

/// Returns the square of the largest distance of a vertex of `from` from the corresponding body in
/// `to`, over the bodies whose hulls the answer reports.
mpq_class squared_way(const Case& from, const Case& to, const SubjectAnswer& answer);

// ---- unions put to a subject that takes convex bodies: the deepest answer about a pair of pieces
// counts ----

/// Puts a pair of pieces as a case with the id of pair_id. Sets the answer, or returns an outcome
/// with verdict and detail.
using AskPair = std::function<Outcome(const Case& pair, std::optional<SubjectAnswer>& answer)>;

/// Returns whether the text is the id of a pair of pieces of this case.
bool is_pair_of(std::string_view text, const Case& pair);

/// Returns why a case cannot be put to the subject, which gets lengths times 2^exponent: it is one
/// of unions, and the subject rounds bodies; or the subject rounds bodies by a radius so large that
/// its answers cannot distinguish bodies of this size. Empty if the case can be put.
std::string obstacle_to(const Case& seen, const SubjectInfo& info, long exponent);
/// Returns whether the case is put to the subject by pairs of pieces.
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
