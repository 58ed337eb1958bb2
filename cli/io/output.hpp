// SPDX-License-Identifier: GPL-3.0-or-later
// stdout is data, stderr is talk.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace fathom::cli {

/// Standard output, or an output file, refused a write: closed, full disk.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Opens the standard streams that are closed, so that no other file gets their descriptors and their output. They stay unusable: reading
/// and writing fail as before.
void hold_standard_streams();

/// Writes `text` and a newline to standard output and flushes, so that a reader has each result as soon as it is there.
/// Throws OutputError.
void print(std::string_view text);

/// Returns `text` with control characters, which a terminal would obey, as \xNN: line ends and those of two bytes in UTF-8 too.
std::string without_controls(std::string_view text);

/// Returns the message for `error`, which no input caused.
std::string fault_text(const std::exception& error);

/// Writes "fathom: `text`" and a newline to standard error. Never fails. Escapes control characters other than line ends.
void talk(std::string_view text);

}  // namespace fathom::cli
