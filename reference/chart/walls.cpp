// SPDX-License-Identifier: GPL-3.0-or-later
// Abscissae in binary64 propose an order, the predicate decides: it sorts each group of walls that lie close together, and then it is asked
// about all neighbours. If any of them were wrong, it would sort all.
#include "reference/chart/walls.hpp"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

struct Candidate {
  double x;
  Charts::Wall wall;
};

std::vector<Candidate> candidates(const Charts& charts) {
  std::vector<Candidate> result;
  const Vec3<double> v = image(charts.frame.v), z = image(charts.frame.z), right = cross(v, z);
  for (const Colour c : {Colour::a, Colour::b}) {
    const std::vector<std::uint32_t>& wall_of = charts.wall_of[static_cast<std::size_t>(c)];
    for (std::uint32_t i = 0; i < wall_of.size(); ++i) {
      if (wall_of[i] == at_infinity) continue;
      const Vec3<double> n = image(charts.node(c, i));
      const double x = dot(n, right) / dot(n, z);
      result.push_back({std::isnan(x) ? 0 : x, {c, i}});
    }
  }
  return result;
}

bool close_together(double x, double y) { return !(std::abs(y - x) > 0x1p-40 * (1 + std::abs(x))); }

}  // namespace

void raise_walls(const PerturbedKernel& kernel, Charts& charts) {
  const auto left_of = [&](const Candidate& s, const Candidate& t) {
    const bool same = s.wall.colour == t.wall.colour && s.wall.node == t.wall.node;
    return !same && kernel.x_order(charts.node(s.wall.colour, s.wall.node), charts.node(t.wall.colour, t.wall.node), charts.frame.v) ==
                        Sign::positive;
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
    charts.wall_of[static_cast<std::size_t>(c.wall.colour)][c.wall.node] = static_cast<std::uint32_t>(charts.walls.size());
    charts.walls.push_back(c.wall);
  }
}

}  // namespace fathom
