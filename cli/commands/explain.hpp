// SPDX-License-Identifier: GPL-3.0-or-later
// The page about two bodies, which `explain` writes, and `study --html` too.
#pragma once

#include <string>

#include "cli/commands/depth.hpp"
#include "view/stages/stages.hpp"

namespace fathom::cli {

/// What the page is made from.
struct ExplainRequest {
  explicit ExplainRequest(const Given& given) : depth(given) { depth.form.patch = true; }

  DepthRequest depth;            ///< the page has what `fathom depth --patch --json` prints
  stages::StageOptions options;  ///< of its stages; the monitor is that of the call
  std::string opens;             ///< the section that is seen first, or "": the top
};

/// Returns the page: view/page/page.hpp. Throws InputError as answered_by does, Interrupted if the
/// monitor stops it.
std::string explained_page(const AskedCase& asked, const ExplainRequest& request, Monitor& monitor);

}  // namespace fathom::cli
