// SPDX-License-Identifier: GPL-3.0-or-later
// Names that options accept for parts of fathom: families of cases, and subjects.
//                                                                       [verify/subjects/README.md]
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "verify/families/families.hpp"

namespace fathom::cli {

/// Returns a few of the names, by default those of families, that are similar to `name`: first
/// those that contain it, then those at the smallest edit distance.
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

/// Returns the adapter of "NAME" or "NAME,key=value,...", or null.
const Adapter* adapter_named(std::string_view words);

/// Returns a sentence on how to build or install missing adapters.
std::string how_adapters_come();

/// Returns the path of the adapter's program: beside fathom's own, or in ../libexec/fathom from
/// there; "" if it is in neither place, or is a script whose packages are missing.
std::string program_of(const Adapter& adapter);

/// Returns the shell command for "NAME" or "NAME,key=value,...". Throws InputError if there is no
/// such adapter, its program is not built, or its packages are missing.
std::string adapter_command(const std::string& words);

}  // namespace fathom::cli
