// SPDX-License-Identifier: Apache-2.0
// The part of limits.hpp on format 5.                               [FORMAT.md, sections 14 and 15]
#include <algorithm>

#include "combine.hpp"
#include "counts.hpp"
#include "solids.hpp"

namespace fathom_check {
namespace {

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

/// How many of the vertices of a polytope its facets name, each once.
Count count_named(const Facets& facets, std::size_t first, std::size_t last, std::size_t vertices) {
  std::vector<std::uint32_t> named(facets.corners.begin() + static_cast<std::ptrdiff_t>(facets.begin_of(first)),
                                   facets.corners.begin() + static_cast<std::ptrdiff_t>(facets.begin_of(last)));
  std::sort(named.begin(), named.end());
  const auto end = std::unique(named.begin(), named.end());
  return static_cast<Count>(std::lower_bound(named.begin(), end, vertices) - named.begin());
}

void add_polytopes(const Certificate& c, SizeAndWork& total) {
  List vertices{0, 0}, facets{0, 0};  // of the polytope before
  for (const InnerPolytope& polytope : c.of_unions.polytopes) {
    const Count v = polytope.vertices.end - vertices.end, p = polytope.facets.end - facets.end;
    const Facets& all = c.facets.items;
    const Count corners = all.begin_of(polytope.facets.end) - all.begin_of(facets.end), h = total.h;
    total.size = sum(total.size, product(2 * v + 12 * p, h));
    total.work = sum(total.work, product(3 * corners, cost(8 * h, 8 * h)));
    total.work =
        sum(total.work, product(product(p, count_named(all, facets.end, polytope.facets.end, v)), cost(10 * h, 2 * h)));
    vertices = polytope.vertices;
    facets = polytope.facets;
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
      const RationalPoint& p = body.points.items[*corner];
      result.take(p.x), result.take(p.y), result.take(p.z);
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
  Width of_optima(m, line, limits);
  for (const RationalPoint& t : parts.optima.items)
    for (const Rational* x : {&t.x, &t.y, &t.z}) of_optima.take(*x);
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

}  // namespace

void require_limits_of_solids(Certificate& c, std::size_t line, const Limits& limits) {
  if (c.claim != Claim::solid) return require_limits_of_two(c, line, limits);
  const SizeAndWork total = of_bodies({&c.a}, {PiecedBody(c.a)});
  if (total.size > limits.size) throw Width(0, line, limits).too_large();
  require_work(total.work, line, limits);
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
