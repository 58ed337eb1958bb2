// SPDX-License-Identifier: GPL-3.0-or-later
// A field that nobody reads, and that looks as if it were meant to be read: "depht".
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace fathom::harness {

/// The least number of slips of the pen between two words: a letter left out, put in, or wrong, or two neighbours swapped. Upper and lower
/// case are the same.
std::size_t slips(std::string_view s, std::string_view t);

/// Whether `text` is meant to be the word: at most one slip for every three letters of the word.
bool is_near(std::string_view text, std::string_view word);

/// For each word of `known` that is not among the fields, the first of them that is near it and no known word: "the field 'depht' is not
/// read: is 'depth' meant?", with "; " between several. Empty if there is none.
std::string near_misses(std::span<const std::string> there, std::span<const std::string_view> known);

}  // namespace fathom::harness
