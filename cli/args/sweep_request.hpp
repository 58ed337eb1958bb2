// SPDX-License-Identifier: GPL-3.0-or-later
// What the user asked for of study --sweep.
#pragma once

#include <string>
#include <vector>

namespace fathom::cli {

struct SweepRequest {
  std::string family;           ///< empty: no sweep
  std::vector<unsigned> sizes;  ///< ascending
};

}  // namespace fathom::cli
