// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths in another unit, a power of two larger or smaller: exact.
#pragma once

#include <gmpxx.h>

#include "fathom/body.hpp"

namespace fathom::judging {

/// value * 2^exponent.
mpq_class scaled(const mpq_class& value, long exponent);

/// The points with all coordinates times 2^exponent; in binary64 if they were and are.
GivenPoints scaled(const GivenPoints& points, long exponent);

}  // namespace fathom::judging
