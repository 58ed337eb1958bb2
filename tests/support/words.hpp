// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of short texts, written one behind the other.
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace fathom::testing {

/// What stands between blanks and ends of lines.
inline std::vector<std::string> words(const std::string& text) {
  std::istringstream from(text);
  std::vector<std::string> result;
  for (std::string word; from >> word;) result.push_back(word);
  return result;
}

}  // namespace fathom::testing
