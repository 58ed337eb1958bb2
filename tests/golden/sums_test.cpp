// SPDX-License-Identifier: GPL-3.0-or-later
// Law: a page of sums is read only in the one form in which it is written.
#include "verify/golden/release/sums.hpp"

#include <gtest/gtest.h>

#include "verify/golden/io/sha256.hpp"

namespace fathom::golden {
namespace {

TEST(Sums, KnownDigests) {  // [FIPS 180-4, examples]
  EXPECT_EQ(digest_of("").sha256, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(digest_of("abc"), (Digest{3, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"}));
  Sha256 pieces;
  for (int i = 0; i < 1'000'000; ++i) pieces.add("a");
  EXPECT_EQ(pieces.digest(), (Digest{1'000'000, "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"}));
}

TEST(Sums, OneForm) {
  const std::vector<Sum> sums = {{"a.json", digest_of("a").sha256}, {"b.zst", digest_of("b").sha256}};
  const std::string text = sums_text({sums[1], sums[0]});
  EXPECT_EQ(text, sums[0].sha256 + "  a.json\n" + sums[1].sha256 + "  b.zst\n");
  ASSERT_TRUE(parse_sums(text));
  EXPECT_EQ(*parse_sums(text), sums);
  const std::string line = sums[0].sha256 + "  ";
  for (const std::string& wrong :
       {text.substr(1), text.substr(0, text.size() - 1), text + '\n', text + text, sums[1].sha256 + "  b.zst\n" + line + "a.json\n",
        line + "\n", line + ".hidden\n", line + "../up\n", line + "a b\n", line + "a\r\n", sums[0].sha256 + " *a\n",
        std::string(64, 'A') + "  a\n", std::string(64, 'g') + "  a\n", std::string("short  a\n"), "\n" + text})
    EXPECT_FALSE(parse_sums(wrong)) << wrong;
}

}  // namespace
}  // namespace fathom::golden
