// SPDX-License-Identifier: GPL-3.0-or-later
// Judges two bodies of any kind: polytopes, shapes, unions of convex pieces.
#pragma once

#include <optional>
#include <string>
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

/// Returns the truth about two rounded bodies. Throws std::invalid_argument for a union beside a
/// shape that is no polytope, and as the functions truth_about of fathom/judge.hpp do.
AnyTruth truth_of(const Body& a, const Body& b, const Options& options = {});

/// Judges the reply as the functions judge of fathom/judge.hpp do.
Judgement judged(const AnyTruth& truth, const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                 const Tolerance& tolerance, const std::optional<Motion>& motion = {}, Monitor* monitor = nullptr);

/// Adds a finding to a judgement, at its rank.
void add_finding(Judgement& judgement, Verdict finding, const std::string& sentence);

}  // namespace fathom::judging
