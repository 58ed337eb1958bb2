// SPDX-License-Identifier: GPL-3.0-or-later
// Laws: the digests are those of the standard, in one piece or in many.
#include "verify/digest/sha256.hpp"

#include <gtest/gtest.h>

namespace fathom::digest {
namespace {

TEST(Sha256, KnownDigests) {  // [FIPS 180-4, examples]
  EXPECT_EQ(digest_of("").sha256, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(digest_of("abc"), (Digest{3, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"}));
  Sha256 pieces;
  for (int i = 0; i < 1'000'000; ++i) pieces.add("a");
  EXPECT_EQ(pieces.digest(), (Digest{1'000'000, "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"}));
}

}  // namespace
}  // namespace fathom::digest
