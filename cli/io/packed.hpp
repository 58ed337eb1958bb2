// SPDX-License-Identifier: GPL-3.0-or-later
// Several texts as one, for messages between processes.
#pragma once

#include <charconv>
#include <stdexcept>
#include <string>
#include <vector>

namespace fathom::cli {

/// Appends a text of any bytes: its length, a blank, itself.
inline void pack(std::string& all, const std::string& text) { ((all += std::to_string(text.size())) += ' ') += text; }

inline std::string packed(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) pack(all, text);
  return all;
}

/// The texts that were packed. Throws std::invalid_argument for other text.
inline std::vector<std::string> unpacked(const std::string& all) {
  std::vector<std::string> texts;
  for (std::size_t at = 0; at < all.size();) {
    std::size_t length = 0;
    const auto [end, error] = std::from_chars(all.data() + at, all.data() + all.size(), length);
    const std::size_t begin = static_cast<std::size_t>(end - all.data()) + 1;  // behind the blank
    if (error != std::errc() || begin > all.size() || *end != ' ' || length > all.size() - begin)
      throw std::invalid_argument("expected packed texts, found another text");
    texts.push_back(all.substr(begin, length));
    at = begin + length;
  }
  return texts;
}

}  // namespace fathom::cli
