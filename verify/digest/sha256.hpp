// SPDX-License-Identifier: GPL-3.0-or-later
// SHA-256 of a stream of bytes, by libmd.                                         [FIPS 180-4]
#pragma once

#include <sha2.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace fathom::digest {

/// The number of bytes, and their SHA-256 in 64 lower-case hexadecimal digits.
struct Digest {
  std::uint64_t bytes = 0;
  std::string sha256;
  friend bool operator==(const Digest&, const Digest&) = default;
};

class Sha256 {
 public:
  Sha256();
  void add(std::string_view bytes);
  /// Returns the digest of all bytes so far. Call it once.
  Digest digest();

 private:
  SHA2_CTX state_;
  std::uint64_t bytes_ = 0;
};

/// Returns the digest of a text.
Digest digest_of(std::string_view text);

}  // namespace fathom::digest
