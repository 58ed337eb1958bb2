// SPDX-License-Identifier: GPL-3.0-or-later
// Two unions and a certificate: what is true of them, as far as the certificate proves it.
#pragma once

#include <string_view>

#include "verify/golden/unions/union_facts.hpp"

namespace fathom::golden {

/// Returns the truth that the certificate proves: status, depth, all translations, distance and nearest pieces are its own. Throws
/// NotProved unless the checker accepts it, it has the id of these unions and is about them, and agrees with what is known of the answer by
/// construction.                                                                                                     [proofs/golden.md]
UnionStatement proved_truth(const FormedUnions& bodies, std::string_view certificate);

}  // namespace fathom::golden
