// SPDX-License-Identifier: GPL-3.0-or-later
// From a path to bytes, and from bytes to what a message may show of them.
#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

namespace fathom {

/// The longest line of a stream, in bytes, and the longest case, over however many lines: an input without an end must not eat all memory.
inline constexpr std::size_t longest_line = std::size_t{256} << 20;

enum class LineRead { whole, too_long, no_memory, none };

/// Replaces `line` by the next line of `input`, without its line feed; `none`: there is no more. A line that is longer than the limit, or
/// than the memory at hand, is passed over to its end and leaves `line` empty; after sixteen times the limit `input` is taken to be
/// without an end, and goes bad.
LineRead read_line(std::istream& input, std::string& line);

/// The whole file, byte by byte; pipes are read to their end.
/// InputError if it is missing, a directory, unreadable, or a pipe or device, which may have no end, of more than so many bytes.
std::string read_file(const std::string& path, std::size_t most_of_a_pipe = std::size_t{1} << 30);

/// InputError if `path` is missing, a directory or unreadable. Opens nothing.
void require_readable(const std::string& path);

/// The extension of the file's name in lower case and without the dot; empty if there is none.
std::string extension(std::string_view path);

/// `text` in single quotes for a message: cut to a readable length, bytes outside printable ASCII as \xNN. "nothing" if empty.
std::string shown(std::string_view text);

/// `text` with the bytes outside printable ASCII as \xNN, cut after `limit` bytes.
std::string printable(std::string_view text, std::size_t limit);

}  // namespace fathom
