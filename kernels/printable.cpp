// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/messages.hpp"

namespace fathom::kernels {

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

std::string shown(std::string_view text) {
  constexpr std::size_t readable = 40;
  return text.empty() ? "nothing" : "'" + printable(text, readable) + "'";
}

}  // namespace fathom::kernels
