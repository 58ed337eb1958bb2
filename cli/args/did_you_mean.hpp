// SPDX-License-Identifier: GPL-3.0-or-later
// What a misspelt word may be meant to be.
#pragma once

#include <span>
#include <string>

namespace fathom::cli {

/// Returns "; did you mean 'word'?" for the one of `words` that alone begins with `typed`, or else is nearest to it and near; or "".
std::string did_you_mean(const std::string& typed, std::span<const std::string> words);

}  // namespace fathom::cli
