// SPDX-License-Identifier: GPL-3.0-or-later
// Only triangles strictly below the new point are removed. So the point never lies on the line through an edge of the horizon, and new
// triangles are never degenerate; coplanar triangles stay side by side.  [proofs/expanding.md, lemma 1]
#include "reference/expanding/surface.hpp"

#include <stdexcept>
#include <utility>

namespace fathom::expanding {
namespace {

// Which edge of `t` starts at `from`.
int edge_from(const Triangle& t, CornerId from) {
  for (int k = 0; k < 3; ++k)
    if (t.corners[k] == from) return k;
  throw std::logic_error("the surface of the expanding polytope is torn");
}

}  // namespace

Surface::Surface(std::array<SurfaceVertex, 4> corners, long exponent) : exponent_(exponent) {
  const Vector& p = corners[0].exact;
  const int turn = sgn(det(corners[1].exact - p, corners[2].exact - p, corners[3].exact - p));
  if (turn == 0) throw std::logic_error("the expanding polytope starts flat");
  if (turn > 0) std::swap(corners[1], corners[2]);  // so that corner 3 lies below the triangle 0 1 2
  vertices_.reserve(32);                            // most searches need no more
  triangles_.reserve(128);
  for (SurfaceVertex& corner : corners) vertices_.push_back(std::move(corner));
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

TriangleId Surface::add(const std::array<CornerId, 3>& corners) {
  const TriangleId t(static_cast<std::uint32_t>(triangles_.size()));
  const kernels::RoundedPlane rounded(vertices_[corners[0]].rounded, vertices_[corners[1]].rounded, vertices_[corners[2]].rounded);
  triangles_.push_back({corners, {}, rounded, true, nullptr});
  ++alive_;
  return t;
}

void Surface::remove(TriangleId t) {
  triangles_[t].alive = false;
  triangles_[t].exact.reset();
  --alive_;
}

const ExactPlane& Surface::plane(TriangleId t) {
  std::unique_ptr<ExactPlane>& exact = triangles_[t].exact;
  if (!exact) {
    const std::array<CornerId, 3>& c = triangles_[t].corners;
    const Vector& p = vertices_[c[0]].exact;
    exact = std::make_unique<ExactPlane>();
    exact->normal = cross(vertices_[c[1]].exact - p, vertices_[c[2]].exact - p);
    exact->height = dot(exact->normal, p);
  }
  return *exact;
}

int Surface::side(TriangleId t, const SurfaceVertex& vertex) {
  if (const auto sure = triangles_[t].rounded.side(vertex.rounded)) return kernels::to_int(*sure);
  const ExactPlane& p = plane(t);
  return sgn(mpz_class(dot(p.normal, vertex.exact) - p.height));
}

std::vector<Surface::HorizonEdge> Surface::take_out_visible(const SurfaceVertex& vertex, TriangleId seen) {
  std::vector<TriangleId> visible{seen};
  remove(seen);
  std::vector<HorizonEdge> horizon;
  for (std::size_t i = 0; i < visible.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const CornerId from = triangles_[visible[i]].corners[k], to = triangles_[visible[i]].corners[next(k)];
      const TriangleId other = triangles_[visible[i]].across[k];
      if (!triangles_[other].alive) continue;
      if (side(other, vertex) > 0) {
        remove(other);
        visible.push_back(other);
      } else {
        horizon.push_back({from, to, other, edge_from(triangles_[other], to)});
      }
    }
  }
  return horizon;
}

std::vector<TriangleId> Surface::insert(SurfaceVertex vertex, TriangleId seen) {
  if (!triangles_[seen].alive || side(seen, vertex) <= 0) throw std::logic_error("the new point does not lie above the triangle");
  const std::vector<HorizonEdge> horizon = take_out_visible(vertex, seen);
  const CornerId apex(static_cast<std::uint32_t>(vertices_.size()));
  vertices_.push_back(std::move(vertex));
  fan_.resize(vertices_.size());
  std::vector<TriangleId> fresh;
  for (const HorizonEdge& edge : horizon) {
    const TriangleId t = add({edge.from, edge.to, apex});
    triangles_[t].across[0] = edge.beyond;
    triangles_[edge.beyond].across[edge.side] = t;
    fan_[edge.from] = t;
    fresh.push_back(t);
  }
  for (const TriangleId t : fresh) {
    const TriangleId following = fan_[triangles_[t].corners[1]];
    if (following < fresh.front() || triangles_[following].corners[0] != triangles_[t].corners[1])
      throw std::logic_error("the horizon of the new point is no cycle");
    triangles_[t].across[1] = following;
    triangles_[following].across[2] = t;
  }
  return fresh;
}

}  // namespace fathom::expanding
