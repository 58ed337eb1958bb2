// SPDX-License-Identifier: GPL-3.0-or-later
// How large a case is for its human reader.
#pragma once

#include <gmpxx.h>

#include <compare>
#include <cstddef>

#include "fathom/files.hpp"

namespace fathom::harness {

/// Fewer points come first, and of bodies by name fewer vertices, fields, terms and matrices; then cheaper numbers, then fewer signs.
struct Size {
  std::size_t points = 0, bits = 0, signs = 0;
  friend auto operator<=>(const Size&, const Size&) = default;
};

/// What a coordinate costs: nothing for 0; an integer below 1024 its bits; of any other number the bits of its odd part, those of its
/// exponent as the distance from 1, and 10 for not being a small integer. The sign costs nothing.
std::size_t cost(const mpq_class& value);

Size size_of(const Case& pair);

}  // namespace fathom::harness
