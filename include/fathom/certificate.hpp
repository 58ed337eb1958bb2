// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies and an answer.
// Output  a proof of it, for a reader who trusts nobody: an inner polytope and supporting directions, as exact text. Three independent
//         checkers read it: fathom-check (as a library, fathom/check.hpp), check.py, and fathom-check-proved, extracted from a Coq proof.
//                                                                                                                  [proofs/certificate.md]
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/depth.hpp"
#include "fathom/monitor.hpp"
#include "fathom/point.hpp"

namespace fathom {

/// What a certificate proves. depth: depth^2 = low = high > 0. bounds: the bodies penetrate, and low <= depth^2 <= high.
enum class ClaimKind { depth, bounds, touching, disjoint };

/// Self-contained: it holds the points. With h(n) = max_b <n,b> - min_a <n,a> and P = B (+) (-A):
struct Certificate {
  std::string id;           ///< of the case; may be empty
  std::vector<Point> a, b;  ///< all points of the bodies
  ClaimKind claim = ClaimKind::disjoint;
  mpq_class low, high;                       ///< depth and bounds
  std::vector<Vector> directions;            ///< depth: optimal ones, h(n)^2 = low <n,n>. bounds: one with h(n)^2 <= high <n,n>, h(n) > 0.
                                             ///< touching: one with h(n) = 0. disjoint: one with h(n) < 0.
  bool complete = true;                      ///< depth: the directions are all optimal ones
  InnerPolytope inner;                       ///< depth and bounds: inside P, and holds the ball of squared radius low around O
  std::vector<Weight> weights_a, weights_b;  ///< touching: convex weights of one common point of A and B
};

/// Returns the certificate of an answer, whatever method found it. There always is one: it takes long only if many facets of P are nearly
/// nearest. Throws std::logic_error if the proof contradicts the answer, std::invalid_argument if a body is empty, and Interrupted.
Certificate make_certificate(std::span<const Point> a, std::span<const Point> b, const Depth& answer, Monitor* monitor = nullptr);

/// Returns a certificate that the bodies penetrate and low <= depth^2 <= high; `hint`, if given, is the direction that shows `high` if it
/// does. low = 0 proves just that they penetrate. Throws std::invalid_argument if that is not so, or low < 0, and Interrupted.
Certificate make_bounds_certificate(std::span<const Point> a, std::span<const Point> b, const mpq_class& low, const mpq_class& high,
                                    const std::optional<Vector>& hint = std::nullopt, Monitor* monitor = nullptr);

/// The text that checkers read: format 1, verify/check/FORMAT.md.
std::string certificate_text(const Certificate& certificate);

/// The text of make_certificate(a, b, answer), with this id. If the answer holds its proof, that is written as it stands: the points are not
/// copied. Throws as make_certificate does.
std::string certificate_text(std::span<const Point> a, std::span<const Point> b, const Depth& answer, std::string_view id = {},
                             Monitor* monitor = nullptr);
std::string certificate_text(std::span<const std::array<double, 3>> a, std::span<const std::array<double, 3>> b, const Depth& answer,
                             std::string_view id = {}, Monitor* monitor = nullptr);
std::string certificate_text(const Body& a, const Body& b, const Depth& answer, std::string_view id = {}, Monitor* monitor = nullptr);

}  // namespace fathom
