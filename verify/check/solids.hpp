// SPDX-License-Identifier: Apache-2.0
// The bodies of section 15, solids and unions alike: points over denominators of their own, and
// pieces with corners. Trees that show that a translation takes them apart.
//                                                                           [FORMAT.md, section 15]
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "budget.hpp"
#include "certificate.hpp"
#include "scaled.hpp"

namespace fathom_check {

class PiecedBody {
 public:
  explicit PiecedBody(const Body& body);

  [[nodiscard]] const std::vector<Homogeneous>& points() const { return points_; }
  [[nodiscard]] std::size_t pieces() const { return ends_.size(); }

  /// The corners of all pieces, one piece after another, by the numbers of their points; and where
  /// those of a piece begin. A piece of a solid has each point that its facets name once.
  [[nodiscard]] const std::vector<std::uint32_t>& corners() const { return corners_; }
  [[nodiscard]] std::size_t begin_of(std::size_t piece) const { return piece == 0 ? 0 : ends_[piece - 1]; }
  [[nodiscard]] std::size_t corners(std::size_t piece) const { return begin_of(piece + 1) - begin_of(piece); }

  /// The point that is corner `number` of a piece, which must exist. Returns nullopt if there is no
  /// such corner.
  [[nodiscard]] std::optional<std::uint32_t> corner(std::size_t piece, std::uint32_t number) const;

 private:
  std::vector<Homogeneous> points_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> ends_;
  bool is_union_;
};

/// Pieces from number `first` to `last`.
struct PieceRange {
  std::size_t first, last;
  [[nodiscard]] std::size_t size() const { return last - first; }
};

/// Calls `take` for each vector of an apart tree, with the number of its block, and the pieces of A
/// and of B that it is for. Returns what shows that the blocks are no tree, from the first block on
/// that does; nullopt if they are one.
std::optional<Fault> for_each_vector(
    const UnionParts& parts, std::size_t list, std::size_t pieces_a, std::size_t pieces_b,
    const std::function<void(std::size_t block, const PieceRange& of_a, const PieceRange& of_b)>& take);

}  // namespace fathom_check
