// SPDX-License-Identifier: GPL-3.0-or-later
// Sums around O: P of two convex bodies, or those of pieces of unions; with the ball round O that has none of their boundary inside.
#pragma once

#include <string>
#include <vector>

#include "view/picture/drawn.hpp"
#include "view/picture/view.hpp"

namespace fathom::picture {

/// What is drawn. Places are differences b - a, exactly as given.
struct SumScene {
  View view;                                ///< across the way
  std::vector<Wires> sums;                  ///< at least one; the first are over the later ones
  std::vector<std::vector<Point>> nearest;  ///< facets that the ball touches, by their corners
  Point way;                                ///< from O to the first of them: as long as the ball's radius; not zero
  bool approximate = false;                 ///< whether a sum is a mesh near what is meant
};

/// The edges of the mesh of a convex polytope, up to the numbers that hold for Wires. `polygons` are facets, counter-clockwise from
/// outside, with unit normals; `creases`: of a mesh near a curved body those alone that can be seen as edges, and the outline.
struct Mesh {
  std::vector<Point> vertices;
  std::vector<std::vector<std::uint32_t>> polygons;
  std::vector<Vec3<double>> normals;
  bool creases = false;
};
Wires wires_of(const Mesh& mesh, const View& view);
/// How many edges it has.
std::size_t edges_count(const Mesh& mesh);

/// Whether the ball is so small beside the sums that doubles could not place their facets around it.
bool is_speck(const SumScene& scene);

/// One or two SVG elements, as scene_panels: all of it, and a close-up of the ball where that is small, though no speck. `label` and
/// `description` are markup.
std::string sum_panels(const SumScene& scene, const std::string& name, const std::string& label, const std::string& description);

}  // namespace fathom::picture
