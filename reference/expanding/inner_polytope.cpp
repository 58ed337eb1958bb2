// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/expanding/inner_polytope.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "reference/expanding/surface.hpp"

namespace fathom::expanding {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

class Merging {
 public:
  explicit Merging(Surface& surface)
      : surface_(surface), facet_of_(surface.triangles().size(), none), name_(surface.vertices().size(), none) {}

  InnerPolytope run() {
    for (const TriangleId t : surface_.triangles().ids()) {
      if (!surface_.triangles()[t].alive || facet_of_[t] != none) continue;
      flood(t);
      add_facet();
    }
    return std::move(result_);
  }

 private:
  // For neighbours. Only the corner that they do not share can lie off the plane.
  bool coplanar(TriangleId t, TriangleId other) {
    const std::array<CornerId, 3>& known = surface_.triangles()[t].corners;
    for (const CornerId corner : surface_.triangles()[other].corners)
      if (std::find(known.begin(), known.end(), corner) == known.end()) return surface_.side(t, surface_.vertices()[corner]) == 0;
    throw std::logic_error("two triangles of the expanding polytope have the same corners");
  }

  // All triangles of the facet that holds t, into members_.
  void flood(TriangleId t) {
    members_.assign(1, t);
    facet_of_[t] = static_cast<std::uint32_t>(result_.facets.size());
    for (std::size_t i = 0; i < members_.size(); ++i) {
      for (const TriangleId other : surface_.triangles()[members_[i]].across) {
        if (facet_of_[other] != none || !coplanar(members_[i], other)) continue;
        facet_of_[other] = facet_of_[t];
        members_.push_back(other);
      }
    }
  }

  struct Side {
    TriangleId triangle;
    int k;
  };

  bool inner(const Side& side) const { return facet_of_[surface_.triangles()[side.triangle].across[side.k]] == facet_of_[side.triangle]; }

  Side some_outer_side() const {
    for (const TriangleId t : members_)
      for (int k = 0; k < 3; ++k)
        if (!inner({t, k})) return {t, k};
    throw std::logic_error("a facet of the expanding polytope has no boundary");
  }

  CornerId start(const Side& side) const { return surface_.triangles()[side.triangle].corners[side.k]; }

  // The side that follows on the boundary of the facet, counter-clockwise: around the corner, over inner sides.
  Side following(Side side) const {
    side.k = next(side.k);
    while (inner(side)) {
      const CornerId pivot = start(side);
      const TriangleId other = surface_.triangles()[side.triangle].across[side.k];
      side.triangle = other;
      for (side.k = 0; start(side) != pivot; ++side.k) {
      }
    }
    return side;
  }

  bool on_one_line(CornerId u, CornerId v, CornerId w) const {
    const kernels::IdVector<CornerId, SurfaceVertex>& vertices = surface_.vertices();
    return is_zero(cross(vertices[v].exact - vertices[u].exact, vertices[w].exact - vertices[v].exact));
  }

  std::uint32_t name(CornerId vertex) {
    if (name_[vertex] == none) {
      name_[vertex] = static_cast<std::uint32_t>(result_.vertices.size());
      result_.vertices.push_back(surface_.vertices()[vertex].from);
    }
    return name_[vertex];
  }

  void add_facet() {
    std::vector<CornerId> cycle;
    const Side first = some_outer_side();
    Side side = first;
    do {
      cycle.push_back(start(side));
      side = following(side);
    } while (side.triangle != first.triangle || side.k != first.k);
    std::vector<std::uint32_t> corners;
    const std::size_t n = cycle.size();
    for (std::size_t i = 0; i < n; ++i) {
      const bool kept = members_.size() == 1 || !on_one_line(cycle[(i + n - 1) % n], cycle[i], cycle[(i + 1) % n]);
      if (kept) corners.push_back(name(cycle[i]));
    }
    result_.facets.push_back(std::move(corners));
  }

  Surface& surface_;
  kernels::IdVector<TriangleId, std::uint32_t> facet_of_;  // in result_, or none
  kernels::IdVector<CornerId, std::uint32_t> name_;        // in result_, or none
  std::vector<TriangleId> members_;
  InnerPolytope result_;
};

}  // namespace

InnerPolytope inner_polytope(Surface& surface) { return Merging(surface).run(); }

}  // namespace fathom::expanding
