// SPDX-License-Identifier: Apache-2.0
// For who writes certificates: whether checkers will read one, before its proof is of interest.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "limits.hpp"

namespace fathom_check {

/// Why every checker finds the certificate malformed that `text` begins with: it does not follow
/// the grammar, or passes a limit, which the phrase names. Returns an empty text if it is
/// well-formed; nothing is said of its proof. Throws std::bad_alloc.
[[nodiscard]] std::string unreadable(std::string_view text, const Limits& limits = {});

/// A proof that no checker would read is none, and not to be handed out.
struct Unreadable : std::length_error {
  using std::length_error::length_error;
};

/// Throws Unreadable, which says why, unless `unreadable` is empty. Whoever gives certificates to
/// users asks here first.
void require_readable(std::string_view certificate, const Limits& limits = {});

}  // namespace fathom_check
