// SPDX-License-Identifier: GPL-3.0-or-later
// Cases and their bodies as JSON, with every number exact for every reader.
//                                                                        [case.schema.json]
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "reference/files/pose.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/text/json.hpp"

namespace fathom::files {

/// The name of the schema of a case, as each case may say it.
inline constexpr std::string_view case_schema = "fathom/case/1";

/// Whether fields with their default values (axis z, identity pose) are written.
enum class Defaults { left_out, written };

/// A body by its words if it has some, else by its vertices, which are placed if there is a pose.
/// Throws std::invalid_argument for a shape that is no polytope and has no words.
text::Json body_json(const Body& body, const std::optional<Pose>& pose = std::nullopt);
/// By its vertices, with the pose as it was given: a matrix, or a quaternion and a translation.
text::Json body_json(const Body& body, const GivenPose& pose);
text::Json body_json(const NamedBody& body, Defaults defaults = Defaults::left_out);
text::Json motion_json(const Motion& motion);

/// A case to be written. Empty fields are left out.
struct CaseText {
  std::string id;
  text::Json a, b;
  std::vector<std::pair<std::string, std::string>> source;  ///< keys, which need no escapes, and texts
  std::string comment;
  bool pose_rounding = false;  ///< whether readers round the placed points once to binary64
  std::optional<Motion> motion = {};
  bool plane = false;  ///< the bodies are of the plane
};

/// One line of pure ASCII, without its newline.
std::string case_json(const CaseText& text);
std::string case_json(const Case& pair, const std::string& comment = "");

}  // namespace fathom::files
