// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies of the plane.
// Output  the bodies of space that stand for them, and what an answer about these says of them.
//                                                                               [proofs/plane.md]
//
// Point i of a body of n points becomes point i, at the height -h, and point n + i, at h. The first
// body stays flat, at the height 0, unless a body is a union, whose pieces need interiors.
#pragma once

#include <gmpxx.h>

#include <string>
#include <string_view>
#include <vector>

#include "fathom/answer.hpp"
#include "fathom/body.hpp"
#include "fathom/certificate.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::answer {

/// Calls `use` with each hull of points that a body consists of: with the points of each piece, or
/// of the core of a shape; with none if those are no points, as of a half-plane.
template <class Use>
void for_each_hull(const Body& body, const Use& use) {
  if (body.pieces) {
    for (const std::vector<Point>& piece : *body.pieces) use(piece);
  } else if (!body.shape) {
    use(body.points.exact());
  } else if (const auto points = files::points_of(*body.shape)) {
    use(*points);
  }
}

/// Bodies of space that stand for two bodies of the plane.
struct Prisms {
  Body a, b;
  mpq_class height;  ///< h; 0 if nothing is raised, beside a half-plane
};

/// A power of two above the sum of the bodies' extents along x, which is more than the depth of
/// their cores.
mpq_class height_above(const Body& a, const Body& b);

/// Throws std::invalid_argument unless both are of the plane.
Prisms prisms_of(const Body& a, const Body& b);

/// A height of which certificates prove that nothing is gained by leaving the plane: above the
/// signed depth, and the radii.
mpq_class proving_height(const Prisms& prisms, const Answer& of_prisms);

/// The certificate of an answer about two bodies of the plane, those of shapes in this format.
/// Throws as fathom::certificate_text does.
std::string certificate_in_plane(const Body& a, const Body& b, const Answer& answer, std::string_view id,
                                 ShapeFormat format, Monitor* monitor);

/// What a cone of directions in space that are optimal for raised bodies is in the plane: all
/// directions of the plane are those of a plane in space.
OptimalCone cone_in_plane(OptimalCone cone);

/// The kind of the contact of an edge or a vertex of A with one of B.
constexpr ContactKind kind_in_plane(bool edge_a, bool edge_b) {
  if (edge_a) return edge_b ? ContactKind::edge_edge : ContactKind::edge_vertex;
  return edge_b ? ContactKind::vertex_edge : ContactKind::vertex_vertex;
}

/// What the answer about the prisms says of the bodies.
Answer in_plane(const Body& a, const Body& b, Answer of_prisms);

/// Whether a body of the plane has no interior there, or one of space none in space. Pieces have
/// interiors.
bool is_flat_body(const Body& body);

}  // namespace fathom::answer
