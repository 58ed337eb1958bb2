// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two faces that meet once A has been moved: their corners, orthogonal to one direction.
// Output  the contact patch: the set of points that they then share.              [proofs/patch.md]
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/patch.hpp"
#include "kernels/messages.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/points.hpp"

namespace fathom::patch {

/// The points whose hull is the core of a body, if that is a polytope of no more than
/// most_expanded_points points: not of a half-space, of what is curved, and of unions.
class CorePoints {
 public:
  /// The body must outlive it.
  explicit CorePoints(const Body& body);

  [[nodiscard]] bool known() const { return !body_.pieces && (!body_.shape || expanded_); }
  // If they are known:
  [[nodiscard]] polytope::Points points() const {
    return expanded_ ? polytope::Points(*expanded_) : polytope::Points(body_.points);
  }
  [[nodiscard]] const std::vector<Point>& exact() const { return expanded_ ? *expanded_ : body_.points.exact(); }

 private:
  const Body& body_;
  std::optional<std::vector<Point>> expanded_;  // of a shape
};

/// The face of each body by its corners, in any order: extreme points, each once. One is a vertex,
/// two are an edge. The views must outlive it.
struct MeetingFaces {
  Vector direction;  ///< n: both lie in planes orthogonal to it
  polytope::Points a;
  std::span<const std::uint32_t> of_a;
  polytope::Points b;
  std::span<const std::uint32_t> of_b;
};

/// What the faces share once A has been moved along n until they lie in one plane: its core is at
/// the height `support` then. Of m and n corners it takes O(m n) signs of determinants of the given
/// corners: no point is constructed to find the others. Throws std::logic_error if they share
/// nothing.
Patch shared(const MeetingFaces& faces, const mpq_class& support);
/// The same once A has been moved by t, which brings the faces into one plane.
Patch shared_after(const Point& t, const MeetingFaces& faces);

/// The same of bodies that penetrate, for their contact in an optimal direction: a point that is
/// inside both faces needs no search [Lemma 2].
Patch shared_inside(const MeetingFaces& faces, const mpq_class& support);

/// The patch of a face of a body, of which some points may be no corners, and a half-space whose
/// plane it lies in once A has been moved: all of it. `half_space_is_a`: the face is B's.
Patch on_plane(const Vector& n, const polytope::Points& body, std::span<const std::uint32_t> face,
               const mpq_class& support, bool half_space_is_a);

/// The corners among points that lie in a plane orthogonal to n, counter-clockwise seen from its
/// tip; of equal points the lowest id stands for all.
std::vector<std::uint32_t> counter_clockwise(const Vector& n, const polytope::Points& body,
                                             std::span<const std::uint32_t> ids);

/// The corners of a patch with slack, which is at least 0, in order around it: of the set of all
/// pairs of points of the cores, one over the other along the patch's direction, whose way along
/// it is at most the slack short of the translation. Without slack it is the patch; the slack is
/// rounded up by 2^-40 of itself. nullopt of unions, and where the core of a body is not known by
/// its points.
std::optional<std::vector<RoundedWitness>> with_slack(const Body& a, const Body& b, const Patch& patch,
                                                      const mpq_class& slack);

/// The weights, ascending and none 0, of the point p in a polygon, segment or point with these
/// corners, in order: of a polygon those in a triangle at the first corner. Throws std::logic_error
/// if p is not in it.
std::vector<Weight> weights_in(polytope::Positions body, const std::vector<std::uint32_t>& corners, const Point& p);

/// Points over one denominator > 0.
template <class Integer>
struct PointsOver {
  std::vector<Vec3<Integer>> points;
  Integer denominator = 1;
};
using Scaled = PointsOver<mpz_class>;
Scaled scaled(std::span<const GivenPoint> given);

/// The exponents of coordinates in binary64: all are multiples of 2^low, and less than 2^high.
struct BinaryRange {
  long low = 0, high = 0;  ///< low is at most 0
};
/// nullopt unless all points are in binary64.
std::optional<BinaryRange> binary_range(std::span<const GivenPoint> given);

/// Points in binary64 over 2^-low. `shifted` makes an Integer of a word and by how much it is
/// shifted.
template <class Integer, class Shifted>
PointsOver<Integer> over_power_of_two(std::span<const GivenPoint> given, long low, const Shifted& shifted) {
  PointsOver<Integer> result{{}, shifted(1, static_cast<unsigned>(-low))};
  result.points.reserve(given.size());
  const auto integer = [&](double c) {
    const kernels::Dyadic number = kernels::dyadic(c);
    return shifted(number.mantissa, static_cast<unsigned>(number.exponent - low));
  };
  for (const GivenPoint& p : given) {
    const auto& [x, y, z] = std::get<std::array<double, 3>>(p.coordinates);
    result.points.push_back({integer(x), integer(y), integer(z)});
  }
  return result;
}

/// The part of a polygon, segment or point where `height` is not negative. Parts of a polygon that
/// is not convex may be joined by seams.
template <class Height>
std::vector<Point> clipped(const std::vector<Point>& cycle, const Height& height) {
  std::vector<Point> kept;
  for (std::size_t k = 0; k < cycle.size(); ++k) {
    const Point &p = cycle[k], &q = cycle[(k + 1) % cycle.size()];
    const mpq_class s = height(p), r = height(q);
    if (s >= 0) kept.push_back(p);
    if (s * r < 0) kept.push_back(p + mpq_class(s / (s - r)) * (q - p));
  }
  return kept;
}

/// The corners on A of what the faces share after the translation t, counter-clockwise from the
/// lexicographically least: the polygon of A is clipped by one half-plane of B after another, in
/// rationals. The naive twin.
std::vector<Point> shared_naive(const Point& t, const MeetingFaces& faces);

/// Checks the laws of a patch from the definitions: corners lie inside the faces that they name,
/// are extreme and in order.
[[nodiscard]] kernels::Report validate(const Patch& patch, const MeetingFaces& faces);

/// The least box around points, of which there is one at least.
struct CornerBox {
  Point low, high;
  explicit CornerBox(std::span<const Point> points);
  /// Whether they have a common point.
  [[nodiscard]] bool meets(const CornerBox& other) const;
};

/// The surface of a mesh. Of equal points the lowest index stands for all. In rationals throughout;
/// computes with what is near the set that is asked about, and keeps nothing else.
class MeshSurface {
 public:
  MeshSurface(const std::vector<Point>& points, const MeshFaces& faces);

  /// Of a convex set by its corners, in order around it: one, two, or three and more in a plane. At
  /// a point the vertex, else the edges, else the faces that hold it; of a segment, what holds
  /// almost all points of a part of it, in this way; of a polygon the faces that hold a part of it
  /// with an area. Sorted. Empty if no part of the set lies on the surface.
  [[nodiscard]] std::vector<MeshFeature> features(std::span<const Point> corners) const;

 private:
  const std::vector<Point>& points_;
  std::vector<std::vector<std::uint32_t>> faces_;
};

/// The surfaces of two bodies, of those that are solids of meshes.
class SolidSurfaces {
 public:
  SolidSurfaces(const Body& a, const Body& b);
  /// Sets met.mesh_a and met.mesh_b to what of the meshes holds a patch.
  template <class Met>
  void name(const Patch& patch, Met& met) const {
    if (a_) met.mesh_a = a_->features(places(patch, &Patch::a));
    if (b_) met.mesh_b = b_->features(places(patch, &Patch::b));
  }

 private:
  static std::vector<Point> places(const Patch& patch, RoundedPoint (Patch::*place)(std::size_t) const);

  std::optional<MeshSurface> a_, b_;
};

}  // namespace fathom::patch
