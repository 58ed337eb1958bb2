// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that are shapes, as the protocol writes them.                                                            [verify/PROTOCOL.md]
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "verify/subjects/subject.hpp"

namespace subject {

/// Reads a body with a field `shape`; of a name that is not known, nothing but the name. Throws where the fields are not those of the
/// shape.
Body read_shape(const nlohmann::json& from);

/// Throws Unsupported for a shape or a margin that the mode does not declare, and for a pose that is no rotation.
void check_taken(const Body& body, const Mode& mode);

}  // namespace subject
