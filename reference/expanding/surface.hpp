// SPDX-License-Identifier: GPL-3.0-or-later
// A convex polytope that grows point by point: its surface as triangles, none degenerate,
// neighbours coplanar or convex. Exact; integers are used only where binary64 with an error bound
// leaves a sign open. Only triangles strictly below the new point are removed. So the point never
// lies on the line through an edge of the horizon, and new triangles are never degenerate; coplanar
// triangles stay side by side.                                       [proofs/expanding.md, lemma 1]
// Here are its surface, the four points it starts from, and the form in which it is handed out.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <initializer_list>
#include <limits>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/filters/plane.hpp"
#include "kernels/id.hpp"
#include "kernels/number/lazy_integer.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::expanding {

using PoolIndex = kernels::Id<struct PoolTag>;

/// Values that come and go, in memory that stays. Values are never constructed again: what `take`
/// returns holds some earlier value. References stay valid until the pool is gone.
template <class T>
class Pool {
 public:
  PoolIndex take() {
    if (!free_.empty()) {
      const PoolIndex index = free_.back();
      free_.pop_back();
      return index;
    }
    if (taken_ == values_.size()) values_.emplace_back();
    return PoolIndex(static_cast<std::uint32_t>(taken_++));
  }
  void give_back(PoolIndex index) { free_.push_back(index); }
  /// Gives back all.
  void clear() {
    free_.clear();
    taken_ = 0;
  }
  T& operator[](PoolIndex index) { return values_[index.value]; }

 private:
  std::deque<T> values_;
  std::size_t taken_ = 0;  // values from here on have not been taken since the last `clear`
  std::vector<PoolIndex> free_;
};

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

/// One triangle, counter-clockwise seen from outside; across[k] lies on the other side of the edge
/// from corner k to corner k + 1.
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

/// `Integer` holds every number of this computation: mpz_class, a LazyInteger, or a FixedInteger
/// that is wide enough. One object serves many polytopes, one after another, and keeps its memory.
template <class Integer>
class Surface {
 public:
  using Vertex = SurfaceVertex<Integer>;
  static constexpr bool lazy = std::is_same_v<Integer, kernels::LazyInteger>;

  /// Becomes the tetrahedron of four differences that do not lie in one plane. Throws
  /// std::logic_error if they do.
  void start(std::array<Vertex, 4> corners);

  /// Adds a point that lies strictly above triangle `seen`, and returns the new triangles, until
  /// the next call. Then the surface is that of the convex hull. Throws std::logic_error if the
  /// point does not lie above it.
  const std::vector<TriangleId>& insert(const Vertex& vertex, TriangleId seen);

  [[nodiscard]] const kernels::IdVector<TriangleId, Triangle>& triangles() const {
    return triangles_;
  }  ///< all that were ever alive
  [[nodiscard]] const kernels::IdVector<CornerId, Vertex>& vertices() const { return vertices_; }
  [[nodiscard]] std::size_t alive() const { return alive_; }
  [[nodiscard]] const SideCounts& sides() const { return sides_; }

  /// The plane of a triangle; computed on first use.
  const ExactPlane<Integer>& plane(TriangleId t);
  /// The sign of the height of a point above the plane of triangle t.
  int side(TriangleId t, const Vertex& vertex);
  /// In lazy integers: <n, v - p> for the normal n of triangle t and that corner p of it which
  /// leaves most digits.
  kernels::WideEnclosure height_enclosure(TriangleId t, const Vertex& vertex);
  /// In lazy integers: the product of the normals of t and another, in a form that leaves digits if
  /// they share corners, the sum of e_1 (d_3 - d_2) and its like over the other's corners d and
  /// their heights e above t.
  Vec3<kernels::WideEnclosure> cross_enclosure(TriangleId t, TriangleId other);
  /// Whether both triangles lie in one plane whatever the points are.
  [[nodiscard]] bool in_plane_by_name(TriangleId t, TriangleId other) const {
    return std::ranges::all_of(triangles_[other].corners,
                               [&](CornerId c) { return in_plane_by_name(t, vertices_[c].from); });
  }
  /// The points of A that corners with one point of B have, and the reverse: an edge of the
  /// triangle is their difference.
  [[nodiscard]] polytope::LevelPoints level(TriangleId t) const;

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
  // The same of a difference.
  [[nodiscard]] bool in_plane_by_name(TriangleId t, polytope::Difference from) const;
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
  kernels::IdVector<CornerId, TriangleId>
      fan_;  // of each vertex on the horizon: the new triangle whose edge on the horizon begins there
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
  const kernels::RoundedPlane rounded(vertices_[corners[0]].rounded, vertices_[corners[1]].rounded,
                                      vertices_[corners[2]].rounded);
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
    if constexpr (lazy) {
      std::tie(exact.normal, exact.height) = plane_through(p, vertices_[c[1]].exact, vertices_[c[2]].exact);
    } else {
      exact.normal = cross(vertices_[c[1]].exact - p, vertices_[c[2]].exact - p);
      exact.height = dot(exact.normal, p);
    }
  }
  return planes_[triangle.plane];
}

template <class Integer>
int Surface<Integer>::side(TriangleId t, const Vertex& vertex) {
  ++sides_.calls;
  if (const auto sure = triangles_[t].rounded.side(vertex.rounded)) return kernels::to_int(*sure);
  ++sides_.exact;
  if constexpr (lazy)
    if (const auto sure = height_enclosure(t, vertex).sign()) return kernels::to_int(*sure);
  const ExactPlane<Integer>& p = plane(t);
  return sgn(Integer(dot(p.normal, vertex.exact) - p.height));
}

template <class Integer>
kernels::WideEnclosure Surface<Integer>::height_enclosure(TriangleId t, const Vertex& vertex) {
  if (in_plane_by_name(t, vertex.from)) return {};
  const Vec3<kernels::WideEnclosure> normal = enclosure(plane(t).normal);
  kernels::WideEnclosure nearest;
  bool first = true;
  for (const CornerId c : triangles_[t].corners) {
    const auto found = dot(normal, enclosure_of_difference(vertex.exact, vertices_[c].exact));
    if (first || found.error() < nearest.error()) nearest = found;
    first = false;
    if (nearest.has_digits()) break;
  }
  return nearest;
}

template <class Integer>
Vec3<kernels::WideEnclosure> Surface<Integer>::cross_enclosure(TriangleId t, TriangleId other) {
  Vec3<kernels::WideEnclosure> sum;
  const std::array<CornerId, 3>& c = triangles_[other].corners;
  for (int k = 0; k < 3; ++k) {
    const Vec3<Integer>&from = vertices_[c[next(k)]].exact, &to = vertices_[c[next(next(k))]].exact;
    sum = sum + height_enclosure(t, vertices_[c[k]]) * enclosure_of_difference(to, from);
  }
  return sum;
}

template <class Integer>
polytope::LevelPoints Surface<Integer>::level(TriangleId t) const {
  const std::array<CornerId, 3>& c = triangles_[t].corners;
  polytope::LevelPoints level;
  const auto add = [](polytope::LevelPoints::Ids& ids, std::uint32_t i) {
    if (!ids.holds(i)) ids.ids[ids.count++] = i;
  };
  for (int k = 0; k < 3; ++k) {
    const polytope::Difference &d = vertices_[c[k]].from, &e = vertices_[c[next(k)]].from;
    if (d.second == e.second) {
      add(level.a, d.first);
      add(level.a, e.first);
    }
    if (d.first == e.first) {
      add(level.b, d.second);
      add(level.b, e.second);
    }
  }
  return level;
}

template <class Integer>
bool Surface<Integer>::in_plane_by_name(TriangleId t, polytope::Difference from) const {
  const polytope::LevelPoints known = level(t);
  const auto same = [](const polytope::LevelPoints::Ids& ids, std::uint32_t i, std::uint32_t j) {
    return i == j || (ids.holds(i) && ids.holds(j));
  };
  return std::ranges::any_of(triangles_[t].corners, [&](CornerId c) {
    const polytope::Difference& corner = vertices_[c].from;
    return same(known.a, corner.first, from.first) && same(known.b, corner.second, from.second);
  });
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
  if (!triangles_[seen].alive || side(seen, vertex) <= 0)
    throw std::logic_error("the new point does not lie above the triangle");
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
    if (following < fresh_.front() || triangles_.size() <= following.value ||
        triangles_[following].corners[0] != triangles_[t].corners[1])
      throw std::logic_error("the horizon of the new point is no cycle");
    triangles_[t].across[1] = following;
    triangles_[following].across[2] = t;
  }
  return fresh_;
}

/// Where an expanding polytope starts. Each point is searched in a direction u from the hull of the
/// points before it to O, then in -u. If neither leads out of that hull, P lies in a plane
/// orthogonal to u.
template <class Differences>
class Start {
 public:
  using Integer = typename Differences::Integer;
  using Direction = Vec3<Integer>;

  explicit Start(Differences& differences) : differences_(differences) {}

  /// Returns nullopt if P is flat. Exact.
  std::optional<std::array<polytope::Difference, 4>> run() {
    const Direction some = differences_[{0, 0}];
    const polytope::Difference first = differences_.extreme(is_zero(some) ? axis(0, 1) : -some);
    const Direction p = differences_[first];
    const auto second = first_beyond(p, {-p, axis(0, 1), axis(0, -1)});
    if (!second) return std::nullopt;
    const Direction line = differences_[*second] - p;
    Direction out = cross(cross(p, line), line);  // from the line to O
    if (is_zero(out)) out = some_normal(line);
    const auto third = first_beyond(p, {out, -out});
    if (!third) return std::nullopt;
    const Direction normal = cross(line, differences_[*third] - p);
    const bool towards = sgn(dot(normal, p)) <= 0;
    const auto fourth = first_beyond(p, {towards ? normal : -normal, towards ? -normal : normal});
    if (!fourth) return std::nullopt;
    return std::array{first, *second, *third, *fourth};
  }

 private:
  static Direction axis(int k, long sign) {
    return {Integer(k == 0 ? sign : 0), Integer(k == 1 ? sign : 0), Integer(k == 2 ? sign : 0)};
  }

  // The first extreme difference, over `directions`, that lies farther in its direction than
  // `from`.
  std::optional<polytope::Difference> first_beyond(const Direction& from, std::initializer_list<Direction> directions) {
    for (const Direction& u : directions) {
      if (is_zero(u)) continue;
      const polytope::Difference d = differences_.extreme(u);
      if (rises(u, from, differences_[d])) return d;
    }
    return std::nullopt;
  }

  static bool rises(const Direction& u, const Direction& from, const Direction& to) {
    if constexpr (Surface<Integer>::lazy) return order_along(u, to, from) > 0;
    else return cmp(Integer(dot(u, to)), Integer(dot(u, from))) > 0;
  }

  static Direction some_normal(const Direction& line) {
    for (int k = 0; k < 3; ++k) {
      const Direction n = cross(line, axis(k, 1));
      if (!is_zero(n)) return n;
    }
    return {};
  }

  Differences& differences_;
};

/// Returns four differences that do not lie in one plane, found in directions that lead towards O,
/// or nullopt if P is flat. Exact.
template <class Differences>
std::optional<std::array<polytope::Difference, 4>> starting_tetrahedron(Differences& differences) {
  return Start<Differences>(differences).run();
}

// The form in which an expansion proves how far O is from the boundary of P: a polytope inside P.
// Coplanar triangles of the surface become one polygon, corners inside facets or edges are dropped.

/// What merging remembers.
struct MergeMemory {
  kernels::IdVector<TriangleId, std::uint32_t> facet_of;  ///< of triangles that are alive: the index of their facet
  kernels::IdVector<CornerId, std::uint32_t> name;        // in the result, or none
  std::vector<TriangleId> members;
  std::vector<CornerId> cycle;
  std::vector<std::uint32_t> corners;
};

/// Merges the facets of a surface.
template <class Integer>
class Merging {
 public:
  Merging(Surface<Integer>& surface, MergeMemory& memory) : surface_(surface), memory_(memory) {
    memory.facet_of.assign(surface.triangles().size(), none);
    memory.name.assign(surface.vertices().size(), none);
  }

  InnerPolytope run() {
    result_.facets.reserve(surface_.alive());
    result_.vertices.reserve(surface_.vertices().size());
    for (const TriangleId t : surface_.triangles().ids()) {
      if (!surface_.triangles()[t].alive || memory_.facet_of[t] != none) continue;
      flood(t);
      add_facet();
    }
    return std::move(result_);
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  struct Side {
    TriangleId triangle;
    int k;
  };

  // For neighbours. Only the corner that they do not share can lie off the plane.
  bool coplanar(TriangleId t, TriangleId other) {
    const std::array<CornerId, 3>& known = surface_.triangles()[t].corners;
    for (const CornerId corner : surface_.triangles()[other].corners)
      if (std::find(known.begin(), known.end(), corner) == known.end())
        return surface_.side(t, surface_.vertices()[corner]) == 0;
    throw std::logic_error("two triangles of the expanding polytope have the same corners");
  }

  // All triangles of the facet that holds t, into `members`.
  void flood(TriangleId t) {
    std::vector<TriangleId>& members = memory_.members;
    members.assign(1, t);
    memory_.facet_of[t] = static_cast<std::uint32_t>(result_.facets.size());
    for (std::size_t i = 0; i < members.size(); ++i) {
      for (const TriangleId other : surface_.triangles()[members[i]].across) {
        if (memory_.facet_of[other] != none || !coplanar(members[i], other)) continue;
        memory_.facet_of[other] = memory_.facet_of[t];
        members.push_back(other);
      }
    }
  }

  [[nodiscard]] bool inner(const Side& side) const {
    return memory_.facet_of[surface_.triangles()[side.triangle].across[side.k]] == memory_.facet_of[side.triangle];
  }

  [[nodiscard]] Side some_outer_side() const {
    for (const TriangleId t : memory_.members)
      for (int k = 0; k < 3; ++k)
        if (!inner({t, k})) return {t, k};
    throw std::logic_error("a facet of the expanding polytope has no boundary");
  }

  [[nodiscard]] CornerId start(const Side& side) const { return surface_.triangles()[side.triangle].corners[side.k]; }

  // The side that follows on the boundary of the facet, counter-clockwise: around the corner, over
  // inner sides.
  [[nodiscard]] Side following(Side side) const {
    side.k = next(side.k);
    while (inner(side)) {
      const CornerId pivot = start(side);
      side.triangle = surface_.triangles()[side.triangle].across[side.k];
      for (side.k = 0; start(side) != pivot; ++side.k) {
      }
    }
    return side;
  }

  [[nodiscard]] bool on_one_line(CornerId u, CornerId v, CornerId w) const {
    const auto& vertices = surface_.vertices();
    return is_zero(cross(vertices[v].exact - vertices[u].exact, vertices[w].exact - vertices[v].exact));
  }

  std::uint32_t name(CornerId vertex) {
    if (memory_.name[vertex] == none) {
      memory_.name[vertex] = static_cast<std::uint32_t>(result_.vertices.size());
      result_.vertices.push_back(surface_.vertices()[vertex].from);
    }
    return memory_.name[vertex];
  }

  void add_facet() {
    std::vector<CornerId>& cycle = memory_.cycle;
    cycle.clear();
    const Side first = some_outer_side();
    Side side = first;
    do {
      cycle.push_back(start(side));
      side = following(side);
    } while (side.triangle != first.triangle || side.k != first.k);
    memory_.corners.clear();
    const std::size_t n = cycle.size();
    for (std::size_t i = 0; i < n; ++i) {
      const bool kept =
          memory_.members.size() == 1 || !on_one_line(cycle[(i + n - 1) % n], cycle[i], cycle[(i + 1) % n]);
      if (kept) memory_.corners.push_back(name(cycle[i]));
    }
    result_.facets.push_back(memory_.corners);
  }

  Surface<Integer>& surface_;
  MergeMemory& memory_;
  InnerPolytope result_;
};

template <class Integer>
InnerPolytope inner_polytope(Surface<Integer>& surface, MergeMemory& memory) {
  return Merging<Integer>(surface, memory).run();
}

}  // namespace fathom::expanding
