// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies and an answer.
// Output  a proof of it, for a reader who trusts nobody: an inner polytope and supporting
//         directions, as exact text. Three independent checkers read it: fathom-check (as a
//         library, fathom/check.hpp), check.py, and fathom-check-proved, extracted from a Coq
//         proof. [proofs/certificate.md]
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/depth.hpp"
#include "fathom/monitor.hpp"
#include "fathom/patch.hpp"
#include "fathom/point.hpp"
#include "fathom/shape.hpp"
#include "fathom/signed_depth.hpp"
#include "fathom/union.hpp"

namespace fathom {

/// What a certificate proves. depth: depth^2 = low = high > 0. bounds: the bodies penetrate, and
/// low <= depth^2 <= high. apart: the bodies are disjoint, and distance^2 = low = high > 0.
enum class ClaimKind { depth, bounds, touching, apart };

/// Self-contained: it holds the points. With h(n) = max_b <n,b> - min_a <n,a> and P = B (+) (-A):
struct Certificate {
  std::string id;                      ///< of the case; may be empty
  std::vector<Point> a, b;             ///< all points of the bodies
  ClaimKind claim = ClaimKind::depth;  ///< what is proved
  mpq_class low, high;                 ///< of the claim; 0 if touching
  /// depth: optimal ones, h(n)^2 = low <n,n>. bounds: one with h(n)^2 <= high <n,n>, h(n) > 0.
  /// touching: one with h(n) = 0. apart: one with h(n)^2 = low <n,n>, h(n) < 0.
  std::vector<Vector> directions;
  bool complete = true;  ///< depth: the directions are all optimal ones
  InnerPolytope inner;   ///< depth and bounds: inside P, and holds the ball of squared radius low around O
  /// touching: convex weights of one common point of A and B. apart: of nearest points.
  std::vector<Weight> weights_a, weights_b;
};

/// Returns the certificate of an answer, whatever method found it. There always is one: it takes
/// long only if many facets of P are nearly nearest. Throws std::logic_error if the proof
/// contradicts the answer, std::invalid_argument if a body is empty, and Interrupted.
Certificate make_certificate(std::span<const Point> a, std::span<const Point> b, const Depth& answer,
                             Monitor* monitor = nullptr);

/// Returns a certificate that the bodies penetrate and low <= depth^2 <= high; `hint`, if given, is
/// the direction that shows `high` if it does. low = 0 proves just that they penetrate. Throws
/// std::invalid_argument if that is not so, or low < 0, and Interrupted.
Certificate make_bounds_certificate(std::span<const Point> a, std::span<const Point> b, const mpq_class& low,
                                    const mpq_class& high, const std::optional<Vector>& hint = std::nullopt,
                                    Monitor* monitor = nullptr);

/// The text that checkers read: format 1, or 2 if the bodies are apart, verify/check/FORMAT.md.
std::string certificate_text(const Certificate& certificate);

/// The text of make_certificate(a, b, answer), with this id. If the answer holds its proof, that is
/// written as it stands: the points are not copied. Throws as make_certificate does.
std::string certificate_text(std::span<const Point> a, std::span<const Point> b, const Depth& answer,
                             std::string_view id = {}, Monitor* monitor = nullptr);
std::string certificate_text(std::span<const std::array<double, 3>> a, std::span<const std::array<double, 3>> b,
                             const Depth& answer, std::string_view id = {}, Monitor* monitor = nullptr);
std::string certificate_text(const Body& a, const Body& b, const Depth& answer, std::string_view id = {},
                             Monitor* monitor = nullptr);

// ---- shapes: format 2 ----

/// Proves that a cone is the set of all optimal directions of bodies that touch: each of its facets
/// is that of a difference.
struct ConeProof {
  OptimalCone cone;  ///< of all optimal directions
  /// indices of a point a of A and a point b of B, for b - a
  std::vector<std::pair<std::uint32_t, std::uint32_t>> differences;
};

/// What a certificate of shapes proves, about the cores or about the bodies with their radii.
/// depth: the cores overlap, of squared depth low = high. touching: the cores do. apart: the cores
/// are at the squared distance low = high. signed_bounds: low <= signed depth of the bodies <=
/// high. In the first three cases the signed depth of the bodies follows exactly.
enum class ShapeClaim { depth, touching, apart, signed_bounds };

/// A direction orthogonal to that of a patch, in which the patch ends: the face of a body has its
/// least <inward,x> all along a line on which two corners are: this one, and that of the side
/// before.
struct PatchSide {
  bool of_b;           ///< whose face it is
  Vector inward;       ///< primitive
  std::size_t corner;  ///< the last corner on the line, counter-clockwise
};

/// Proves that a contact patch is the hull of its corners, and each of them extreme.
struct PatchProof {
  /// convex weights of points of A, and of points of B; none of a half-space
  std::vector<std::pair<std::vector<Weight>, std::vector<Weight>>> corners;
  std::vector<PatchSide> sides;  ///< counter-clockwise seen from the tip of the direction
};

/// A derivative of the signed depth, along a motion of A.
struct CertifiedRate {
  Twist motion;  ///< of A; B is at rest
  Surd value;    ///< its rational part is 0
};

/// Self-contained: it holds the shapes.
struct ShapeCertificate {
  std::string id;  ///< of the case; may be empty
  /// As simple as they can be. Each core is one hull of points or a half-space, unless the claim is
  /// signed_bounds: then a sum of terms, or a half-space.
  Shape a, b;
  ShapeClaim claim = ShapeClaim::depth;  ///< what is proved
  mpq_class low, high;                   ///< of the claim
  std::vector<Vector> directions;        ///< optimal ones of the cores; signed_bounds: one that shows the upper bound
  bool complete = false;                 ///< depth of points: the directions are all optimal ones
  /// signed_bounds: for each term of A, at least its support in the direction -n; likewise B, n
  std::vector<mpq_class> heights_a;
  std::vector<mpq_class> heights_b;          ///< the same of B
  std::vector<InnerPoint> inner_a, inner_b;  ///< signed_bounds: points of the cores
  /// depth and signed_bounds: inside the P of the cores, and around O; its indices are those of
  /// points, or of inner points. Or empty.
  InnerPolytope inner;
  std::vector<Weight> weights_a,  ///< else, unless a core is a half-space: convex weights of points of A
      weights_b;                  ///< of points of B: the distance of the two is that of the cores
  std::optional<ConeProof> cone;  ///< touching, of points: all optimal directions
  /// One for each direction, or none at all: format 2. Not of signed_bounds.
  std::vector<PatchProof> patches;
  std::vector<CertifiedRate> rates;  ///< beside patches, if all optimal directions are proved
};

/// Returns the certificate of an answer to signed_depth(a, b). Throws std::logic_error if the proof
/// contradicts the answer, std::invalid_argument if a shape is none or a sum has more than
/// most_expanded_points points, and Interrupted.
ShapeCertificate make_certificate(const Shape& a, const Shape& b, const SignedDepth& answer,
                                  Monitor* monitor = nullptr);

/// The text that checkers read: format 2, or 4 if it has patches.
std::string certificate_text(const ShapeCertificate& certificate);

/// Which format the text of two point sets without radii is in that touch: both can express them.
/// Depths of point sets are in format 1, and all that it cannot express, distances among it, in
/// format 2.
enum class ShapeFormat {
  shortest,  ///< format 1: one direction
  richest    ///< format 2: all directions
};

/// The text of make_certificate(a, b, answer), with this id.
std::string certificate_text(const Shape& a, const Shape& b, const SignedDepth& answer, std::string_view id = {},
                             ShapeFormat format = ShapeFormat::shortest, Monitor* monitor = nullptr);

// ---- with contact patches: format 4 ----

/// The text of a certificate of the answer, of its patches, and of the derivatives along these
/// motions of A, where all optimal directions can be proved: not of cores that touch, nor if optima
/// are unlisted. `geometry` is that of the answer. Throws as the functions above do, and
/// std::invalid_argument unless it tells smoothness: patches of unions have no certificate.
std::string certificate_text(const Body& a, const Body& b, const Answer& answer, const ContactGeometry& geometry,
                             std::span<const Twist> motions = {}, std::string_view id = {}, Monitor* monitor = nullptr);

// ---- unions of convex pieces: formats 3 and 5 ----

/// The text of a certificate of the answer to union_depth(a, b): the depth with all optima,
/// touching, or the distance. Its length and the time grow with the search that the answer took. It
/// is of format 3; or of format 5, where that would be too long: of points without a short common
/// denominator, or of more than 1,666,666 pairs of pieces, all optima together. Of bodies that are
/// solids the text for an Answer (fathom/answer.hpp) is about their meshes.
/// Throws std::logic_error if the answer is not complete or the proof contradicts it,
/// std::invalid_argument as union_depth does, and Interrupted.
std::string certificate_text(const Pieces& a, const Pieces& b, const UnionDepth& answer, std::string_view id = {},
                             Monitor* monitor = nullptr);

}  // namespace fathom
