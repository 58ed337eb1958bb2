// SPDX-License-Identifier: GPL-3.0-or-later
// What the hull of a body hides of it.
// Input   the points of a body, and the faces of its mesh if it has some: equal points, faces that
//         turn inside out, holes and slivers welcome.
// Output  how many points are not extreme; whether some face goes through the inside of the points'
//         hull, and how much the hull adds.
// Time    that of a hull; of convex bodies less: n log n double operations if all points are seen
//         to be extreme, linear but for hashing and sorting if the mesh is the boundary.
//                                                                              [proofs/polytope.md]
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fathom/body.hpp"
#include "kernels/vector.hpp"

namespace fathom::polytope {

/// Counts the points that are not vertices of the hull, nor equal to one. Exact. Returns nullopt if
/// a hull is needed, but the points' denominators share little (place_if_slim). The body must not
/// be empty.
std::optional<std::size_t> count_inner_points(std::span<const Point> body);

/// A point and how deep inside a hull it is.
struct DeepestPoint {
  std::uint32_t point = 0;
  mpq_class squared_depth;  ///< 0: on the hull's boundary
};

/// A mesh whose hull is another body.
struct Dents {
  /// the hull's volume over what the mesh encloses, if it is closed and that is less; > 1. What the
  /// surface goes around twice counts twice, and what it goes around the other way is taken off.
  std::optional<mpq_class> volume_ratio;
  /// the point deepest inside the hull, of several the first; nullopt if it takes too long to find
  std::optional<DeepestPoint> deepest;
};

/// What is known of a mesh.
struct MeshConvexity {
  bool tried = false;          ///< false: it has no faces, or its points' denominators share little (place_if_slim)
  std::optional<Dents> dents;  ///< set if it is not convex
  bool open = false;           ///< an edge has an odd number of faces, and the points do not lie in a plane
};

/// Compares the mesh with the hull of its points, exactly. A face belongs to the hull's boundary if
/// it lies in a facet's plane; a face without area belongs to it, and so does any face if all
/// points lie in a plane. The mesh is closed if along each edge as many faces go one way as the
/// other, whatever corners cut it into pieces. The search for the deepest point compares points
/// with facets, and gives up after so many comparisons. Throws std::invalid_argument if there is no
/// point.
MeshConvexity mesh_convexity(std::span<const Point> points, const MeshFaces& faces,
                             std::size_t most_comparisons = 1'000'000);

using MeshTriangle = std::array<std::uint32_t, 3>;

/// What the sides of triangles add up to: nothing, if along each edge as many go one way as the
/// other; an even number of them, as those of a cube with a face turned over; or else.
enum class Seam { closed, even, open };

/// The faces as triangles, those with two equal corners left out; of equal points the one named
/// `canonical` stands for all.
std::vector<MeshTriangle> triangles_of(const MeshFaces& faces, std::span<const std::uint32_t> canonical);

/// Exact where corners of some triangles lie on sides of others, too: no point is compared with an
/// edge. The points differ.                                                    [proofs/polytope.md]
Seam seam_of(std::span<const Vector> points, std::span<const MeshTriangle> triangles);

/// True only if the triangles are the boundary of a convex body with interior, all seen from one
/// side. Points that are no corners do not count. False says nothing.
bool is_convex_boundary(std::span<const Vector> points, std::span<const MeshTriangle> triangles);

}  // namespace fathom::polytope
