// SPDX-License-Identifier: GPL-3.0-or-later
// Named pairs of shapes, fixed and small enough to be drawn by hand: centres, axes and generators that coincide, bodies that stand, lie or
// balance on others, and distances that equal the sum of the radii, or miss it by one ulp. Each states its signed depth.
#pragma once

#include <span>
#include <string_view>

#include "verify/families/shape_pairs.hpp"

namespace fathom::families {

struct ShapeCatalogueEntry {
  std::string_view description;  ///< one line
  ShapeCase shapes;              ///< its id is the name of the entry: letters, digits and underscores
};

/// All entries, in groups: balls and capsules, cylinders, cones, other shapes. All have a known signed depth.
std::span<const ShapeCatalogueEntry> shape_catalogue();

}  // namespace fathom::families
