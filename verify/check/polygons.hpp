// SPDX-License-Identifier: Apache-2.0
// Flat and convex polygons by the numbers of their corners, and the polytopes whose facets they
// are: what the pieces of solids and the polytopes of two bodies have in common.
//                                                           [FORMAT.md, section 14, checks 2 to 5]
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "certificate.hpp"
#include "scaled.hpp"
#include "vectors.hpp"

namespace fathom_check {

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
