// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the Gaussian diagrams of -A and of B.
// Output  the charts of one hemisphere: both diagrams, perturbed, projected centrally to a plane, where arcs are segments, rays and lines,
//         and the walls through their endpoints.                                               [AGHRS, section 2.2, "Computing F"]
// Departs from the paper: arcs are not cut at the equator. An arc that crosses it is a ray in either chart, because <v,z> = 0 puts the
//         equator at x = -infinity and x = +infinity.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernels/context.hpp"
#include "kernels/filters/double_images.hpp"
#include "kernels/predicates/perturbed_kernel.hpp"
#include "kernels/report.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"

namespace fathom {

/// The pole z of a hemisphere and the upward direction v of its chart, <v,z> = 0.
struct Frame {
  Direction v, z;
};

/// v = (0,1,0) and z = (0,0,1), or (0,0,-1) for the lower hemisphere; tilted infinitesimally by the perturbation.
Frame chart_frame(bool lower);

/// Which body an arc or a node belongs to. Colour a is the diagram of -A.
enum class Colour : std::uint8_t { a, b };

constexpr Colour other(Colour c) { return c == Colour::a ? Colour::b : Colour::a; }

inline constexpr std::uint32_t at_infinity = UINT32_MAX;

/// The part of an arc in this hemisphere, oriented from left to right.
struct ChartArc {
  std::uint32_t arc;          ///< index in the diagram: the edge
  std::uint32_t left, right;  ///< node, or at_infinity
  bool flipped;               ///< <circle,v> < 0: above and below change places
  /// Of each end: of the other colour's arcs over its abscissa, or over the same infinity, those with an index below this height pass
  /// below the end, all others above.
  std::uint32_t left_height = 0, right_height = 0;
};

/// Where a node lies among the arcs of the other colour.
struct NodePlace {
  /// Of the arcs over the node, those with an index below `height` pass below it, all others above.
  std::uint32_t height = 0;
  /// The vertex whose face holds the node.
  std::uint32_t face = 0;
};

/// Charts of both colours over one frame. No two nodes share an abscissa, no node lies on an arc of the other colour or on the equator,
/// no arc on a vertical: whatever coincides on the input, the perturbation has separated.
struct Charts {
  Perturbation perturbation;
  Frame frame;
  std::array<const GaussianDiagram*, 2> diagrams;
  /// In height order: where two arcs of one colour overlap in an x-interval, the higher one has the greater index.
  std::array<std::vector<ChartArc>, 2> arcs;
  /// Of each chart arc the image of its circle, oriented upward: what searches read.
  std::array<std::vector<Vec3<double>>, 2> circles;
  /// Walls: the nodes of both colours in this hemisphere, from left to right. The one skeleton of both segment trees.
  struct Wall {
    Colour colour;
    std::uint32_t node;
  };
  std::vector<Wall> walls;
  /// Of each node of the diagram the index of its wall, or at_infinity when it lies in the other hemisphere.
  std::array<std::vector<std::uint32_t>, 2> wall_of;
  /// Of each node of the diagram, if it lies in this hemisphere, its place in the other diagram.
  std::array<std::vector<NodePlace>, 2> place_of;
  /// Of each arc of the diagram whether its chart arc is flipped; only of those that have one.
  std::array<std::vector<bool>, 2> flipped_of;

  [[nodiscard]] const GaussianDiagram& diagram(Colour c) const { return *diagrams[static_cast<std::size_t>(c)]; }
  [[nodiscard]] const std::vector<ChartArc>& arcs_of(Colour c) const { return arcs[static_cast<std::size_t>(c)]; }
  [[nodiscard]] const std::vector<Vec3<double>>& circles_of(Colour c) const { return circles[static_cast<std::size_t>(c)]; }
  [[nodiscard]] std::uint32_t wall(Colour c, std::uint32_t node) const { return wall_of[static_cast<std::size_t>(c)][node]; }
  [[nodiscard]] const NodePlace& place(Colour c, std::uint32_t node) const { return place_of[static_cast<std::size_t>(c)][node]; }
  [[nodiscard]] bool flipped(Colour c, std::uint32_t arc) const { return flipped_of[static_cast<std::size_t>(c)][arc]; }
  [[nodiscard]] const Direction& node(Colour c, std::uint32_t i) const { return diagram(c).nodes[i]; }
  [[nodiscard]] const Direction& circle(Colour c, const ChartArc& arc) const { return diagram(c).arcs[arc.arc].circle; }
  /// The vertex whose face lies right above, or right below, the arc in this chart.
  [[nodiscard]] std::uint32_t vertex_above(Colour c, const ChartArc& arc) const;
  [[nodiscard]] std::uint32_t vertex_below(Colour c, const ChartArc& arc) const;
};

/// The diagrams must outlive the charts. O((m + n) log(m + n)): walls are sorted, and nodes are located by a plane sweep.
Charts make_charts(Context& context, const GaussianDiagram& minus_a, const GaussianDiagram& b, const Frame& frame,
                   const Perturbation& perturbation = {});

/// Questions of the combinatorial layer; no answer is zero.
/// Positive: the node lies above the line of the arc. Not for an end of the arc.
Sign node_above_arc(const PerturbedKernel& kernel, const Charts& charts, Colour of_node, std::uint32_t node, Colour of_arc,
                    const ChartArc& arc);
/// Positive: arc e lies above arc f on the wall.
Sign above_on_wall(const PerturbedKernel& kernel, const Charts& charts, Colour of_e, const ChartArc& e, Colour of_f, const ChartArc& f,
                   const Charts::Wall& wall);
/// Positive: arc e lies above arc f far to the left.
Sign above_far_left(const PerturbedKernel& kernel, const Charts& charts, Colour of_e, const ChartArc& e, Colour of_f, const ChartArc& f);
/// Positive: e lies above f over their common x-range. Both are arcs of one colour whose x-ranges overlap in more than a point: they do not
/// cross, so the later of the left ends decides; if they share it, the earlier of the right ends.        [degree 3, no wall needed]
Sign above_same_colour(const PerturbedKernel& kernel, const Charts& charts, Colour colour, const ChartArc& e, const ChartArc& f);

/// Checks walls' order pairwise for neighbours, orientation and hemisphere of every arc and end, and at each face that the arcs below it
/// come before those above it: then the arcs are in height order [proofs/chart.md]. Linear. Places are checked by vertex_facet.
[[nodiscard]] Report validate(const Charts& charts);

}  // namespace fathom
