// SPDX-License-Identifier: GPL-3.0-or-later
// The text of the exception that FCL throws when its signed distance fails ("Error with
// configuration"): two shapes and their poses.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/files.hpp"
#include "reference/files/pose.hpp"

namespace fathom::files {

/// A shape in its own frame, and where it stands.
struct FclShape {
  Body body;
  Pose pose;
};

/// One failure.
struct FclFailure {
  std::size_t line = 0;  ///< where "Shape 1" stands
  FclShape first, second;
  std::string message;  ///< FCL's own, on one line; may be empty
};

/// Returns every failure in a log, in order. Skips lines of other programs between them, and what
/// stands before "Shape 1:" on a line. Reads both spellings: that of FCL 0.6 and 0.7 ("Shape 1:
/// Box0.5 0.5 0.5", matrices in columns) and the later one ("Box<double>(0.5, 0.5, 0.5);", matrices
/// with commas). Boxes and Convex with their points are bodies; decimals mean the nearest binary64.
/// Throws InputError with file, line and what was expected: another shape (a sphere is not a
/// polytope), a Convex printed without its points, a bad number, a last row that is not 0 0 0 1, or
/// no failure in the text at all.
std::vector<FclFailure> read_fcl_text(std::string_view text, const std::string& name);

}  // namespace fathom::files
