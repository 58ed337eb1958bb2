// SPDX-License-Identifier: GPL-3.0-or-later
// The integers of planes through differences of lattice points, of the points where these planes meet, and of what is computed from them:
// of fixed size where the lattice is narrow, or of any size.                                     [proofs/unions.md, "Fixed integers"]
#pragma once

#include <gmpxx.h>

#include <type_traits>

#include "kernels/number/fixed_integer.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

struct AnyNumbers {
  using OfPlane = mpz_class;
  using OfPoint = mpz_class;
  using Product = mpz_class;
};

/// For coordinates of lattice points up to 2^w in size, w <= most_bits.
struct FixedNumbers {
  static constexpr long most_bits = 103;
  using OfPlane = FixedInteger<320>;   ///< at most 3w + 9 bits
  using OfPoint = FixedInteger<960>;   ///< at most 9w + 20
  using Product = FixedInteger<3584>;  ///< at most 34w + 82
};

/// The same number or vector in other integers. A FixedInteger that is too narrow throws.
template <class Integer, class From>
decltype(auto) as(const From& number) {
  if constexpr (std::is_same_v<Integer, From>) return static_cast<const From&>(number);
  else if constexpr (std::is_same_v<Integer, mpz_class>) return number.to_mpz();
  else return Integer(number);
}
template <class Integer, class From>
decltype(auto) as(const Vec3<From>& v) {
  if constexpr (std::is_same_v<Integer, From>) return static_cast<const Vec3<From>&>(v);
  else return Vec3<Integer>{as<Integer>(v.x), as<Integer>(v.y), as<Integer>(v.z)};
}

}  // namespace fathom::kernels
