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

#include "certificate.hpp"
#include "limits.hpp"
#include "scaled.hpp"
#include "vectors.hpp"

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

// Flat and convex polygons by the numbers of their corners, and the polytopes whose facets they
// are: what the pieces of solids and the polytopes of two bodies have in common.
//                                                           [FORMAT.md, section 14, checks 2 to 5]

/// A triangle of a mesh, or a facet of a polytope.
struct Polygon {
  const std::uint32_t* corners;
  std::size_t size, line;
  int sense;      ///< 1 in a mesh, -1 in a piece: what its flags count
  Vector normal;  ///< primitive, outward

  /// Cyclically: k is at most `size`.
  [[nodiscard]] std::uint32_t corner(std::size_t k) const { return corners[k == size ? 0 : k]; }
};

inline bool same_vector(const Vector& u, const Vector& v) { return u.x == v.x && u.y == v.y && u.z == v.z; }

/// Those that have been found right, among the same points.
class Polygons {
 public:
  explicit Polygons(std::vector<Homogeneous> points) : points_(std::move(points)) {}

  [[nodiscard]] const std::vector<Homogeneous>& points() const { return points_; }
  [[nodiscard]] std::vector<Polygon>& all() { return all_; }

  /// Throws Fault (refused) unless these are numbers of points.
  void require_points(const std::uint32_t* corners, std::size_t size, std::size_t line) const;

  /// Whether the triangle of the first three corners has an area.
  bool has_area(const std::uint32_t* corners) { return find_fan_normal(corners, 1); }

  /// Adds one whose normal is yet to be found. Throws Fault (refused) unless it is flat and convex.
  void take(Polygon polygon);

  /// Adds the facets of these numbers, which are those of a polytope, one for each of its faces.
  /// Throws Fault (refused) otherwise.
  void take_polytope(const Part<Facets>& facets, std::size_t first, std::size_t last, std::size_t line);

  /// Finds a vector, divided by its greatest divisor, that is a positive multiple of point v minus
  /// point u. They must not be the same.
  void find_direction(MutableVector& direction, std::uint32_t u, std::uint32_t v);

 private:
  void find_edge(MutableVector& edge, std::uint32_t u, std::uint32_t v) const;
  bool find_fan_normal(const std::uint32_t* corners, std::size_t k);
  void make_primitive(MutableVector& v);
  void check_support(const Polygon& facet, const std::vector<std::uint32_t>& corners);
  void check_edges(std::size_t first) const;

  std::vector<Homogeneous> points_;
  std::vector<Polygon> all_;
  Arena integers_;  ///< of their normals
  MutableVector first_edge_, second_edge_, normal_;
  mpz_class divisor_, height_, level_, scratch_;
};

}  // namespace fathom_check
