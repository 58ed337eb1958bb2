// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs with features in common: identical and mirrored bodies, parallel edges, common normals, prisms on one axis, ties by the dozen.
#include <array>

#include "verify/families/catalogue_groups.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {

namespace {

constexpr std::string_view distinct = "the bodies share no features", edges_cross = "no parallel edges", one_nearest = "one nearest facet";

Known deep(std::size_t optima, std::optional<ContactKind> kind = std::nullopt) { return {Status::penetrating, optima, kind}; }

CatalogueEntry identical_entry(std::string_view name, std::string_view description, const Known& known, const Body& body) {
  return entry(name, distinct, description, known, body, body);
}

/// All integer points of {0..side}^3, x fastest.
Body grid(int side) {
  Body body;
  for (int z = 0; z <= side; ++z)
    for (int y = 0; y <= side; ++y)
      for (int x = 0; x <= side; ++x) body.points.push_back({x, y, z});
  return body;
}

/// The permutations of (0, +-1, +-2): six squares and eight hexagons.
Body truncated_octahedron() {
  Body body;
  for (const int one : {-1, 1})
    for (const int two : {-2, 2})
      for (const Point& p :
           {Point{0, one, two}, Point{0, two, one}, Point{one, 0, two}, Point{two, 0, one}, Point{one, two, 0}, Point{two, one, 0}})
        body.points.push_back(p);
  return body;
}

/// The prism along z over a polygon.
Body prism_over(const std::vector<std::array<int, 2>>& polygon, int low, int high) {
  Body body;
  for (const int z : {low, high})
    for (const auto& [x, y] : polygon) body.points.push_back({x, y, z});
  return body;
}

}  // namespace

Entries shared_entries() {
  using enum ContactKind;
  const Body unit = block({0, 0, 0}, {1, 1, 1}), two = block({0, 0, 0}, {2, 2, 2});
  const Body square = prism_over({{2, 2}, {-2, 2}, {-2, -2}, {2, -2}}, -3, 3),
             diamond = prism_over({{3, 0}, {0, 3}, {-3, 0}, {0, -3}}, -2, 4);
  const Body triangle = prism_over({{3, 0}, {-2, 2}, {-2, -2}}, -3, 3);
  return {
      identical_entry("identical_cubes", "{0,1}^3 against itself: its width, in six directions", deep(6, facet_facet), unit),
      identical_entry("identical_tetrahedra", "a regular tetrahedron against itself: its width, between opposite edges", deep(6, edge_edge),
                      tetrahedron()),
      identical_entry("identical_octahedra", "an octahedron against itself: its width, between opposite facets", deep(8, facet_facet),
                      octahedron()),
      identical_entry("identical_points", "a point against itself", touches, {{{1, 2, 3}}}),
      identical_entry("identical_segments", "a segment against itself", touches, {{{0, 0, 0}, {1, 2, 3}}}),
      identical_entry("identical_polygons", "a square against itself", touches, {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}}),
      entry("mirrored_tetrahedra", distinct, "B = -A: all nodes and arcs of the two Gaussian diagrams coincide", deep(4, facet_facet),
            tetrahedron(), scaled(tetrahedron(), -1)),
      entry("nested_cubes", one_nearest, "a cube in the centre of a larger one: six nearest facets", deep(6, facet_facet), cube(),
            box(2, 2, 2)),
      entry("nested_cubes_corner", distinct, "a cube in the corner of a larger one: three pairs of coplanar facets, one common vertex",
            deep(3, facet_facet), unit, two),
      entry("lattice_grids", one_nearest, "{0..3}^3, all 64 points, against itself moved by (2, 2, 2): three nearest facets",
            deep(3, facet_facet), grid(3), translated(grid(3), {2, 2, 2})),
      entry("lattice_grids_two", one_nearest, "{0..2}^3, all 27 points, against itself moved by (1, 1, 0)", deep(2, facet_facet), grid(2),
            translated(grid(2), {1, 1, 0})),
      identical_entry("lattice_truncated_octahedra", "a lattice polytope against itself: ties between opposite hexagons",
                      deep(8, facet_facet), truncated_octahedron()),
      entry("parallel_edges", edges_cross, "two triangular prisms with parallel axes, no other feature in common", deep(1, facet_edge),
            prism_over({{3, 0}, {-2, 3}, {-2, -1}}, -3, 3), translated(prism_over({{-3, 0}, {1, 4}, {3, -2}}, -2, 5), {2, 1, 0})),
      entry("parallel_edges_cubes", edges_cross, "cubes of different sizes along the axes: edges of all three directions are parallel",
            deep(1, facet_facet), unit, block({ratio(1, 2), ratio(1, 3), ratio(1, 4)}, {2, 3, 4})),
      entry("prisms_on_common_axis", distinct, "a square prism and a diamond prism around the same axis", deep(4, edge_facet), square,
            diamond),
      entry("prisms_on_common_axis_identical", distinct, "a triangular prism against itself", deep(4), triangle, triangle),
      entry("common_facet_normals", "no shared facet normals", "pyramids upright over parallel bases: the bases face the same way", deep(2),
            {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 5}}}, {{{0, 0, 1}, {3, 1, 1}, {1, 3, 1}, {2, 1, 4}}}),
      entry("opposite_facet_normals", "no shared facet normals", "two pyramids with their bases towards each other, a unit deep",
            deep(1, facet_facet), {{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {2, 2, 5}}}, {{{1, 0, 1}, {6, 1, 1}, {1, 6, 1}, {2, 1, -5}}}),
      entry("coplanar_facets", "no coplanar facets", "two pyramids with their bases in one plane, on the same side of it",
            deep(1, edge_edge), {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 5}}}, {{{1, 1, 0}, {5, 2, 0}, {2, 5, 0}, {2, 3, 4}}}),
  };
}

}  // namespace fathom::families
