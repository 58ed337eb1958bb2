// SPDX-License-Identifier: GPL-3.0-or-later
// A point outside a cone lies strictly beyond one of its planes. Points strictly beyond given planes through O exist if and only if some
// are beyond these planes moved out by 1: the nearest of these stands for all.
#include "reference/unions/clearance.hpp"

#include <algorithm>
#include <deque>

#include "reference/unions/least_norm.hpp"

namespace fathom::unions {
namespace {

class Covering {
 public:
  explicit Covering(const std::vector<TangentCone>& cones) {
    for (const TangentCone& cone : cones) {
      std::vector<Facet>& facets = cones_.emplace_back();
      for (const Vector& normal : cone) {
        kernels::OrientedPlane through = kernels::oriented_plane(normal, 0, 0);
        facets.push_back({through, kernels::oriented_plane(normal, 1, 0), through.reversed()});
      }
    }
  }

  bool run() { return covered(); }

 private:
  struct Facet {
    kernels::OrientedPlane through, moved, reversed;
  };

  static bool holds(const std::vector<Facet>& cone, const kernels::RationalPoint& p) {
    return std::all_of(cone.begin(), cone.end(), [&](const Facet& f) { return kernels::side(f.through, p) <= 0; });
  }

  // Whether the cones cover the cell of all `beyond_`.
  bool covered() {
    kernels::RationalPoint p;
    if (nearest_in_cell(beyond_, 0, p) != CellEnd::found) return true;
    const auto cone = std::find_if(cones_.begin(), cones_.end(), [&](const std::vector<Facet>& c) { return holds(c, p); });
    if (cone == cones_.end()) return false;
    const std::size_t before = beyond_.size();
    bool all = true;
    for (const Facet& f : *cone) {
      beyond_.push_back(&f.moved);
      all = covered();
      beyond_.pop_back();
      if (!all) break;
      beyond_.push_back(&f.reversed);  // the rest is not beyond it
    }
    beyond_.resize(before);
    return all;
  }

  std::deque<std::vector<Facet>> cones_;
  std::vector<Barrier> beyond_;
};

}  // namespace

bool cover_space(const std::vector<TangentCone>& cones) { return Covering(cones).run(); }

}  // namespace fathom::unions
