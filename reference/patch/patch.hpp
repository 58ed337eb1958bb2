// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two faces that meet once A has been moved: their corners, orthogonal to one direction.
// Output  the contact patch: the set of points that they then share.              [proofs/patch.md]
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fathom/patch.hpp"
#include "kernels/report.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::patch {

/// A face by its corners, counter-clockwise seen from the tip of the direction, on a lattice. One
/// is a vertex, two are an edge.
struct Corners {
  std::vector<Vector> points;
  std::vector<std::uint32_t> ids;  ///< of the body's points
};

/// A point p of the lattice stands for origin + p / denominator. A is moved by shift / divisor, in
/// units of the lattice; then the faces lie in one plane.
struct MeetingFaces {
  Vector direction;
  Corners a, b;
  Point origin;
  mpz_class denominator, divisor;  ///< > 0
  Vector shift;
};

/// The faces with these corners, in any order, of two bodies. A is moved along n until they meet.
MeetingFaces faces_along(const Vector& n, const polytope::Points& a, std::span<const std::uint32_t> of_a,
                         const polytope::Points& b, std::span<const std::uint32_t> of_b);
/// The same, A being moved by t, after which the faces lie in one plane orthogonal to n.
MeetingFaces faces_after(const Point& t, const Vector& n, const polytope::Points& a,
                         std::span<const std::uint32_t> of_a, const polytope::Points& b,
                         std::span<const std::uint32_t> of_b);

/// What the moved face of A shares with the face of B. Of m and n corners it takes O(m n) signs of
/// determinants of the given corners, and constructs no point before it is known to be a corner.
/// Throws std::logic_error if they share nothing.
Patch shared(const MeetingFaces& faces);

/// What the moved face of A shares with a half-space whose plane it lies in then: all of it. Of the
/// patch on_b is empty. `half_space_is_a`: the face is B's, and on_a is empty.
Patch on_plane(const Vector& n, const polytope::Points& body, std::span<const std::uint32_t> face,
               const mpq_class& support, bool half_space_is_a);

/// The corners on A of what the faces share, in the order of Patch: the polygon of A is clipped by
/// one half-plane of B after another, in rationals. The naive twin.
std::vector<Point> shared_naive(const MeetingFaces& faces);

/// Checks the laws of a patch from the definitions: corners lie in both faces, are extreme and in
/// order, and each names its least faces.
[[nodiscard]] kernels::Report validate(const Patch& patch, const MeetingFaces& faces);

}  // namespace fathom::patch
