// SPDX-License-Identifier: GPL-3.0-or-later
// How large bodies are: the lengths of their boxes along x, y and z. A millimetre that was taken for a metre shows there.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "cli/output/json.hpp"
#include "fathom/files.hpp"

namespace fathom::cli {

/// The lengths of a body's box along x, y and z, rounded to the nearest binary64, infinity included; of bodies with discs or balls, upper
/// bounds that are off by a few units in the last place at most. nullopt of a half-space.
std::optional<std::array<double, 3>> extent(const Body& body);

/// The extents of the bodies of a case.
struct BodySizes {
  std::optional<std::array<double, 3>> a, b;
  bool one_body = false;  ///< A alone
};
BodySizes sizes_of(const Case& input, bool one_body);

/// "A 2 x 2 x 2, B 1 x 1 x 1".
std::string sizes_text(const BodySizes& sizes);

/// {"a": [2, 2, 2], "b": null}: null for what is not finite.
Json sizes_object(const BodySizes& sizes);

/// A sentence if one body is more than 100 times as large as the other.
std::optional<std::string> sizes_note(const BodySizes& sizes);

}  // namespace fathom::cli
