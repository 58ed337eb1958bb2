// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `fathom golden export`.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "verify/golden/export/export.hpp"

namespace fathom::cli {

/// Adds all but the folder or file. `certificates` is the file for those. Both must outlive the app.
void add_export_options(CLI::App& app, golden::ExportRequest& request, std::string& certificates);

}  // namespace fathom::cli
