// SPDX-License-Identifier: GPL-3.0-or-later
// A failing case as a program to paste into a bug report or a test.               [docs/certify.md]
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/files/shape_names.hpp"
#include "verify/harness/outcome.hpp"
#include "verify/harness/shrink/shrink.hpp"

namespace fathom::harness {

/// Returns a whole C++ program that puts the case to the subject's library (libccd, FCL, Bullet,
/// ODE: info.library) by its own calls and prints its answer; for any other library, for bodies by
/// name, and for a wrong derivative, a GoogleTest that passes the recorded answer to fathom::judge,
/// whose first line says where to put the user's call instead. Coordinates are C99 hex floats. A
/// comment on top states the exact depth^2, the claim, the verdict, and how to compile it. `pair`
/// is the case as it was put to the subject.
std::string snippet(const SubjectInfo& info, const Case& pair, const Outcome& outcome);

// ---- the best case so far, on disk ----

/// The user's own program for a case; see filled_harness.
struct HarnessTemplate {
  std::string text;
  std::string ending = ".cpp";  ///< of its file, and of the files made from it
};
/// Throws InputError if the file cannot be read, or lacks both a mark for A and one for B.
HarnessTemplate read_harness(const std::string& path);

/// Writes <verdict>.case.json, <verdict>.cert and <verdict>.cpp (the user's own program, or the
/// snippet) into `directory`, which is made if needed. Each file is written under
/// another name and then renamed, so none is ever half written. A variant's verdict is followed by
/// "~<variant>". Returns the paths. Throws InputError naming the file that cannot be written.
std::vector<std::string> write_shrunk(const std::string& directory, const Shrunk& shrunk, const SubjectInfo& info,
                                      const std::optional<HarnessTemplate>& own = {});

/// Writes <stem>.case.json, the case with a comment, in the same way. Returns its path.
std::string write_case(const std::string& directory, const std::string& stem, const Case& pair,
                       const std::string& comment);

}  // namespace fathom::harness
