// SPDX-License-Identifier: GPL-3.0-or-later
// A record as exports tell it: everything a test of a program in doubles needs, and nothing that is not a double but the exact square.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom::golden {

struct ExportCase {
  std::string name, group;  ///< the record's id; the family, "catalogue" or "real"; of one's own cases "own"
  std::string status;
  double signed_depth = 0;  ///< correctly rounded to nearest: the depth, 0, or minus the distance
  std::string squared;      ///< its square, exact
  std::vector<std::string> flags;
  std::vector<std::string> formats;   ///< that hold the points: binary64, or both that and binary32
  std::vector<std::string> contacts;  ///< the kinds of all optima's contacts, each once; none unless penetrating
  double size = 0;                    ///< the longest side of the bodies' boxes, correctly rounded
  double largest = 0;                 ///< the largest magnitude of a coordinate
  std::vector<std::array<double, 3>> a, b;
  std::vector<std::array<double, 3>> directions;  ///< unit vectors, rounded: of all optima, or the one direction of the record
};

/// Returns what exports tell of a record of polytopes. Returns nullopt if a coordinate is not binary64, or a number that exports write is
/// beyond binary64. Throws NotARecord, also if a text holds what the writer of records never writes.
std::optional<ExportCase> export_case(std::string_view line);

}  // namespace fathom::golden
