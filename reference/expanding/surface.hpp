// SPDX-License-Identifier: GPL-3.0-or-later
// A convex polytope that grows point by point: its surface as triangles, none degenerate, neighbours coplanar or convex. Exact; integers
// are used only where binary64 with an error bound leaves a sign open.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "kernels/filters/rounded_plane.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/differences.hpp"

namespace fathom::expanding {

/// A vertex of the surface: the difference b - a of two input points.
struct SurfaceVertex {
  polytope::Difference from;  ///< indices of a and of b
  Vector exact;               ///< b - a
  Vec3<double> rounded;       ///< its image
};

/// The plane <normal, x> = height; the normal points outwards and is not reduced.
struct ExactPlane {
  Vector normal;
  mpz_class height;
};

/// One triangle, counter-clockwise seen from outside; across[k] lies on the other side of the edge from corner k to corner k + 1.
struct Triangle {
  std::array<std::uint32_t, 3> corners;
  std::array<std::uint32_t, 3> across;
  kernels::RoundedPlane rounded;
  bool alive = true;  ///< still part of the surface
  std::unique_ptr<ExactPlane> exact;
};

class Surface {
 public:
  /// The tetrahedron of four differences that do not lie in one plane. `exponent`: that of the clouds. Throws std::logic_error if they do.
  Surface(std::array<SurfaceVertex, 4> corners, long exponent);

  /// Adds a point that lies strictly above triangle `seen`, and returns the new triangles. Then the surface is that of the convex hull.
  /// Throws std::logic_error if the point does not lie above it.
  std::vector<std::uint32_t> insert(SurfaceVertex vertex, std::uint32_t seen);

  [[nodiscard]] std::size_t size() const { return triangles_.size(); }  ///< counts also the triangles that are no longer alive
  [[nodiscard]] const Triangle& triangle(std::uint32_t t) const { return triangles_[t]; }
  [[nodiscard]] const std::vector<SurfaceVertex>& vertices() const { return vertices_; }
  [[nodiscard]] std::size_t alive() const { return alive_; }

  /// The plane of a triangle; computed on first use.
  const ExactPlane& plane(std::uint32_t t);
  /// The sign of the height of a point above the plane of triangle t.
  int side(std::uint32_t t, const SurfaceVertex& vertex);

 private:
  struct HorizonEdge {
    std::uint32_t from, to;
    std::uint32_t beyond;  // the triangle that stays, and
    int side;              // which of its edges this is
  };

  std::uint32_t add(const std::array<std::uint32_t, 3>& corners);
  void remove(std::uint32_t t);
  std::vector<HorizonEdge> take_out_visible(const SurfaceVertex& vertex, std::uint32_t seen);

  long exponent_;
  std::vector<SurfaceVertex> vertices_;
  std::vector<Triangle> triangles_;
  std::size_t alive_ = 0;
  std::vector<std::uint32_t> fan_;  // of each vertex on the horizon: the new triangle whose edge on the horizon begins there
};

}  // namespace fathom::expanding
