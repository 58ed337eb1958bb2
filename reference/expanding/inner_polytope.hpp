// SPDX-License-Identifier: GPL-3.0-or-later
// The form in which an expansion proves how far O is from the boundary of P: a polytope inside P. Coplanar triangles of the surface become
// one polygon, corners inside facets or edges are dropped.
#pragma once

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

#include "fathom/depth.hpp"
#include "reference/expanding/surface.hpp"

namespace fathom::expanding {

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
      if (std::find(known.begin(), known.end(), corner) == known.end()) return surface_.side(t, surface_.vertices()[corner]) == 0;
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

  // The side that follows on the boundary of the facet, counter-clockwise: around the corner, over inner sides.
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
      const bool kept = memory_.members.size() == 1 || !on_one_line(cycle[(i + n - 1) % n], cycle[i], cycle[(i + 1) % n]);
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
