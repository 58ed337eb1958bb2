// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>

#include "verify/families/catalogue.hpp"
#include "verify/families/shape_catalogue_groups.hpp"

namespace fathom::families {

std::span<const ShapeCatalogueEntry> shape_catalogue() {
  static const ShapeEntries all = [] {
    ShapeEntries entries;
    for (const auto group : {ball_entries, capsule_entries, cylinder_entries, cone_entries, other_entries})
      std::ranges::move(group(), std::back_inserter(entries));
    return entries;
  }();
  return all;
}

}  // namespace fathom::families
