// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

namespace fathom::kernels {

/// p / q in lowest terms; q is not zero.
inline mpq_class ratio(const mpz_class& p, const mpz_class& q) {
  mpq_class result(p, q);
  result.canonicalize();
  return result;
}

}  // namespace fathom::kernels
