// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "verify/digest/sha256.hpp"
#include "view/picture/markup.hpp"

namespace fathom::picture {
namespace {

unsigned hex_value(char c) { return static_cast<unsigned>(c <= '9' ? c - '0' : c - 'a' + 10); }

/// Base64 of the bytes that lower-case hexadecimal digits stand for.
std::string base64(std::string_view hex) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for (; !hex.empty(); hex.remove_prefix(std::min<std::size_t>(6, hex.size()))) {  // 3 bytes make 4 letters
    const std::size_t digits = std::min<std::size_t>(6, hex.size());
    unsigned bits = 0;
    for (std::size_t i = 0; i < 6; ++i) bits = bits << 4 | (i < digits ? hex_value(hex[i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i) result += i <= digits / 2 ? letters[bits >> (18 - 6 * i) & 63U] : '=';
  }
  return result;
}

std::string sources(std::string_view what, std::span<const std::string_view> texts) {
  std::string result(what);
  if (texts.empty()) result += " 'none'";
  for (const std::string_view text : texts) result += fmt::format(" 'sha256-{}'", base64(digest::digest_of(text).sha256));
  return result;
}

}  // namespace

std::string security_policy(std::span<const std::string_view> scripts, std::span<const std::string_view> styles) {
  return fmt::format("default-src 'none'; {}; {}; img-src data:; base-uri 'none'; form-action 'none'", sources("script-src", scripts),
                     sources("style-src", styles));
}

std::string policy_element(std::span<const std::string_view> scripts, std::span<const std::string_view> styles) {
  return fmt::format("<meta http-equiv=\"Content-Security-Policy\" content=\"{}\"/>", security_policy(scripts, styles));
}

}  // namespace fathom::picture
