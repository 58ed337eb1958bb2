// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a pair: both hulls as wires, the way that A must be moved, and the way that was claimed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fathom/judge.hpp"
#include "kernels/vector.hpp"

namespace fathom::harness {

/// The translation of A that a reply claims, to within a few roundings, for directions of any length. Returns nullopt if the reply has no
/// direction, or one that is not finite.
std::optional<Point> claimed_translation(const Reply& reply, const Conventions& conventions);

/// One or two SVG elements, ready to stand in an HTML page, with class names that the page's style colours: the whole pair seen across
/// the true and the claimed translation, and a close-up of both where they are short. `name` begins the ids of its elements, and `label`
/// its title; both are markup already.
std::string pair_picture(const Truth& truth, const std::optional<Point>& claimed, const std::string& name, const std::string& label);

}  // namespace fathom::harness
