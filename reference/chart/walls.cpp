// SPDX-License-Identifier: GPL-3.0-or-later
// Abscissae in binary64 propose an order, and the predicate decides: it sorts each group of walls that lie close together, then checks all
// neighbours. If it finds any in the wrong order, it sorts all walls.
#include "reference/chart/walls.hpp"

#include <algorithm>
#include <cmath>

namespace fathom::chart {
namespace {

struct Candidate {
  double x;
  Wall wall;
};

std::vector<Candidate> candidates(const Charts& charts) {
  std::vector<Candidate> result;
  const Vec3<double> v = kernels::image(charts.frame.v), z = kernels::image(charts.frame.z), right = cross(v, z);
  for (const gaussian::Colour c : gaussian::both_colours) {
    const ColourChart& chart = charts.of[c];
    for (const gaussian::NodeId i : chart.wall_of.ids()) {
      if (chart.wall_of[i].is_none()) continue;
      const Vec3<double> n = kernels::image(chart.node(i));
      const double x = dot(n, right) / dot(n, z);
      result.push_back({std::isnan(x) ? 0 : x, {c, i}});
    }
  }
  return result;
}

bool close_together(double x, double y) { return !(std::abs(y - x) > 0x1p-40 * (1 + std::abs(x))); }

}  // namespace

void raise_walls(const kernels::PerturbedKernel& kernel, Charts& charts) {
  const auto left_of = [&](const Candidate& s, const Candidate& t) {
    return s.wall != t.wall && kernel.x_order(charts.node(s.wall), charts.node(t.wall), charts.frame.v) == kernels::Sign::positive;
  };
  std::vector<Candidate> all = candidates(charts);
  std::ranges::sort(all, {}, &Candidate::x);
  for (auto first = all.begin(); first != all.end();) {
    auto last = first + 1;
    while (last != all.end() && close_together(std::prev(last)->x, last->x)) ++last;
    std::sort(first, last, left_of);
    first = last;
  }
  if (!std::ranges::is_sorted(all, left_of)) std::ranges::sort(all, left_of);
  charts.walls.reserve(all.size());
  for (const Candidate& c : all) {
    charts.of[c.wall.colour].wall_of[c.wall.node] = WallId(static_cast<std::uint32_t>(charts.walls.size()));
    charts.walls.push_back(c.wall);
  }
}

}  // namespace fathom::chart
