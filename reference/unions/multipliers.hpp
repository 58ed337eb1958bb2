// SPDX-License-Identifier: GPL-3.0-or-later
// Input   half-spaces <n,x> >= h whose planes all go through the point of their intersection that is nearest to O.
// Output  at most three of them that have the same nearest point.                   [Karush, Kuhn and Tucker; Caratheodory]
#pragma once

#include <vector>

#include "reference/unions/least_norm.hpp"

namespace fathom::unions {

/// The first one, two or three barriers such that `direction` is a combination of their normals with weights >= 0. Throws std::logic_error
/// if there are none.
std::vector<Barrier> deciding(const std::vector<Barrier>& tight, const Vector& direction);

}  // namespace fathom::unions
