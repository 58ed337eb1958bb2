// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies as the JSON of cases, with every number exact for every reader.                                  [schemas/case.schema.json]
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>

#include "fathom/body.hpp"
#include "reference/files/named_body.hpp"
#include "reference/files/pose.hpp"

namespace fathom::files {

/// A JSON number if it is a binary64 number, in the shortest text that reads back as it; else a string: an integer or p/q.
std::string number_json(const mpq_class& value);

/// A string. Pure ASCII, whatever the text.
std::string text_json(const std::string& text);

/// The items as an array, each as `text` writes it.
template <class List, class Text>
std::string array_json(const List& list, Text text) {
  std::string result = "[";
  for (const auto& item : list) {
    if (result.size() > 1) result += ',';
    result += text(item);
  }
  return result + ']';
}

/// What need not be said of a shape: that its axis is z, and that it is not moved.
enum class Defaults { left_out, written };

/// A body by its words if it has some, else by its vertices, which are placed if there is a pose. Throws std::invalid_argument for a shape
/// that is no polytope and has no words.
std::string body_json(const Body& body, const std::optional<Pose>& pose = std::nullopt);
/// By its vertices, with the pose as it was given: a matrix, or a quaternion and a translation.
std::string body_json(const Body& body, const GivenPose& pose);
std::string body_json(const NamedBody& body, Defaults defaults = Defaults::left_out);

}  // namespace fathom::files
