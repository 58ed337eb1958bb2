// SPDX-License-Identifier: GPL-3.0-or-later
// Two convex parts on both sides of one facet have a convex union if and only if each lies below
// the planes of all other facets of the other.
#include <algorithm>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

#include "reference/solids/arrangement.hpp"
#include "reference/solids/chain.hpp"

namespace fathom::solids {
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
