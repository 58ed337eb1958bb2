// SPDX-License-Identifier: Apache-2.0
// Integer vectors. All of the checks are made of these five.
#pragma once

#include <gmpxx.h>

#include <cstdint>

#include "certificate.hpp"

namespace fathom_check {

inline mpz_class dot(const Vector& u, const Vector& v) {
  mpz_class result = u.x * v.x;
  mpz_addmul(result.get_mpz_t(), u.y.get_mpz_t(), v.y.get_mpz_t());
  mpz_addmul(result.get_mpz_t(), u.z.get_mpz_t(), v.z.get_mpz_t());
  return result;
}

inline Vector cross(const Vector& u, const Vector& v) {
  Vector result{u.y * v.z, u.z * v.x, u.x * v.y};
  mpz_submul(result.x.get_mpz_t(), u.z.get_mpz_t(), v.y.get_mpz_t());
  mpz_submul(result.y.get_mpz_t(), u.x.get_mpz_t(), v.z.get_mpz_t());
  mpz_submul(result.z.get_mpz_t(), u.y.get_mpz_t(), v.x.get_mpz_t());
  return result;
}

inline Vector difference(const Vector& u, const Vector& v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }

inline void add(Vector& sum, const Vector& v) {
  sum.x += v.x;
  sum.y += v.y;
  sum.z += v.z;
}

inline bool is_zero(const Vector& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// Binary digits of the absolute value; 0 has none.
inline std::uint64_t bits(const mpz_class& value) { return value == 0 ? 0 : mpz_sizeinbase(value.get_mpz_t(), 2); }

}  // namespace fathom_check
