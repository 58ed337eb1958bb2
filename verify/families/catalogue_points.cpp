// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs whose input points are degenerate before any geometry begins, and pairs that are degenerate except for 2^-1000.
#include "verify/families/catalogue_groups.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {

namespace {

constexpr std::string_view extreme = "all points are extreme";

Known deep(std::size_t optima, std::optional<ContactKind> kind = std::nullopt) { return {Status::penetrating, optima, kind}; }

Body with(Body body, const std::vector<Point>& more) {
  std::vector<Point>& points = body.points.edit();
  points.insert(points.end(), more.begin(), more.end());
  return body;
}

mpq_class tiny() { return times_power_of_two(1, -1000); }

}  // namespace

Entries redundant_entries() {
  using enum ContactKind;
  const Body two = block({0, 0, 0}, {2, 2, 2}), other = block({1, ratio(1, 2), ratio(1, 3)}, {3, 3, 3});
  const Known third = deep(1, facet_facet);
  return {
      entry("duplicate_points", "points are distinct", "a cube with every corner given twice", third, with(two, two.points), other),
      entry("duplicate_points_both", "points are distinct", "two tetrahedra with repeated corners, the first ones last", deep(1, edge_edge),
            {{{0, 0, 3}, {0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {0, 0, 0}}},
            {{{2, 2, 3}, {1, 1, 1}, {-2, 1, 1}, {1, -3, 1}, {1, 1, 1}}}),
      entry("collinear_points", extreme, "a cube with points on its edges", third,
            with(two, {{1, 0, 0}, {0, 1, 0}, {2, 2, 1}, {0, ratio(1, 2), 0}}), other),
      entry("coplanar_points", extreme, "a cube with points in its facets", third,
            with(two, {{1, 1, 0}, {ratio(1, 2), 1, 0}, {0, 1, 1}, {1, 2, 1}}), other),
      entry("interior_points", extreme, "a cube with points in its interior, given first", third,
            with({{{1, 1, 1}, {ratio(1, 2), 1, 1}, {1, 1, 1}}}, two.points), other),
  };
}

Entries near_entries() {
  using enum ContactKind;
  const Body unit = block({0, 0, 0}, {1, 1, 1});
  const Body tip{{{0, 0, 0}, {-2, -2, 2}, {2, -2, 2}, {2, 2, 2}, {-2, 2, 2}}}, tip_below = scaled(tip, -1);
  const mpq_class above_one = 1 + tiny(), below_one = 1 - tiny();
  return {
      entry("nearly_touching_apart", "the bodies are clearly apart", "two cubes with a gap of 2^-1000", is_apart, unit,
            block({above_one, 0, 0}, {2, 1, 1})),
      entry("nearly_touching_deep", "the bodies overlap clearly", "two cubes 2^-1000 deep", deep(1, facet_facet), unit,
            block({below_one, 0, 0}, {2, 1, 1})),
      entry("nearly_touching_tips_apart", "the bodies are clearly apart", "the tips of two pyramids with a gap of 2^-1000", is_apart, tip,
            translated(tip_below, {0, 0, mpq_class(-tiny())})),
      entry("nearly_touching_tips_deep", "the bodies overlap clearly", "the tips of two pyramids, 2^-1000 deep", deep(4, facet_facet), tip,
            translated(tip_below, {0, 0, tiny()})),
      entry("nearly_tied", "ties are exact or clearly broken", "a cube in a cube, off its centre by 2^-1000 along one axis",
            deep(1, facet_facet), cube(), translated(box(2, 2, 2), {tiny(), 0, 0})),
      entry("nearly_identical", "the bodies share features or not", "a tetrahedron against itself with one corner moved by 2^-1000",
            deep(5, edge_edge), tetrahedron(), {{{above_one, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}}),
      entry("nearly_parallel_edges", "edges are parallel or not", "a prism along z and one whose axis leans by 2^-1000", deep(1, edge_edge),
            {{{0, 0, -2}, {4, 1, -2}, {1, 4, -2}, {0, 0, 2}, {4, 1, 2}, {1, 4, 2}}},
            {{{2, 3, -3},
              {3, -2, -3},
              {-2, 1, -3},
              {mpq_class(2 + tiny()), 3, 3},
              {mpq_class(3 + tiny()), -2, 3},
              {mpq_class(-2 + tiny()), 1, 3}}}),
      entry("nearly_flat", "bodies are flat or not", "a tetrahedron 2^-1000 thick in a cube", deep(1, vertex_facet),
            {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {ratio(1, 3), ratio(1, 3), tiny()}}}, block({-1, -2, ratio(-1, 4)}, {3, 3, 2})),
  };
}

}  // namespace fathom::families
