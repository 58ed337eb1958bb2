// SPDX-License-Identifier: GPL-3.0-or-later
// The policy of pages names the texts that it allows by their digests, and nothing else.
#include <gtest/gtest.h>

#include <vector>

#include "view/picture/markup.hpp"

namespace fathom::picture {
namespace {

// The digest of the example in the Content Security Policy specification, section "Usage of
// hashes".
TEST(Policy, AllowsTextsByTheirDigest) {
  const std::vector<std::string_view> scripts{"alert('Hello, world.');"}, none;
  EXPECT_EQ(security_policy(scripts, none),
            "default-src 'none'; script-src 'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='; style-src 'none'; "
            "img-src data:; "
            "base-uri 'none'; form-action 'none'");
  EXPECT_EQ(security_policy(none, scripts),
            "default-src 'none'; script-src 'none'; style-src 'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='; "
            "img-src data:; "
            "base-uri 'none'; form-action 'none'");
}

TEST(Policy, IsAnElement) {
  EXPECT_EQ(policy_element({}, {}),
            "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'none'; style-src "
            "'none'; img-src data:; "
            "base-uri 'none'; form-action 'none'\"/>");
}

}  // namespace
}  // namespace fathom::picture
