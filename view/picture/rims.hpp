// SPDX-License-Identifier: GPL-3.0-or-later
// The rims of cylinders, cones, frusta and their like: where a flat end meets the side. Without them a cylinder looks like any blob.
#pragma once

#include <vector>

#include "view/picture/drawn.hpp"

namespace fathom::picture {

/// The circles, or ellipses, that are edges of the sum of the terms, in parts that are seen and parts that are hidden. Sampled, in
/// binary64.
std::vector<Rim> rims_of(const std::vector<Term>& terms, const View& view);

}  // namespace fathom::picture
