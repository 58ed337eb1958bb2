// SPDX-License-Identifier: GPL-3.0-or-later
// cddlib's double description, in rational arithmetic, of all differences b - a.
#pragma once

#include "tests/oracles/oracle.hpp"

namespace fathom::oracles {

/// Bodies of any rank. Meant for up to about 10 x 10 points; 20 x 20 take about a second. Throws
/// std::runtime_error when cddlib reports an error.
OracleAnswer cdd_oracle(std::span<const Point> a, std::span<const Point> b);

}  // namespace fathom::oracles
