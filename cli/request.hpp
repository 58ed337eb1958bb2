// SPDX-License-Identifier: GPL-3.0-or-later
// What the user asked for, once the command line has been understood.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernels/number/parse.hpp"
#include "reference/depth/depth.hpp"

namespace fathom::cli {

enum class Command { depth, width };

struct Request {
  Command command = Command::depth;
  std::vector<std::string> inputs;  ///< depth: two meshes or one stream; width: one mesh or one stream
  Method method = Method::exact;
  std::optional<unsigned> digits;  ///< of the enclosure of the depth, if one is wanted
  bool json = false;
  bool counters = false;
  Decimals decimals = Decimals::binary64;  ///< of text meshes; cases say it themselves
};

}  // namespace fathom::cli
