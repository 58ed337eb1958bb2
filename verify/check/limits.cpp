// SPDX-License-Identifier: Apache-2.0
#include "limits.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "solids.hpp"
#include "vectors.hpp"

namespace fathom_check {

namespace {

using Count = std::uint64_t;

/// No amount of work is counted above this.
constexpr Count too_much = std::numeric_limits<Count>::max() / 2;

Count sum(Count s, Count t) { return std::min(too_much, std::min(too_much, s) + std::min(too_much, t)); }
Count product(Count s, Count t) { return s != 0 && t > too_much / s ? too_much : s * t; }

/// How wide numbers become over their common denominator, if `vectors` of them are kept.
class Width {
 public:
  Width(Count vectors, std::size_t line, const Limits& limits)
      : vectors_(vectors), line_(line), largest_(limits.size) {}

  void take(const Rational& r) {
    numerator_ = std::max(numerator_, bits(r.num));
    const mpz_srcptr common = denominator_.get_mpz_t(), den = r.den.get_mpz_t();
    const bool words = bits(common) <= 63 && bits(den) <= 63;
    if (words ? to_word(common) % to_word(den) == 0 : mpz_divisible_p(common, den) != 0) return;
    mpz_lcm(denominator_.get_mpz_t(), denominator_.get_mpz_t(), r.den.get_mpz_t());
    if (vectors_ * bits(denominator_) > largest_) throw too_large();
  }
  void take(const RationalPoint& p) { take(p.x), take(p.y), take(p.z); }
  [[nodiscard]] Count value() const { return bits(denominator_) + numerator_; }
  [[nodiscard]] const mpz_class& denominator() const { return denominator_; }

  [[nodiscard]] Fault too_large() const {
    return malformed(line_, "a certificate larger than the limit, " + std::to_string(largest_) + " in its size");
  }

 private:
  Count vectors_, numerator_ = 0;
  std::size_t line_;
  std::uint64_t largest_;
  mpz_class denominator_ = 1;
};

/// What a product of numbers of these sizes takes.
Count cost(Count s, Count t) {
  constexpr Count fixed = 256, linear_from = 4'000;
  return product(fixed + std::max(s, t), fixed + std::min({s, t, linear_from}));
}

Count widest(const Vector& n) { return std::max({bits(n.x), bits(n.y), bits(n.z)}); }
Count widest(const Part<std::vector<Vector>>& vectors) {
  Count result = 0;
  for (const Vector& n : vectors.items) result = std::max(result, widest(n));
  return result;
}

/// Throws Fault (malformed, on `line`) if it is above the limit.
void require_work(Count work, std::size_t line, const Limits& limits) {
  if (work > limits.work)
    throw malformed(line, "a certificate of more work than the limit, " + std::to_string(limits.work));
}

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

/// Calls `take` with each point, center and axis.
template <class Take>
void for_each_point(const Body& body, const Take& take) {
  for (const RationalPoint& p : body.points.items) take(p);
  for (const Term& term : body.terms)
    for (const Atom& atom : term)
      for (const RationalPoint& vector : atom) take(vector);
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

Width width_of_optima(const UnionParts& parts, std::size_t line, const Limits& limits) {
  Width result(parts.optima.items.size(), line, limits);
  for (const RationalPoint& t : parts.optima.items) result.take(t);
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

  Width of_points(vectors, line, limits);
  for (const Body* body : {&c.a, &c.b})
    for_each_point(*body, [&of_points](const RationalPoint& p) { of_points.take(p); });
  const Width of_optima = width_of_optima(parts, line, limits);
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

/// Of one solid, or of two bodies; and the letter h.
struct SizeAndWork {
  Count size = 0, work = 0, h = 0;
};

// The letters are those of section 14, or, of two bodies, of section 15.
SizeAndWork of_bodies(const std::vector<const Body*>& bodies, const std::vector<PiecedBody>& pieced) {
  Count n = 0, f = 0, corners = 0, s = 0, h = 0;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const SolidParts& solid = bodies[k]->solid;
    n += pieced[k].points().size();
    f += solid.mesh.items.size();
    corners += bodies[k]->core == Body::Core::pieces ? pieced[k].points().size() : solid.facets.items.corners.size();
    for (std::size_t i = 0; i < solid.pieces.size(); ++i)
      s = sum(s, product(solid.pieces[i].end - begin_of(solid.pieces, i), pieced[k].corners(i)));
    for (const auto& [p, d] : pieced[k].points())
      h = std::max<Count>(h, bits(d) + std::max({bits(p.x), bits(p.y), bits(p.z)}));
  }
  const Count work = product(3 * (3 * f + corners), cost(4 * h, 4 * h));
  return {product(n + 10 * f + 4 * corners, h), sum(work, product(s, cost(5 * h, h))), h};
}

void add_polytopes(const Certificate& c, SizeAndWork& total) {
  const Facets& all = c.facets.items;
  for (const InnerPolytope& polytope : c.of_unions.polytopes) {
    const std::size_t first = polytope.first_facet, last = polytope.facets.end;
    const Count v = polytope.vertices.end - polytope.first_vertex, p = last - first, h = total.h,
                corners = all.begin_of(last) - all.begin_of(first);
    const std::vector<std::uint32_t> named = all.named(first, last);  // of which some may not exist
    const auto vertices = std::lower_bound(named.begin(), named.end(), v) - named.begin();
    total.size = sum(total.size, product(2 * v + 12 * p, h));
    total.work = sum(total.work, product(3 * corners, cost(8 * h, 8 * h)));
    total.work = sum(total.work, product(product(p, static_cast<Count>(vertices)), cost(10 * h, 2 * h)));
  }
}

/// The letter x: of the weights, and of the corners that they name.
Count width_of_weights(const Certificate& c, const std::vector<PiecedBody>& pieced, Count count, std::size_t line,
                       const Limits& limits) {
  Width result(count, line, limits);
  const auto take = [&](const Body& body, const PiecedBody& of, std::size_t piece, const auto& weights) {
    for (const Weight& weight : weights.items) {
      result.take(weight.weight);
      const auto corner = piece < of.pieces() ? of.corner(piece, weight.index) : std::nullopt;
      if (!corner) continue;
      result.take(body.points.items[*corner]);
    }
  };
  take(c.a, pieced[0], c.of_unions.nearest_a, c.weights_a);
  take(c.b, pieced[1], c.of_unions.nearest_b, c.weights_b);
  return count > 0 ? result.value() : 0;
}

// The letters are those of section 15.
void require_limits_of_two(Certificate& c, std::size_t line, const Limits& limits) {
  const std::vector<PiecedBody> pieced{PiecedBody(c.a), PiecedBody(c.b)};
  SizeAndWork total = of_bodies({&c.a, &c.b}, pieced);
  add_polytopes(c, total);
  UnionParts& parts = c.of_unions;
  Count k = 0, u = 0, e_corners = 0;
  for (const Block& block : parts.blocks.items)
    if (block.kind == Block::Kind::vector) ++k, u = std::max(u, widest(block.u));
  for (std::size_t list = 0; list < parts.separation_lists.size(); ++list)
    for_each_vector(parts, list, pieced[0].pieces(), pieced[1].pieces(),
                    [&](std::size_t, const PieceRange& of_a, const PieceRange& of_b) {
                      e_corners += pieced[0].begin_of(of_a.last) - pieced[0].begin_of(of_a.first);
                      e_corners += pieced[1].begin_of(of_b.last) - pieced[1].begin_of(of_b.first);
                    });
  const Count m = parts.optima.items.size(), r = c.weights_a.items.size() + c.weights_b.items.size(), h = total.h;
  const Width of_optima = width_of_optima(parts, line, limits);
  const Count e = m > 0 ? of_optima.value() : 0, x = width_of_weights(c, pieced, r, line, limits);
  const Count b = c.claim == Claim::touching ? 0 : std::max(bits(c.low.num), bits(c.low.den));
  if (sum(total.size, k * u + m * e + r * x) > limits.size) throw of_optima.too_large();

  const Count z = 4 * h + 2 * u + b + e;
  Count work = sum(total.work, product(4 * e_corners, cost(h + u, h)));
  work = sum(work, product(8 * k, cost(z, z)));
  work = sum(work, product(4 * r, cost(2 * x, 2 * x)));
  require_work(work, line, limits);
  parts.work = work;
  parts.width_of_claim = b;
  parts.width_of_optima = e;
  parts.unit = of_optima.denominator();
}

void require_limits_of_solids(Certificate& c, std::size_t line, const Limits& limits) {
  if (c.claim != Claim::solid) return require_limits_of_two(c, line, limits);
  const SizeAndWork total = of_bodies({&c.a}, {PiecedBody(c.a)});
  if (total.size > limits.size) throw Width(0, line, limits).too_large();
  require_work(total.work, line, limits);
}

// The letters are those of section 17.
void require_limits_of_motions(Certificate& c, std::size_t line, const Limits& limits) {
  MotionParts& parts = c.of_motions;
  const Count n = c.a.points.items.size() + c.b.points.items.size();
  Count k = 0, ends = c.claim == Claim::contact ? 1 : 0, r = c.weights_a.items.size() + c.weights_b.items.size();
  Count u = 0, b = bits(c.low.num) + bits(c.low.den);  // at least 1
  for (const MotionParts::Piece& piece : parts.pieces) {
    const bool near = piece.kind == MotionParts::Piece::Kind::near;
    ++(near ? ends : k);
    r += piece.weights[0].items.size() + piece.weights[1].items.size();
    u = std::max({u, widest(piece.n), widest(piece.g)});
    b = std::max(b, static_cast<Count>(bits(piece.end.num) + bits(piece.end.den)));
    if (near) b = std::max(b, static_cast<Count>(bits(piece.delta.num) + bits(piece.delta.den)));
  }
  constexpr Count places = 4, quaternions = 4;
  Width of_points(n + places, line, limits), of_turns(quaternions, line, limits), of_weights(r, line, limits);
  for (const Body* body : {&c.a, &c.b}) for_each_point(*body, [&](const RationalPoint& p) { of_points.take(p); });
  for (const MotionParts::Motion& motion : parts.motions) {
    for (const RationalPoint& p : motion.places) of_points.take(p);
    for (const MotionParts::Quaternion& q : motion.turns) of_turns.take(q.r), of_turns.take(q.v);
  }
  const auto take = [&](const Part<std::vector<Weight>>& weights) {
    for (const Weight& weight : weights.items) of_weights.take(weight.weight);
  };
  for (const auto* weights : {&c.weights_a, &c.weights_b}) take(*weights);
  for (const MotionParts::Piece& piece : parts.pieces)
    for (const auto& weights : piece.weights) take(weights);
  const Count w = of_points.value(), y = of_turns.value(), x = of_weights.value();
  if ((n + places) * w + quaternions * y + r * x + 2 * k * u > limits.size) throw of_points.too_large();

  const Count z = 2 * w + 4 * y + 12 * b + 2 * u + 32;
  Count work = product(product(6 * n, k), cost(z, w));
  work = sum(work, product(sum(200 * k, product(8 * n, ends)), cost(z, z)));
  work = sum(work, product(4 * r, cost(z + x, z + x)));
  require_work(work, line, limits);
  c.scale = of_points.denominator();
  parts.turning = of_turns.denominator();
}

}  // namespace

// The letters are those of section 8.
void require_limits(Certificate& c, std::size_t line, const Limits& limits) {
  if (c.format == 3) return require_limits_of_unions(c, line, limits);
  if (c.format == 5) return require_limits_of_solids(c, line, limits);
  if (c.format == 6) return require_limits_of_motions(c, line, limits);
  Count n = 0;
  for (const Body* body : {&c.a, &c.b}) for_each_point(*body, [&n](const RationalPoint&) { ++n; });
  const Count i = c.a.inner.items.size() + c.b.inner.items.size(), f = c.facets.items.size(),
              e = c.differences.items.size();
  const Count j = c.a.heights.items.size() + c.b.heights.items.size(), r = c.rays.items.size();
  const Count weights = c.weights_a.items.size() + c.weights_b.items.size();
  const Count k = c.directions.items.size() + r + 2 * c.lineality.items.size();
  const Count vectors = n + i + c.vertices.items.size() + 3 * f + e;

  Width of_points(vectors, line, limits), of_parameters(vectors, line, limits), of_heights(j, line, limits);
  for (const Body* body : {&c.a, &c.b}) {
    for_each_point(*body, [&of_points](const RationalPoint& p) { of_points.take(p); });
    for (const Place& place : body->inner.items) of_parameters.take(place.y);
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

void WorkOfTree::take(std::size_t constraints, std::size_t digits) {
  constexpr Count products_of_four = 8, products = 16;
  constexpr Count sums = 8;  // digits more than the products have
  const Count p = digits + sums;
  if (constraints == most_constraints) {
    total_ = sum(total_, product(products_of_four, cost(5 * p, 5 * p)));
  } else {
    const Count y = (2 * constraints + 2) * p + parts_->width_of_claim;
    total_ = sum(total_, product(products, cost(y, y + parts_->width_of_optima)));
  }
  constexpr std::size_t last_line = 0;
  require_work(total_, last_line, {});
}

}  // namespace fathom_check
