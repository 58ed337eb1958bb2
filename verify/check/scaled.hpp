// SPDX-License-Identifier: Apache-2.0
// The bodies over one common denominator. From here on there are only integers, but for half-spaces
// and heights.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <vector>

#include "certificate.hpp"
#include "vectors.hpp"

namespace fathom_check {

/// A point over a common denominator of its own.
struct Homogeneous {
  MutableVector x;
  mpz_class w;  ///< positive, the least there is
};
Homogeneous homogeneous(const RationalPoint& p);
std::vector<Homogeneous> homogeneous(const Body& body);

/// Finds a positive multiple of `to` - `from`: the difference times both denominators.
void subtract(MutableVector& difference, const Homogeneous& to, const Homogeneous& from);

/// Zeros that binary digits of all points end with, left out axis by axis: by so many powers of 2
/// coordinates are larger than is stored. No plane, and no side of one, depends on such units;
/// lengths do.
struct Units {
  std::array<mp_bitcnt_t, 3> zeros{};

  [[nodiscard]] mp_bitcnt_t largest() const { return *std::max_element(zeros.begin(), zeros.end()); }
  [[nodiscard]] bool equal() const { return zeros[0] == zeros[1] && zeros[1] == zeros[2]; }
  /// Makes of the normal of the plane <n,x> = c in these units that of the same plane where all
  /// axes have the largest unit, with the same c.
  void make_equal(MutableVector& n) const;
  /// Makes of a direction that of its planes in these units. Returns the power of 2 by which
  /// heights along the one before are larger, where all axes have the largest unit.
  long take(MutableVector& n) const;
};

/// In units of 2^zeros / certificate.scale.
struct ScaledBody {
  std::vector<Vector> points;                           ///< the core points: none of a half-space; of all pieces
  std::vector<Words> words;                             ///< the same points; empty if one of them does not fit
  std::vector<std::vector<std::vector<Vector>>> terms;  ///< of a shape: their atoms, each the center, then the axes
  Vector normal;     ///< of a half-space: a positive multiple of the one that was read
  mpq_class offset;  ///< for this normal

  [[nodiscard]] Points all_points() const { return {points, words, 0, points.size()}; }
};

/// Both bodies. They may share digits with the certificate, which must outlive them.
struct Scaled {
  Arena integers;
  Units units;  ///< all 1 but for claims of depth about polytopes
  ScaledBody a, b;
};

/// Whether integers of a fixed size are used where they hold what is computed. What is checked does
/// not depend on it; tests do without.
enum class Arithmetic { fixed_where_it_fits, of_any_size };

/// Throws Fault (refused) unless the bodies are as section 4 demands of every claim, inner points
/// included; of pieces, if there is none.
Scaled scaled(const Certificate& certificate, Arithmetic arithmetic);

}  // namespace fathom_check
