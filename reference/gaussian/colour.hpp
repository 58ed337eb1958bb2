// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the two bodies something belongs to.
#pragma once

#include <array>
#include <cstdint>

namespace fathom::gaussian {

/// Colour a is the diagram of -A, colour b that of B.
enum class Colour : std::uint8_t { a, b };

inline constexpr std::array both_colours{Colour::a, Colour::b};

constexpr Colour other(Colour c) { return c == Colour::a ? Colour::b : Colour::a; }

/// What exists once for each colour.
template <class T>
struct PerColour {
  T a, b;

  [[nodiscard]] T& operator[](Colour c) { return c == Colour::a ? a : b; }
  [[nodiscard]] const T& operator[](Colour c) const { return c == Colour::a ? a : b; }
};

}  // namespace fathom::gaussian
