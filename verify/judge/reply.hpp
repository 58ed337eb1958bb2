// SPDX-License-Identifier: GPL-3.0-or-later
// What an implementation answers about two bodies, in its own numbers, and the conventions it declares.      [verify/PROTOCOL.md]
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace fathom {

/// The type that the subject computes in, and in which it sees the points.
enum class Precision { binary32, binary64 };

/// As everywhere in texts: "binary32", "binary64".
constexpr std::string_view name(Precision precision) { return precision == Precision::binary32 ? "binary32" : "binary64"; }

/// What a subject declares of itself. Judging never guesses them.
struct Conventions {
  enum class Touching { overlap, separate, either };  ///< what bodies that touch count as
  enum class Sign { positive, negative };
  enum class Body { a, b };
  Touching touching = Touching::either;
  Sign depth = Sign::positive;  ///< of the depth of bodies that overlap
  Body moves = Body::a;         ///< the body that |depth| * direction moves apart
  bool unit = true;             ///< whether directions are promised to have length 1
};

using Triple = std::array<double, 3>;

/// Numbers as the subject gave them: NaN and infinities are possible. A binary32 subject's are binary32 numbers.
struct Reply {
  bool overlap = false;
  // Read only where the bodies are said to overlap:
  std::optional<double> depth;
  std::optional<Triple> direction;
  std::optional<Triple> witness_a, witness_b;  ///< a point of each body, with b - a = the translation that moves A apart
};

}  // namespace fathom
