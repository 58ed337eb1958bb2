// SPDX-License-Identifier: GPL-3.0-or-later
// What a closed surface goes around is cut into convex parts: by planes at reflex edges, and large
// chunks also in the middle.                                                  [proofs/solids.md]
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "reference/solids/arrangement.hpp"

namespace fathom::solids {

namespace {

/// Cuts a closed surface into convex parts.
class Decomposition {
 public:
  explicit Decomposition(Arrangement& space)
      : space_(space), cutter_(space), corner_count_(static_cast<std::uint32_t>(space.point_count())) {}

  CutSurface run(const Chunk& surface) {
    std::vector<Chunk> todo{surface};
    while (!todo.empty()) {
      Chunk chunk = std::move(todo.back());
      todo.pop_back();
      std::vector<Chunk> parts = cutter_.components(std::move(chunk));
      chunk = std::move(parts.back());
      parts.pop_back();
      std::ranges::move(parts, std::back_inserter(todo));
      const std::vector<PointId> points = Cutter::points_of(chunk);
      if (const std::optional<PlaneId> plane = best_cut(chunk, points)) {
        cutter_.look(*plane, points);
        auto [above, below] = cutter_.cut(std::move(chunk), *plane);
        for (Chunk* part : {&above, &below})
          if (!part->empty()) todo.push_back(std::move(*part));
      } else if (!add_part(chunk, points)) {
        break;
      }
    }
    return {std::move(parts_), cutter_.looked_at()};
  }

 private:
  static constexpr std::size_t most_candidates = 8;

  // Planes at reflex edges: those at most of them, and as many from all the others.
  static std::vector<PlaneId> candidates(const std::vector<ReflexEdge>& reflex) {
    constexpr std::size_t half = most_candidates / 2;
    std::map<PlaneId, int> uses;
    for (const ReflexEdge& e : reflex) ++uses[e.first], ++uses[e.second];
    std::vector<std::pair<int, PlaneId>> order;
    for (const auto& [plane, count] : uses) order.emplace_back(-count, plane);
    std::ranges::sort(order);
    std::vector<PlaneId> result;
    for (std::size_t i = 0; i < std::min(order.size(), half); ++i) result.push_back(order[i].second);
    const std::size_t rest = order.size() - result.size(), more = std::min(rest, half);
    for (std::size_t i = 0; i < more; ++i) result.push_back(order[half + (2 * i + 1) * rest / (2 * more)].second);
    return result;
  }

  // By how much more reflex edges lie in the plane that was looked at than it crosses, how few
  // others it crosses, and how evenly it divides the points: what is left in one part is looked at
  // again.
  long score(const Chunk& chunk, const std::vector<ReflexEdge>& reflex, const Cutter::Sides& points) const {
    constexpr long per_reflex_edge = 50, per_point = 3;
    long sum = -per_point * static_cast<long>(std::max(points.above, points.below));
    for (const ReflexEdge& e : reflex) {
      const int low = cutter_.side(e.low), high = cutter_.side(e.high);
      if (low == 0 && high == 0) sum += per_reflex_edge;
      if (low * high < 0) sum -= per_reflex_edge;
    }
    for (const ChainFacet& facet : chunk)
      for (const ChainEdge& e : facet.edges) sum -= cutter_.side(e.low) * cutter_.side(e.high) < 0 ? 1 : 0;
    return sum;
  }

  // Across each axis, through the median of the corners of the mesh that the chunk has. Each plane
  // of a round mesh has all but a few points on one side; cut by these alone, n triangles are
  // looked at n times.
  std::vector<PlaneId> middle_planes(const std::vector<PointId>& points) {
    constexpr std::size_t few_points = 100;
    std::vector<PlaneId> planes;
    std::vector<PointId> corners(points.begin(), std::ranges::lower_bound(points, PointId(corner_count_)));
    if (points.size() <= few_points || corners.empty()) return planes;
    const auto middle = corners.begin() + static_cast<std::ptrdiff_t>(corners.size() / 2);
    for (const int axis : {0, 1, 2}) {
      std::ranges::nth_element(corners, middle, [&](PointId p, PointId q) { return space_.compare(p, q, axis) < 0; });
      planes.push_back(space_.plane_across(axis, *middle));
    }
    return planes;
  }

  // The best plane of several; nullopt if the chunk lies on one side of the planes of all its
  // facets.
  std::optional<PlaneId> best_cut(const Chunk& chunk, const std::vector<PointId>& points) {
    const std::vector<ReflexEdge> reflex = reflex_edges(space_, chunk);
    std::optional<PlaneId> best;
    long best_score = 0;
    std::size_t found = 0;
    const auto consider = [&](PlaneId plane) {
      const Cutter::Sides sides = cutter_.look(plane, points);
      if (!sides.both()) return;
      const long of_plane = score(chunk, reflex, sides);
      if (++found > 1 && of_plane <= best_score) return;
      best = plane;
      best_score = of_plane;
    };
    for (const PlaneId plane : candidates(reflex)) consider(plane);
    if (best)
      for (const PlaneId plane : middle_planes(points)) consider(plane);
    if (best) return best;
    std::set<PlaneId> tried;
    for (const ChainFacet& facet : chunk)
      if (found < most_candidates && tried.insert(facet.side.plane).second) consider(facet.side.plane);
    return best;
  }

  // All points lie on one side of each facet's plane, so the winding number is one number inside
  // their hull. Returns false if it is negative.
  bool add_part(const Chunk& chunk, const std::vector<PointId>& points) {
    std::map<PlaneId, std::vector<ChainEdge>> edges;
    for (const ChainFacet& facet : chunk)
      edges[facet.side.plane].insert(edges[facet.side.plane].end(), facet.edges.begin(), facet.edges.end());
    ConvexPart part;
    for (const auto& [plane, all] : edges) {
      ChainFacet facet{{plane, cutter_.look(plane, points).above > 0}, normalised(space_, all)};
      if (facet.edges.empty()) continue;
      const ChainEdge& first = facet.edges.front();
      const auto next = std::ranges::find_if(facet.edges, [&](const ChainEdge& e) { return e.from() == first.to(); });
      if (next == facet.edges.end()) throw std::logic_error("the chain of a facet is not closed");
      const int turn = space_.turn(facet.side, first.from(), first.to(), next->to());
      const std::int64_t times = turn * (first.times < 0 ? -first.times : first.times);
      if (times == 0 || (part.times != 0 && part.times != times))
        throw std::logic_error("the winding number of a convex part is not one number");
      part.times = times;
      for (ChainEdge& e : facet.edges) {
        e.times = (e.times < 0) == (times < 0) ? 1 : -1;
        part.corners.push_back(e.from());
      }
      part.facets.push_back(std::move(facet));
    }
    if (part.facets.empty()) return true;
    std::ranges::sort(part.corners);
    part.corners.erase(std::unique(part.corners.begin(), part.corners.end()), part.corners.end());
    parts_.push_back(std::move(part));
    return parts_.back().times > 0;
  }

  Arrangement& space_;
  Cutter cutter_;
  std::uint32_t corner_count_;  // the mesh's points come first
  std::vector<ConvexPart> parts_;
};

}  // namespace

CutSurface convex_parts(Arrangement& space, const Chunk& surface) { return Decomposition(space).run(surface); }

// Two convex parts on both sides of one facet have a convex union if and only if each lies below
// the planes of all other facets of the other.

namespace {

std::vector<PointId> corners_of(const std::vector<ChainEdge>& edges) {
  std::vector<PointId> corners;
  for (const ChainEdge& e : edges) corners.push_back(e.from());
  std::ranges::sort(corners);
  return corners;
}

/// Two parts that may be joined: the largest common facet first, then those of the lowest numbers.
struct Join {
  std::uint64_t area;
  std::uint32_t first, second;
  PlaneId plane;

  bool operator<(const Join& other) const {
    return std::tuple(area, other.first, other.second) < std::tuple(other.area, first, second);
  }
};

class PartJoiner {
 public:
  PartJoiner(const Arrangement& space, std::vector<ConvexPart> parts)
      : space_(space), parts_(std::move(parts)), alive_(parts_.size(), true) {}

  std::vector<ConvexPart> run() {
    for (std::uint32_t i = 0; i < parts_.size(); ++i) enter(i);
    while (!joins_.empty()) {
      const Join join = joins_.top();
      joins_.pop();
      if (!alive_[join.first] || !alive_[join.second]) continue;
      parts_.push_back(joined(join));
      alive_[join.first] = alive_[join.second] = false;
      alive_.push_back(true);
      enter(static_cast<std::uint32_t>(parts_.size() - 1));
    }
    std::vector<ConvexPart> left;
    for (std::uint32_t i = 0; i < parts_.size(); ++i)
      if (alive_[i]) left.push_back(std::move(parts_[i]));
    return left;
  }

 private:
  using FacetKey = std::pair<PlaneId, std::vector<PointId>>;

  // Tells the facets of a part to those on their other sides.
  void enter(std::uint32_t i) {
    for (const ChainFacet& facet : parts_[i].facets) {
      std::vector<std::uint32_t>& there = with_facet_[{facet.side.plane, corners_of(facet.edges)}];
      std::erase_if(there, [&](std::uint32_t j) { return !alive_[j]; });
      for (const std::uint32_t j : there)
        if (fit(parts_[i], parts_[j], facet.side.plane)) joins_.push({area(facet), j, i, facet.side.plane});
      there.push_back(i);
    }
  }

  [[nodiscard]] bool is_below(const ConvexPart& part, const ConvexPart& planes_of, PlaneId but) const {
    return std::ranges::all_of(planes_of.facets, [&](const ChainFacet& facet) {
      return facet.side.plane == but ||
             std::ranges::none_of(part.corners, [&](PointId p) { return space_.side(facet.side, p) > 0; });
    });
  }

  [[nodiscard]] bool fit(const ConvexPart& a, const ConvexPart& b, PlaneId common) const {
    const auto side_of = [&](const ConvexPart& part) {
      return std::ranges::find(part.facets, common, [](const ChainFacet& f) { return f.side.plane; })->side;
    };
    return a.times == b.times && side_of(a) != side_of(b) && is_below(a, b, common) && is_below(b, a, common);
  }

  // About how large a facet is, in whole numbers: it decides nothing but the order.
  [[nodiscard]] std::uint64_t area(const ChainFacet& facet) const {
    using Grid = Vec3<std::int64_t>;
    const auto grid = [&](PointId p) {
      const Vec3<double>& image = space_[p].image;
      const auto cell = [](double x) { return static_cast<std::int64_t>(x * 0x1p28); };
      return Grid{cell(image.x), cell(image.y), cell(image.z)};
    };
    const Grid origin = grid(facet.edges.front().from());
    Grid sum{0, 0, 0};
    for (const ChainEdge& e : facet.edges) sum = sum + cross(grid(e.from()) - origin, grid(e.to()) - origin);
    std::uint64_t size = 0;
    for (const std::int64_t c : {sum.x, sum.y, sum.z}) size += static_cast<std::uint64_t>(c < 0 ? -c : c);
    return size;
  }

  [[nodiscard]] ConvexPart joined(const Join& join) const {
    const ConvexPart &a = parts_[join.first], &b = parts_[join.second];
    std::map<PlaneSide, std::vector<ChainEdge>> edges;
    for (const ConvexPart* part : {&a, &b})
      for (const ChainFacet& facet : part->facets)
        if (facet.side.plane != join.plane)
          edges[facet.side].insert(edges[facet.side].end(), facet.edges.begin(), facet.edges.end());
    ConvexPart result{{}, {}, a.times};
    for (const auto& [side, all] : edges) {
      result.facets.push_back({side, normalised(space_, all)});
      for (const ChainEdge& e : result.facets.back().edges) result.corners.push_back(e.from());
    }
    std::ranges::sort(result.corners);
    result.corners.erase(std::unique(result.corners.begin(), result.corners.end()), result.corners.end());
    return result;
  }

  const Arrangement& space_;
  std::vector<ConvexPart> parts_;
  std::vector<bool> alive_;
  std::map<FacetKey, std::vector<std::uint32_t>> with_facet_;
  std::priority_queue<Join> joins_;
};

}  // namespace

std::vector<ConvexPart> joined_parts(const Arrangement& space, std::vector<ConvexPart> parts) {
  return PartJoiner(space, std::move(parts)).run();
}

}  // namespace fathom::solids
