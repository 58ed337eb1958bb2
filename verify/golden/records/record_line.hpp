// SPDX-License-Identifier: GPL-3.0-or-later
// A record as a line of JSON. Serialization is canonical: equal facts give equal bytes.
#pragma once

#include <string>

#include "verify/golden/records/record_facts.hpp"

namespace fathom::golden {

/// Returns the record's line, without a line feed.
std::string line_of(const Facts& facts);

}  // namespace fathom::golden
