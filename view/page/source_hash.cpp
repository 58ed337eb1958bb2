// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/page/source_hash.hpp"

#include <array>

#include "verify/digest/sha256.hpp"

namespace fathom::page {
namespace {

unsigned nibble(char c) { return static_cast<unsigned>(c <= '9' ? c - '0' : c - 'a' + 10); }

}  // namespace

std::string source_hash(std::string_view text) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::string hex = digest::digest_of(text).sha256;
  std::string result = "sha256-";
  // Three bytes are six hexadecimal digits and four letters; 32 bytes leave two, hence one "=".
  for (std::size_t i = 0; i < hex.size(); i += 6) {
    std::array<unsigned, 6> digits{};
    const std::size_t used = std::min<std::size_t>(6, hex.size() - i);
    for (std::size_t k = 0; k < used; ++k) digits[k] = nibble(hex[i + k]);
    unsigned bits = 0;
    for (const unsigned digit : digits) bits = bits << 4 | digit;
    for (std::size_t k = 0; k < 4; ++k) result += k * 3 < used * 2 ? letters[bits >> (18 - 6 * k) & 63U] : '=';
  }
  return result;
}

}  // namespace fathom::page
