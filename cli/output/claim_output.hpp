// SPDX-License-Identifier: GPL-3.0-or-later
// What was found of a published claim, as text and as JSON.
#pragma once

#include <string>

#include "verify/claims/claims.hpp"

namespace fathom::cli {

/// One line, and one more for each statement; without the last newline.
std::string claim_text(const claims::PublishedClaim& claim, const claims::JudgedClaim& judged);

/// One line of the schema fathom/claim/1, without its newline.
std::string claim_json(const claims::PublishedClaim& claim, const claims::JudgedClaim& judged);

}  // namespace fathom::cli
