// SPDX-License-Identifier: GPL-3.0-or-later
// The contacts of an answer, one by one and as a whole: each has its own depth along the direction
// of all, and together they cover the patch where the bodies touch after the shortest way out.
//                                                    [VERDICTS.md, "Contacts"; proofs/judge.md]
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fathom/judge.hpp"
#include "reference/patch/local_depth.hpp"
#include "verify/judge/claim.hpp"

namespace fathom::judging {

/// What is wrong with contacts, all of which is told with a proof.
constexpr bool is_of_contacts(Verdict finding) {
  return finding >= Verdict::contact_outside && finding <= Verdict::tips;
}

/// A point of a patch that the contacts do not reach, seen along the patch's direction n.
struct MissedPoint {
  Vector direction;  ///< n
  Point point;       ///< on A
  Vector away;       ///< orthogonal to n: no contact is so far along it as the point, by more than is allowed
};

/// A finding with its proof.
struct ContactFault {
  Verdict finding;                         ///< one of those of contacts
  std::optional<std::size_t> contact;      ///< which of the reply's it is about; none if it is about all
  std::optional<patch::TwoPlanes> planes;  ///< of one that is outside or too deep
  std::vector<patch::LineOverlap> lines;   ///< of one that is too shallow: the corners of all lines near it
  std::vector<MissedPoint> missed;         ///< of all: a corner of each patch, or the centroid of one
  std::string sentence;                    ///< for people, one line
};

/// Contacts beside a patch with slack, exactly.
struct MeasuredExtent {
  mpq_class missed_squared;                  ///< how far its corners are from the contacts' hull, at most
  std::optional<mpq_class> covered_squared;  ///< the share of its area, or length, in that hull; none of a point
};

/// Judges the contacts of one answer about two polytopes. Lengths and points may be off by what is
/// allowed, of positions rounded up by 2^-40.
class ContactJudge {
 public:
  /// All must outlive it. `declared`: by its unit, 2^exponent times that of the truth. `slack`: of
  /// the patch, see Tolerance.
  ContactJudge(const Truth& truth, const Claim& claim, const Allowances& allowed,
               const std::optional<ContactLimits>& declared, long exponent, const std::optional<mpq_class>& slack);

  /// All that is wrong, in order of contacts, those about all of them at last; only the first that
  /// holds of each contact. Positions, depths and the direction are taken as they stand: an answer
  /// with a wrong sign is to be judged by that first. Empty for an answer without contacts beside a
  /// depth, or with numbers that are not finite.
  [[nodiscard]] std::vector<ContactFault> faults() const;

  /// Where there is a slack, whatever was declared: of the optimum along the claim for which less
  /// is missed. nullopt if there is none, without contacts, and where not all optima are listed.
  [[nodiscard]] std::optional<MeasuredExtent> measured() const;

  /// Whether a fault follows from the numbers that it holds, by products of them with all points;
  /// that of a contact too shallow by clipping the bodies' shadows.
  [[nodiscard]] bool proves(const ContactFault& fault) const;

 private:
  /// How far a point may be from the contacts: a length, and a root beside it.
  struct Reach {
    mpq_class length, squared = 0;
  };
  struct Extent {
    Vector direction;
    mpq_class support;
    std::vector<Point> corners;  ///< of the patch that is asked for, with its slack
    Point centroid;              ///< of the exact one
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
  mpq_class near_;                   ///< by how much a position may be off
  std::optional<mpq_class> slack_;   ///< of the patch, at least 0
  bool promised_ = false;            ///< whether the contacts are to cover the patch
  std::optional<std::size_t> most_;  ///< how many contacts it answers at most
  std::vector<Extent> extents_;      ///< of optima along the claim; none unless bodies overlap and it is asked for
};

/// Judges as the function judge of fathom/judge.hpp does. Tells what is wrong with the contacts if
/// `faults` is not null.
Judgement judged(const Truth& truth, const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                 const Tolerance& tolerance, const std::optional<Motion>& motion, Monitor* monitor,
                 std::vector<ContactFault>* faults);

/// How far two sets of contacts reach differently, seen along n: the Hausdorff distance of their
/// hulls, squared. Neither is empty.
mpq_class unlike_squared(const Vector& n, std::span<const Point> xs, std::span<const Point> ys);

}  // namespace fathom::judging
