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

/// The body in C++: its points as {{x, y, z}, ...}, or the functions of fathom/shape.hpp that make
/// it, as fathom::moved(fathom::sphere(0.5), ...). Numbers are the shortest decimals that read back
/// as the same binary64 number.
std::string body_code(const Body& body);
/// The same; points become fathom::hull(...).
std::string as_shape_code(const Body& body);
std::string shape_code(const files::NamedBody& words);

/// The user's own program: `text` with each @A@ and @B@ filled by body_code, and each @A_JSON@ and
/// @B_JSON@ by the body as the subject is sent it. Of a variant it is the case itself. Nothing else
/// is changed.
std::string filled_harness(std::string text, const SubjectInfo& info, const Case& pair, const Outcome& outcome);

/// A whole C++ program that puts the case to the subject's library (libccd, FCL, Bullet, ODE:
/// info.library) by its own calls and prints what it answers; for any other library, and for bodies
/// by name, a GoogleTest that hands the recorded answer to fathom::judge, whose first line says
/// where a call belongs in its place. Coordinates are C99 hex floats. A comment on top tells the
/// exact depth^2, what was claimed, the verdict, and how to compile it. `pair` is as the subject
/// saw it.
std::string snippet(const SubjectInfo& info, const Case& pair, const Outcome& outcome);

// ---- the best case so far, on disk ----

/// The user's own program around a case; see filled_harness.
struct HarnessTemplate {
  std::string text;
  std::string ending = ".cpp";  ///< of its file, and of the files that are made of it
};
/// Throws InputError if the file cannot be read, or has neither a place for A nor one for B.
HarnessTemplate read_harness(const std::string& path);

/// Writes <verdict>.case.json, <verdict>.cert and <verdict>.cpp (the snippet, or the user's own
/// program) into `directory`, which is made if needed. Each file is written under another name and
/// then renamed, so none is ever half written. A variant's verdict is followed by "~<variant>".
/// Returns the three paths. Throws InputError naming the file that cannot be written.
std::vector<std::string> write_shrunk(const std::string& directory, const Shrunk& shrunk, const SubjectInfo& info,
                                      const std::optional<HarnessTemplate>& own = {});

/// Writes <stem>.case.json, the case with a comment, in the same way. Returns its path.
std::string write_case(const std::string& directory, const std::string& stem, const Case& pair,
                       const std::string& comment);

}  // namespace fathom::harness
