// SPDX-License-Identifier: GPL-3.0-or-later
// A proof that no checker would read is none: whoever asked for it is told, and nothing is written. [verify/check/FORMAT.md, section 8]
#pragma once

#include <string>
#include <string_view>

#include "verify/check/limits.hpp"

namespace fathom::cli {

/// Throws OutputError, which names the limit and what helps, if the certificate of this case passes a limit of all checkers.
void require_readable(const std::string& id, std::string_view certificate, const fathom_check::Limits& limits = {});

}  // namespace fathom::cli
