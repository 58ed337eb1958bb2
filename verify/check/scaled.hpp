// SPDX-License-Identifier: Apache-2.0
// The bodies over one common denominator. From here on there are only integers.
#pragma once

#include <vector>

#include "budget.hpp"
#include "certificate.hpp"

namespace fathom_check {

/// The points of A and B, and numbers num / den, in units of 1 / scale.
struct Scaled {
  std::vector<Vector> a, b;
  mpz_class scale;
  std::uint64_t widest = 0;  ///< bits of the largest point
};

Scaled scaled(const Certificate& certificate, Budget& budget);

}  // namespace fathom_check
