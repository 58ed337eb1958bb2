// SPDX-License-Identifier: GPL-3.0-or-later
// Breaks general position on purpose, in one named way at a time: makes any pair of bodies
// degenerate and keeps its looks. Features are made to coincide by exact linear maps, as close to
// the identity as possible.                                                        [docs/golden.md]
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "fathom/files.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {

/// In the chart, z = (0, 0, 1) is the pole and v = (0, 1, 0) the vertical. The diagrams are those
/// of B and of -A.
enum class Degradation {
  duplicate_points,        ///< some points are given again
  collinear_points,        ///< each body gets points inside its edges
  coplanar_points,         ///< each body gets a facet with four corners or more, and a point inside it
  shared_vertex,           ///< a vertex of A is a vertex of B
  shared_edge_direction,   ///< an edge of A is parallel to an edge of B
  shared_facet_normal,     ///< a facet of A and one of B have the same outward normal
  opposite_facet_normals,  ///< a facet of A and one of B have opposite normals: a common node of the two diagrams
  coplanar_facets,         ///< a facet of A and one of B lie in one plane, on the same side of it
  axis_aligned_facet,      ///< each body has a facet with a coordinate axis as its normal
  normal_at_pole,          ///< each body has a facet with the normal z or -z
  normal_on_equator,       ///< each body has a facet whose normal has z = 0
  arc_on_equator,          ///< each body has an edge parallel to z
  vertical_edge,  ///< each body has an edge with y = 0 in its direction: the arc's circle passes through the vertical v
  nodes_on_one_vertical,  ///< a node of each diagram on one great circle through v
  normal_on_arc,          ///< a node of -A in the middle of an arc of B
  flattened_body,         ///< A, B or both are projected into the plane of one of their facets
  identical_bodies,       ///< B = A
  tie_by_reflection,      ///< both bodies are made symmetric about O: every optimum has an opposite one
  touching_translation,   ///< A is moved by its exact translation: the bodies touch
  snapped_to_lattice,     ///< coordinates are rounded to a grid of 4 to 16 steps across the pair
};

struct DegradationName {
  Degradation way;
  std::string_view name;         ///< letters and underscores, as above
  std::string_view description;  ///< one line
};

/// All ways, in the order of the enumeration.
std::span<const DegradationName> degradations();

/// Returns `generic`, degraded in this way, with the id "<id>-<name>". The result is the same on
/// every machine. If there is a choice of features to coincide, the seed makes it. A body that
/// lacks the feature (a point has no edge) stays as it is. Bodies must not be empty.
Case degrade(const Case& generic, Degradation way, std::uint64_t seed);

// Almost degenerate pairs: a degenerate pair whose points are each moved by at most 2^-k.
//                                                                                  [docs/golden.md]

/// Moves every point of both bodies by its own displacement: three random multiples of 2^-(k+20),
/// each at most 2^-k in size. As k grows, the pair tends to `degenerate`, but all coincidences are
/// gone: parallel edges, coplanar points, ties, touching, flatness. Exact, and the same on every
/// machine. The id is "<id>-k<k>-s<seed>".
Case approach(const Case& degenerate, unsigned k, std::uint64_t seed);

// The catalogue, the degradations and the approach to them, as families.

/// An entry of the catalogue; the size is ignored.
Bodies from_catalogue(Random& random, unsigned n);

/// An entry of the catalogue with at most 16 points a body, each point moved by at most 2^-k, 4 <=
/// k <= 200; the size is ignored.
Bodies approaching_catalogue(Random& random, unsigned n);

/// random_sphere with at least 4 points, degraded in this way.
Bodies degraded(Degradation way, Random& random, unsigned n);

/// A pair of spheres of points, degraded in a random way, then each point moved by at most 2^-k, 4
/// <= k <= 200.
Bodies approaching_degraded(Random& random, unsigned n);

}  // namespace fathom::families
