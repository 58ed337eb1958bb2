// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/messages.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace fathom::kernels {

std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + ' ' + std::string(count == 1 ? one : many);
}

std::string printable(std::string_view text, std::size_t limit) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string result;
  for (const char c : text.substr(0, limit)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      result += c;
    } else {
      result += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
    }
  }
  if (text.size() > limit) result += "...";
  return result;
}

std::string shown(std::string_view text) { return text.empty() ? "nothing" : "'" + printable(text, readable) + "'"; }

std::size_t slips(std::string_view s, std::string_view t) {
  std::vector<std::vector<std::size_t>> least(s.size() + 1, std::vector<std::size_t>(t.size() + 1));
  for (std::size_t i = 0; i <= s.size(); ++i) {
    for (std::size_t j = 0; j <= t.size(); ++j) {
      if (i == 0 || j == 0) {
        least[i][j] = i + j;
        continue;
      }
      const bool same = lower(s[i - 1]) == lower(t[j - 1]);
      least[i][j] = std::min({least[i - 1][j] + 1, least[i][j - 1] + 1, least[i - 1][j - 1] + (same ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && lower(s[i - 1]) == lower(t[j - 2]) && lower(s[i - 2]) == lower(t[j - 1]);
      if (swapped) least[i][j] = std::min(least[i][j], least[i - 2][j - 2] + 1);
    }
  }
  return least[s.size()][t.size()];
}

bool is_near(std::string_view text, std::string_view word) {
  const std::size_t most = word.size() / 3;
  return text.size() <= word.size() + most && word.size() <= text.size() + most && slips(text, word) <= most;
}

std::string near_misses(std::span<const std::string> there, std::span<const std::string_view> known) {
  std::vector<std::string_view> unknown;
  std::ranges::copy_if(there, std::back_inserter(unknown),
                       [&](std::string_view field) { return std::ranges::find(known, field) == known.end(); });
  std::string result;
  if (unknown.empty()) return result;
  for (const std::string_view word : known) {
    if (std::ranges::find(there, word) != there.end()) continue;
    const auto field = std::ranges::find_if(unknown, [&](std::string_view each) { return is_near(each, word); });
    if (field != unknown.end())
      result += (result.empty() ? "" : "; ") +
                ("the field " + shown(*field) + " is not read: is '" + std::string(word) + "' meant?");
  }
  return result;
}

}  // namespace fathom::kernels
