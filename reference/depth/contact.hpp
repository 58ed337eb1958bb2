// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a direction in which a facet of P lies.
// Output  the contact: the faces of both bodies in that direction, the translation, and a pair of points that meet.      [proofs/depth.md]
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fathom/depth.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/position.hpp"

namespace fathom::depth {

using FaceMeeting = decltype(Penetration::meeting);

/// A face of a body: its extreme points in the order of their indices, those of the input; of equal points the lowest index.
struct ExtremeFace {
  std::vector<Vector> points;
  std::vector<std::uint32_t> ids;
};

/// The faces that meet when A is moved out of B along n: that of A in direction -n, and that of B in direction n.
struct FacingFaces {
  ExtremeFace a, b;
};

/// The face that is spanned by points which are all extreme in one direction, given their ids, ascending.
ExtremeFace face_of(std::span<const std::uint32_t> ids, std::vector<Vector> points);

FacingFaces facing_faces(const polytope::PlacedPair& pair, const Vector& n);

/// The contact of any two faces.
Contact contact_of(FacingFaces faces);

/// Returns the optimum in direction n, the outward normal of a facet of P, given the faces in that direction. Throws std::logic_error if
/// these do not span a facet.
Optimum optimum(const polytope::PlacedPair& pair, const Vector& n, const FacingFaces& faces);

/// Returns what the witness follows from, given the faces in direction n. There is a witness for a nearest facet: the foot point of O lies
/// in it.
FaceMeeting meeting(const polytope::PlacedPair& pair, const Vector& n, const FacingFaces& faces);

/// The same for simple faces, of which only the numbers of corners matter: a corner against any face, edges that cross. Returns nullopt for
/// others. a(k) is the position of corner k of the face of A, b(k) that of B.
template <class PositionA, class PositionB>
std::optional<FaceMeeting> simple_meeting(std::size_t of_a, std::size_t of_b, PositionA a, PositionB b) {
  if (of_b == 1) return CornerOfB{{b(0)}};
  if (of_a == 1) return CornerOfA{{a(0)}};
  if (of_a == 2 && of_b == 2) return CrossingEdges{{{{a(0)}, {a(1)}}}, {{{b(0)}, {b(1)}}}};
  return std::nullopt;
}
/// The same for others, whose faces overlap.
FaceMeeting overlap(const polytope::PlacedPair& pair, const Vector& n, const FacingFaces& faces);

/// The kind of contact of faces with these numbers of corners. Throws std::logic_error if they do not span a facet.
ContactKind kind_of(std::size_t corners_of_a, std::size_t corners_of_b);

/// Returns points a and b of the faces with b - a = v / d, d > 0, in units of the lattice, or nullopt if there are none.
std::optional<Witness> meeting_points(const polytope::PlacedPair& pair, const FacingFaces& faces, const Vector& v, const mpz_class& d);

/// Returns the rational position of a convex combination of lattice points.
Point combination(const polytope::PlacedPair& pair, std::span<const Vector> points, const std::vector<Weight>& weights);

/// Returns the answer without `inner`, given the normals of all nearest facets of P, primitive and in lexicographic order. It lists the
/// first `listed` optima, at least one. `contacts` finds them on the lattice: contacts.optimum(n), and then contacts.meeting(optimum).
template <class Contacts, class Normals>
Penetration penetration_by(Contacts contacts, const Normals& nearest, std::optional<std::size_t> listed) {
  Penetration result;
  const std::size_t all = nearest.size(), most = std::min<std::size_t>(all, listed.value_or(all));
  result.optima.reserve(most);
  result.unlisted = all - most;
  for (const Vector& n : nearest) {
    if (result.optima.size() == most) break;
    result.optima.push_back(contacts.optimum(n));
    if (result.optima.size() == 1) result.meeting = contacts.meeting(result.optima.front());
  }
  return result;
}

/// The contacts of bodies on any lattice.
class PlacedContacts {
 public:
  explicit PlacedContacts(const polytope::PlacedPair& pair) : pair_(pair) {}
  Optimum optimum(const Vector& n) { return depth::optimum(pair_, n, faces_ = facing_faces(pair_, n)); }
  [[nodiscard]] FaceMeeting meeting(const Optimum& last) const { return depth::meeting(pair_, last.direction, faces_); }

 private:
  const polytope::PlacedPair& pair_;
  FacingFaces faces_;
};

/// The same for bodies on any lattice.
template <class Normals>
Penetration penetration_along(const polytope::PlacedPair& pair, const Normals& nearest, std::optional<std::size_t> listed = std::nullopt) {
  return penetration_by(PlacedContacts(pair), nearest, listed);
}

/// Throws std::invalid_argument unless at least one optimum is asked for.
void require_listed(const std::optional<std::size_t>& listed);
/// Leaves the first `listed` optima.
void list_first(Penetration& penetration, const std::optional<std::size_t>& listed);

}  // namespace fathom::depth
