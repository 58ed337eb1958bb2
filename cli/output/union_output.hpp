// SPDX-License-Identifier: GPL-3.0-or-later
// The depth of unions, for people and for programs (JSON, schemas/union.schema.json).
#pragma once

#include <string>

#include "cli/args/request.hpp"
#include "fathom/union.hpp"

namespace fathom::cli {

/// Several lines, without the last newline.
std::string union_text(const UnionDepth& depth, const Request& request);
/// One line, pure ASCII. With the certificate, if it is not empty.
std::string union_json(const std::string& id, const UnionDepth& depth, const std::string& certificate);

}  // namespace fathom::cli
