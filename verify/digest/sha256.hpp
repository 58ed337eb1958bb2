// SPDX-License-Identifier: GPL-3.0-or-later
// SHA-256 of a stream of bytes.                                                   [FIPS 180-4]
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace fathom::digest {

/// How many bytes there were, and their SHA-256 in 64 lower-case hexadecimal digits.
struct Digest {
  std::uint64_t bytes = 0;
  std::string sha256;
  friend bool operator==(const Digest&, const Digest&) = default;
};

class Sha256 {
 public:
  void add(std::string_view bytes);
  /// Returns the digest of all bytes so far. Call it once.
  Digest digest();

 private:
  void take_block(const char* bytes);

  /// The first 32 bits of the fractional parts of the square roots of the first 8 primes.
  std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::string rest_;  // bytes of a block that is not full
  std::uint64_t bytes_ = 0;
};

/// Returns the digest of a text.
Digest digest_of(std::string_view text);

}  // namespace fathom::digest
