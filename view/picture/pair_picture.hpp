// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a pair: both hulls as wires, the way that A must be moved, and the way that was claimed.
#pragma once

#include <optional>
#include <string>

#include "fathom/body.hpp"
#include "fathom/depth.hpp"
#include "kernels/vector.hpp"

namespace fathom::picture {

/// Two bodies and what is known about them.
struct Pair {
  const GivenPoints& a;
  const GivenPoints& b;
  const Depth& depth;
};

/// One or two SVG elements, ready to stand in an HTML page, with class names that the page's style colours: the whole pair seen across
/// the true and the claimed translation, and a close-up of both where they are short. `name` begins the ids of its elements, and `label`
/// its title; both are markup already.
std::string pair_picture(const Pair& pair, const std::optional<Point>& claimed, const std::string& name, const std::string& label);

}  // namespace fathom::picture
