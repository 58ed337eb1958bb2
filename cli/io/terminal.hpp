// SPDX-License-Identifier: GPL-3.0-or-later
// How wide a terminal is, and text that fits it. Widths are characters of UTF-8, each of which
// counts as one column.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fathom::cli {

/// Stands for the width of files and pipes, which get whole lines.
inline constexpr std::size_t unlimited = static_cast<std::size_t>(-1);

/// Returns whether the descriptor is a terminal that a person may look at.
bool is_terminal(int descriptor);

/// Returns how many columns the terminal behind the descriptor has; 80 if it does not say, or if
/// there is none.
std::size_t terminal_columns(int descriptor);

/// Returns the width for help: the environment's COLUMNS if that is a number above 0, else that of
/// the terminal; within limits that leave text readable.
std::size_t help_columns(int descriptor);

/// Returns the terminal's width, or `unlimited` if the descriptor is no terminal.
std::size_t seen_columns(int descriptor);

/// Returns the first `most` characters.
std::string_view cut(std::string_view text, std::size_t most);

/// Returns the text in lines of at most `width` characters, broken at spaces behind the first
/// `indent` characters. Lines behind a break begin with that many spaces, or half the width if that
/// is less. Words that are too long keep their length; line ends stay.
std::string folded(std::string_view text, std::size_t width, std::size_t indent = 0);

/// Returns the text for standard output: folded() on a terminal, else as it is.
std::string fitted(std::string_view text, std::size_t indent = 0);

}  // namespace fathom::cli
