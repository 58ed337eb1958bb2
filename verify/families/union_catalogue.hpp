// SPDX-License-Identifier: GPL-3.0-or-later
// Named pairs of unions, fixed and small enough to be drawn by hand: exact fits and those that miss by 2^-16, bodies that hold on to each
// other, seams, repeated pieces. Each states its answer.                                                              [docs/unions.md]
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "fathom/files.hpp"
#include "fathom/union.hpp"

namespace fathom::families {

struct UnionCatalogueEntry {
  std::string_view description;  ///< one line
  Status status;
  mpq_class squared;              ///< depth^2, or the squared distance if they are disjoint
  std::size_t optima;             ///< how many translations attain the depth; 0 if disjoint, 1 if touching
  std::optional<bool> clearance;  ///< of all optima; nullopt if they differ or there are none
  Case pair;                      ///< its id is the name of the entry: letters, digits and underscores
};

/// All entries, in groups: fits, bodies that hold on to each other, seams, others.
std::span<const UnionCatalogueEntry> union_catalogue();

}  // namespace fathom::families
