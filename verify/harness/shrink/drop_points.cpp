// SPDX-License-Identifier: GPL-3.0-or-later
// Delta debugging of the points (Zeller and Hildebrandt 2002: ddmin, its complements only).
#include <algorithm>
#include <utility>

#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "verify/harness/shrink/passes.hpp"

namespace fathom::harness {
namespace {

std::vector<Point> extreme(const std::vector<Point>& points) {
  const polytope::Polytope hull = polytope::convex_hull(polytope::place(points, points).a.points());
  std::vector<Point> result;
  for (const std::uint32_t id : hull.input_ids) result.push_back(points[id]);
  return result;
}

void drop_inner(Search& search) {
  const Case before = search.best();
  Case both = before;
  both.a.points = extreme(before.a.points);
  both.b.points = extreme(before.b.points);
  if (search.offer(both)) return;
  search.offer({before.id, both.a, before.b});
  search.offer({before.id, before.a, both.b});
}

/// One sweep over the chunks of this length. True: some were dropped.
bool drop_chunks(Search& search, Body Case::*body, std::size_t length) {
  bool dropped = false;
  std::size_t begin = 0;
  while (begin < (search.best().*body).points.size() && !search.over()) {
    Case candidate = search.best();
    std::vector<Point>& points = (candidate.*body).points.edit();
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(begin);
    points.erase(first, first + static_cast<std::ptrdiff_t>(std::min(length, points.size() - begin)));
    if (search.offer(std::move(candidate))) dropped = true;
    else begin += length;
  }
  return dropped;
}

void drop_by_halves(Search& search, Body Case::*body) {
  std::size_t length = ((search.best().*body).points.size() + 1) / 2;
  while (length > 0 && !search.over()) {
    const bool dropped = drop_chunks(search, body, length);
    if (length == 1 && !dropped) return;
    length = length == 1 ? 1 : (length + 1) / 2;
  }
}

}  // namespace

void drop_points(Search& search) {
  drop_inner(search);
  drop_by_halves(search, &Case::a);
  drop_by_halves(search, &Case::b);
}

}  // namespace fathom::harness
