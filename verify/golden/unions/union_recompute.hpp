// SPDX-License-Identifier: GPL-3.0-or-later
// A second way to records of unions.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "fathom/depth.hpp"
#include "verify/golden/records/record_reader.hpp"

namespace fathom::golden {

/// Returns the line as it is when the unions are turned, exchanged and answered anew, so that the search takes another way through other
/// numbers; status, depth, distance and all translations are turned back from there. Of disjoint ones the line says which pieces are
/// nearest, as several pairs may be: `method` answers about these two. There is no other method for unions. Throws NotProved if there are
/// no such unions; NotARecord, Interrupted.
std::string union_line_by(Method method, std::string_view line, const Claimed& claimed, Monitor* monitor = nullptr);

}  // namespace fathom::golden
