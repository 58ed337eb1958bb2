// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/digest/sha256.hpp"

#include <array>

namespace fathom::digest {

Sha256::Sha256() { SHA256Init(&state_); }

void Sha256::add(std::string_view bytes) {
  SHA256Update(&state_, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  bytes_ += bytes.size();
}

Digest Sha256::digest() {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> text;
  return {bytes_, SHA256End(&state_, text.data())};
}

Digest digest_of(std::string_view text) {
  Sha256 sum;
  sum.add(text);
  return sum.digest();
}

}  // namespace fathom::digest
