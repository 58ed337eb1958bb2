// SPDX-License-Identifier: GPL-3.0-or-later
// How the catalogue is put together. Not a door: the door is catalogue.hpp.
#pragma once

#include <vector>

#include "verify/families/catalogue.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {

/// What is known of the answer: its status, the number of optima, and their kind if they have one in common.
struct Known {
  Status status = Status::penetrating;
  std::size_t optima = 0;
  std::optional<ContactKind> kind;
};

inline constexpr Known touches{Status::touching, 0, std::nullopt}, is_apart{Status::disjoint, 0, std::nullopt};

inline CatalogueEntry entry(std::string_view name, std::string_view breaks, std::string_view description, const Known& known, Body a,
                            Body b) {
  return {name, breaks, description, known.status, known.optima, known.kind, {std::string(name), std::move(a), std::move(b)}};
}

/// The corners of the box between two corners, x fastest.
inline Body block(const Point& low, const Point& high) {
  Body body;
  for (unsigned i = 0; i < 8; ++i) body.points.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  return body;
}

using Entries = std::vector<CatalogueEntry>;
Entries touching_entries();
Entries contact_entries();
Entries shared_entries();
Entries sphere_entries();
Entries redundant_entries();
Entries flat_entries();
Entries near_entries();

}  // namespace fathom::families
