// SPDX-License-Identifier: GPL-3.0-or-later
// Where a report comes from.
#pragma once

#include <string>

namespace fathom::harness {

/// Which fathom judged, and how it was called. Every report says so.
struct Provenance {
  std::string version;    ///< "0.1.0"
  std::string command;    ///< the command line, ready for a shell
  std::string cut_short;  ///< why the run ended before every case was judged; empty if it did not
};

}  // namespace fathom::harness
