// SPDX-License-Identifier: GPL-3.0-or-later
// A second way to records of shapes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "fathom/depth.hpp"
#include "verify/golden/records/record_reader.hpp"

namespace fathom::golden {

/// Where cores are polytopes, or one is a half-space and the other a polytope: the line as it is when `method` answers about the cores.
/// Curved bodies no other method can answer: they are turned, exchanged and enclosed anew, so that the search takes another way from
/// another start, and nullopt is returned if both enclosures overlap. Throws NotProved if they do not, and if there are no such shapes;
/// NotARecord, Interrupted.
std::optional<std::string> shape_line_by(Method method, std::string_view line, const Claimed& claimed, Monitor* monitor = nullptr);

}  // namespace fathom::golden
