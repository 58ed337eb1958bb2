// SPDX-License-Identifier: GPL-3.0-or-later
// The names that options take for what comes with fathom: families of cases, and subjects.
//                                                                       [verify/subjects/README.md]
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "verify/families/families.hpp"

namespace fathom::cli {

/// A few of the names: of families, unless others are given. Those that hold `name` come first,
/// then those by the fewest slips.
std::vector<std::string_view> nearest_families(std::string_view name,
                                               std::vector<std::string_view> names = families::family_names());

// The subjects that come with fathom, by name.                          [verify/subjects/README.md]

struct Adapter {
  std::string name;     ///< "libccd-epa"
  std::string program;  ///< "fathom-subject-libccd"; or a script for node, "web-subjects/jolt.mjs"
  std::string argument;
  std::string description;
};

const std::vector<Adapter>& adapters();

/// Returns that of "NAME" or "NAME,key=value,...", or null.
const Adapter* adapter_named(std::string_view words);

/// Returns a sentence on how those come that are not there.
std::string how_adapters_come();

/// Returns the path of the adapter's program: beside fathom's own, or in ../libexec/fathom from
/// there; "" if it is in neither place, or a script whose packages are not there.
std::string program_of(const Adapter& adapter);

/// Returns the shell command for "NAME" or "NAME,key=value,...". Throws InputError if there is no
/// such adapter, or its program is not built or has not its packages.
std::string adapter_command(const std::string& words);

}  // namespace fathom::cli
