// SPDX-License-Identifier: GPL-3.0-or-later
// The sphere with both diagrams, seen from outside.
#pragma once

#include <optional>
#include <string>

#include "view/stages/stages.hpp"

namespace fathom::atlas {

inline constexpr double sphere_height = 452;

struct SpherePanel {
  std::string content;  ///< elements, with the left upper corner at the origin
  std::string caption;  ///< as plain text
};

/// Seen from near the optimum, which is in the front.
SpherePanel sphere_panel(const stages::Stages& stages, std::optional<stages::Index> pair);

}  // namespace fathom::atlas
