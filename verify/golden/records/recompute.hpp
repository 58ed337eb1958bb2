// SPDX-License-Identifier: GPL-3.0-or-later
// Compares a record with what one method says of its points: a way to the same line that takes nothing from certificate and answer.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "fathom/depth.hpp"

namespace fathom::golden {

/// Computes the answer about the record's points by `method` alone, and from it every field of the record, except which certificate goes
/// with it; of shapes and unions what shape_recompute.hpp and union_recompute.hpp say. Returns nullopt if the line is the same, else one
/// sentence on the first difference. Throws Interrupted, and nothing on bad input.                                     [proofs/golden.md]
std::optional<std::string> disagreement_with(Method method, std::string_view line, Monitor* monitor = nullptr);

}  // namespace fathom::golden
