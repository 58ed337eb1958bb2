// SPDX-License-Identifier: GPL-3.0-or-later
// The words for the values of an answer, the same in every format.
#pragma once

#include <optional>
#include <string_view>

#include "reference/depth/depth.hpp"

namespace fathom {

/// "penetrating", "touching", "disjoint".
std::string_view name(Status status);
/// "facet-vertex": A's feature first.
std::string_view name(ContactKind kind);
std::string_view name(Method method);

/// The inverse of `name`.
std::optional<Status> status_named(std::string_view text);

}  // namespace fathom
