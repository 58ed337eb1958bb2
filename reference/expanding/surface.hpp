// SPDX-License-Identifier: GPL-3.0-or-later
// A convex polytope that grows point by point: its surface as triangles, none degenerate, neighbours coplanar or convex. Exact; integers
// are used only where binary64 with an error bound leaves a sign open.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "kernels/filters/rounded_plane.hpp"
#include "kernels/id.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/differences.hpp"

namespace fathom::expanding {

/// Indices in a surface.
using CornerId = kernels::Id<struct SurfaceVertex>;
using TriangleId = kernels::Id<struct Triangle>;

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

/// The corner of a triangle after corner k, counter-clockwise.
constexpr int next(int k) { return k == 2 ? 0 : k + 1; }

/// One triangle, counter-clockwise seen from outside; across[k] lies on the other side of the edge from corner k to corner k + 1.
struct Triangle {
  std::array<CornerId, 3> corners;
  std::array<TriangleId, 3> across;
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
  std::vector<TriangleId> insert(SurfaceVertex vertex, TriangleId seen);

  [[nodiscard]] const kernels::IdVector<TriangleId, Triangle>& triangles() const { return triangles_; }  ///< all that were ever alive
  [[nodiscard]] const kernels::IdVector<CornerId, SurfaceVertex>& vertices() const { return vertices_; }
  [[nodiscard]] std::size_t alive() const { return alive_; }

  /// The plane of a triangle; computed on first use.
  const ExactPlane& plane(TriangleId t);
  /// The sign of the height of a point above the plane of triangle t.
  int side(TriangleId t, const SurfaceVertex& vertex);

 private:
  struct HorizonEdge {
    CornerId from, to;
    TriangleId beyond;  // the triangle that stays, and
    int side;           // which of its edges this is
  };

  TriangleId add(const std::array<CornerId, 3>& corners);
  void remove(TriangleId t);
  std::vector<HorizonEdge> take_out_visible(const SurfaceVertex& vertex, TriangleId seen);

  long exponent_;
  kernels::IdVector<CornerId, SurfaceVertex> vertices_;
  kernels::IdVector<TriangleId, Triangle> triangles_;
  std::size_t alive_ = 0;
  kernels::IdVector<CornerId, TriangleId> fan_;  // of each vertex on the horizon: the new triangle whose edge on the horizon begins there
};

}  // namespace fathom::expanding
