// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a direction in which a facet of P lies.
// Output  the contact: the faces of both bodies in that direction, the translation, and a pair of
//         points that meet.                                                       [proofs/depth.md]
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/filters/plane.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::depth {

using FaceMeeting = decltype(Penetration::meeting);

/// A face of a body: its extreme points in the order of their indices, those of the input; of equal
/// points the lowest index.
struct ExtremeFace {
  std::vector<Vector> points;
  std::vector<std::uint32_t> ids;
};

/// The faces that meet when A is moved out of B along n: that of A in direction -n, and that of B
/// in direction n.
struct FacingFaces {
  ExtremeFace a, b;
};

FacingFaces facing_faces(const polytope::PlacedPair& pair, const Vector& n);

/// The contact of any two faces, by their corners.
Contact contact_of(std::vector<std::uint32_t> a, std::vector<std::uint32_t> b);
inline Contact contact_of(FacingFaces faces) { return contact_of(std::move(faces.a.ids), std::move(faces.b.ids)); }

/// Points of two faces whose planes are orthogonal to n, with b - a a multiple of n: they overlap,
/// seen along n.
Witness overlap(const polytope::PlacedPair& pair, const Vector& n, const FacingFaces& faces);

/// The kind of contact of faces with these numbers of corners. Throws std::logic_error if they do
/// not span a facet.
ContactKind kind_of(std::size_t corners_of_a, std::size_t corners_of_b);

/// The points of two edges that are not parallel, with b - a a multiple of n.
Witness crossing_of(const CrossingEdges& edges, const Vector& n);

/// Returns points a and b of the faces with b - a = v / d, d > 0, in units of the lattice, or
/// nullopt if there are none.
std::optional<Witness> meeting_points(const polytope::PlacedPair& pair, const FacingFaces& faces, const Vector& v,
                                      const mpz_class& d);

/// The convex combination of points, by their index.
template <class PointOf>
Point combination(const std::vector<Weight>& weights, PointOf point_of) {
  Point sum;
  for (const Weight& w : weights) sum = sum + w.weight * point_of(w.index);
  return sum;
}

/// The corners of the face of a body in direction u, ascending; of equal points the lowest index.
template <class Body, class Integer>
std::vector<std::uint32_t> face_corners(const Body& body, const Vec3<Integer>& u) {
  std::vector<std::uint32_t> ids = polytope::polygon_corners(body, extreme_points(body, u), u);
  std::sort(ids.begin(), ids.end());
  return ids;
}

/// The contact of the faces that meet when A is moved along n.
template <class Integer>
Contact contact_along(const polytope::PlacedPairIn<Integer>& pair, const Vector& n) {
  const Vec3<Integer> u{Integer(n.x), Integer(n.y), Integer(n.z)};
  return contact_of(face_corners(pair.a, -u), face_corners(pair.b, u));
}

/// The optimum in direction n, the outward normal of a facet of P. Throws std::logic_error if the
/// faces do not span a facet.
template <class Integer>
Optimum optimum_along(const polytope::PlacedPairIn<Integer>& pair, const Vector& n) {
  const Vec3<Integer> u{Integer(n.x), Integer(n.y), Integer(n.z)};
  std::vector<std::uint32_t> a = face_corners(pair.a, -u), b = face_corners(pair.b, u);
  const Integer height = dot(u, pair.differences()[{a.front(), b.front()}]);
  const ContactKind kind = kind_of(a.size(), b.size());
  return {n, pair.in_units(height), {kind, std::move(a), std::move(b)}};
}

/// What the witness of an optimum follows from. There is a witness for a nearest facet: the foot
/// point of O lies in it.
template <class Integer>
FaceMeeting meeting_of(const polytope::PlacedPairIn<Integer>& pair, const Contact& contact) {
  const std::vector<std::uint32_t>&a = contact.a, &b = contact.b;
  const auto of_a = [&](std::size_t k) { return pair.point_of_a(a[k]); };
  const auto of_b = [&](std::size_t k) { return pair.point_of_b(b[k]); };
  if (b.size() == 1) return CornerOfB{of_b(0)};
  if (a.size() == 1) return CornerOfA{of_a(0)};
  if (a.size() == 2 && b.size() == 2) return CrossingEdges{{of_a(0), of_a(1)}, {of_b(0), of_b(1)}};
  OverlappingFaces faces{{}, {}, pair.point_of_b(0), pair.units()};
  faces.a.reserve(a.size());
  faces.b.reserve(b.size());
  for (std::size_t k = 0; k < a.size(); ++k) faces.a.push_back(of_a(k));
  for (std::size_t k = 0; k < b.size(); ++k) faces.b.push_back(of_b(k));
  return faces;
}

/// Returns the answer without `inner`, given the normals of all nearest facets of P, primitive and
/// in lexicographic order. It lists the first `listed` optima, at least one.
template <class Integer, class Normals>
Penetration penetration_along(const polytope::PlacedPairIn<Integer>& pair, const Normals& nearest,
                              std::optional<std::size_t> listed = std::nullopt) {
  Penetration result;
  const std::size_t all = nearest.size(), most = std::min<std::size_t>(all, listed.value_or(all));
  result.optima.reserve(most);
  result.unlisted = all - most;
  for (const Vector& n : nearest) {
    if (result.optima.size() == most) break;
    result.optima.push_back(optimum_along(pair, n));
  }
  if (most > 0) result.meeting = meeting_of(pair, result.optima.front().contact);
  return result;
}

/// Whether binary64 shows that some of these points do not lie in one plane: it looks at few.
inline bool surely_solid(const kernels::Images& images) {
  const std::size_t few = std::min<std::size_t>(images.size(), 8);
  if (few < 4) return false;
  const auto image = [&](std::size_t i) { return Vec3<double>{images.x[i], images.y[i], images.z[i]}; };
  const kernels::RoundedPlane plane(image(0), image(1), image(2));
  for (std::size_t i = 3; i < few; ++i)
    if (const auto side = plane.side(image(i)); side && *side != kernels::Sign::zero) return true;
  return false;
}

/// Whether the bodies are flat; extreme points are not counted.
template <class Integer>
BodyFacts facts_of(const polytope::PlacedPairIn<Integer>& pair) {
  const auto flat = [](const auto& body) {
    return !surely_solid(body.images()) && polytope::affine_span<Integer>(body, body.size()).rank < 3;
  };
  return {flat(pair.a), flat(pair.b), 0, 0};
}

/// Throws std::invalid_argument unless at least one optimum is asked for.
void require_listed(const std::optional<std::size_t>& listed);
/// Leaves the first `listed` optima.
void list_first(Penetration& penetration, const std::optional<std::size_t>& listed);

}  // namespace fathom::depth
