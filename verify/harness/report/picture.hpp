// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a failure: what the truth and the reply say about the same pair.
#pragma once

#include <optional>
#include <string>

#include "fathom/files.hpp"
#include "fathom/judge.hpp"
#include "kernels/vector.hpp"

namespace fathom::harness {

/// The translation of A that a reply claims, to within a few roundings, for directions of any length. Returns nullopt if the reply has no
/// direction, or one that is not finite.
std::optional<Point> claimed_translation(const Reply& reply, const Conventions& conventions);

/// One or two SVG elements, as view/picture paints them.
std::string pair_picture(const Truth& truth, const std::optional<Point>& claimed, const std::string& name, const std::string& label);

/// The same for unions.
std::string unions_picture(const UnionTruth& truth, const std::optional<Point>& claimed, const std::string& name, const std::string& label);

/// The same for a case of shapes, without a claim; empty if its depth is not found.
std::string shapes_picture(const Case& seen, const std::string& name, const std::string& label);

}  // namespace fathom::harness
