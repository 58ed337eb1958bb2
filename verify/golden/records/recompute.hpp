// SPDX-License-Identifier: GPL-3.0-or-later
// Compares a record with what is found of its bodies in another way: one that takes nothing from certificate and answer.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "fathom/depth.hpp"

namespace fathom::golden {

/// Computes the answer about the record's bodies anew, and from it every field of the record, except which certificate goes with it.
/// Returns nullopt if the line is the same, else one sentence on the first difference. Throws Interrupted, and nothing on bad input.
///
/// Polytopes `method` answers alone. Shapes whose cores are polytopes, or one a half-space and the other a polytope, are turned and
/// exchanged, and `method` answers about the cores. Other shapes no other method can answer: turned, exchanged and enclosed anew the search
/// takes another way from another start, and both enclosures must overlap. Unions are turned and exchanged too; which pieces are nearest,
/// where several pairs may be, the line says, and `method` answers about these two.                                   [proofs/golden.md]
std::optional<std::string> disagreement_with(Method method, std::string_view line, Monitor* monitor = nullptr);

}  // namespace fathom::golden
