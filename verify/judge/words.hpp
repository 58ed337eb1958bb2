// SPDX-License-Identifier: GPL-3.0-or-later
// Policies in words. (Those for verdicts and classes are in fathom/judge.hpp.)
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "fathom/judge.hpp"

namespace fathom::judging {

inline constexpr Policy::Kind policy_kinds[] = {Policy::Kind::declared, Policy::Kind::minimum, Policy::Kind::separating,
                                                Policy::Kind::within};

/// "declared", "minimum", "separating", "within=5%", "within=5/2%".
std::string policy_text(const Policy& policy);
/// The inverse of `policy_text`; the percentage may be a decimal too. nullopt for other words, and
/// for what is below 0.
std::optional<Policy> policy_of(std::string_view text);

}  // namespace fathom::judging
