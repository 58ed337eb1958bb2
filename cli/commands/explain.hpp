// SPDX-License-Identifier: GPL-3.0-or-later
// The page about two bodies that `explain`, and `study --html`, write.
#pragma once

#include <string>

#include "cli/commands/depth.hpp"
#include "view/stages/stages.hpp"

namespace fathom::cli {

/// The options of the page.
struct ExplainRequest {
  explicit ExplainRequest(const Given& given) : depth(given) { depth.form.patch = true; }

  DepthRequest depth;            ///< the page includes the output of `fathom depth --patch --json`
  stages::StageOptions options;  ///< of its stages; the monitor is set by the call
  std::string opens;             ///< the section shown first, or "": the top
};

/// Returns the page; its form is described in view/page/page.hpp. Throws InputError as answered_by
/// does, Interrupted if the monitor stops it.
std::string explained_page(const AskedCase& asked, const ExplainRequest& request, Monitor& monitor);

}  // namespace fathom::cli
