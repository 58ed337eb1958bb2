// SPDX-License-Identifier: GPL-3.0-or-later
// The output of the process: results on standard output, messages on standard error, both folded to
// the width of a terminal, and an exit code in the end.
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

#include "reference/files/file_io.hpp"
#include "verify/check/limits.hpp"

namespace fathom::cli {

/// Exit codes; a stream ends with the largest that occurred.
enum ExitCode : int {
  fine = 0,
  judged_wrong = 1,    ///< a verdict failed, a certificate was refused
  bad_input = 2,       ///< usage; or input malformed, missing, unreadable, empty, a directory
  internal_error = 3,  ///< a fault of fathom itself, or output cannot be written
  incomplete = 4,      ///< not every case could be put to the subject
  interrupted = 130,   ///< Ctrl-C
};

/// Standard output, or an output file, refused a write: closed, full disk.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Opens the standard streams that are closed, so that no other file gets their descriptors and
/// their output. They stay unusable: reading and writing fail as before.
void hold_standard_streams();

/// Writes `text` and a newline to standard output and flushes, so that a reader gets each result at
/// once. Throws OutputError.
void print(std::string_view text);

/// Returns `text` with control characters, which a terminal would obey, as \xNN: line ends and
/// those of two bytes in UTF-8 too.
std::string without_controls(std::string_view text);

/// Returns the message for `error`, which was not caused by input.
std::string fault_text(const std::exception& error);

/// Writes "fathom: `text`" and a newline to standard error. Never fails. Escapes control characters
/// other than line ends.
void talk(std::string_view text);

/// Prints the sentence on standard error and returns the code.
ExitCode failed(std::string_view sentence, ExitCode code);

/// Returns the result of `run`, or prints one sentence on the exception that it threw and returns
/// the corresponding exit code. Does not throw.
ExitCode guarded(const std::function<ExitCode()>& run);

// Text that fits the terminal. Widths are characters of UTF-8, each of which counts as one column.

/// The width of files and pipes, which get whole lines.
inline constexpr std::size_t unlimited = static_cast<std::size_t>(-1);

/// Returns whether the descriptor is a terminal that a person may look at.
bool is_terminal(int descriptor);

/// Returns the number of columns of the terminal behind the descriptor; 80 if it reports none, or
/// if there is no terminal.
std::size_t terminal_columns(int descriptor);

/// Returns the width for help: the environment's COLUMNS if that is a number above 0, else that of
/// the terminal; within limits that leave text readable.
std::size_t help_columns(int descriptor);

/// Returns the terminal's width, or `unlimited` if the descriptor is no terminal.
std::size_t seen_columns(int descriptor);

/// Returns the first `most` characters.
std::string_view cut(std::string_view text, std::size_t most);

/// Returns the text in lines of at most `width` characters, broken at spaces after the first
/// `indent` characters. Continued lines begin with `indent` spaces, or half the width if that is
/// less. Words that are too long keep their length; line ends are kept.
std::string folded(std::string_view text, std::size_t width, std::size_t indent = 0);

/// Returns the text for standard output: folded() on a terminal, else as it is.
std::string fitted(std::string_view text, std::size_t indent = 0);

// Files for certificates, pictures and reports, and folders of them; and the limits of the checkers
// on certificates.

/// A file for a certificate, a picture or a report, which appears with all of its content or not at
/// all. Opened before solving, so that an unwritable path fails early.
class CertificateFile {
 public:
  /// `what` is for messages. Throws InputError if nothing can be written there.
  explicit CertificateFile(const std::string& path, const std::string& what = "certificate");

  /// Writes the content, once. Throws OutputError.
  void write(std::string_view text);

 private:
  std::string what_;
  files::WholeFile file_;
};

/// Returns the file at `path`, opened; null if the path is empty.
std::unique_ptr<CertificateFile> wanted_file(const std::string& path, const std::string& what);

/// A folder for the certificates, or the pictures, of a stream; made if it is missing.
class CertificateFolder {
 public:
  /// `what` names the files in messages, `ending` is that of their names. Throws InputError if the
  /// path is not a folder and cannot be made.
  explicit CertificateFolder(std::string path, std::string what = "certificate", std::string ending = ".cert");

  /// Returns the path for the file of a case. Throws InputError if the id occurred before.
  std::string file(const std::string& id);

 private:
  std::string path_, what_, ending_;
  std::set<std::string> names_;
};

// Refuses to write a certificate that exceeds the checkers' limits: an error, and no file.
// [verify/check/FORMAT.md, section 8]

/// Throws OutputError, which names the limit and what helps, if the certificate of this case passes
/// a limit of all checkers.
void require_readable(const std::string& id, std::string_view certificate, const fathom_check::Limits& limits = {});

}  // namespace fathom::cli
