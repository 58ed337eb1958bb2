// SPDX-License-Identifier: GPL-3.0-or-later
// stdout is data, stderr is talk.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace fathom::cli {

/// Standard output, or a file of ours, refused a write: closed, full disk.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Opens the standard streams that are closed, so that no file of ours takes their place and gets what is meant for them. They stay as
/// unusable as they were: what is written or read is refused as before.
void hold_standard_streams();

/// Writes `text` and a newline to standard output and flushes, so that a reader has each result before the next case is read.
/// Throws OutputError.
void print(std::string_view text);

/// `text` with its control characters as \xNN, those of two bytes in UTF-8 too: what a terminal would obey, and line ends.
std::string without_controls(std::string_view text);

/// What `error`, caught from anything that is no input's fault, is to be called.
std::string fault_text(const std::exception& error);

/// Writes "fathom: `text`" and a newline to standard error. Never fails. Of control characters only line ends are written as they are.
void talk(std::string_view text);

}  // namespace fathom::cli
