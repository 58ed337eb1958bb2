// SPDX-License-Identifier: GPL-3.0-or-later
// Answers as pictures: SVG, with the numbers of the text below.                                         [docs/command_line.md]
#pragma once

#include <string>

#include "cli/args/request.hpp"
#include "cli/output/answer.hpp"
#include "cli/output/shape_output.hpp"
#include "fathom/files.hpp"

namespace fathom::cli {

/// The picture of a case and its answer, as an SVG file.
std::string picture_text(const Case& bodies, const Answer& answer, const Request& request);
std::string picture_text(const Case& bodies, const ShapeAnswer& answer, const Request& request);

}  // namespace fathom::cli
