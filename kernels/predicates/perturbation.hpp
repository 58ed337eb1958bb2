// SPDX-License-Identifier: GPL-3.0-or-later
// The whole policy of symbolic perturbation: which operand moves how. B stays. -A is mapped by a
// linear map close to the identity, and the chart's frame is tilted. Topology is decided on the
// moved operands, values never are.                                        [proofs/perturbation.md]
#pragma once

#include <array>
#include <cstdint>

#include "kernels/number/infinitesimal.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

/// What a direction is, hence how it moves.
enum class Role : std::uint8_t {
  fixed,        ///< a node or a circle of B: stays
  node_of_a,    ///< a facet normal n of -A: (I + E) n, for a 3x3 matrix E of nine independent infinitesimals
  circle_of_a,  ///< an edge direction d of -A, normal to its arc's great circle: cof(I + E) d, since Mn x Mm = cof(M)
                ///< (n x m)
  vertical,     ///< the chart's v = (0, 1, 0): (a, 1, b)
  pole,  ///< the chart's z = (0, 0, 1), or its negative: z = (c, -ac - b, 1), so that <v,z> = 0 stays an identity
};

/// The twelve infinitesimals by what they move: the entries of E row by row, then a, b, c.
inline constexpr unsigned infinitesimals = 12;

/// Which of the twelve is e1, e2, ..., and with which sign it enters. Every choice is as good as
/// any other: results do not depend on it, which is tested.
struct Perturbation {
  /// rank[i] in 1..12: the i-th infinitesimal (E11, E12, ..., E33, a, b, c) is e_rank[i]. The
  /// frame's come first: they are the only ones that questions within one body need.
  std::array<std::uint8_t, infinitesimals> rank{4, 5, 6, 7, 8, 9, 10, 11, 12, 1, 2, 3};
  std::array<std::int8_t, infinitesimals> sign{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};

  /// The direction `d`, moved, where only e1, ..., e_level are not 0.
  [[nodiscard]] Vec3<Infinitesimal> moved(const Vector& d, Role role, unsigned level) const;
  /// The vector t for which e_level enters the moved vertical as e_level t: only if e_level
  /// concerns it.
  [[nodiscard]] Vector tilt_of_vertical(unsigned level) const;
  /// Whether e_level moves directions of this role.
  [[nodiscard]] bool concerns(Role role, unsigned level) const;
};

}  // namespace fathom::kernels
