// SPDX-License-Identifier: GPL-3.0-or-later
// The best case so far, on disk.                                                                                     [docs/certify.md]
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verify/harness/shrink/shrink.hpp"

namespace fathom::harness {

/// The user's own program around a case; see filled_harness.
struct HarnessTemplate {
  std::string text;
  std::string ending = ".cpp";  ///< of its file, and of the files that are made of it
};
/// Throws InputError if the file cannot be read, or has neither a place for A nor one for B.
HarnessTemplate read_harness(const std::string& path);

/// Writes <verdict>.case.json, <verdict>.cert and <verdict>.cpp (the snippet, or the user's own program) into `directory`, which is made if
/// needed. Each file is written under another name and then renamed, so none is ever half written. A variant's verdict is followed by
/// "~<variant>". Returns the three paths. Throws InputError naming the file that cannot be written.
std::vector<std::string> write_shrunk(const std::string& directory, const Shrunk& shrunk, const SubjectInfo& info,
                                      const std::optional<HarnessTemplate>& own = {});

/// Writes <stem>.case.json, the case with a comment, in the same way. Returns its path.
std::string write_case(const std::string& directory, const std::string& stem, const Case& pair, const std::string& comment);

}  // namespace fathom::harness
