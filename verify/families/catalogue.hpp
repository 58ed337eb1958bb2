// SPDX-License-Identifier: GPL-3.0-or-later
// Named degenerate pairs, fixed and small enough to be drawn by hand: one for each way in which bodies break general position, and one for
// each way in which they meet. Each states what one can see of its answer by looking at the pair.                        [docs/golden.md]
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "fathom/depth.hpp"
#include "fathom/files.hpp"

namespace fathom::families {

struct CatalogueEntry {
  std::string_view name;         ///< letters, digits and underscores; also the id of `pair`
  std::string_view breaks;       ///< the assumption that does not hold here, as a phrase: "no parallel edges"
  std::string_view description;  ///< one line
  Status status;
  std::size_t optima;               ///< how many directions attain the depth; 0 unless penetrating
  std::optional<ContactKind> kind;  ///< of every optimum; nullopt if they differ or there is none
  Case pair;
};

/// All entries, in groups: touching, contact kinds, shared features, the sphere of directions, input points, flat bodies, nearly
/// degenerate ones.
std::span<const CatalogueEntry> catalogue();

/// Returns null if no entry has that name.
const CatalogueEntry* find_catalogue_entry(std::string_view name);

}  // namespace fathom::families
