// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the Gaussian diagrams of -A and of B.
// Output  the charts of one hemisphere: both diagrams, perturbed, projected centrally to a plane,
//         where arcs are segments, rays and lines, and the walls through their endpoints.
//                                                               [AGHRS, section 2.2, "Computing F"]
// Departs from the paper: arcs are not cut at the equator. An arc that crosses it is a ray in
// either chart, because <v,z> = 0 puts the
//         equator at x = -infinity and x = +infinity.
#pragma once

#include "kernels/context.hpp"
#include "kernels/messages.hpp"
#include "kernels/predicates/direction.hpp"
#include "kernels/predicates/perturbed_kernel.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"

namespace fathom::chart {

enum class Hemisphere : std::uint8_t { upper, lower };

inline constexpr std::array both_hemispheres{Hemisphere::upper, Hemisphere::lower};

/// The pole z of a hemisphere and the upward direction v of its chart, <v,z> = 0.
struct Frame {
  kernels::Direction v, z;
};

/// v = (0,1,0) and z = (0,0,1), or (0,0,-1) for the lower hemisphere; tilted infinitesimally by the
/// perturbation.
Frame chart_frame(Hemisphere hemisphere);

/// Indices in a chart. The arcs of one colour are numbered in height order: where two overlap in an
/// x-interval, the higher one has the greater index. Walls are numbered from left to right.
using ChartArcId = kernels::Id<struct ChartArc>;
using WallId = kernels::Id<struct Wall>;

/// The chart arcs of A and of B, where both meet.
template <gaussian::Colour c>
struct ChartArcTag;
template <gaussian::Colour c>
using ChartArcOf = kernels::Id<ChartArcTag<c>>;
using ChartArcOfA = ChartArcOf<gaussian::Colour::a>;
using ChartArcOfB = ChartArcOf<gaussian::Colour::b>;

/// The end of a chart arc that has no node.
inline constexpr gaussian::NodeId at_infinity = gaussian::NodeId::none();

/// The part of an arc in this hemisphere, oriented from left to right.
struct ChartArc {
  gaussian::ArcId arc;           ///< the whole arc
  gaussian::NodeId left, right;  ///< or at_infinity
  bool flipped;                  ///< <circle,v> < 0: above and below change places
  /// For each end: the other colour's arcs over its abscissa, or over the same infinity, pass below
  /// the end if their index is below this height, and above it otherwise.
  ChartArcId left_height, right_height;
};

/// Of the arc's circle: positive if it points upward.
constexpr kernels::Sign orientation(const ChartArc& arc) {
  return arc.flipped ? kernels::Sign::negative : kernels::Sign::positive;
}

/// Where a node lies among the arcs of the other colour.
struct NodePlace {
  /// Arcs over the node pass below it if their index is below `height`, and above it otherwise.
  ChartArcId height;
  /// The vertex whose face holds the node.
  gaussian::VertexId face;
};

/// The vertical through a node.
struct Wall {
  gaussian::Colour colour;
  gaussian::NodeId node;
  friend bool operator==(const Wall&, const Wall&) = default;
};

/// The chart of one diagram, and its relation to the other one.
struct ColourChart {
  const gaussian::GaussianDiagram* diagram = nullptr;
  kernels::IdVector<ChartArcId, ChartArc> arcs;
  /// The image of each arc's circle, oriented upward. Searches read these.
  kernels::IdVector<ChartArcId, Vec3<double>> circles;
  /// The wall of each node, or none if the node lies in the other hemisphere.
  kernels::IdVector<gaussian::NodeId, WallId> wall_of;
  /// The place of each node of this hemisphere in the other diagram.
  kernels::IdVector<gaussian::NodeId, NodePlace> place_of;

  [[nodiscard]] const kernels::Direction& node(gaussian::NodeId i) const { return diagram->nodes[i]; }
  [[nodiscard]] const kernels::Direction& circle(const ChartArc& arc) const { return diagram->arcs[arc.arc].circle; }
  /// The vertex whose face lies right above, or right below, the arc in this chart.
  [[nodiscard]] gaussian::VertexId vertex_above(const ChartArc& arc) const;
  [[nodiscard]] gaussian::VertexId vertex_below(const ChartArc& arc) const;
};

/// Charts of both colours over one frame. No two nodes share an abscissa, no node lies on an arc of
/// the other colour or on the equator, and no arc lies on a vertical: the perturbation separates
/// whatever coincides on the input.
struct Charts {
  kernels::Perturbation perturbation;
  Frame frame;
  gaussian::PerColour<ColourChart> of;
  /// The walls of all nodes in this hemisphere, of both colours. Both segment trees stand on them.
  kernels::IdVector<WallId, Wall> walls;

  [[nodiscard]] const kernels::Direction& node(const Wall& wall) const { return of[wall.colour].node(wall.node); }
};

/// The diagrams must outlive the charts. O((m + n) log(m + n)): walls are sorted, and nodes are
/// located by a plane sweep.
Charts make_charts(kernels::Context& context, const gaussian::GaussianDiagram& minus_a,
                   const gaussian::GaussianDiagram& b, const Frame& frame,
                   const kernels::Perturbation& perturbation = {});

/// Checks the order of neighbouring walls, the orientation and the ends of every arc, and at each
/// face that the arcs below it come before those above it; then the arcs are in height order
/// [proofs/chart.md]. Linear. The validate of vertex_facet checks the places.
[[nodiscard]] kernels::Report validate(const Charts& charts);

// What searches ask about the nodes and arcs of a chart: the predicates of kernels/ with the arcs
// oriented from left to right. No answer is zero.

/// Positive: the node lies above the line of the arc. Not for an end of the arc.
kernels::Sign node_above_arc(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour of_node,
                             gaussian::NodeId node, gaussian::Colour of_arc, const ChartArc& arc);
/// Positive: arc e lies above arc f on the wall.
kernels::Sign above_on_wall(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour of_e,
                            const ChartArc& e, gaussian::Colour of_f, const ChartArc& f, const Wall& wall);
/// Positive: arc e lies above arc f far to the left.
kernels::Sign above_far_left(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour of_e,
                             const ChartArc& e, gaussian::Colour of_f, const ChartArc& f);
/// Positive: e lies above f over their common x-range. Both are arcs of one colour whose x-ranges
/// overlap in more than a point: they do not cross, so the later of the left ends decides; if they
/// share it, the earlier of the right ends.                              [degree 3, no wall needed]
kernels::Sign above_same_colour(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour colour,
                                const ChartArc& e, const ChartArc& f);

}  // namespace fathom::chart
