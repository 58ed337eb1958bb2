// SPDX-License-Identifier: GPL-3.0-or-later
// What a pattern finds in a text. std::regex recurses once a character, which is too deep for a
// picture under a sanitizer.
#pragma once

#include <regex.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace fathom {

/// What the first group of an extended regular expression matches, at every place of the text where
/// the expression does.
inline std::vector<std::string> all(const std::string& text, const std::string& pattern) {
  regex_t regex;
  if (regcomp(&regex, pattern.c_str(), REG_EXTENDED) != 0) throw std::invalid_argument(pattern);
  std::vector<std::string> result;
  regmatch_t at[2];
  for (const char* rest = text.c_str(); regexec(&regex, rest, 2, at, 0) == 0; rest += at[0].rm_eo)
    result.emplace_back(rest + at[1].rm_so, rest + at[1].rm_eo);
  regfree(&regex);
  return result;
}

}  // namespace fathom
