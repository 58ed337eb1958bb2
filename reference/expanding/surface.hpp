// SPDX-License-Identifier: GPL-3.0-or-later
// A convex polytope that grows point by point: its surface as triangles, none degenerate, neighbours coplanar or convex. Exact; integers
// are used only where binary64 with an error bound leaves a sign open. Only triangles strictly below the new point are removed. So the
// point never lies on the line through an edge of the horizon, and new triangles are never degenerate; coplanar triangles stay side by
// side.                                                                                                     [proofs/expanding.md, lemma 1]
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "kernels/filters/rounded_plane.hpp"
#include "kernels/id.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::expanding {

/// Indices in a surface.
using CornerId = kernels::Id<struct CornerTag>;
using TriangleId = kernels::Id<struct TriangleTag>;

/// A vertex of the surface: the difference b - a of two input points.
template <class Integer>
struct SurfaceVertex {
  polytope::Difference from;  ///< indices of a and of b
  Vec3<Integer> exact;        ///< b - a
  Vec3<double> rounded;       ///< its image
};

/// The plane <normal, x> = height; the normal points outwards and is not reduced.
template <class Integer>
struct ExactPlane {
  Vec3<Integer> normal;
  Integer height;
};

/// The corner of a triangle after corner k, counter-clockwise.
constexpr int next(int k) { return k == 2 ? 0 : k + 1; }

/// One triangle, counter-clockwise seen from outside; across[k] lies on the other side of the edge from corner k to corner k + 1.
struct Triangle {
  std::array<CornerId, 3> corners;
  std::array<TriangleId, 3> across;
  kernels::RoundedPlane rounded;
  bool alive = true;  ///< still part of the surface
  PoolIndex plane;    ///< the exact one, once it has been asked for
};

/// How often sides were asked for, and how often binary64 could not tell.
struct SideCounts {
  std::uint64_t calls = 0, exact = 0;
};

/// `Integer` holds every number of this computation: mpz_class, or a FixedInteger that is wide enough. One object serves many polytopes,
/// one after another, and keeps its memory.
template <class Integer>
class Surface {
 public:
  using Vertex = SurfaceVertex<Integer>;

  /// Becomes the tetrahedron of four differences that do not lie in one plane. Throws std::logic_error if they do.
  void start(std::array<Vertex, 4> corners);

  /// Adds a point that lies strictly above triangle `seen`, and returns the new triangles, until the next call. Then the surface is that of
  /// the convex hull. Throws std::logic_error if the point does not lie above it.
  const std::vector<TriangleId>& insert(const Vertex& vertex, TriangleId seen);

  [[nodiscard]] const kernels::IdVector<TriangleId, Triangle>& triangles() const { return triangles_; }  ///< all that were ever alive
  [[nodiscard]] const kernels::IdVector<CornerId, Vertex>& vertices() const { return vertices_; }
  [[nodiscard]] std::size_t alive() const { return alive_; }
  [[nodiscard]] const SideCounts& sides() const { return sides_; }

  /// The plane of a triangle; computed on first use.
  const ExactPlane<Integer>& plane(TriangleId t);
  /// The sign of the height of a point above the plane of triangle t.
  int side(TriangleId t, const Vertex& vertex);

 private:
  struct HorizonEdge {
    CornerId from, to;
    TriangleId beyond;  // the triangle that stays, and
    int side;           // which of its edges this is
  };

  // Which edge of triangle t starts at `from`.
  [[nodiscard]] int edge_from(TriangleId t, CornerId from) const {
    for (int k = 0; k < 3; ++k)
      if (triangles_[t].corners[k] == from) return k;
    throw std::logic_error("the surface of the expanding polytope is torn");
  }
  TriangleId add(const std::array<CornerId, 3>& corners);
  void remove(TriangleId t);
  void find_horizon(const Vertex& vertex, TriangleId seen);

  kernels::IdVector<CornerId, Vertex> vertices_;
  kernels::IdVector<TriangleId, Triangle> triangles_;
  Pool<ExactPlane<Integer>> planes_;
  std::size_t alive_ = 0;
  SideCounts sides_;
  // Of the last insertion.
  std::vector<TriangleId> visible_, fresh_;
  std::vector<HorizonEdge> horizon_;
  kernels::IdVector<CornerId, TriangleId> fan_;  // of each vertex on the horizon: the new triangle whose edge on the horizon begins there
};

template <class Integer>
void Surface<Integer>::start(std::array<Vertex, 4> corners) {
  const Vec3<Integer>& p = corners[0].exact;
  const int turn = sgn(det(corners[1].exact - p, corners[2].exact - p, corners[3].exact - p));
  if (turn == 0) throw std::logic_error("the expanding polytope starts flat");
  if (turn > 0) std::swap(corners[1], corners[2]);  // so that corner 3 lies below the triangle 0 1 2
  vertices_.clear();
  triangles_.clear();
  planes_.clear();
  alive_ = 0;
  sides_ = {};
  for (const Vertex& corner : corners) vertices_.push_back(corner);
  const CornerId a(0), b(1), c(2), d(3);
  for (const std::array<CornerId, 3>& t : {std::array{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}}) add(t);
  for (const TriangleId t : triangles_.ids()) {
    for (int k = 0; k < 3; ++k) {
      for (const TriangleId other : triangles_.ids()) {
        for (int l = 0; l < 3; ++l) {
          const std::array<CornerId, 3>&mine = triangles_[t].corners, &theirs = triangles_[other].corners;
          if (mine[k] == theirs[next(l)] && mine[next(k)] == theirs[l]) triangles_[t].across[k] = other;
        }
      }
    }
  }
}

template <class Integer>
TriangleId Surface<Integer>::add(const std::array<CornerId, 3>& corners) {
  const TriangleId t(static_cast<std::uint32_t>(triangles_.size()));
  const kernels::RoundedPlane rounded(vertices_[corners[0]].rounded, vertices_[corners[1]].rounded, vertices_[corners[2]].rounded);
  triangles_.push_back({corners, {}, rounded, true, PoolIndex::none()});
  ++alive_;
  return t;
}

template <class Integer>
void Surface<Integer>::remove(TriangleId t) {
  Triangle& triangle = triangles_[t];
  triangle.alive = false;
  if (!triangle.plane.is_none()) planes_.give_back(std::exchange(triangle.plane, PoolIndex::none()));
  --alive_;
}

template <class Integer>
const ExactPlane<Integer>& Surface<Integer>::plane(TriangleId t) {
  Triangle& triangle = triangles_[t];
  if (triangle.plane.is_none()) {
    triangle.plane = planes_.take();
    ExactPlane<Integer>& exact = planes_[triangle.plane];
    const std::array<CornerId, 3>& c = triangle.corners;
    const Vec3<Integer>& p = vertices_[c[0]].exact;
    exact.normal = cross(vertices_[c[1]].exact - p, vertices_[c[2]].exact - p);
    exact.height = dot(exact.normal, p);
  }
  return planes_[triangle.plane];
}

template <class Integer>
int Surface<Integer>::side(TriangleId t, const Vertex& vertex) {
  ++sides_.calls;
  if (const auto sure = triangles_[t].rounded.side(vertex.rounded)) return kernels::to_int(*sure);
  ++sides_.exact;
  const ExactPlane<Integer>& p = plane(t);
  return sgn(Integer(dot(p.normal, vertex.exact) - p.height));
}

// Takes out all triangles below the vertex.
template <class Integer>
void Surface<Integer>::find_horizon(const Vertex& vertex, TriangleId seen) {
  visible_.assign(1, seen);
  remove(seen);
  horizon_.clear();
  for (std::size_t i = 0; i < visible_.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const Triangle& triangle = triangles_[visible_[i]];
      const CornerId from = triangle.corners[k], to = triangle.corners[next(k)];
      const TriangleId other = triangle.across[k];
      if (!triangles_[other].alive) continue;
      if (side(other, vertex) > 0) {
        remove(other);
        visible_.push_back(other);
      } else {
        horizon_.push_back({from, to, other, edge_from(other, to)});
      }
    }
  }
}

template <class Integer>
const std::vector<TriangleId>& Surface<Integer>::insert(const Vertex& vertex, TriangleId seen) {
  if (!triangles_[seen].alive || side(seen, vertex) <= 0) throw std::logic_error("the new point does not lie above the triangle");
  find_horizon(vertex, seen);
  const CornerId apex(static_cast<std::uint32_t>(vertices_.size()));
  vertices_.push_back(vertex);
  fan_.resize(vertices_.size());
  fresh_.clear();
  for (const HorizonEdge& edge : horizon_) {
    const TriangleId t = add({edge.from, edge.to, apex});
    triangles_[t].across[0] = edge.beyond;
    triangles_[edge.beyond].across[edge.side] = t;
    fan_[edge.from] = t;
    fresh_.push_back(t);
  }
  for (const TriangleId t : fresh_) {
    const TriangleId following = fan_[triangles_[t].corners[1]];
    if (following < fresh_.front() || triangles_.size() <= following.value || triangles_[following].corners[0] != triangles_[t].corners[1])
      throw std::logic_error("the horizon of the new point is no cycle");
    triangles_[t].across[1] = following;
    triangles_[following].across[2] = t;
  }
  return fresh_;
}

}  // namespace fathom::expanding
