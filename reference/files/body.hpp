// SPDX-License-Identifier: GPL-3.0-or-later
// What every reader yields: bodies as exact points, and the one error that bad input raises.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "kernels/vector.hpp"

namespace fathom {

/// A finite, non-empty point set; it stands for its convex hull.
struct Body {
  std::vector<Point> points;
};

/// Two bodies to be judged against each other.
struct Case {
  std::string id;
  Body a, b;
};

/// Malformed, missing or unreadable input. what() is one complete sentence for the user:
/// "cube.off:12: expected a vertex index below 8, found '9'".
class InputError : public std::runtime_error {
 public:
  InputError(std::string file, std::size_t line, const std::string& message);  ///< line 0: no line
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] std::size_t line() const { return line_; }

 private:
  std::string file_;
  std::size_t line_;
};

}  // namespace fathom
