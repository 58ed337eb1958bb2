// SPDX-License-Identifier: GPL-3.0-or-later
// A face of a body is spanned by the body's extreme points in a direction: the hull of the body is
// not needed.
#include "reference/depth/contact.hpp"

#include <stdexcept>

#include "reference/polytope/polytope.hpp"
#include "reference/polytope/position.hpp"

namespace fathom::depth {
namespace {

ExtremeFace face(const kernels::PointCloud& body, const Vector& u) {
  ExtremeFace face{{}, face_corners(body, u)};
  for (const std::uint32_t i : face.ids) face.points.push_back(body[i]);
  return face;
}

}  // namespace

// A face of a convex polytope given by its extreme points: one is a vertex, two an edge, more a
// facet.
ContactKind kind_of(std::size_t corners_of_a, std::size_t corners_of_b) {
  if (corners_of_a >= 3) {
    return corners_of_b == 1   ? ContactKind::facet_vertex
           : corners_of_b == 2 ? ContactKind::facet_edge
                               : ContactKind::facet_facet;
  }
  if (corners_of_b >= 3) return corners_of_a == 1 ? ContactKind::vertex_facet : ContactKind::edge_facet;
  if (corners_of_a == 2 && corners_of_b == 2) return ContactKind::edge_edge;
  throw std::logic_error("the faces in an optimal direction do not span a facet");
}

FacingFaces facing_faces(const polytope::PlacedPair& pair, const Vector& n) {
  return {face(pair.a, -n), face(pair.b, n)};
}

Contact contact_of(std::vector<std::uint32_t> a, std::vector<std::uint32_t> b) {
  const ContactKind kind = a.size() + b.size() == 2         ? ContactKind::vertex_vertex
                           : a.size() == 1 && b.size() == 2 ? ContactKind::vertex_edge
                           : a.size() == 2 && b.size() == 1 ? ContactKind::edge_vertex
                                                            : kind_of(a.size(), b.size());
  return {kind, std::move(a), std::move(b)};
}

// The faces F_A + v / d and F_B share a point exactly if d F_A + v and d F_B do: integers again.
std::optional<Witness> meeting_points(const polytope::PlacedPair& pair, const FacingFaces& faces, const Vector& v,
                                      const mpz_class& d) {
  std::vector<Vector> moved_a, scaled_b;
  for (const Vector& p : faces.a.points) moved_a.push_back(d * p + v);
  for (const Vector& p : faces.b.points) scaled_b.push_back(d * p);
  const polytope::PlacedPair moved = polytope::place_integers(std::move(moved_a), std::move(scaled_b));
  const polytope::PositionOfOrigin common = polytope::position_of_origin(moved.a, moved.b);
  if (common.position == polytope::Position::outside) return std::nullopt;
  return Witness{combination(common.a, [&](std::size_t i) { return pair.position(faces.a.points[i]); }),
                 combination(common.b, [&](std::size_t i) { return pair.position(faces.b.points[i]); })};
}

Witness overlap(const polytope::PlacedPair& pair, const Vector& n, const FacingFaces& faces) {
  const Vector apart = faces.b.points.front() - faces.a.points.front();
  std::optional<Witness> common = meeting_points(pair, faces, dot(n, apart) * n, dot(n, n));
  if (!common) throw std::logic_error("the faces in an optimal direction do not meet");
  return std::move(*common);
}

void require_listed(const std::optional<std::size_t>& listed) {
  if (listed == 0U) throw std::invalid_argument("at least one optimum must be listed");
}

void list_first(Penetration& penetration, const std::optional<std::size_t>& listed) {
  const std::size_t all = penetration.optima.size();
  if (!listed || all <= *listed) return;
  penetration.optima.resize(*listed);
  penetration.unlisted += all - *listed;
}

}  // namespace fathom::depth
