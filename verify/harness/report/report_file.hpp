// SPDX-License-Identifier: GPL-3.0-or-later
// A report of schema fathom/verdict/1 as a whole, read back from a file.                    [schemas/verdict.schema.json;
// verify/PROTOCOL.md]
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "verify/harness/outcome.hpp"

namespace fathom::harness {

struct ReportFile {
  std::string path;
  std::map<std::string, std::string> header;  ///< every field but the command, by its path: "subject.settings.margin", "tolerance.relative"
  double unit_roundoff = 0;                   ///< of the subject's numbers
  std::vector<Outcome> outcomes;              ///< in the order of the file; of an id that stands in several lines, the last
  std::size_t repeated = 0;                   ///< lines whose id stands in a later line again
  std::size_t unattributed = 0;
  bool whole = false;  ///< it ends with a summary

  /// "libccd-epa 2.1-2, fathom 0.1.0".
  [[nodiscard]] std::string title() const;
};

/// Throws InputError, naming the line and what was expected, if the file cannot be read or is no report. A last line that was cut off by a
/// kill is passed over.
ReportFile read_report(const std::string& path);

}  // namespace fathom::harness
