// SPDX-License-Identifier: GPL-3.0-or-later
// Named degenerate pairs, fixed and small enough to be drawn by hand: one for each way in which
// bodies break general position, and one for each way in which they meet. Each states what one can
// see of its answer by looking at the pair.                                        [docs/golden.md]
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "fathom/depth.hpp"
#include "fathom/files.hpp"
#include "fathom/union.hpp"
#include "verify/families/shape_pairs.hpp"

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

/// All entries, in groups: touching, contact kinds, shared features, the sphere of directions,
/// input points, flat bodies, nearly degenerate ones.
std::span<const CatalogueEntry> catalogue();

/// Returns null if no entry has that name.
const CatalogueEntry* find_catalogue_entry(std::string_view name);

// Named pairs of shapes, fixed and small enough to be drawn by hand: centres, axes and generators
// that coincide, bodies that stand, lie or balance on others, and distances that equal the sum of
// the radii, or miss it by one ulp. Each states its signed depth.

struct ShapeCatalogueEntry {
  std::string_view description;  ///< one line
  ShapeCase shapes;              ///< its id is the name of the entry: letters, digits and underscores
};

/// All entries, in groups: balls and capsules, cylinders, cones, other shapes. All have a known
/// signed depth.
std::span<const ShapeCatalogueEntry> shape_catalogue();

// Named pairs of unions, fixed and small enough to be drawn by hand: exact fits and those that miss
// by 2^-16, bodies that hold on to each other, seams, repeated pieces. Each states its answer.
//                                                                                  [docs/unions.md]

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
