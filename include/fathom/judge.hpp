// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies, and what an implementation of penetration depth answered about them.
// Output  whether the answer is right, and if not, how wrong it is, by exact comparison.
//         verify/judge/VERDICTS.md defines every verdict and number.
// C programs include fathom/fathom.h.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/depth.hpp"
#include "fathom/shape.hpp"
#include "fathom/signed_depth.hpp"
#include "fathom/union.hpp"

namespace fathom {

// ---- the answer under test ----

/// The type that the implementation computes in, and to which the points are rounded before it sees
/// them.
enum class Precision { binary32, binary64 };

/// "binary32", "binary64".
constexpr std::string_view name(Precision precision) {
  return precision == Precision::binary32 ? "binary32" : "binary64";
}

/// The numbers that an implementation works with. A Precision stands for that of both, in the unit
/// of the bodies.
struct NumberFormat {
  Precision points = Precision::binary64;   ///< to which coordinates are rounded before it sees them
  Precision answers = Precision::binary64;  ///< of the numbers in its answers
  long exponent = 0;         ///< the lengths that it sees and answers are 2^exponent times those of the bodies
  NumberFormat() = default;  ///< both in binary64
  NumberFormat(Precision both)
      : points(both), answers(both) {}  ///< the same for both; NOLINT(google-explicit-constructor)
  /// points, answers, exponent
  NumberFormat(Precision of_points, Precision of_answers, long exponent_of_unit = 0)
      : points(of_points), answers(of_answers), exponent(exponent_of_unit) {}
  friend bool operator==(const NumberFormat&, const NumberFormat&) = default;
};

/// What an implementation declares of the contacts in one answer.
struct ContactLimits {
  std::optional<std::size_t> most = {};  ///< how many there are at most
  /// how much less deep than the answer contacts without a depth may be: a length in its unit,
  /// finite, at least 0
  double margin = 0;
};

/// What an implementation declares of itself. Judging never guesses these.
struct Conventions {
  enum class Touching { overlap, separate, either };  ///< what bodies that touch count as
  enum class Sign { positive, negative };             ///< of a depth
  enum class Body { a, b };                           ///< which of the two
  /// of a translation: that none is shorter; or that it separates, at its own separating distance
  enum class Claims { minimum, separating };
  Touching touching = Touching::either;  ///< of bodies that touch
  Sign depth = Sign::positive;           ///< of the depth of bodies that overlap
  Body moves = Body::a;                  ///< the body that |depth| * direction moves apart
  bool unit = true;                      ///< whether directions are promised to have length 1
  Claims claims = Claims::minimum;       ///< what a depth with a direction means
  /// that its contacts reach as far as the bodies touch, unless `most` is 1; else no extent is
  /// promised
  std::optional<ContactLimits> manifold = std::nullopt;
};

/// x, y, z.
using Triple = std::array<double, 3>;

/// One point of a contact manifold.
struct ContactPoint {
  Triple position;              ///< in both bodies
  std::optional<double> depth;  ///< there, along the one direction of all contacts
  friend bool operator==(const ContactPoint&, const ContactPoint&) = default;
};

/// The answer, in the numbers of the implementation: NaN and infinities are judged too. Binary32
/// numbers are given as their equal doubles.
struct Reply {
  bool overlap = false;         ///< whether the bodies overlap, or penetrate
  std::optional<double> depth;  ///< of the overlap; read only if overlap
  // Read beside a depth or a distance:
  std::optional<Triple> direction;  ///< in which a body moves apart, or farther apart
  /// a point of each body, with b - a = the translation of A that makes the bodies touch
  std::optional<Triple> witness_a, witness_b;
  std::optional<double> distance;  ///< of the bodies, at least 0; read only if they are said to be apart
  /// one or more; the largest of their depths is `depth`. Read only beside a depth
  std::vector<ContactPoint> contacts;
  /// at which rate the signed depth grows as the bodies begin to move, deeper being more whatever
  /// the conventions; read only by a judge that is told how they move
  std::optional<double> derivative = std::nullopt;
};

/// Which translations pass that are longer than need be, with a depth that is the separating
/// distance of their own direction.
struct Policy {
  /// what the conventions claim; none; all; separating distances up to (1 + most) depths
  enum class Kind { declared, minimum, separating, within };
  Kind kind = Kind::declared;  ///< what is asked
  mpq_class most = 0;          ///< of `within`
  friend bool operator==(const Policy&, const Policy&) = default;
};

/// How wrong an answer may be: by the largest of relative * depth, absolute * extent, ulps *
/// ulp(depth). The extent is the longest side of the bodies' boxes, the larger of the two; an ulp
/// is that of the implementation's precision at the depth. Of a claimed distance it is the true
/// distance that counts in the depth's place. Negative values count as 0. Of shapes that the
/// implementation grew by radii of its own, the depth and the extent are those without these; see
/// ShapeTruth. Besides, an answer may be off by what rounding each of its numbers to nearest costs,
/// or an error of `ulps` in each.
struct Tolerance {
  mpq_class relative{1, 1000};       ///< of the depth
  mpq_class absolute{1, 1'000'000};  ///< of the extent
  unsigned long ulps = 0;            ///< of the depth
  Policy policy = {};                ///< of depths that are too deep
  /// contacts are held against the patch with this slack, a length of at least 0: they are to reach
  /// all lines along which the bodies overlap by the depth less the slack. nullopt: against the
  /// exact patch
  std::optional<mpq_class> patch_slack = std::nullopt;
};

// ---- the verdict ----

/// In order of rank: if several hold of one answer, the first is the verdict. The last two are
/// passes.
enum class Verdict {
  // There is no answer that could be judged. `judge` never returns these; programs that run
  // implementations do.
  crash,     ///< the program ended by a signal, or with a failure, while it held the case
  time_out,  ///< no answer in the time that was given
  silent,    ///< the program ended well, or closed its output, without an answer
  garbage,   ///< its output is not a reply to the case
  failed,    ///< it says itself that it could not answer: an exception, an error code
  // The answer is wrong.
  nan,               ///< a number that it needs is NaN or infinite
  false_separation,  ///< the bodies overlap by more than the tolerance, and it says that they do not
  false_overlap,     ///< the bodies are apart by more than the tolerance, and it says that they overlap
  not_a_direction,   ///< the direction is zero, or not of unit length where that was promised
  wrong_sign,        ///< only a sign is wrong: of the depth, of the distance, or of the direction
  too_deep,          ///< the depth is larger than the penetration depth
  too_shallow,       ///< the depth is smaller than the penetration depth
  too_far,           ///< the distance is larger than that of the bodies, which is 0 if they overlap
  too_near,          ///< the distance is smaller than that of the bodies
  not_separating,    ///< the bodies still overlap after the translation that it gives
  inconsistent,      ///< the depth, or the distance, is not that of its own direction
  witness_off,  ///< a witness point is not on its body, or they do not differ by the translation; or a contact is not
                ///< in both
  // Of contacts, along the direction of the answer:
  contact_outside,      ///< no line near one meets both bodies
  contact_too_deep,     ///< along no line near one they overlap so much
  contact_too_shallow,  ///< along each line near one that meets both they overlap more
  misses_extent,        ///< all together they leave out part of each patch
  tips,                 ///< and so much that the middle of the patch is not between them: beside misses_extent
  // Along the twists that were asked for:
  wrong_derivative,  ///< the derivative is not that of the signed depth
  not_invariant,     ///< a case that differs by a symmetry only is answered differently; `judge` never returns it
  // Not judged.
  unsupported,  ///< the program declined the case; `judge` never returns it
  // Passes.
  touching_by_convention,  ///< the bodies touch, and it counts that as it declared
  pass
};

/// "too-deep": lower case, hyphens.
std::string_view name(Verdict verdict);
/// The inverse of `name`; nullopt for other words.
std::optional<Verdict> verdict_named(std::string_view name);

/// Whether it is pass or touching_by_convention.
constexpr bool passes(Verdict verdict) { return verdict >= Verdict::touching_by_convention; }
/// Whether it is neither a pass nor `unsupported`.
constexpr bool fails(Verdict verdict) { return verdict < Verdict::unsupported; }

/// The best class that a right depth or distance is in; u_r_16 is within 16 u R, the unit roundoff
/// times the largest coordinate.
enum class Accuracy { correctly_rounded, ulps_4, u_r_16, millionth, tolerance };
/// "correctly rounded", "4 ulp", "16 uR", "1e-6", "tolerance".
std::string_view name(Accuracy accuracy);

/// low <= value <= high: a length, rounded outward; equal only if it is known and a double.
/// Infinite beyond binary64.
struct Between {
  double low, high;  ///< the bounds
  friend bool operator==(const Between&, const Between&) = default;
};

/// A claimed derivative of the signed depth beside the truth.
struct DerivativeJudgement {
  double claimed = 0;                ///< in the unit of the bodies
  std::optional<mpq_class> squared;  ///< of the true rate, negative if that is; nullopt if it is left out
  std::string left_out;              ///< then why: the word of LeftOut
  std::vector<std::string> kinks;    ///< why there is no gradient: the words of Kink; of unions not told
  std::optional<double> error;       ///< the claimed rate less the true one, correctly rounded
  std::string sentence;              ///< what is wrong with the claim; empty if nothing is
};

/// What is right and wrong about one answer, with the truth beside it.
struct Judgement {
  Verdict verdict = Verdict::garbage;  ///< the first of the findings, or a pass
  std::vector<Verdict> findings;       ///< everything that is wrong with the answer, in order of rank
  std::optional<Accuracy> accuracy;    ///< of a pass with a depth or a distance, unless `excess_allowed`
  bool excess_allowed = false;         ///< whether the depth would be too deep, but for the policy

  std::optional<Status> status = Status::disjoint;  ///< the truth; nullopt if the bounds of shapes leave it open
  mpq_class depth_squared;                          ///< the truth about polytopes; 0 unless penetrating
  mpq_class distance_squared;                       ///< the truth about polytopes; 0 unless disjoint
  std::optional<Between> signed_depth;              ///< the truth about shapes

  // Residuals of the claim, with its conventions undone. They do not depend on the verdict, and are
  // infinite beyond binary64. Of shapes, a residual that is not known is the least one that the
  // bounds of the truth allow, rounded towards 0: at least so much is wrong. Of a claimed depth, or
  // distance: how much larger it is than the true one, correctly rounded to nearest; negative if it
  // is smaller.
  /// no relative error and no ulps of one that is 0
  std::optional<double> error, error_ulps, error_relative, error_u_r;
  // Of a claimed direction u: by the plane across it, and along it. Signed squares: negative if the
  // bodies are apart. Of polytopes.
  /// h(u)^2 / <u,u>: A moved so far along u lies behind a plane across u
  std::optional<mpq_class> separating_distance_squared;
  /// squared length of the shortest way along u after which the interiors are disjoint
  std::optional<mpq_class> exit_distance_squared;
  /// the claimed depth, or minus the claimed distance, less the separating distance
  std::optional<double> inconsistency;
  std::optional<double> overlap_left;  ///< exit distance less the claimed depth, if that is positive
  /// separating distance / depth - 1, correctly rounded, of bodies that overlap and an answer that
  /// says so
  std::optional<double> relative_excess;
  // The same of shapes. Against a half-space `separating_distance` is the way along u; nullopt if u
  // does not lead out of it.
  std::optional<Between> separating_distance, witness_a_distance, witness_b_distance;  ///< lengths
  // Of witness points: squared distances from their bodies, exact, of polytopes, and the length of
  // (b - a) - translation, rounded; if no direction is claimed, | |b - a| - depth |.
  std::optional<mpq_class> witness_a_squared, witness_b_squared;  ///< 0 on the body
  std::optional<double> witness_gap;                              ///< 0 if they fit
  // The same of the contact that is farthest from A, and of that from B.
  std::optional<mpq_class> contact_a_squared, contact_b_squared;  ///< of polytopes
  std::optional<Between> contact_a_distance, contact_b_distance;  ///< of shapes
  std::optional<double> deepest;  ///< the largest depth of a contact less the claimed depth
  // Of contacts of polytopes, if there is a slack of the patch: of the patch with it, along the
  // direction near the claimed one for which less is missed. Exact.
  std::optional<mpq_class> extent_missed_squared;   ///< how far its corners are from the contacts' hull, at most
  std::optional<mpq_class> extent_covered_squared;  ///< the share of its area, or length, in that hull; none of a point
  // Of unions there is no separating distance and no exit distance; `overlap_left` is the depth
  // after the claimed translation, and `inconsistency` its negative, or the distance then. These
  // two are the least that the way from a root to a rational allows, if that matters to their
  // rounding.
  /// of unions that overlap: what the deepest pair of pieces, and the hulls, would say
  std::optional<UnionBounds> bounds;
  /// (depth / claimed depth)^2 of unions that overlap, for a claimed depth above 0
  std::optional<mpq_class> deeper_squared;

  /// of a reply that has one, if the judge is told how the bodies begin to move
  std::optional<DerivativeJudgement> derivative;

  std::string sentence;  ///< for people, one line: "too deep by 0.4392: 1.0392 is claimed, the depth is 0.6; ..."
};

// ---- judging ----

/// Judges the reply about two bodies with coordinates in binary64; they are rounded to the format
/// first. Any numbers in `reply` are judged, its derivative if `motion` says how the bodies begin
/// to move: its lengths are in the unit of the bodies. Throws std::invalid_argument if a body is
/// empty, or a coordinate is not finite or overflows the format.
Judgement judge(const std::vector<Triple>& a, const std::vector<Triple>& b, const Reply& reply,
                const Conventions& conventions = {}, const NumberFormat& format = {}, const Tolerance& tolerance = {},
                const std::optional<Motion>& motion = {});

/// Two bodies as the implementation saw them, and the exact answer.
struct Truth {
  GivenPoints a, b;  ///< the points that it saw
  Depth depth;       ///< the exact answer
  /// 2: these are what stands in space for bodies of the plane, whose sizes have no z
  unsigned dimension = 3;
};

/// Returns the points rounded to nearest, which is what an implementation of this format sees, in
/// the unit that they were given in; nullopt if a coordinate overflows.
std::optional<GivenPoints> seen(const GivenPoints& points, const NumberFormat& format);

/// Returns the truth about two bodies, to judge several replies by. Throws as penetration_depth
/// does.
Truth truth_about(GivenPoints a, GivenPoints b, const Options& options = {});

/// Judges the reply by a truth that is known.
Judgement judge(const Truth& truth, const Reply& reply, const Conventions& conventions = {},
                const NumberFormat& format = {}, const Tolerance& tolerance = {},
                const std::optional<Motion>& motion = {}, Monitor* monitor = nullptr);

// ---- shapes ----

/// Two shapes as the implementation saw them, and what is known of the answer.
struct ShapeTruth {
  Shape a, b;         ///< the shapes that it saw
  SignedDepth depth;  ///< exact, or bounds
  /// What of their radii the implementation added itself, at most the whole. It is no excuse:
  /// tolerances and classes are relative to the bodies, and to a depth, without it.
  mpq_class added_a = 0, added_b = 0;
  unsigned dimension = 3;  ///< as that of Truth
};

/// Returns the truth about two shapes, to judge several replies by. Throws as signed_depth does.
ShapeTruth truth_about(Shape a, Shape b, const SignedDepthOptions& options = {});

/// Judges the reply by a truth that is known. Something is found to be wrong only if it is so for
/// every value within the bounds of the truth; where they leave that open, closer bounds are asked
/// for, to 160 bits at most. A touching case is one whose bodies are proved to touch.
Judgement judge(const ShapeTruth& truth, const Reply& reply, const Conventions& conventions = {},
                const NumberFormat& format = {}, const Tolerance& tolerance = {},
                const std::optional<Motion>& motion = {}, Monitor* monitor = nullptr);

// ---- unions of convex pieces ----

/// Two unions as the implementation saw them, and the exact answer.
struct UnionTruth {
  Pieces a, b;             ///< the pieces that it saw
  UnionDepth depth;        ///< the exact answer, complete and with its bounds
  unsigned dimension = 3;  ///< as that of Truth
};

/// Returns the truth about two unions, to judge several replies by. Throws as union_depth does, and
/// Interrupted if the search is stopped.
UnionTruth truth_about(Pieces a, Pieces b, const UnionOptions& options = {});

/// Judges the reply by a truth that is known. A claimed translation is judged by what it leaves:
/// the depth or the distance after it is found anew, which may take as long as the truth did, and
/// may be stopped by the monitor; then Interrupted is thrown.
Judgement judge(const UnionTruth& truth, const Reply& reply, const Conventions& conventions = {},
                const NumberFormat& format = {}, const Tolerance& tolerance = {},
                const std::optional<Motion>& motion = {}, Monitor* monitor = nullptr);

}  // namespace fathom
