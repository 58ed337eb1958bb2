// SPDX-License-Identifier: GPL-3.0-or-later
// The public function: cores that are polytopes are answered by penetration_depth, and so is a half-space against one; the radii are added.
#include "fathom/signed_depth.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "kernels/context.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/positions.hpp"
#include "kernels/vector.hpp"
#include "reference/curved/curved_bounds.hpp"
#include "reference/depth/contact.hpp"
#include "reference/rounded/half_space.hpp"
#include "reference/rounded/optimal_cone.hpp"
#include "reference/shapes/core.hpp"
#include "reference/solve/depth.hpp"

namespace fathom {
namespace {

// The square of h(n)/|n| with the sign of h(n).
mpq_class signed_square(const PlaneSupport& plane) { return plane.support * abs(plane.support) / dot(plane.direction, plane.direction); }

// Cores that are polytopes. Those that touch have a common lattice, unless their denominators share too little.
SignedDepth depth_of_points(kernels::Positions a, kernels::Positions b, const Shape& of_a, const Shape& of_b, const Options& options) {
  kernels::Context context(options.monitor);
  solve::PlacedDepth found = solve::placed_depth(context, a, b, options);
  SignedDepth result{Surd{of_a.radius + of_b.radius, signed_square(found.depth)}, of_a.radius, of_b.radius, std::move(found.depth), {}, {}};
  if (const Touch* touch = std::get<Depth>(result.core).touch()) {
    result.cone = found.pair ? rounded::optimal_cone(context, *found.pair, touch->point, touch->direction)
                             : rounded::optimal_cone(context, a, b, touch->point);
    const Vector n = rounded::inner_direction(*result.cone);
    result.touching = found.pair ? depth::contact_of(depth::facing_faces(*found.pair, n)) : rounded::contact_along(a, b, n);
    if (options.validate) kernels::insist(rounded::validate(*result.cone, a, b));
  }
  return result;
}

// Of a core that is one hull of points.
kernels::Positions centers(const Shape& shape) {
  return kernels::Positions(std::span<const Atom>(std::get<std::vector<Term>>(shape.core).front().atoms));
}

// nullopt unless every atom is a point.
std::optional<SignedDepth> depth_of_half_space(const HalfSpace& half, rounded::Side side, const Shape& a, const Shape& b) {
  const std::vector<Term>& terms = std::get<std::vector<Term>>((side == rounded::Side::a ? b : a).core);
  for (const Term& term : terms)
    for (const Atom& atom : term.atoms)
      if (!atom.axes.empty()) return std::nullopt;
  PlaneSupport plane = rounded::plane_support(half, side, terms);
  Surd value{a.radius + b.radius, signed_square(plane)};
  std::optional<OptimalCone> cone;
  if (plane.support == 0) cone = OptimalCone{Lineality::none, {}, {plane.direction}};
  return SignedDepth{std::move(value), a.radius, b.radius, std::move(plane), std::move(cone), {}};
}

// nullopt if a core is curved, or a sum of too many points.
std::optional<SignedDepth> exact_depth(const Shape& a, const Shape& b, const SignedDepthOptions& options) {
  if (const HalfSpace* half = std::get_if<HalfSpace>(&a.core)) return depth_of_half_space(*half, rounded::Side::a, a, b);
  if (const HalfSpace* half = std::get_if<HalfSpace>(&b.core)) return depth_of_half_space(*half, rounded::Side::b, a, b);
  const auto points_a = shapes::polytope_points(a, most_expanded_points), points_b = shapes::polytope_points(b, most_expanded_points);
  if (!points_a || !points_b) return std::nullopt;
  return depth_of_points(*points_a, *points_b, a, b, options.cores);
}

// Of valid shapes.
SignedDepth enclosed_depth(const Shape& a, const Shape& b, const SignedDepthOptions& options) {
  if (options.bits > most_bound_bits) throw std::invalid_argument("more than " + std::to_string(most_bound_bits) + " bits are asked for");
  kernels::Context context(options.cores.monitor);
  curved::CurvedBounds bounds = curved::signed_bounds(context, a, b, options.bits, options.support_calls);
  if (options.cores.validate) kernels::insist(curved::validate(bounds, a, b));
  bounds.bracket.support_calls = bounds.support_calls;
  SignedDepth result{Bounds{bounds.low, bounds.high}, a.radius, b.radius, std::move(bounds.bracket), {}, {}};
  if (bounds.low == bounds.high) result.value = Surd{bounds.low, 0};
  return result;
}

}  // namespace

SignedDepth signed_depth(const Shape& a, const Shape& b, const SignedDepthOptions& options) {
  const kernels::DefaultFloatEnvironment environment;
  const bool points_of_a = shapes::require_all_but_points(a), points_of_b = shapes::require_all_but_points(b);
  if (points_of_a && points_of_b) return depth_of_points(centers(a), centers(b), a, b, options.cores);
  if (points_of_a && !points_of_b) shapes::require_shape(a);
  if (points_of_b && !points_of_a) shapes::require_shape(b);
  if (std::holds_alternative<HalfSpace>(a.core) && std::holds_alternative<HalfSpace>(b.core))
    throw std::invalid_argument("two half-spaces have no signed depth: it would be infinite, or that of one direction by convention");
  if (std::optional<SignedDepth> depth = exact_depth(a, b, options)) return std::move(*depth);
  // Spheres that were given as balls.
  const Shape simple_a = shapes::simplified(a), simple_b = shapes::simplified(b);
  if (std::optional<SignedDepth> depth = exact_depth(simple_a, simple_b, options)) return std::move(*depth);
  return enclosed_depth(simple_a, simple_b, options);
}

}  // namespace fathom
