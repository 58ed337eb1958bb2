// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two finite point sets with rational coordinates; each stands for its convex hull.
// Output  what is degenerate about the pair: how often each predicate of the exact method met an exact zero, and what decided then; and
//         the coincidences of the bodies by name, with the features involved.                                    [docs/command_line.md]
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/counters.hpp"
#include "fathom/depth.hpp"
#include "fathom/monitor.hpp"
#include "fathom/point.hpp"

namespace fathom {

/// What can coincide, or lie specially in the frame. "Nodes" and "arcs" are those of the Gaussian diagrams of -A and of B: a node is a
/// facet's normal (negated for A), an arc an edge. The equator is z = 0, a vertical a half of a great circle through (0, 1, 0): the frame
/// before it is tilted.
enum class Coincidence {
  parallel_edges,         ///< an edge of A and an edge of B
  parallel_edges_of_a,    ///< two edges of A
  parallel_edges_of_b,    ///< two edges of B
  coincident_normals,     ///< facets of A and B with opposite outward normals: one node in both diagrams
  equal_normals,          ///< facets of A and B with the same outward normal
  coplanar_facets,        ///< those of the two kinds above that lie in one plane
  normals_on_arcs,        ///< a node of one diagram inside an arc of the other: a facet of one body, an edge of the other
  nodes_on_equator,       ///< a facet of A or B
  arcs_on_equator,        ///< an edge of A or B, parallel to the z-axis
  crossings_on_equator,   ///< edges of A and B whose arcs cross there, inside both and not in one great circle
  nodes_on_one_vertical,  ///< two facets of either body, coincident normals included; not those on the equator
  arcs_on_verticals,      ///< an edge of A or B, with y constant along it
  touching_features,      ///< of touching bodies: the faces in the direction that proves the touch
  ties,                   ///< the contacts of all optima, if there is more than one
  count
};

inline constexpr std::array<std::string_view, static_cast<std::size_t>(Coincidence::count)> coincidence_names{
    "parallel_edges",        "parallel_edges_of_a",
    "parallel_edges_of_b",   "coincident_normals",
    "equal_normals",         "coplanar_facets",
    "normals_on_arcs",       "nodes_on_equator",
    "arcs_on_equator",       "crossings_on_equator",
    "nodes_on_one_vertical", "arcs_on_verticals",
    "touching_features",     "ties"};

/// A vertex, an edge or a facet: ascending 0-based indices of the input points that span it, extreme points only, of equal points the
/// lowest index.
using Feature = std::vector<std::uint32_t>;

/// The features that take part in one coincidence: one, or two of one body or of both.
struct Involved {
  std::vector<Feature> a, b;
  friend bool operator==(const Involved&, const Involved&) = default;
};

/// All coincidences of one kind.
struct Coincidences {
  std::uint64_t count = 0;
  std::vector<Involved> listed;  ///< the first of them, as many as were asked for
};

/// How large a body's convex hull is.
struct BodySize {
  int rank = 0;  ///< dimension of the body: 0 a point, 1 a segment, 2 flat, 3
  std::uint64_t vertices = 0, edges = 0, facets = 0;
};

/// What is degenerate about two bodies, and their depth.
struct Study {
  Depth depth;
  BodySize a, b;
  /// Of the exact method's run. If the bodies do not penetrate, of its topological part alone: charts, vertex-facet pairs, canonical
  /// subsets.
  PredicateCounts predicates{};
  std::array<Coincidences, static_cast<std::size_t>(Coincidence::count)> coincidences;

  [[nodiscard]] const Coincidences& operator[](Coincidence kind) const { return coincidences[static_cast<std::size_t>(kind)]; }
};

/// How much to list, and who watches.
struct StudyOptions {
  std::size_t listed = 20;     ///< the most coincidences of a kind that are listed; counts are always complete
  Monitor* monitor = nullptr;  ///< hears of progress and may stop the work; may be null
};

/// Finds what is degenerate about two bodies. Exact, for bodies of every rank. Near-linear in the size of the bodies, except for
/// normals_on_arcs and arcs_on_equator, which look at all pairs, and for the depth itself. Throws as penetration_depth does.
Study study(std::span<const Point> a, std::span<const Point> b, const StudyOptions& options = {});

/// What a key of TierCounts::decided stands for: "1", "a", "E11 b^2". Eij is an entry of the matrix that moves -A; a, b, c tilt the frame.
///                                                                                                              [proofs/perturbation.md]
std::string monomial_name(std::uint64_t monomial);

}  // namespace fathom
