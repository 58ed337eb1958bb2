// SPDX-License-Identifier: GPL-3.0-or-later
// The points, lines and planes that cuts of a mesh meet, each once: equal ones have equal ids.
//                                                                              [proofs/solids.md]
//
// Every plane is one of the mesh's, or of a piece that it is compared with, or goes across an axis
// through a corner; every line is an edge's or where two of these planes meet, every point a corner
// or where such a line meets a plane. So numbers stay short, however many cuts follow one another.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "kernels/filters/meeting_points.hpp"
#include "kernels/id.hpp"
#include "kernels/vector.hpp"

namespace fathom::solids {

using PointId = kernels::Id<struct MeetingPointTag>;
using LineId = kernels::Id<struct MeetingLineTag>;
using PlaneId = kernels::Id<struct MeetingPlaneTag>;

/// A plane with an outside: the side that its normal points to, or the other one.
struct PlaneSide {
  PlaneId plane;
  bool reversed = false;

  [[nodiscard]] PlaneSide opposite() const { return {plane, !reversed}; }
  friend auto operator<=>(const PlaneSide&, const PlaneSide&) = default;
};

/// The line through p in `direction`, by its Pluecker coordinates: `moment` is p x direction. They
/// have no common factor, and the first component of `direction` that is not 0 is positive.
struct SpaceLine {
  Vector direction, moment;
  int axis;                   ///< of that component
  kernels::PlaneImage image;  ///< of the direction, as if it were a plane's normal
};

/// All of them. Coordinates of points are at most 2^exponent in size.
class Arrangement {
 public:
  explicit Arrangement(long exponent) : exponent_(exponent) {}

  /// The point v / w; w is not 0.
  PointId point(Vector v, mpz_class w = 1);
  /// The same of the point in this position.
  PointId point_at(const Point& position);
  /// The plane through three points, its outside where they appear counter-clockwise; nullopt if
  /// they lie on a line.
  std::optional<PlaneSide> plane(PointId p, PointId q, PointId r);
  /// The plane through a point of the mesh's lattice where coordinate `axis` is constant.
  PlaneId plane_across(int axis, PointId p);
  /// The line through two points; where two planes meet, which are not parallel.
  LineId line(PointId p, PointId q);
  LineId line(PlaneId e, PlaneId f);
  /// Where a line meets a plane to which it is not parallel.
  PointId meeting(LineId l, PlaneId e);

  [[nodiscard]] const kernels::RationalPoint& operator[](PointId p) const { return points_[p]; }
  [[nodiscard]] std::size_t point_count() const { return points_.size(); }
  /// 1 if the point lies on the side that the normal points to, -1 on the other one, 0 in the
  /// plane.
  [[nodiscard]] int side(PlaneId e, PointId p) const { return kernels::side(planes_[e], points_[p]); }
  /// 1 if it lies outside, -1 inside.
  [[nodiscard]] int side(PlaneSide e, PointId p) const { return e.reversed ? -side(e.plane, p) : side(e.plane, p); }
  /// The sign of p - q along coordinate `axis`.
  [[nodiscard]] int compare(PointId p, PointId q, std::size_t axis) const {
    return kernels::compare(points_[p], points_[q], static_cast<int>(axis));
  }
  /// Whether p comes before q along the direction of the line that holds both.
  [[nodiscard]] bool before(LineId l, PointId p, PointId q) const {
    return p != q && kernels::compare(points_[p], points_[q], lines_[l].axis) < 0;
  }
  /// The sign of det(n, m, d) for the outward normals of e and f and the direction of l.
  [[nodiscard]] int turn(PlaneSide e, PlaneSide f, LineId l) const;
  /// 1 if the points turn left, seen from outside the plane that holds them, -1 if they turn right.
  [[nodiscard]] int turn(PlaneSide e, PointId p, PointId q, PointId r) const;

 private:
  using Known = std::unordered_multimap<std::size_t, std::uint32_t>;  // by hashes

  PlaneId plane(const Vector& normal, const mpz_class& height);
  LineId line(Vector direction, Vector moment);

  long exponent_;
  kernels::IdVector<PointId, kernels::RationalPoint> points_;
  kernels::IdVector<LineId, SpaceLine> lines_;
  kernels::IdVector<PlaneId, kernels::OrientedPlane> planes_;
  Known known_points_, known_lines_, known_planes_;
};

// A solid by its boundary: for each plane and side the directed edges that bound what lies there.
// There are no faces with holes, no nesting and no neighbours: a chain of segments on a line is
// known by the points where it begins and ends, a flat chain of polygons by the segments that bound
// it, and so is all that happens to them when a plane cuts the solid.            [proofs/solids.md]

/// A segment of a line, so many times in the line's direction; backwards if `times` < 0.
struct ChainEdge {
  LineId line;
  PointId low, high;  ///< in the order of the line
  std::int64_t times;

  [[nodiscard]] PointId from() const { return times > 0 ? low : high; }
  [[nodiscard]] PointId to() const { return times > 0 ? high : low; }
};

/// The segment from one point to another one.
inline ChainEdge edge_from_to(Arrangement& space, PointId p, PointId q) {
  const LineId line = space.line(p, q);
  return space.before(line, p, q) ? ChainEdge{line, p, q, 1} : ChainEdge{line, q, p, -1};
}

/// Where chains end, those that begin there taken away; or the opposite.
struct ChainEnd {
  LineId line;
  PointId point;
  std::int64_t times;
};

/// What lies in one plane and looks to one side, counter-clockwise seen from outside.
struct ChainFacet {
  PlaneSide side;
  std::vector<ChainEdge> edges;
};

/// A part of the solid: a closed surface.
using Chunk = std::vector<ChainFacet>;

/// The segments on lines with these ends, each as long as it can be; sorted by lines, and along
/// them. On each line the ends sum to 0.
std::vector<ChainEdge> edges_between(const Arrangement& space, std::vector<ChainEnd> ends);
/// The same chain by such segments: those that overlap are added up.
std::vector<ChainEdge> normalised(const Arrangement& space, const std::vector<ChainEdge>& edges);

/// Points with the extreme coordinates of a chunk, along each axis.
struct ChunkBox {
  std::array<PointId, 3> low, high;
};
ChunkBox box_of(const Arrangement& space, const Chunk& chunk);
/// Whether they have common points in their interiors.
bool overlap(const Arrangement& space, const ChunkBox& a, const ChunkBox& b);

/// A segment at which a chunk is not convex, with the planes that meet there.
struct ReflexEdge {
  PointId low, high;
  PlaneId first, second;
};
/// All of them; and every segment where more than two facets meet.
std::vector<ReflexEdge> reflex_edges(const Arrangement& space, const Chunk& chunk);

/// The two parts of a chunk.
struct CutChunk {
  Chunk above, below;  ///< `above` where the plane's normal points
};

/// Cuts chunks, and takes them apart. Holds what is known of the points of the chunk at hand.
class Cutter {
 public:
  explicit Cutter(Arrangement& space) : space_(space) {}

  /// The points of the chunk, each once.
  static std::vector<PointId> points_of(const Chunk& chunk);

  /// On which sides of the plane the points lie: those asked about last.
  struct Sides {
    std::size_t above = 0, below = 0;  ///< how many do, strictly
    [[nodiscard]] bool both() const { return above > 0 && below > 0; }
  };
  Sides look(PlaneId e, const std::vector<PointId>& points);
  [[nodiscard]] int side(PointId p) const { return sides_[p.value]; }
  /// How many points were asked about, each as often as it was.
  [[nodiscard]] std::uint64_t looked_at() const { return looked_at_; }

  /// Both parts, closed by caps in the plane, after look(e, points_of(chunk)).
  CutChunk cut(Chunk chunk, PlaneId e);

  /// The chunk's parts that share no point, together where their boxes overlap: each is a closed
  /// surface, and goes around nothing that another one goes around.
  std::vector<Chunk> components(Chunk chunk);

 private:
  struct Cap {
    std::vector<ChainEnd> above, below;  // of the chains in the plane that close the parts
  };
  void cut_facet(const ChainFacet& facet, PlaneId e, CutChunk& parts, Cap& cap);
  std::vector<Chunk> united_where_boxes_overlap(std::vector<Chunk> chunks);

  Arrangement& space_;
  std::uint64_t looked_at_ = 0;
  std::vector<std::int8_t> sides_;     // by points
  std::vector<std::uint32_t> number_;  // by points: among those of the chunk at hand
};

/// A convex part of the solid, around which the surface goes so many times.
struct ConvexPart {
  std::vector<ChainFacet> facets;  ///< each a convex polygon, once around
  std::vector<PointId> corners;    ///< sorted
  std::int64_t times = 0;
};

/// A surface that was cut.
struct CutSurface {
  std::vector<ConvexPart> parts;
  std::uint64_t looked_at;  ///< points on whose sides planes were chosen, each as often as it was
};
/// The convex parts of what a closed surface goes around. If it goes around one inwards, so that
/// `times` < 0, that is the last, and the rest is not cut. The points known to `space` are corners
/// of the mesh.
CutSurface convex_parts(Arrangement& space, const Chunk& surface);

/// The parts with neighbours joined where that makes a convex part, those with the largest common
/// facet first.
std::vector<ConvexPart> joined_parts(const Arrangement& space, std::vector<ConvexPart> parts);

}  // namespace fathom::solids
