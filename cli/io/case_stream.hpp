// SPDX-License-Identifier: GPL-3.0-or-later
// What all commands that answer streams of cases share.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "fathom/depth.hpp"
#include "fathom/files.hpp"
#include "fathom/monitor.hpp"
#include "reference/output/json_values.hpp"

namespace fathom::cli {

struct AskedCase {
  const Case& input;
  output::AboutBodies bodies;

  AskedCase(const Case& asked, bool one_body) : input(asked), bodies(output::about_bodies(asked, one_body)) {}
  operator const Case&() const { return input; }  // NOLINT(google-explicit-constructor): most commands need no more
};

/// An answer to a case.
struct CaseReply {
  std::string text;  ///< to be printed, without the last newline
  /// if set: called first, in the order of the cases; may throw InputError and OutputError
  std::function<void()> keep = {};
  ExitCode code = fine;  ///< of a single case that was interrupted and has part of an answer
};

/// What a command does with the cases of a stream.
struct StreamWork {
  /// Answers one case. Called for several at once, on other threads, each with a workspace of its
  /// own. May throw anything.
  std::function<CaseReply(const AskedCase&, Monitor&, Workspace&)> answer;
  /// Returns the result line of a case without an answer; if not set, the sentence goes to standard
  /// error.
  std::function<std::string(const CaseItem&, const std::string& sentence)> error_line;
  /// Hears of each case without an answer, in order, beside what is printed; may be empty.
  std::function<void(const std::string& sentence)> lost = {};
  /// Printed before all results, unless empty.
  std::string header;
  /// Whether B is ignored.
  bool one_body = false;
  /// Empty if bodies may be shapes that are no polytopes; else such cases are errors, and this says
  /// which command takes them.
  std::string refuses_shapes;
  /// Whether bodies may be unions of pieces; else such cases are errors.
  bool takes_unions = false;
  /// Whether a mesh that is not convex is an error.
  bool require_convex = false;
  /// How many cases are answered at once.
  unsigned threads = 1;
  /// If set, blocks of cases are answered by this, called by as many threads at once, instead of by
  /// `answer`: it passes the block to answer_block in any process, and returns what that returns.
  /// `name` tells what the block is. Then a block is answered once it is whole.
  std::function<std::string(const std::string& block, const std::string& name)> elsewhere = {};
};

/// Returns whether a body of the case is a shape that is no polytope.
inline bool has_shape(const Case& single) { return single.a.shape || single.b.shape; }

/// Returns whether a body of the case is a union of pieces.
inline bool has_union(const Case& single) { return single.a.pieces || single.b.pieces; }

/// Returns what is wrong with the bodies of a case if they must be polytopes, as `refuses_shapes`
/// says unless it is empty, and may be unions only if `takes_unions`; or "".
std::string wrong_bodies(const Case& single, bool one_body, const std::string& refuses_shapes, bool takes_unions);

/// Returns what is wrong with the meshes of a case if they must be convex, or "".
std::string wrong_meshes(const shapes::HullFacts& facts, bool require_convex);

/// Answers a block of cases for for_each_case in another process, with the same `input` and a
/// `work` that is the same except for `threads` and `elsewhere`; replies must not have `keep`.
/// Throws Interrupted, and std::invalid_argument for other texts.
std::string answer_block(const std::string& block, const std::string& input, const StreamWork& work);

/// Answers each case of the stream called `input`, in order: whatever is printed does not depend on
/// the number of threads, and no answer waits for a later case to be there. Of cases that have no
/// answer yet, a fixed number is read ahead, large ones only when their turn has come. A bad case
/// gets its error and counts in the exit code, and the stream goes on. Notes the first case with
/// points that are not extreme on standard error, and a count of others at the end. A stream
/// without any case is an error. Throws InputError if the stream cannot be read, OutputError,
/// Interrupted.
ExitCode for_each_case(const std::string& input, const StreamWork& work);

/// Notes on standard error how many points of each body are not extreme, as those of a mesh that is
/// not convex: the answer is about the hull. The note is the same with every method, and needs no
/// hull where all points are seen to be extreme.
void tell_of_hulls(const Case& input, bool one_body, Progress& progress);

}  // namespace fathom::cli
