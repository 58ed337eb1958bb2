// SPDX-License-Identifier: GPL-3.0-or-later
// Finds misspelt fields: unknown ones that look like a known one, such as "depht".
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace fathom::kernels {

/// The edit distance of two words: letters missing, inserted or wrong, or two neighbours swapped. Case does not matter.
std::size_t slips(std::string_view s, std::string_view t);

/// Whether `text` is probably the word: its edit distance is at most a third of the word's length.
bool is_near(std::string_view text, std::string_view word);

/// For each known word that is missing, names the first unknown field near it: "the field 'depht' is not read: is 'depth' meant?".
/// Several are joined by "; ". Empty if there is none.
std::string near_misses(std::span<const std::string> there, std::span<const std::string_view> known);

}  // namespace fathom::kernels
