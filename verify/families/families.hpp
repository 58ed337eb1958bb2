// SPDX-License-Identifier: GPL-3.0-or-later
// All families of polytopes by name; those of other shapes are in shape_families.hpp. A case is given by its family, its size and its seed,
// and is the same on every machine.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "verify/families/solids.hpp"

namespace fathom::families {

struct Family {
  std::string_view name;         ///< letters, digits and underscores
  std::string_view description;  ///< one line
  unsigned usual_size;           ///< the default
  Bodies (*build)(Random& random, unsigned size);

  /// The case "<name>-n<size>-s<seed>". `size` is about the number of points of each body; families of fixed shape ignore it, and
  /// others raise it to the least that their shape needs. Never throws; every body has at least one point.
  [[nodiscard]] Case make(std::uint64_t seed, unsigned size) const;
};

/// Sorted into groups, not by name. Names are unique.
std::span<const Family> families();

/// Returns null if no family has that name.
const Family* find_family(std::string_view name);

/// The stream of random numbers of a family's case, and the case's id.
Random stream_of(std::string_view family, std::uint64_t seed);
std::string case_id(std::string_view family, unsigned size, std::uint64_t seed);

}  // namespace fathom::families
