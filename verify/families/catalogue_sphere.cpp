// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs that are degenerate for the charts alone: the decomposition looks at directions from the pole z = (0, 0, 1), splits the sphere at
// the equator z = 0, and sweeps along the vertical v = (0, 1, 0). Turned by any other rotation they are harmless.
#include "verify/families/catalogue_groups.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {

namespace {

constexpr std::string_view off_equator = "no direction on the equator", one_each = "at most one node on a vertical",
                           off_arcs = "no normal of one body on an arc of the other", off_poles = "no normal at a pole of the chart";

Known deep(std::size_t optima, std::optional<ContactKind> kind = std::nullopt) { return {Status::penetrating, optima, kind}; }

/// Twelve rhombs with the normals (+-1, +-1, 0) and permutations.
Body rhombic_dodecahedron() {
  Body body = cube();
  for (const Point& corner : scaled(octahedron(), 2).points) body.points.push_back(corner);
  return body;
}

/// No two edges parallel, no coordinate of an edge or a normal zero.
Body generic_tetrahedron() { return {{{3, 1, 2}, {-2, 4, 1}, {-1, -3, 3}, {1, 2, -4}}}; }

}  // namespace

Entries sphere_entries() {
  using enum ContactKind;
  return {
      entry("normals_at_the_poles", off_poles, "two pyramids with horizontal bases, one facing up and one down", deep(1, facet_facet),
            {{{3, 1, -1}, {-2, 4, -1}, {-1, -3, -1}, {1, 1, 4}}}, {{{2, 3, 2}, {-4, 1, 2}, {1, -3, 2}, {1, 2, -3}}}),
      entry("normals_at_the_vertical", "no normal at the vertical", "the bases of two pyramids have the normals (0, -1, 0) and (0, 1, 0)",
            deep(1, facet_facet), {{{3, -1, 1}, {-2, -1, 4}, {-1, -1, -3}, {1, 4, 1}}}, {{{2, 2, 3}, {-4, 2, 1}, {1, 2, -3}, {1, -3, 2}}}),
      entry("normals_on_the_equator", off_equator, "each body has a facet whose normal has z = 0, and no vertical edge", deep(1, edge_edge),
            {{{0, 0, 0}, {0, 2, 1}, {0, 1, 3}, {3, 1, 1}}}, {{{2, 0, 1}, {0, 2, 0}, {1, 1, 3}, {-1, -2, 2}}}),
      entry("arcs_on_the_equator", off_equator, "each body has one vertical edge: its arc lies on the equator", deep(1, edge_facet),
            {{{0, 0, -2}, {0, 0, 2}, {4, 3, 1}, {3, -4, -1}}}, {{{2, 0, -3}, {2, 0, 3}, {-2, 1, 2}, {-1, -3, 1}}}),
      entry("arcs_through_the_vertical", one_each, "each body has an edge with y = 0 in its direction: its arc stands upright in the chart",
            deep(1, vertex_facet), {{{0, 1, 0}, {3, 1, 2}, {1, -2, 4}, {2, 4, 3}}}, {{{1, 0, 1}, {4, 0, -1}, {2, 3, 2}, {2, -1, 4}}}),
      entry("nodes_on_one_vertical", one_each, "B has the normal (1, -1, 3) and -A the normal (1, 2, 3): the same x in the chart",
            deep(1, vertex_facet), {{{1, 1, -1}, {-2, 1, 0}, {3, 0, -1}, {1, 1, 3}}}, {{{1, 1, 0}, {0, 3, 1}, {3, 0, -1}, {0, 0, -4}}}),
      entry("nodes_all_on_one_vertical", one_each, "a prism along x: its ring of normals stands on one vertical", deep(1, vertex_facet),
            {{{0, 0, 1}, {0, 1, -1}, {0, -1, -2}, {3, 0, 1}, {3, 1, -1}, {3, -1, -2}}}, generic_tetrahedron()),
      entry("normals_on_arcs", off_arcs, "a cube against a rhombic dodecahedron: its normals lie in the middle of the cube's arcs",
            deep(12, facet_edge), rhombic_dodecahedron(), cube()),
      entry("arcs_bisect_arcs", "no crossing at a symmetric place", "a cube against an octahedron: their arcs bisect each other",
            deep(6, facet_vertex), cube(), octahedron()),
      entry("crossings_on_the_equator", off_equator, "an octahedron's edge along (1, -1, 0) and one along (1, -1, 1) meet at (1, 1, 0)",
            deep(1, facet_vertex), {{{-2, 0, -1}, {-1, -1, 0}, {2, 1, 1}, {1, 2, -2}, {1, 1, 2}}}, scaled(octahedron(), 2)),
      entry("poles_of_both", off_poles, "antiprisms on one axis: normals at both poles, all else in general position", deep(2, facet_facet),
            antiprism(3, 1), scaled(antiprism(5, 1), 1, 1, ratio(1, 2))),
      entry("great_circle_of_arcs", "no arcs on one great circle", "a prism whose edges give arcs all around one tilted great circle",
            deep(1, facet_vertex), {{{0, 0, 0}, {3, 1, 0}, {1, 3, 0}, {1, 1, 4}, {4, 2, 4}, {2, 4, 4}}},
            translated(generic_tetrahedron(), {1, 1, 1})),
  };
}

}  // namespace fathom::families
