// SPDX-License-Identifier: GPL-3.0-or-later
// All families of pairs of unions of convex pieces by name. They are a kind of their own, as those of shapes are: who draws on
// families::families() gets none of these. A case is given by its family, its size and its seed, and is the same on every machine.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "fathom/files.hpp"
#include "verify/families/union_pairs.hpp"

namespace fathom::families {

struct UnionFamily {
  std::string_view name;         ///< letters, digits and underscores; no family of polytopes or of shapes has it
  std::string_view description;  ///< one line
  unsigned usual_size;           ///< the default
  UnionPair (*build)(Random& random, unsigned size);

  /// The case "<name>-n<size>-s<seed>". `size` is about the number of pieces of each body; families of fixed shape raise it to the least
  /// that they need. Every body has pieces, and all pieces have interiors.
  [[nodiscard]] Case make(std::uint64_t seed, unsigned size) const;
};

/// Sorted into groups, not by name. Names are unique. Of the families "cut_..." both unions are convex.
std::span<const UnionFamily> union_families();

/// Returns null if no family of unions has that name.
const UnionFamily* find_union_family(std::string_view name);

}  // namespace fathom::families
