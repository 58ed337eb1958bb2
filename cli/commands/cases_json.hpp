// SPDX-License-Identifier: GPL-3.0-or-later
// Cases as text: one line of schema fathom/case/1, with every coordinate exact for every reader.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "reference/files/pose.hpp"
#include "verify/families/named_body.hpp"

namespace fathom::cli {

/// A body as a JSON object: polytopes by their vertices, which are placed if there is a pose.
std::string body_json(const Body& polytope, const std::optional<files::Pose>& pose = std::nullopt);
std::string body_json(const families::NamedBody& body);

/// A case to be written: its bodies as JSON, and other fields. Empty fields are left out.
struct CaseText {
  std::string id, a, b;
  std::vector<std::string> flags;
  std::vector<std::pair<std::string, std::string>> source;  ///< keys and texts
  std::string comment;
  bool pose_rounding = false;  ///< whether readers round the placed points once to binary64
};

/// Returns one line, without its newline. A coordinate is a JSON number if it is a binary64 number, in the shortest text that reads back as
/// it; else a string: an integer or p/q. Pure ASCII.
std::string case_json(const CaseText& text);

}  // namespace fathom::cli
