// SPDX-License-Identifier: GPL-3.0-or-later
// Judging of two bodies of any kind: polytopes, shapes, unions of convex pieces.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "fathom/body.hpp"
#include "fathom/judge.hpp"

namespace fathom::judging {

/// What is known of two bodies: that of unions if one is a union, else that of shapes if one is a
/// shape that is no polytope.
using AnyTruth = std::variant<Truth, ShapeTruth, UnionTruth>;

/// Returns the body as an implementation of this format sees it: points are rounded, those of each
/// piece too; the numbers of shapes are taken as they are. Returns nullopt if a coordinate
/// overflows.
std::optional<Body> body_seen(const Body& body, const NumberFormat& format);

/// Returns the truth about two bodies as they were seen. Throws std::invalid_argument for a union
/// beside a shape that is no polytope, and as the functions truth_about of fathom/judge.hpp do.
AnyTruth truth_of(const Body& a, const Body& b, const Options& options = {});

/// Judges the reply as the functions judge of fathom/judge.hpp do.
Judgement judged(const AnyTruth& truth, const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                 const Tolerance& tolerance, const std::optional<Motion>& motion = {}, Monitor* monitor = nullptr);

/// Adds what else is wrong with an answer, at its rank.
void add_finding(Judgement& judgement, Verdict finding, const std::string& sentence);

}  // namespace fathom::judging
