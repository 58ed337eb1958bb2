// SPDX-License-Identifier: Apache-2.0
// The bodies over one common denominator. From here on there are only integers.
#pragma once

#include <vector>

#include "certificate.hpp"

namespace fathom_check {

/// The points of A and B, in units of 1 / certificate.scale. They may share digits with the certificate, which must outlive them.
struct Scaled {
  Arena integers;
  std::vector<Vector> a, b;
};

Scaled scaled(const Certificate& certificate);

}  // namespace fathom_check
