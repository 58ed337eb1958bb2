// SPDX-License-Identifier: GPL-3.0-or-later
// All families by name, of polytopes, of shapes, of unions of convex pieces and of bodies of the
// plane: a case is given by its family, its size and its seed, and is the same on every machine.
// And the catalogues: cases that have names of their own.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/files.hpp"
#include "fathom/union.hpp"
#include "verify/families/plane_pairs.hpp"
#include "verify/families/shape_pairs.hpp"
#include "verify/families/solids.hpp"
#include "verify/families/union_pairs.hpp"

namespace fathom::families {

/// The kind of the bodies of a case.
enum class Kind { polytopes, shapes, unions, plane };

struct Family {
  std::string_view name;         ///< letters, digits and underscores
  std::string_view description;  ///< one line
  unsigned usual_size;           ///< the default
  /// In the order of Kind.
  std::variant<Bodies (*)(Random&, unsigned), NamedPair (*)(Random&, unsigned), UnionPair (*)(Random&, unsigned),
               PlanePair (*)(Random&, unsigned)>
      build;

  [[nodiscard]] constexpr Kind kind() const { return static_cast<Kind>(build.index()); }

  /// The case "<name>-n<size>-s<seed>". `size` is about the number of points of each polytope or
  /// hull, or of pieces of each union; families of fixed shape ignore it, and others raise it to
  /// the least that their shape needs. Never throws. Every polytope has at least one point; every
  /// union has pieces, all of them with interiors.
  [[nodiscard]] Case make(std::uint64_t seed, unsigned size) const;

  /// The same case of a family of shapes, by their names and with what is known of the answer.
  /// Throws std::bad_variant_access if the family is none.
  [[nodiscard]] ShapeCase make_shapes(std::uint64_t seed, unsigned size) const;
};

/// The families of one kind, sorted into groups, not by name. Of the families of unions "cut_..."
/// both unions are convex.
std::span<const Family> families(Kind kind = Kind::polytopes);

/// Returns the families of all kinds, in the order of Kind. Names are unique.
std::span<const Family> all_families();
/// Their names.
std::vector<std::string_view> family_names();

/// Returns the family, of whatever kind, or null if none has that name.
const Family* find_family(std::string_view name);

// Named degenerate pairs, fixed and small enough to be drawn by hand: one for each way in which
// bodies break general position, and one for each way in which they meet. Each states what one can
// see of its answer by looking at the pair.                                        [docs/golden.md]

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
