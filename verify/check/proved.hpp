// SPDX-License-Identifier: Apache-2.0
// What a certificate proves, if it is accepted.
#pragma once

#include <gmpxx.h>

#include "certificate.hpp"

namespace fathom_check {

mpq_class value(const Rational& r);

/// The sum of both radii.
mpq_class radii(const Certificate& certificate);

/// "penetrating", "touching", "disjoint", or, for bounds that leave it open, "undecided": of the
/// bodies, radii included.
const char* status(const Certificate& certificate);

/// Whether the signed depth is sqrt(|c|) + radii, the root with the sign of c, and not just within
/// bounds; if so, c.
bool is_exact(const Certificate& certificate);
mpq_class squared_of_cores(const Certificate& certificate);

}  // namespace fathom_check
