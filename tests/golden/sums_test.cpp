// SPDX-License-Identifier: GPL-3.0-or-later
// Law: a page of sums is read only in the one form in which it is written.
#include "verify/golden/release/sums.hpp"

#include <gtest/gtest.h>

#include "verify/digest/sha256.hpp"

namespace fathom::golden {
namespace {

TEST(Sums, OneForm) {
  const std::vector<Sum> sums = {{"a.json", digest::digest_of("a").sha256}, {"b.zst", digest::digest_of("b").sha256}};
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
