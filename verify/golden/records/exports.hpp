// SPDX-License-Identifier: GPL-3.0-or-later
// Records in other forms, for programs that read neither JSON nor rationals: CSV and a C++ include file, both with hex floats.
#pragma once

#include <string>

#include "verify/golden/records/record_facts.hpp"

namespace fathom::golden {

/// The names of the columns, with a line feed. NOTES.md explains them.
std::string csv_header();

/// The part of the C++ include file before the first entry, and after the last one.
std::string include_head();
std::string include_tail();

/// One record in the two files, each with a line feed; both empty unless all of its points are binary64.
struct Exports {
  std::string csv_row, include_entry;
};

Exports exports_of(const Facts& facts);

}  // namespace fathom::golden
