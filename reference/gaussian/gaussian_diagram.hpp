// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the two bodies something belongs to.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernels/id.hpp"
#include "kernels/messages.hpp"
#include "kernels/predicates/direction.hpp"
#include "kernels/predicates/perturbed_kernel.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::gaussian {

/// Colour a is the diagram of -A, colour b that of B.
enum class Colour : std::uint8_t { a, b };

inline constexpr std::array both_colours{Colour::a, Colour::b};

constexpr Colour other(Colour c) { return c == Colour::a ? Colour::b : Colour::a; }

/// What exists once for each colour.
template <class T>
struct PerColour {
  T a, b;

  [[nodiscard]] T& operator[](Colour c) { return c == Colour::a ? a : b; }
  [[nodiscard]] const T& operator[](Colour c) const { return c == Colour::a ? a : b; }
};

// Input   a convex polytope of rank 0 to 3.
// Output  its Gaussian diagram, or that of its reflection through O: nodes are outward facet
//         normals, arcs are edges, faces are vertices. [AGHRS, section 2.2, "Computing F"]
// Size    linear.

/// Indices in a diagram. Node i is facet i of the polytope, arc i is edge i.
using NodeId = kernels::Id<struct NodeTag>;
using ArcId = kernels::Id<struct Arc>;
/// A face of the diagram is known by the polytope's vertex.
using polytope::VertexId;

/// The node of a facet, and the facet of a node; none of none.
constexpr NodeId node_of(polytope::FacetId facet) { return NodeId(facet.value); }
constexpr polytope::FacetId facet_of(NodeId node) { return polytope::FacetId(node.value); }

/// The edges of A and of B, where both meet: arc i of a diagram is edge i.
template <Colour c>
struct EdgeTag;
template <Colour c>
using EdgeOf = kernels::Id<EdgeTag<c>>;
using EdgeOfA = EdgeOf<Colour::a>;
using EdgeOfB = EdgeOf<Colour::b>;

/// The arc of an edge, from node `from` to node `to`, shorter than pi for rank 3: the normals of
/// the planes that support the body at the edge. `circle` is normal to its great circle, a positive
/// multiple of from x to. Rank 2: a half-circle, from = 0 and to = 1 antipodal; the order of its
/// interior is that of rank 3 in the limit: it passes through circle x from. Rank 1: a full circle,
/// no nodes: both are none.
struct Arc {
  kernels::Direction circle;
  NodeId from, to;
  /// The faces beside the arc, as vertices: `above` where <u,circle> > 0, `below` where < 0.
  VertexId above, below;
};

struct GaussianDiagram {
  int rank = 0;
  kernels::IdVector<NodeId, kernels::Direction> nodes;
  kernels::IdVector<ArcId, Arc> arcs;
};

/// The diagram of the polytope itself: what B contributes.
GaussianDiagram gaussian_diagram(const polytope::Polytope& polytope);

/// The diagram of -polytope: what A contributes. Node i is the negated normal of facet i, face i
/// the vertex i, negated.
GaussianDiagram gaussian_diagram_of_reflection(const polytope::Polytope& polytope);

/// Checks every node against its facet, the orientation of every arc, that both faces beside an arc
/// are equally extreme at its ends, that the arcs around each face close up, and V - E + F = 2 for
/// rank 3. O(n log n). `colour` tells which diagram of the polytope it should be.
[[nodiscard]] kernels::Report validate(const GaussianDiagram& diagram, const polytope::Polytope& polytope,
                                       Colour colour);

// Whether two arcs cross, decided on the sphere from the two arcs alone: the yardstick for
// everything that finds crossings faster.

/// The signs s for which s (e.circle x f.circle) is a strict crossing: a transversal one, in the
/// interior of both arcs. At most one sign, except for two full circles. With n_i the ends of e,
/// (n1 x n2) x f.circle = n2 <n1,f.circle> - n1 <n2,f.circle> tells which of the two antipodal
/// points of the great circles e meets.
std::vector<kernels::Sign> strict_crossings(const kernels::UnperturbedKernel& kernel, const GaussianDiagram& of_e,
                                            const Arc& e, const GaussianDiagram& of_f, const Arc& f);

/// The same for the perturbed arcs, where every crossing is strict.
std::vector<kernels::Sign> perturbed_crossings(const kernels::PerturbedKernel& kernel, const GaussianDiagram& of_e,
                                               const Arc& e, const GaussianDiagram& of_f, const Arc& f);

/// Whether the closed arc contains u, a direction on its great circle.
bool contains(const GaussianDiagram& diagram, const Arc& arc, const Vector& u);

/// Whether the closed arcs have a point in common. True for arcs of one great circle only if an end
/// of one lies on the other.
bool touch(const GaussianDiagram& of_e, const Arc& e, const GaussianDiagram& of_f, const Arc& f);

}  // namespace fathom::gaussian
