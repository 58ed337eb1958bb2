// SPDX-License-Identifier: GPL-3.0-or-later
// Policies as texts. (The texts of verdicts and classes are in fathom/judge.hpp.)
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "fathom/judge.hpp"

namespace fathom::judging {

inline constexpr Policy::Kind policy_kinds[] = {Policy::Kind::declared, Policy::Kind::minimum, Policy::Kind::separating,
                                                Policy::Kind::within};

/// Returns "declared", "minimum", "separating", "within=5%", "within=5/2%".
std::string policy_text(const Policy& policy);
/// Returns the policy of such a text; the percentage may also be a decimal. Returns nullopt for
/// other texts, and for a percentage below 0.
std::optional<Policy> policy_of(std::string_view text);

}  // namespace fathom::judging
