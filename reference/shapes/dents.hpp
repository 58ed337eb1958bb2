// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to say of a mesh that is not convex.
#pragma once

#include <string>
#include <string_view>

#include "reference/polytope/convexity.hpp"

namespace fathom::shapes {

/// "A is not convex: the hull holds 2.2 times its volume, its deepest point is 0.7 inside", of the body so called.
std::string dents_of(std::string_view body, const polytope::Dents& dents);

}  // namespace fathom::shapes
