// SPDX-License-Identifier: GPL-3.0-or-later
// The request of `fathom cases`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fathom::cli {

struct CasesRequest {
  enum class What { family, catalogue, list, from, from_fcl };
  What what = What::family;
  std::vector<std::string> families;  ///< as typed: names, or patterns of them; "all"
  bool shapes = false;                ///< of all families, or the catalogue, or the list: those of shapes, not of polytopes
  bool unions = false;                ///< likewise, those of unions of pieces
  std::uint64_t count = 1, seed = 1;  ///< the seeds are seed, seed + 1, ...
  std::optional<unsigned> size;       ///< if not set, the family's usual size
  std::string fcl;                    ///< the file with the text of FCL's exceptions
};

}  // namespace fathom::cli
