// SPDX-License-Identifier: GPL-3.0-or-later
// Of output.hpp what writes nothing: it is linked into the library for C too.
#include <fmt/format.h>

#include "cli/io/output.hpp"

namespace fathom::cli {

std::string without_controls(std::string_view text) {
  std::string result;
  bool behind_lead = false;  // of a character of two bytes, U+0080 to U+00BF
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool second = behind_lead && byte >= 0x80 && byte < 0xa0;
    if (second) result.replace(result.size() - 1, 1, "\\xc2");
    if (second || byte < 0x20 || byte == 0x7f) result += fmt::format("\\x{:02x}", byte);
    else result += c;
    behind_lead = byte == 0xc2;
  }
  return result;
}

}  // namespace fathom::cli
