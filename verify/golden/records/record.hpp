// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a recipe.
// Output  one to three records: the base case as it is, and as programs see it that round its numbers to binary64 or to binary32.
//         Each is one line of JSON with the truth about exactly the bodies in it, and the certificate that proves it.
#pragma once

#include <string>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/monitor.hpp"
#include "verify/golden/records/recipe.hpp"

namespace fathom::golden {

struct Record {
  std::string id;
  std::string line;                               ///< schemas/golden.schema.json, also a case of schema fathom/case/1; without a line feed
  std::string certificate;                        ///< verify/check/FORMAT.md, with its last line feed; accepted by the checker
  std::string csv_row;                            ///< with its line feed; empty unless of polytopes in binary64
  bool in_binary64 = false, in_binary32 = false;  ///< whether every number is one of that format
};

/// Returns the records of a recipe, one for each of cases_of(recipe). Throws std::logic_error if the certificate is not accepted or proves
/// anything else than the record says, and Interrupted.
std::vector<Record> records_of(const Recipe& recipe, Monitor* monitor = nullptr, Workspace* workspace = nullptr);

/// Returns the record of the base case in one form.
Record record_of(const Recipe& recipe, FormedCase made, Monitor* monitor = nullptr, Workspace* workspace = nullptr);

}  // namespace fathom::golden
