// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/markup.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fathom::picture {
namespace {

struct Lead {
  std::size_t length;  // of the sequence in bytes
  unsigned bits;       // that the first byte gives
  unsigned least;      // a smaller code point has a shorter sequence, so this one is not UTF-8
};

Lead lead_of(unsigned char byte) {
  if (byte < 0x80) return {1, byte, 0};
  if (byte >= 0xc0 && byte < 0xe0) return {2, byte & 0x1fU, 0x80};
  if (byte >= 0xe0 && byte < 0xf0) return {3, byte & 0x0fU, 0x800};
  if (byte >= 0xf0 && byte < 0xf8) return {4, byte & 0x07U, 0x10000};
  return {0, 0, 0};
}

/// Bytes of the character that `text`, which is not empty, begins with; 0 if that is not UTF-8, or none that XML 1.0 may hold.
std::size_t character(std::string_view text) {
  const auto [length, bits, least] = lead_of(static_cast<unsigned char>(text[0]));
  if (length == 0 || length > text.size()) return 0;
  unsigned point = bits;
  for (std::size_t i = 1; i < length; ++i) {
    const unsigned byte = static_cast<unsigned char>(text[i]);
    if (byte >> 6 != 2) return 0;
    point = point << 6 | (byte & 0x3fU);
  }
  const bool surrogate = point >= 0xd800 && point < 0xe000;
  const bool control = point < 0x20 || (point >= 0x7f && point < 0xa0);
  const bool none = (point & 0xfffeU) == 0xfffe || (point >= 0xfdd0 && point < 0xfdf0);
  return point < least || point > 0x10ffff || surrogate || control || none ? 0 : length;
}

std::string byte_text(char c) { return fmt::format("\\x{:02x}", static_cast<unsigned char>(c)); }

}  // namespace

std::string markup(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const char c = text.front();
    std::size_t used = 1;
    if (c == '&') result += "&amp;";
    else if (c == '<') result += "&lt;";
    else if (c == '>') result += "&gt;";
    else if (c == '"') result += "&quot;";
    else if (c == '\'') result += "&#39;";
    else if (c == '\t' || c == '\n' || c == '\r') result += fmt::format("&#{};", static_cast<int>(c));
    else if (used = character(text); used > 0) result += text.substr(0, used);
    else result += byte_text(c), used = 1;
    text.remove_prefix(used);
  }
  return result;
}

std::string ascii(std::string_view text, std::size_t width) {
  std::string result;
  for (const char c : text) {
    result += c >= 0x20 && c < 0x7f ? std::string(1, c) : byte_text(c);
    if (result.size() > width) return result.substr(0, width - 3) + "...";
  }
  return result;
}

std::string without_folders(std::string_view text) {
  constexpr std::string_view before = " \t\n'\"=:,;(", after = " \t\n'\",;)";
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const bool begins = text[at] == '/' && (at == 0 || before.find(text[at - 1]) != std::string_view::npos);
    const std::size_t end = begins ? std::min(text.find_first_of(after, at), text.size()) : at + 1;
    std::string_view part = text.substr(at, end - at);
    if (begins && part.find_last_not_of('/') != std::string_view::npos) {
      part = part.substr(0, part.find_last_not_of('/') + 1);
      part = part.substr(part.rfind('/') + 1);
    }
    result += part;
    at = end;
  }
  return result;
}

}  // namespace fathom::picture
