// SPDX-License-Identifier: GPL-3.0-or-later
// The input of cases: a file, a pipe or standard input, read so that Ctrl-C ends the waiting. And
// the common part of all commands that answer streams of cases.
#pragma once

#include <unistd.h>

#include <array>
#include <cstddef>
#include <functional>
#include <istream>
#include <optional>
#include <streambuf>
#include <string>

#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "fathom/depth.hpp"
#include "fathom/files.hpp"
#include "fathom/monitor.hpp"
#include "reference/files/cases.hpp"
#include "reference/output/json_values.hpp"

namespace fathom::cli {

/// Reads a file descriptor, which remains the caller's; standard input unless another is given.
/// Throws Interrupted once `stopped` returns true, even while waiting. Throws InputError if it
/// cannot be read. A stream passes these on if its exceptions() have badbit.
class InterruptibleInput : public std::streambuf {
 public:
  explicit InterruptibleInput(std::function<bool()> stopped = interrupt_requested, int descriptor = STDIN_FILENO)
      : stopped_(std::move(stopped)), descriptor_(descriptor) {}

 protected:
  int_type underflow() override;

 private:
  std::function<bool()> stopped_;
  int descriptor_;
  std::array<char, 1 << 16> buffer_;
};

// The input of a stream of cases. Waiting for a pipe can be stopped.

class CaseInput {
 public:
  /// Opens the file, or the pipe, called `path`; "-" is standard input. Throws InputError if it
  /// cannot be read. Once `stopped` returns true, nothing more can be read.
  CaseInput(const std::string& path, std::function<bool()> stopped);
  ~CaseInput();
  CaseInput(const CaseInput&) = delete;
  CaseInput& operator=(const CaseInput&) = delete;

  /// Returns the cases of this input, which must outlive them. Call it once.
  [[nodiscard]] files::UnreadCases texts();

 private:
  std::string path_;
  int descriptor_ = -1;  ///< of a pipe with a name
  InterruptibleInput buffer_;
  std::istream stream_{&buffer_};
};

// The number of cases in a file, for the progress line.

/// Returns the number of lines of the file that begin with a brace, which is that of the cases if
/// each has a line of its own, or is indented as usual. Returns nullopt if there are none, and for
/// input that can be read only once.
std::optional<std::size_t> cases_in(const std::string& path);

// The common part of all commands that answer streams of cases.

struct AskedCase {
  const Case& input;
  output::AboutBodies bodies;
  std::string_view text = {};  ///< of a case in JSON, for fields that Case has not, if it is asked for

  AskedCase(const Case& asked, bool one_body) : input(asked), bodies(output::about_bodies(asked, one_body)) {}
  operator const Case&() const { return input; }  // NOLINT(google-explicit-constructor): most commands need no more
};

/// An answer to a case.
struct CaseReply {
  std::string text;  ///< to be printed, without the last newline
  /// If set, it is called before printing, in the order of the cases; may throw InputError and
  /// OutputError.
  std::function<void()> keep = {};
  ExitCode code = fine;  ///< for a single case that was interrupted and has a partial answer
};

/// The functions and options with which a command answers the cases of a stream.
struct StreamWork {
  /// Answers one case. Called for several at once, on other threads, each with a workspace of its
  /// own. May throw anything.
  std::function<CaseReply(const AskedCase&, Monitor&, Workspace&)> answer;
  /// Returns the result line of a case without an answer; if not set, the sentence is printed on
  /// standard error.
  std::function<std::string(const CaseItem&, const std::string& sentence)> error_line;
  /// Called with the error of each case without an answer, in order, in addition to the printed
  /// line; may be empty.
  std::function<void(const std::string& sentence)> lost = {};
  /// A line to print before all results, or "".
  std::string header;
  /// Whether B is ignored.
  bool one_body = false;
  /// Empty if shapes that are no polytopes are allowed as bodies; else such cases are errors, and
  /// this sentence names the command that takes them.
  std::string refuses_shapes;
  /// Empty if unions of pieces are allowed as bodies; else such cases are errors, and this sentence
  /// gives the reason.
  std::string refuses_unions;
  /// The same of bodies of the plane.
  std::string refuses_plane = {};
  /// Whether `answer` reads the text of the case, which takes as much memory as the case.
  bool reads_text = false;
  /// Whether a mesh that is not convex is an error.
  bool require_convex = false;
  /// The number of cases answered at once.
  unsigned threads = 1;
  /// If set, blocks of cases are answered by this function instead of `answer`; it may be called by
  /// `threads` threads at once. It passes the block to answer_block in any process, and returns its
  /// result. `name` describes the block. A block is answered when it is complete.
  std::function<std::string(const std::string& block, const std::string& name)> elsewhere = {};
};

/// Returns whether a body of the case is a shape that is no polytope.
inline bool has_shape(const Case& single) { return single.a.shape || single.b.shape; }

/// Returns what is wrong with the bodies of a case, given the reasons to refuse shapes, unions and
/// bodies of the plane, each of which may be empty; or "".
std::string wrong_bodies(const Case& single, bool one_body, const std::string& refuses_shapes,
                         const std::string& refuses_unions, const std::string& refuses_plane);

/// Returns what is wrong with the meshes of a case if they must be convex, or "".
std::string wrong_meshes(const shapes::HullFacts& facts, bool require_convex);

/// Answers a block of cases for for_each_case in another process, with the same `input` and a
/// `work` that is the same except for `threads` and `elsewhere`; replies must not have `keep`.
/// Throws Interrupted, and std::invalid_argument for other texts.
std::string answer_block(const std::string& block, const std::string& input, const StreamWork& work);

/// Answers each case of the stream called `input`, in order: the output does not depend on the
/// number of threads, and no answer waits for the arrival of a later case. Reads ahead a fixed
/// number of cases, large ones only when they are next. A bad case gets its error and affects the
/// exit code, and the stream continues. Prints a note on the first case with points that are not
/// extreme on standard error, and a count of others at the end. A stream without any case is an
/// error. Throws InputError if the stream cannot be read, OutputError, Interrupted.
ExitCode for_each_case(const std::string& input, const StreamWork& work);

/// Prints on standard error how many points of each body are not extreme, as those of a mesh that
/// is not convex, because the answer is about the hull. The note is the same with every method, and
/// needs no hull if all points are seen to be extreme.
void tell_of_hulls(const Case& input, bool one_body, Progress& progress);

}  // namespace fathom::cli
