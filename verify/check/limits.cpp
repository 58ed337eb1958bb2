// SPDX-License-Identifier: Apache-2.0
#include "limits.hpp"

#include <algorithm>
#include <array>

#include "combine.hpp"
#include "counts.hpp"

namespace fathom_check {
namespace {

Count width_of_claim(const Certificate& c) {
  if (!is_of_bodies(c.format)) {
    if (c.claim == Claim::touching || c.claim == Claim::disjoint) return 0;
    return std::max({bits(c.low.num), bits(c.low.den), bits(c.high.num), bits(c.high.den)});
  }
  Count sum = 0;
  const auto take = [&sum](const Rational& r) { sum += 2 * (bits(r.num) + bits(r.den)); };
  if (c.claim != Claim::touching) take(c.low);
  if (c.claim == Claim::signed_bounds) take(c.high);
  take(c.a.radius);
  take(c.b.radius);
  return sum;
}

Count squared_corners(const Facets& facets) {
  Count sum = 0;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const Count corners = facets.ends[f] - facets.begin_of(f);
    sum += corners * corners;
  }
  return sum;
}

/// Calls `take` with each coordinate of the points, centers and axes.
template <class Take>
void for_each_coordinate(const Body& body, const Take& take) {
  const auto take_point = [&take](const RationalPoint& p) { take(p.x), take(p.y), take(p.z); };
  for (const RationalPoint& p : body.points.items) take_point(p);
  for (const Term& term : body.terms)
    for (const Atom& atom : term)
      for (const RationalPoint& vector : atom) take_point(vector);
}

/// How many leaves there are with 0, 1, .. 4 constraints. Others are refused when they are met.
std::array<Count, most_constraints + 1> count_leaves(const Nodes& nodes) {
  std::array<Count, most_constraints + 1> leaves{};
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const std::size_t constraints = nodes.ends[k] - nodes.begin_of(k);
    if (!nodes.splits[k] && constraints <= most_constraints) ++leaves[constraints];
  }
  return leaves;
}

Width width_of_weights(const Certificate& c, Count weights, std::size_t line, const Limits& limits) {
  Width result(weights, line, limits);
  for (const auto* part : {&c.weights_a, &c.weights_b})
    for (const Weight& weight : part->items) result.take(weight.weight);
  return result;
}

// The letters are those of section 13; v and u are those of section 8.
struct OfPatches {
  Count size = 0, work = 0;
};
OfPatches size_and_work_of_patches(const Certificate& c, Count v, Count u, std::size_t line, const Limits& limits) {
  const PatchParts& parts = c.of_patches;
  const Count corners = parts.corners.items.size(), g = parts.weights.size(), s = parts.sides.items.size(),
              m = parts.rates.items.size(), n = c.a.points.items.size() + c.b.points.items.size();
  Count x = 0, r = 0;
  for (std::size_t k = 0; k < corners; ++k) {
    Width of_corner(g + 2 * corners, line, limits);
    for (std::size_t i = parts.begin_of(k); i < parts.corners.items[k].end_b; ++i)
      of_corner.take(parts.weights[i].weight);
    x = std::max(x, of_corner.value());
  }
  for (const PatchParts::Rate& rate : parts.rates.items) {
    Count sum = 0;
    for (const Rational* q : {&rate.v.x, &rate.v.y, &rate.v.z, &rate.w.x, &rate.w.y, &rate.w.z, &rate.root})
      sum += bits(q->num) + bits(q->den);
    r = std::max(r, sum);
  }
  Count work = product(product(s, n), cost(v, u));
  work = sum(work, product(4 * (g + 8 * corners), cost(v + x + 2 * u, v + x + 2 * u)));
  work = sum(work, product(4 * s, cost(v + x + u, 2 * u)));
  work = sum(work, product(product(8 * m, corners), cost(v + x + u + r, v + x + u + r)));
  return {product(g + 2 * corners, corners > 0 ? v + x : 0), work};
}

// The letters are those of section 12.
void require_limits_of_unions(Certificate& c, std::size_t line, const Limits& limits) {
  const UnionParts& parts = c.of_unions;
  const Count n = c.a.points.items.size() + c.b.points.items.size(), f = c.facets.items.size(),
              m = parts.optima.items.size();
  const Count k = parts.separations.items.size(), r = c.weights_a.items.size() + c.weights_b.items.size();
  const Count vectors = n + c.vertices.items.size() + 3 * f;

  Width of_points(vectors, line, limits), of_optima(m, line, limits);
  for (const Body* body : {&c.a, &c.b})
    for_each_coordinate(*body, [&of_points](const Rational& x) { of_points.take(x); });
  for (const RationalPoint& t : parts.optima.items)
    for (const Rational* x : {&t.x, &t.y, &t.z}) of_optima.take(*x);
  constexpr Count mean = 32;  // as many digits more have vertices that are moved by their mean
  const Count w = of_points.value(), v = w + mean, e = m > 0 ? of_optima.value() : 0,
              x = width_of_weights(c, r, line, limits).value();
  const Count u = widest(parts.separations), b = width_of_claim(c);
  if (vectors * v + k * u + m * e + r * x > limits.size) throw of_points.too_large();

  const Count one_list = c.b.pieces.size() * c.a.points.items.size() + c.a.pieces.size() * c.b.points.items.size();
  Count work = product(product(one_list, parts.separation_lists.size()), cost(w + e, u));
  work = sum(work, product(16 * (n + squared_corners(c.facets.items)), cost(v, v)));
  work = sum(work, product(4 * r, cost(v + x, v + x)));
  std::array<Count, most_constraints + 1> half_spaces = count_leaves(parts.tree.items);
  work = sum(work, product(8 * half_spaces[4], cost(9 * v, 9 * v)));  // of four constraints, whose normals add up to O
  half_spaces[0] = f;  // a leaf without constraints is refused; a facet has no multipliers
  for (Count constraints = 0; constraints < 4; ++constraints) {
    const Count digits = (4 * constraints + 3) * v + b;
    work = sum(work, product(16 * half_spaces[constraints], cost(digits, digits + e)));
  }
  require_work(work, line, limits);
  c.scale = of_points.denominator();
  c.of_unions.unit = of_optima.denominator();
}

}  // namespace

// The letters are those of section 8.
void require_limits(Certificate& c, std::size_t line, const Limits& limits) {
  if (c.format == 3) return require_limits_of_unions(c, line, limits);
  if (c.format == 5) return require_limits_of_solids(c, line, limits);
  Count n = 0;
  for (const Body* body : {&c.a, &c.b}) for_each_coordinate(*body, [&n](const Rational&) { ++n; });
  n /= 3;
  const Count i = c.a.inner.items.size() + c.b.inner.items.size(), f = c.facets.items.size(),
              e = c.differences.items.size();
  const Count j = c.a.heights.items.size() + c.b.heights.items.size(), r = c.rays.items.size();
  const Count weights = c.weights_a.items.size() + c.weights_b.items.size();
  const Count k = c.directions.items.size() + r + 2 * c.lineality.items.size();
  const Count vectors = n + i + c.vertices.items.size() + 3 * f + e;

  Width of_points(vectors, line, limits), of_parameters(vectors, line, limits), of_heights(j, line, limits);
  for (const Body* body : {&c.a, &c.b}) {
    for_each_coordinate(*body, [&of_points](const Rational& x) { of_points.take(x); });
    for (const Place& place : body->inner.items)
      for (const Rational* y : {&place.y.x, &place.y.y, &place.y.z}) of_parameters.take(*y);
    for (const Rational& height : body->heights.items) of_heights.take(height);
  }
  const Count x = width_of_weights(c, weights, line, limits).value();
  const Count v = of_points.value() + (i > 0 ? of_parameters.value() : 0), g = of_heights.value();
  Count u = std::max({widest(c.directions), widest(c.lineality), widest(c.rays)});
  for (const PatchParts::Side& side : c.of_patches.sides.items) u = std::max(u, widest(side.inward));
  const OfPatches patches = size_and_work_of_patches(c, v, u, line, limits);
  if (sum(vectors * v + weights * x + j * g, patches.size) > limits.size) throw of_points.too_large();

  Count work = product(product(n + i, k), cost(v, u));
  work = sum(work, product(n + 4 * i + 4 * squared_corners(c.facets.items), cost(v, v)));
  work = sum(work, product(4 * (k + f), cost(v, width_of_claim(c))));
  work = sum(work, product(4 * weights, cost(v + x, v + x)));
  if (j > 0) work = sum(work, product(4 * n, cost(v + u + g, v + u + g)));
  work = sum(work, product(product(e, r + e), cost(v + u, v + u)));
  work = sum(work, patches.work);
  require_work(work, line, limits);
  c.fine = of_parameters.denominator();
  c.scale = of_points.denominator() * c.fine;
}

}  // namespace fathom_check
