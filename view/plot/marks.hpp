// SPDX-License-Identifier: GPL-3.0-or-later
// Markers and samples of series.
#pragma once

#include <cstddef>
#include <string>

namespace fathom::plot {

/// The marker of the series with this number; with a title if there is one.
std::string mark_element(std::size_t series, double x, double y, const std::string& what);

/// The classes of the line of the series with this number: colour and dash.
std::string line_classes(std::size_t series);

}  // namespace fathom::plot
