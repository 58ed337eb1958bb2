// SPDX-License-Identifier: GPL-3.0-or-later
// Records as CSV with hex floats, for programs that read neither JSON nor rationals.
#pragma once

#include <string>

#include "verify/golden/records/record_facts.hpp"

namespace fathom::golden {

/// The names of the columns, with a line feed. NOTES.md explains them.
std::string csv_header();

/// One record, with a line feed; empty unless all of its points are binary64.
std::string csv_row(const Facts& facts);

}  // namespace fathom::golden
