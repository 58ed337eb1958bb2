// SPDX-License-Identifier: GPL-3.0-or-later
// The ways of degrade.hpp, each on a pair of bodies. Not a door: the door is degrade.hpp.
#pragma once

#include "verify/families/solids.hpp"

namespace fathom::families {

using Way = void (*)(Bodies& bodies, Random& random);

// Points, degrade_points.cpp.
void duplicate_points(Bodies& bodies, Random& random);
void collinear_points(Bodies& bodies, Random& random);
void coplanar_points(Bodies& bodies, Random& random);
void flattened_body(Bodies& bodies, Random& random);
void identical_bodies(Bodies& bodies, Random& random);
void tie_by_reflection(Bodies& bodies, Random& random);
void touching_translation(Bodies& bodies, Random& random);
void snapped_to_lattice(Bodies& bodies, Random& random);

// Features of both bodies, and features on the sphere of directions, degrade_features.cpp.
void shared_vertex(Bodies& bodies, Random& random);
void shared_edge_direction(Bodies& bodies, Random& random);
void shared_facet_normal(Bodies& bodies, Random& random);
void opposite_facet_normals(Bodies& bodies, Random& random);
void coplanar_facets(Bodies& bodies, Random& random);
void axis_aligned_facet(Bodies& bodies, Random& random);
void normal_at_pole(Bodies& bodies, Random& random);
void normal_on_equator(Bodies& bodies, Random& random);
void arc_on_equator(Bodies& bodies, Random& random);
void vertical_edge(Bodies& bodies, Random& random);
void nodes_on_one_vertical(Bodies& bodies, Random& random);
void normal_on_arc(Bodies& bodies, Random& random);

}  // namespace fathom::families
