// SPDX-License-Identifier: GPL-3.0-or-later
// All families of pairs of shapes by name. They are a kind of their own: who draws on families::families() takes polytopes, and gets none
// of these. A case is given by its family, its size and its seed, and is the same on every machine.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "verify/families/random.hpp"
#include "verify/families/shape_pairs.hpp"

namespace fathom::families {

struct ShapeFamily {
  std::string_view name;         ///< letters, digits and underscores; no family of polytopes has it
  std::string_view description;  ///< one line
  unsigned usual_size;           ///< the default
  NamedPair (*build)(Random& random, unsigned size);

  /// The case "<name>-n<size>-s<seed>". `size` is the number of points of each hull, raised to four; bodies without vertices ignore it.
  [[nodiscard]] ShapeCase make(std::uint64_t seed, unsigned size) const;
};

/// Sorted into groups, not by name. Names are unique.
std::span<const ShapeFamily> shape_families();

/// Returns null if no family of shapes has that name.
const ShapeFamily* find_shape_family(std::string_view name);

}  // namespace fathom::families
