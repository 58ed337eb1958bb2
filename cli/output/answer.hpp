// SPDX-License-Identifier: GPL-3.0-or-later
// The exact answer to a case, before it is printed as text or as JSON.
#pragma once

#include <string>
#include <string_view>

#include "cli/output/about_bodies.hpp"
#include "fathom/depth.hpp"

namespace fathom::cli {

struct Answer {
  std::string id;
  Depth depth;                   ///< for `width`: of the body against itself
  std::string certificate = {};  ///< as text, if one is requested
  AboutBodies bodies = {};
};

/// The word for the method that answered.
inline std::string_view method_name(const Depth& depth) { return depth.method ? name(*depth.method) : "shallow"; }

}  // namespace fathom::cli
