// SPDX-License-Identifier: GPL-3.0-or-later
// Judges the contacts of an answer, one by one and as a whole: each has its own depth along the
// common direction, and together they cover the patch where the bodies touch after the shortest way
// out.                                 [VERDICTS.md, "Contacts"; proofs/judge.md]
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fathom/answer.hpp"
#include "fathom/body.hpp"
#include "fathom/judge.hpp"
#include "fathom/shape.hpp"
#include "reference/patch/local_depth.hpp"
#include "verify/judge/claim.hpp"

namespace fathom::judging {

/// Returns whether the finding is about contacts. Each such finding has a proof.
constexpr bool is_of_contacts(Verdict finding) {
  return finding >= Verdict::contact_outside && finding <= Verdict::tips;
}

/// A point of a patch that the hull of the contacts does not reach, in the projection along the
/// patch's direction n.
struct MissedPoint {
  Vector direction;  ///< n
  Point point;       ///< on A
  Vector away;       ///< orthogonal to n: the point is farther along it than every contact, by more than the allowance
};

/// A finding with its proof.
struct ContactFault {
  Verdict finding;                         ///< a finding about contacts
  std::optional<std::size_t> contact;      ///< the index of a contact in the reply; nullopt: about all
  std::optional<patch::TwoPlanes> planes;  ///< for contact_outside and contact_too_deep
  std::vector<patch::LineOverlap> lines;   ///< for contact_too_shallow: the corners of all lines near the contact
  std::vector<MissedPoint> missed;         ///< for findings about all contacts: a corner or the centroid of each patch
  std::string sentence;                    ///< one line of text
};

/// The exact measures of contacts beside a patch with slack.
struct MeasuredExtent {
  mpq_class missed_squared;                  ///< the largest distance of its corners from the contacts' hull
  std::optional<mpq_class> covered_squared;  ///< the share of its area, or length, in that hull; nullopt for a point
};

/// Judges the contacts of one answer about two polytopes. Lengths and points may be off by the
/// allowances; that of positions is rounded up by 2^-40.
class ContactJudge {
 public:
  /// The arguments must outlive the object. The unit of `declared` is 2^exponent times that of the
  /// truth. `slack`: that of the patch, see Tolerance.
  ContactJudge(const Truth& truth, const Claim& claim, const Allowances& allowed,
               const std::optional<ContactLimits>& declared, long exponent, const std::optional<mpq_class>& slack);

  /// Returns all faults: those of single contacts in their order, only the first of each contact;
  /// then those of all contacts. Positions, depths and the direction are not corrected: correct a
  /// wrong sign first. Empty for an answer without contacts beside a depth, or with numbers that
  /// are not finite.
  [[nodiscard]] std::vector<ContactFault> faults() const;

  /// Returns the measures for a slack, whatever was declared, of the optimum along the claim for
  /// which less is missed. Returns nullopt without a slack, without contacts, and if not all optima
  /// are listed.
  [[nodiscard]] std::optional<MeasuredExtent> measured() const;

  /// Returns whether a fault follows from the numbers that it holds, by products of them with all
  /// points; that of a contact that is too shallow, by clipping the bodies' shadows.
  [[nodiscard]] bool proves(const ContactFault& fault) const;

 private:
  /// The allowed distance of a point from the contacts: the sum of a length and a root.
  struct Reach {
    mpq_class length, squared = 0;
  };
  struct Extent {
    Vector direction;
    mpq_class support;
    std::vector<Point> corners;  ///< of the patch, with its slack
    Point centroid;              ///< of the exact patch
  };

  void find_extents();
  [[nodiscard]] std::vector<Point> with_slack(const Extent& extent, const mpq_class& squared) const;
  [[nodiscard]] Reach reach_of(const Extent& extent) const;
  [[nodiscard]] std::optional<MissedPoint> farthest_missed(const Extent& extent, const Reach& reach,
                                                           mpq_class& farthest) const;
  [[nodiscard]] const mpq_class& claimed(std::size_t contact) const;
  [[nodiscard]] mpq_class signed_square(const mpq_class& factor) const;
  [[nodiscard]] bool deeper(std::size_t contact, const mpq_class& factor) const;
  [[nodiscard]] bool shallower(std::size_t contact, const mpq_class& factor) const;
  void judge_contact(const patch::LinesAlong& lines, std::size_t contact, std::vector<ContactFault>& faults) const;
  void judge_extent(std::vector<ContactFault>& faults) const;
  [[nodiscard]] std::optional<MissedPoint> missed(const Extent& extent, const Point& point, const Reach& reach,
                                                  mpq_class& squared) const;
  [[nodiscard]] static bool too_far(const mpq_class& squared, const Reach& reach);
  [[nodiscard]] bool is_missed(const MissedPoint& missed, const Reach& reach) const;
  [[nodiscard]] bool proves_too_shallow(const ContactFault& fault) const;
  [[nodiscard]] bool proves_missed(const ContactFault& fault) const;

  const Truth& truth_;
  const Claim& claim_;
  const Allowance& depth_;
  Allowance margin_;
  mpq_class near_;                   ///< the allowance for positions
  std::optional<mpq_class> slack_;   ///< of the patch, at least 0
  bool promised_ = false;            ///< whether the contacts are to cover the patch
  std::optional<std::size_t> most_;  ///< the most contacts that the subject reports
  std::vector<Extent> extents_;      ///< of optima along the claim; empty unless bodies overlap and it is judged
};

/// Judges as the function judge of fathom/judge.hpp does. Sets `faults`, unless it is null, to
/// those of the contacts.
Judgement judged(const Truth& truth, const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                 const Tolerance& tolerance, const std::optional<Motion>& motion, Monitor* monitor,
                 std::vector<ContactFault>* faults);

/// Returns the squared Hausdorff distance of the hulls of two sets of contacts, projected along n.
/// Neither set is empty.
mpq_class unlike_squared(const Vector& n, std::span<const Point> xs, std::span<const Point> ys);

// Judges a claimed derivative of the signed depth: compares it with the exact one-sided rate at
// which the depth grows as two bodies begin to move, and finds which other rate a wrong claim
// equals.
//                                           [VERDICTS.md, "wrong-derivative"; proofs/patch.md]

/// Judges the derivative that the reply claims about these bodies, whose answer is known. A
/// difference of more than the tolerance times the largest speed of a point is wrong. Other fields
/// of the reply serve to find which other rate a wrong claim equals. `dimension`: 2 if these stand
/// for bodies of the plane. Throws Interrupted, and std::invalid_argument if the motion leaves the
/// plane.
DerivativeJudgement judged_derivative(const Body& a, const Body& b, const Answer& answer, const Motion& motion,
                                      const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                                      const Tolerance& tolerance, unsigned dimension, Monitor* monitor = nullptr);

/// Returns the largest speed that the motion gives a point of either body, rounded up by 2^-40 of
/// itself. A half-space has the points of the other body. A curved core counts as O.
mpq_class largest_speed(const Body& a, const Body& b, const Motion& motion);

}  // namespace fathom::judging
