// SPDX-License-Identifier: GPL-3.0-or-later
// Judges two bodies of any kind: polytopes, shapes, unions of convex pieces. And the policies that
// it may go by.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "fathom/body.hpp"
#include "fathom/judge.hpp"

namespace fathom::judging {

/// The truth about two bodies: a UnionTruth if one is a union, else a ShapeTruth if one is a shape
/// that is no polytope.
using AnyTruth = std::variant<Truth, ShapeTruth, UnionTruth>;

/// Returns the body after rounding to the implementation's format: points are rounded, those of
/// each piece too; the numbers of shapes are not. Returns nullopt if a coordinate overflows.
std::optional<Body> body_seen(const Body& body, const NumberFormat& format);

/// Returns the truth about two rounded bodies; of bodies of the plane that about what stands for
/// them in space [fathom/plane.hpp], where directions and points of the plane have z = 0.
/// Throws std::invalid_argument for a union beside a shape that is no polytope, and as truth_about
/// of fathom/judge.hpp does.
AnyTruth truth_of(const Body& a, const Body& b, const Options& options = {});

/// Judges the reply as the functions judge of fathom/judge.hpp do.
Judgement judged(const AnyTruth& truth, const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                 const Tolerance& tolerance, const std::optional<Motion>& motion = {}, Monitor* monitor = nullptr);

/// The claims that pass without a direction: whether the bodies may be said to overlap, and to be
/// apart, and the least and the greatest number that may stand beside each, among those of
/// binary64: with the signs of the conventions, and in the unit of the format. A depth has no upper
/// bound where the policy lets longer translations pass.
struct Accepted {
  bool overlap = false, apart = false;
  Between depth = {}, distance = {};
};
/// Returns what `judged` accepts, by asking it.
Accepted accepted(const AnyTruth& truth, const Conventions& conventions, const NumberFormat& format,
                  const Tolerance& tolerance, Monitor* monitor = nullptr);

/// Adds a finding to a judgement, at its rank.
void add_finding(Judgement& judgement, Verdict finding, const std::string& sentence);

// Policies as texts. (The texts of verdicts and classes are in fathom/judge.hpp.)

inline constexpr Policy::Kind policy_kinds[] = {Policy::Kind::declared, Policy::Kind::minimum, Policy::Kind::separating,
                                                Policy::Kind::within};

/// Returns "declared", "minimum", "separating", "within=5%", "within=5/2%".
std::string policy_text(const Policy& policy);
/// Returns the policy of such a text; the percentage may also be a decimal. Returns nullopt for
/// other texts, and for a percentage below 0.
std::optional<Policy> policy_of(std::string_view text);

}  // namespace fathom::judging
