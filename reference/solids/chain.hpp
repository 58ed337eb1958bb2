// SPDX-License-Identifier: GPL-3.0-or-later
// A solid by its boundary: for each plane and side the directed edges that bound what lies there.
// There are no faces with holes, no nesting and no neighbours: a chain of segments on a line is
// known by the points where it begins and ends, a flat chain of polygons by the segments that bound
// it, and so is all that happens to them when a plane cuts the solid.            [proofs/solids.md]
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/solids/arrangement.hpp"

namespace fathom::solids {

/// A segment of a line, so many times in the line's direction; backwards if `times` < 0.
struct ChainEdge {
  LineId line;
  PointId low, high;  ///< in the order of the line
  std::int64_t times;

  [[nodiscard]] PointId from() const { return times > 0 ? low : high; }
  [[nodiscard]] PointId to() const { return times > 0 ? high : low; }
};

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
