// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/families/degrade.hpp"

#include <iterator>
#include <string>

#include "verify/families/degrade_ways.hpp"

namespace fathom::families {

namespace {

constexpr DegradationName names[] = {
    {Degradation::duplicate_points, "duplicate_points", "some points are given again"},
    {Degradation::collinear_points, "collinear_points", "points inside edges"},
    {Degradation::coplanar_points, "coplanar_points", "a facet with four corners or more, and a point inside it"},
    {Degradation::shared_vertex, "shared_vertex", "a vertex of A is a vertex of B"},
    {Degradation::shared_edge_direction, "shared_edge_direction", "an edge of A is parallel to an edge of B"},
    {Degradation::shared_facet_normal, "shared_facet_normal", "a facet of A and one of B have the same normal"},
    {Degradation::opposite_facet_normals, "opposite_facet_normals", "a facet of A and one of B have opposite normals"},
    {Degradation::coplanar_facets, "coplanar_facets", "a facet of A and one of B lie in one plane, on the same side of it"},
    {Degradation::axis_aligned_facet, "axis_aligned_facet", "each body has a facet across a coordinate axis"},
    {Degradation::normal_at_pole, "normal_at_pole", "each body has a facet with the normal (0, 0, 1) or (0, 0, -1)"},
    {Degradation::normal_on_equator, "normal_on_equator", "each body has a facet whose normal has z = 0"},
    {Degradation::arc_on_equator, "arc_on_equator", "each body has an edge parallel to the z-axis"},
    {Degradation::vertical_edge, "vertical_edge", "each body has an edge with y = 0 in its direction: its arc stands upright in the chart"},
    {Degradation::nodes_on_one_vertical, "nodes_on_one_vertical", "a node of each Gaussian diagram on one vertical of the chart"},
    {Degradation::normal_on_arc, "normal_on_arc", "a node of -A in the middle of an arc of B"},
    {Degradation::flattened_body, "flattened_body", "A, B or both are projected into the plane of a facet"},
    {Degradation::identical_bodies, "identical_bodies", "B = A"},
    {Degradation::tie_by_reflection, "tie_by_reflection", "both bodies are symmetric about O: every optimum has an opposite one"},
    {Degradation::touching_translation, "touching_translation", "A is moved by its exact translation: the bodies touch"},
    {Degradation::snapped_to_lattice, "snapped_to_lattice", "coordinates are rounded to a coarse grid"},
};

/// In the order of the enumeration.
constexpr Way ways[] = {
    duplicate_points,    collinear_points,       coplanar_points,   shared_vertex,         shared_edge_direction,
    shared_facet_normal, opposite_facet_normals, coplanar_facets,   axis_aligned_facet,    normal_at_pole,
    normal_on_equator,   arc_on_equator,         vertical_edge,     nodes_on_one_vertical, normal_on_arc,
    flattened_body,      identical_bodies,       tie_by_reflection, touching_translation,  snapped_to_lattice,
};
static_assert(std::size(ways) == std::size(names));

}  // namespace

std::span<const DegradationName> degradations() { return names; }

Case degrade(const Case& generic, Degradation way, std::uint64_t seed) {
  Random random(seed);
  Bodies bodies{generic.a, generic.b};
  const auto index = static_cast<std::size_t>(way);
  ways[index](bodies, random);
  return {generic.id + "-" + std::string(names[index].name), std::move(bodies.a), std::move(bodies.b)};
}

}  // namespace fathom::families
