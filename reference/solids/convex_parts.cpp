// SPDX-License-Identifier: GPL-3.0-or-later
// What a closed surface goes around is cut into convex parts: by planes at reflex edges, and large
// chunks also in the middle.                                                  [proofs/solids.md]
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "reference/solids/arrangement.hpp"
#include "reference/solids/chain.hpp"

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

}  // namespace fathom::solids
