// SPDX-License-Identifier: GPL-3.0-or-later
// Words in messages: untrusted bytes of users made printable, misspelt words found, things counted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace fathom::kernels {

/// As many bytes of a text of users are shown in a message.
inline constexpr std::size_t readable = 40;

/// A letter of ASCII in lower case; any other byte as it is.
constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Returns `text` in single quotes for a message: cut to a readable length, bytes outside printable
/// ASCII as \xNN; "nothing" if it is empty.
std::string shown(std::string_view text);

/// "1 way", "2 ways".
std::string counted(std::uint64_t count, std::string_view one, std::string_view many);

/// Returns `text` with the bytes outside printable ASCII as \xNN, cut after `limit` bytes.
std::string printable(std::string_view text, std::size_t limit);

/// The edit distance of two words: letters missing, inserted or wrong, or two neighbours swapped.
/// Case does not matter.
std::size_t slips(std::string_view s, std::string_view t);

/// Whether `text` is probably the word: its edit distance is at most a third of the word's length.
bool is_near(std::string_view text, std::string_view word);

/// For each known field that is missing, names the first unknown field near it: "the field 'depht'
/// is not read: is 'depth' meant?". Several are joined by "; ". Empty if there is none.
std::string near_misses(std::span<const std::string> there, std::span<const std::string_view> known);

}  // namespace fathom::kernels
