// SPDX-License-Identifier: GPL-3.0-or-later
// Cases as text: one line of schema fathom/case/1, with every coordinate exact for every reader.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fathom::cli {

/// A case to be written: its bodies as JSON, and other fields. Empty fields are left out.
struct CaseText {
  std::string id, a, b;
  std::vector<std::string> flags;
  std::vector<std::pair<std::string, std::string>> source;  ///< keys and texts
  std::string comment;
  bool pose_rounding = false;  ///< whether readers round the placed points once to binary64
};

/// Returns one line, without its newline. Pure ASCII. files::body_json writes bodies.
std::string case_json(const CaseText& text);

}  // namespace fathom::cli
