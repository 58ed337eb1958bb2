// SPDX-License-Identifier: GPL-3.0-or-later
// All families by name, of polytopes, of shapes and of unions of convex pieces. A case is given by
// its family, its size and its seed, and is the same on every machine.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "fathom/files.hpp"
#include "verify/families/shape_pairs.hpp"
#include "verify/families/solids.hpp"
#include "verify/families/union_pairs.hpp"

namespace fathom::families {

/// The kind of the bodies of a case.
enum class Kind { polytopes, shapes, unions };

struct Family {
  std::string_view name;         ///< letters, digits and underscores
  std::string_view description;  ///< one line
  unsigned usual_size;           ///< the default
  /// In the order of Kind.
  std::variant<Bodies (*)(Random&, unsigned), NamedPair (*)(Random&, unsigned), UnionPair (*)(Random&, unsigned)> build;

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

}  // namespace fathom::families
