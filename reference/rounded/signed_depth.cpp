// SPDX-License-Identifier: GPL-3.0-or-later
// The signed depth of two shapes: cores that are polytopes are answered by penetration_depth, and
// so is a half-space against one; the radii are added. And the accessors of SignedDepth for every
// kind of cores.
#include "fathom/signed_depth.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "kernels/context.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/vector.hpp"
#include "reference/curved/curved_bounds.hpp"
#include "reference/depth/contact.hpp"
#include "reference/polytope/points.hpp"
#include "reference/rounded/coordinates.hpp"
#include "reference/rounded/optimal_cone.hpp"
#include "reference/shapes/core.hpp"
#include "reference/solve/depth.hpp"

namespace fathom::rounded {
namespace {

// A point of the sum with the least <u,p>; in each term the first one.
Point lowest_point(std::span<const Term> terms, const Vector& u) {
  Point sum;
  for (const Term& term : terms) {
    const Point* lowest = nullptr;
    mpq_class least;
    for (const Atom& atom : term.atoms) {
      const mpq_class height = dot(u, atom.center);
      if (lowest == nullptr || height < least) (lowest = &atom.center, least = height);
    }
    sum = {sum.x + lowest->x, sum.y + lowest->y, sum.z + lowest->z};
  }
  return sum;
}

}  // namespace

PlaneSupport plane_support(const HalfSpace& half, Side side, std::span<const Term> other) {
  const Point& m = half.normal;
  const Vector outward = primitive_along(m);
  // {x : <outward,x> <= height}, as outward is a positive multiple of m.
  const mpq_class height = half.offset * (dot(outward, outward) / dot(outward, m));
  const Point p = lowest_point(other, outward);
  const mpq_class support = height - dot(outward, p), factor = support / dot(outward, outward);
  const Point foot = p + factor * outward;
  if (side == Side::b) return {outward, support, {p, foot}};
  return {-outward, support, {foot, p}};
}

}  // namespace fathom::rounded

namespace fathom {
namespace {

// The square of h(n)/|n| with the sign of h(n).
mpq_class signed_square(const PlaneSupport& plane) {
  return plane.support * abs(plane.support) / dot(plane.direction, plane.direction);
}

// Cores that are polytopes. Those that touch are placed on a common lattice, unless their
// denominators share too little.
SignedDepth depth_of_points(polytope::Positions a, polytope::Positions b, const Shape& of_a, const Shape& of_b,
                            const Options& options) {
  kernels::Context context(options.monitor);
  solve::PlacedDepth found = solve::placed_depth(context, a, b, options);
  SignedDepth result{Surd{of_a.radius + of_b.radius, signed_square(found.depth)},
                     of_a.radius,
                     of_b.radius,
                     std::move(found.depth),
                     {},
                     {}};
  if (const Touch* touch = std::get<Depth>(result.core).touch()) {
    rounded::PlanesBetween planes = rounded::planes_between(context, std::move(found.pair), a, b, *touch);
    result.cone = std::move(planes.cone);
    result.touching = std::move(planes.contact);
    if (options.validate) kernels::insist(rounded::validate(*result.cone, a, b));
  }
  return result;
}

// Of a core that is one hull of points.
polytope::Positions centers(const Shape& shape) {
  return polytope::Positions(std::span<const Atom>(std::get<std::vector<Term>>(shape.core).front().atoms));
}

// nullopt unless every atom is a point.
std::optional<SignedDepth> depth_of_half_space(const HalfSpace& half, rounded::Side side, const Shape& a,
                                               const Shape& b) {
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
  if (const HalfSpace* half = std::get_if<HalfSpace>(&a.core))
    return depth_of_half_space(*half, rounded::Side::a, a, b);
  if (const HalfSpace* half = std::get_if<HalfSpace>(&b.core))
    return depth_of_half_space(*half, rounded::Side::b, a, b);
  const auto points_a = shapes::polytope_points(a, most_expanded_points),
             points_b = shapes::polytope_points(b, most_expanded_points);
  if (!points_a || !points_b) return std::nullopt;
  return depth_of_points(*points_a, *points_b, a, b, options.cores);
}

// Of valid shapes.
SignedDepth enclosed_depth(const Shape& a, const Shape& b, const SignedDepthOptions& options) {
  if (options.bits > most_bound_bits)
    throw std::invalid_argument("more than " + std::to_string(most_bound_bits) + " bits are asked for");
  kernels::Context context(options.cores.monitor);
  curved::CurvedBounds bounds =
      curved::signed_bounds(context, a, b, options.bits, options.support_calls, options.coaxial);
  if (options.cores.validate) kernels::insist(curved::validate(bounds, a, b));
  bounds.bracket.support_calls = bounds.support_calls;
  SignedDepth result{Bounds{bounds.low, bounds.high}, a.radius, b.radius, std::move(bounds.bracket), {}, {}};
  if (bounds.exact) result.value = *bounds.exact;
  return result;
}

// ---- for the accessors ----

std::optional<Status> status_of(int low_sign, int high_sign) {
  if (low_sign != high_sign) return std::nullopt;
  return low_sign > 0 ? Status::penetrating : low_sign < 0 ? Status::disjoint : Status::touching;
}

// h(n) / <n,n>, where (h(n) / <n,n>) n is known.
mpq_class factor(const Point& translation, const Vector& n) { return dot(n, translation) / dot(n, n); }

}  // namespace

SignedDepth signed_depth(const Shape& a, const Shape& b, const SignedDepthOptions& options) {
  const kernels::DefaultFloatEnvironment environment;
  const bool points_of_a = shapes::require_all_but_points(a), points_of_b = shapes::require_all_but_points(b);
  if (points_of_a && points_of_b) return depth_of_points(centers(a), centers(b), a, b, options.cores);
  if (points_of_a && !points_of_b) shapes::require_shape(a);
  if (points_of_b && !points_of_a) shapes::require_shape(b);
  if (shapes::is_halfspace(a) && shapes::is_halfspace(b))
    throw std::invalid_argument(
        "two half-spaces have no signed depth: it would be infinite, or that of one direction by convention");
  if (std::optional<SignedDepth> depth = exact_depth(a, b, options)) return std::move(*depth);
  // Spheres that were given as balls.
  const Shape simple_a = shapes::simplified(a), simple_b = shapes::simplified(b);
  if (std::optional<SignedDepth> depth = exact_depth(simple_a, simple_b, options)) return std::move(*depth);
  return enclosed_depth(simple_a, simple_b, options);
}

std::optional<Status> SignedDepth::status() const {
  if (const Surd* known = exact()) return status_of(sign(*known), sign(*known));
  return status_of(sgn(bounds()->low), sgn(bounds()->high));
}

double SignedDepth::low_binary64() const {
  return exact() ? round_binary64(*exact(), Rounding::rd) : round_binary64(bounds()->low, Rounding::rd);
}

double SignedDepth::high_binary64() const {
  return exact() ? round_binary64(*exact(), Rounding::ru) : round_binary64(bounds()->high, Rounding::ru);
}

Vector SignedDepth::direction() const {
  if (cone) return cone->direction();
  if (const Depth* cores = std::get_if<Depth>(&core)) return cores->direction();
  if (const PlaneSupport* plane = std::get_if<PlaneSupport>(&core)) return plane->direction;
  return std::get<Bracket>(core).direction;
}

const Vector* SignedDepth::around() const {
  const Bracket* const bracket = std::get_if<Bracket>(&core);
  if (bracket == nullptr || !bracket->around) return nullptr;
  const Vector& axis = bracket->around->axis;
  return is_zero(cross(axis, bracket->direction)) ? nullptr : &axis;
}

std::vector<AlongNormal> SignedDepth::translations() const {
  if (!exact()) return {};
  const mpq_class rho = radius_a + radius_b;
  const Depth* const cores = std::get_if<Depth>(&core);
  if (cores != nullptr && cores->penetration()) {
    std::vector<AlongNormal> all;
    for (const Optimum& optimum : cores->optima())
      all.push_back({optimum.direction, optimum.support / dot(optimum.direction, optimum.direction), rho});
    return all;
  }
  const Vector n = direction();
  if (cores != nullptr) return {{n, cores->distance() ? factor(cores->distance()->translation, n) : mpq_class(0), rho}};
  const PlaneSupport* const plane = std::get_if<PlaneSupport>(&core);
  if (plane == nullptr) return {};
  return {{n, plane->support / dot(n, n), rho}};
}

const Contact* SignedDepth::contact() const {
  const Depth* const cores = std::get_if<Depth>(&core);
  if (cores == nullptr) return nullptr;
  return touching ? &*touching : cores->contact();
}

Counters SignedDepth::counters() const {
  if (const Depth* const cores = std::get_if<Depth>(&core)) return cores->counters;
  Counters counters;
  const Bracket* const bracket = std::get_if<Bracket>(&core);
  counters.support_calls = bracket != nullptr ? bracket->support_calls : 1;
  if (bracket == nullptr) return counters;
  counters.expansions = bracket->polytope.vertices.size();
  counters.inner_facets = bracket->polytope.facets.size();
  return counters;
}

std::optional<RoundedWitness> SignedDepth::witness() const {
  if (!exact() || std::holds_alternative<Bracket>(core)) return std::nullopt;
  const Depth* const cores = std::get_if<Depth>(&core);
  const Witness found = cores != nullptr ? cores->contact_points() : std::get<PlaneSupport>(core).witness;
  const Vector n = direction();
  return RoundedWitness{{found.a, n, -radius_a}, {found.b, n, radius_b}};
}

}  // namespace fathom
