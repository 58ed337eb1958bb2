// SPDX-License-Identifier: GPL-3.0-or-later
// What a report says of its run, beside the verdicts.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fathom/depth.hpp"

namespace fathom::harness {

/// Failures that no case caused, by their wording, with their number.
using UnattributedCounts = std::map<std::string, std::size_t>;

inline std::size_t sum(const UnattributedCounts& counts) {
  std::size_t result = 0;
  for (const auto& [detail, count] : counts) result += count;
  return result;
}

/// Which fathom judged, how it was called, and how it went. Every report says so.
struct RunInfo {
  std::string version;    ///< "0.1.0"
  std::string command;    ///< the command line, ready for a shell
  std::string cut_short;  ///< why the run ended before every case was judged; empty if it did not
  UnattributedCounts unattributed = {};
  std::vector<Method> second = {};              ///< methods that found every truth again, and agreed
  std::optional<mpq_class> fit = std::nullopt;  ///< the size that each case was brought to; see exponent_to_fit
};

}  // namespace fathom::harness
