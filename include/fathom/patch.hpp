// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies, and the exact answer about them.
// Output  where they touch once A has been moved by each shortest way: all contact points, exactly;
//         and how the signed depth changes, to first order, when the bodies move.
//                                                                                 [proofs/patch.md]
//
// A and B are the cores, h(u) = max_b <u,b> - min_a <u,a>, and t = (h(n) / <n,n>) n the translation
// of A for an optimal direction n. The contact patch at t is the set of all pairs (p, p + t) of
// points of A and of B. It is a point, a segment or a convex polygon in a plane orthogonal to n.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/answer.hpp"
#include "fathom/body.hpp"
#include "fathom/numbers.hpp"
#include "fathom/point.hpp"
#include "fathom/shape.hpp"
#include "fathom/signed_depth.hpp"

namespace fathom {

/// A corner of a patch, by the least face of each body that holds it: a vertex, the two ends of an
/// edge, or all corners of a facet, as ascending indices of points, as in Contact. A half-space has
/// none.
struct PatchCorner {
  std::vector<std::uint32_t> on_a, on_b;  ///< the least face of A, of B
  /// What its place follows from. Of unions the ends of A's edge have been moved by the way out.
  std::variant<CornerOfA, CornerOfB, CrossingEdges> meeting;
};

/// All contact points in one optimal direction. Its corners are extreme, each listed once: one of a
/// point, two of a segment, three or more of a polygon, counter-clockwise seen from the tip of the
/// direction. The first is the one with the least on_a, and of these with the least on_b, compared
/// as lists. What is rational is computed when it is asked for.
struct Patch {
  Vector direction;                   ///< n: primitive, the way A leaves along
  std::variant<mpq_class, Point> by;  ///< h(n), from which the translation follows; or of unions the translation
  std::vector<PatchCorner> corners;   ///< at least one
  mpq_class radius_a, radius_b;       ///< of the bodies: how far they reach beyond the cores
  /// of unions: the piece of A and the piece of B that touch; else 0 and 0
  std::pair<std::uint32_t, std::uint32_t> pieces;
  std::size_t way = 0;     ///< which of the answer's shortest ways out it belongs to; 0 if they do not penetrate
  bool one_plane = false;  ///< of pieces that touch after the way: whether there is one plane between them
  /// of bodies that are solids of meshes: what of the meshes holds the patch; else empty
  std::vector<MeshFeature> mesh_a = {}, mesh_b = {};

  /// The dimension: 0, 1 or 2.
  [[nodiscard]] int rank() const { return corners.size() > 2 ? 2 : static_cast<int>(corners.size()) - 1; }
  /// The corner on A: that of the core, moved outward by A's radius. `corner` is below
  /// corners.size().
  [[nodiscard]] RoundedPoint a(std::size_t corner) const;
  /// The same point of contact on B: a's core plus translation(), moved outward by B's radius.
  [[nodiscard]] RoundedPoint b(std::size_t corner) const;
  /// Of the cores: (h(n) / <n,n>) n, or the way out of unions.
  [[nodiscard]] Point translation() const;
  /// The centroid of the patch, as a point of A and one of B.
  [[nodiscard]] RoundedWitness centroid() const;
  /// The square of the length of a segment, or of the area of a polygon; 0 of a point. That of the
  /// cores, which is that of the bodies.
  [[nodiscard]] mpq_class squared() const;
};

/// Why the signed depth has no gradient by the bodies' poses.
enum class Kink : std::uint8_t {
  ties,      ///< there are several shortest ways out
  extended,  ///< a patch is more than a point
  cone       ///< the cores touch, and more than one plane separates them
};

/// Why something about the first order is not told.
enum class LeftOut : std::uint8_t {
  curved,      ///< a core is neither a polytope nor a half-space: the formula may be false
  unlisted,    ///< the answer leaves optima unlisted
  incomplete,  ///< the search for the depth of unions was stopped
  touching,    ///< unions that touch
  too_large,   ///< a core against a half-space is a sum of more than most_expanded_points points
  exact_fit,   ///< unions turn, and a way out has no clearance: the depth may jump
  many_planes  ///< unions turn, and pieces that touch have more than one plane between them
};

/// The gradient by A's pose, of unit directions: moving A with the velocity v + w x p at its points
/// p changes the signed depth at the rate -<n, v + w x p> / |n| for this point. That by B's pose is
/// minus it.
struct Gradient {
  Vector normal;  ///< n: the one direction
  Point point;    ///< p, of A's core: the one contact point

  /// The two parts, -n / |n| and -(p x n) / |n|: of v, and of w.
  [[nodiscard]] SurdPoint by_translation() const;
  [[nodiscard]] SurdPoint by_rotation() const;
};

/// Where two bodies touch, and what their signed depth's first order follows from.
struct ContactGeometry {
  /// One for each listed way out, or one of bodies that touch or are apart. Of unions one for each
  /// two pieces that touch after a way out, or that are nearest. Empty if `no_patches` says why.
  std::vector<Patch> patches;
  std::optional<LeftOut> no_patches;      ///< why there are none
  std::optional<LeftOut> no_first_order;  ///< why no derivative is told
  std::optional<OptimalCone> cone;        ///< of cores that touch, all directions that separate them
  /// In the order of Kink, if all optima are listed; else those of the optima that are. Those of
  /// unions are not told.
  std::vector<Kink> kinks;
  bool of_unions = false;           ///< of unions there is no gradient
  std::vector<bool> clearance;      ///< of unions, for each way out: see UnionOptimum
  Status cores = Status::disjoint;  ///< where the cores, or the unions, stand
  unsigned dimension = 3;           ///< 2 of bodies of the plane: then every z is 0

  /// Whether there are patches, and of two convex bodies: then it is told if the depth is smooth,
  /// and a certificate can prove them.
  [[nodiscard]] bool tells_smoothness() const { return !of_unions && !no_patches; }
  /// Whether the signed depth is differentiable by the poses: then strictly so.
  [[nodiscard]] bool smooth() const { return tells_smoothness() && kinks.empty(); }
  /// If it is, its derivative.
  [[nodiscard]] std::optional<Gradient> gradient() const;
};

/// Returns where two bodies touch. `answer` is the one about these bodies. Exact. For faces of m
/// and n corners it takes O(m n) steps and as many bytes; bodies that touch are searched for all
/// planes that separate them, unions that are apart for all nearest pairs of pieces. Throws
/// std::invalid_argument if the answer cannot be about these bodies, InputError and Interrupted as
/// exact_answer does. Of bodies of the plane patches are points and segments, and their cone is of
/// directions of the plane.
ContactGeometry contact_geometry(const Body& a, const Body& b, const Answer& answer, Monitor* monitor = nullptr);

/// A one-sided derivative, over / (under |direction|). Its square is computed when it is asked for.
struct DirectionalDerivative {
  mpz_class over, under = 1;  ///< under > 0; they may have common factors
  Vector direction;           ///< primitive: the optimal direction that decides
  std::size_t patch = 0;      ///< which of ContactGeometry::patches decides
  std::size_t corner = 0;     ///< of its corners the one that decides

  [[nodiscard]] int sign() const { return sgn(over); }  ///< -1, 0 or 1
  [[nodiscard]] mpq_class root() const;                 ///< its square, in lowest terms
  [[nodiscard]] Surd value() const;                     ///< sign() * sqrt(root()), as one number
};

/// Returns the derivative of the signed depth while A and B begin to move with these velocities,
/// from this moment on: (sigma(s) - sigma(0)) / s for s -> 0+. Only the velocities count, not how
/// the bodies go on. Exact [proofs/patch.md, Theorem 1; of unions Theorem 4]. One step for each
/// corner; cubic in the rays of the cone of bodies that touch, and in the contacts of one way out
/// of unions that turn. Throws std::invalid_argument if a number is not in lowest terms, or if the
/// bodies are of the plane and a twist leaves it: only x and y of v, and z of w, may differ from 0.
std::variant<DirectionalDerivative, LeftOut> directional_derivative(const ContactGeometry& geometry, const Twist& of_a,
                                                                    const Twist& of_b = {});

/// The derivatives by the coordinates of the input points: by point i of A -weight n/|n|, by point
/// j of B weight n/|n|, with n the gradient's normal; 0 by all other points.
struct VertexWeights {
  std::vector<Weight> a, b;  ///< by ascending indices, of the cores' points; each sums to 1; none of a half-space
};

/// Returns them if there are such derivatives: if the signed depth is smooth, and no other weights
/// of a body's points make up the contact point. Exact.
std::optional<VertexWeights> vertex_weights(const Body& a, const Body& b, const ContactGeometry& geometry);

// The words, the same in every format.

std::string_view name(Kink kink);       ///< "ties", "extended", "cone"
std::string_view name(LeftOut reason);  ///< "curved", "unlisted", "exact-fit", ...

}  // namespace fathom
