// SPDX-License-Identifier: GPL-3.0-or-later
// Points as a file is read: in binary64 for as long as every coordinate is.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/body.hpp"

namespace fathom::files {

/// A number of a file: in binary64 if it is one of its numbers and was seen to be.
using Coordinate = std::variant<double, mpq_class>;

/// The exact value.
mpq_class exact(Coordinate coordinate);

class CollectedPoints {
 public:
  [[nodiscard]] std::size_t size() const { return in_binary64_ ? binary64_.size() : exact_.size(); }
  [[nodiscard]] bool empty() const { return size() == 0; }
  void reserve(std::size_t count) { binary64_.reserve(count); }
  void add(std::array<Coordinate, 3> point);
  GivenPoints take() { return in_binary64_ ? GivenPoints(std::move(binary64_)) : GivenPoints(std::move(exact_)); }

 private:
  bool in_binary64_ = true;  // all points so far
  std::vector<std::array<double, 3>> binary64_;
  std::vector<Point> exact_;
};

}  // namespace fathom::files
