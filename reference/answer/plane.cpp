// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where bodies of the plane are raised, and where answers come back.
#include "reference/answer/plane.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/plane.hpp"
#include "fathom/union.hpp"
#include "kernels/number/rational.hpp"
#include "reference/certificate/certificate.hpp"
#include "reference/depth/contact.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/shapes/core.hpp"

namespace fathom::answer {
namespace {

// ---- raising ----

/// Calls `use` with each hull of points that the body consists of: with none of a half-plane.
template <class Use>
void for_each_hull(const Body& body, const Use& use) {
  if (body.pieces) {
    for (const std::vector<Point>& piece : *body.pieces) use(piece);
  } else if (!body.shape) {
    use(body.points.exact());
  } else if (const auto points = files::points_of(*body.shape)) {
    use(*points);
  }
}

mpq_class extent_along_x(const Body& body) {
  std::optional<mpq_class> low, high;
  for_each_hull(body, [&](const std::vector<Point>& points) {
    for (const Point& p : points) {
      if (!low || p.x < *low) low = p.x;
      if (!high || p.x > *high) high = p.x;
    }
  });
  return low ? mpq_class(*high - *low) : mpq_class(0);
}

std::vector<Point> raised(const std::vector<Point>& points, const mpq_class& height) {
  std::vector<Point> result;
  result.reserve(2 * points.size());
  for (const mpq_class& z : {mpq_class(-height), height})
    for (const Point& p : points) result.push_back({p.x, p.y, z});
  return result;
}

GivenPoints raised(const GivenPoints& points, const mpq_class& height) {
  const std::optional<double> h = kernels::in_binary64(height);
  if (!points.in_binary64() || !h) return raised(points.exact(), height);
  std::vector<std::array<double, 3>> result;
  result.reserve(2 * points.size());
  for (const double z : {-*h, *h})
    for (const std::array<double, 3>& p : points.binary64()) result.push_back({p[0], p[1], z});
  return GivenPoints(std::move(result));
}

Body raised(const Body& body, const mpq_class& height) {
  Body result;
  if (body.pieces) {
    Pieces pieces;
    for (const std::vector<Point>& piece : *body.pieces) pieces.push_back(raised(piece, height));
    result.pieces = std::make_shared<const Pieces>(std::move(pieces));
  } else if (body.shape) {
    result.shape = Shape{hull(raised(*files::points_of(*body.shape), height)).core, body.shape->radius};
  } else {
    result.points = raised(body.points, height);
  }
  return result;
}

Body flat_in_space(const Body& body) {
  Body result = body;
  result.dimension = 3;
  return result;
}

// ---- coming back: what is left of points and faces of the prisms ----

std::vector<std::uint32_t> mapped(const std::vector<std::uint32_t>& ids, std::size_t count) {
  std::vector<std::uint32_t> result;
  for (const std::uint32_t id : ids) result.push_back(id % static_cast<std::uint32_t>(count));
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

Contact mapped(const Contact& contact, std::size_t count_a, std::size_t count_b) {
  Contact result{{}, mapped(contact.a, count_a), mapped(contact.b, count_b)};
  result.kind = kind_in_plane(result.a.size() > 1, result.b.size() > 1);
  return result;
}

/// How many points the body has, or a piece of it.
std::size_t count_of(const Body& body, std::uint32_t piece = 0) {
  if (body.pieces) return (*body.pieces)[piece].size();
  return body.shape ? files::points_of(*body.shape).value_or(std::vector<Point>()).size() : body.points.size();
}

Depth mapped(const Body& a, const Body& b, const Depth& of_prisms) {
  const auto of_plane = [&, count_a = count_of(a), count_b = count_of(b)](const Contact& contact) {
    return mapped(contact, count_a, count_b);
  };
  Depth depth;
  depth.flat_a = is_flat_body(a);
  depth.flat_b = is_flat_body(b);
  depth.extreme_a = of_prisms.extreme_a;
  depth.extreme_b = of_prisms.extreme_b / 2;
  depth.method = of_prisms.method;
  depth.counters = of_prisms.counters;
  if (const Touch* const touch = of_prisms.touch()) {
    depth.outcome = *touch;
  } else if (const Distance* const distance = of_prisms.distance()) {
    Distance& mapped_distance = depth.outcome.emplace<Distance>(*distance);
    mapped_distance.contact = of_plane(distance->contact);
  } else {
    const Penetration& penetration = *of_prisms.penetration();
    Penetration result{{}, penetration.unlisted, penetration.meeting, std::nullopt};
    for (const Optimum& optimum : penetration.optima)
      result.optima.push_back({optimum.direction, optimum.support, of_plane(optimum.contact)});
    depth.outcome = std::move(result);
  }
  return depth;
}

SignedDepth mapped(const Body& a, const Body& b, SignedDepth depth) {
  if (const Depth* const cores = std::get_if<Depth>(&depth.core)) depth.core = mapped(a, b, *cores);
  if (depth.cone) depth.cone = cone_in_plane(*std::move(depth.cone));
  if (depth.touching) depth.touching = mapped(*depth.touching, count_of(a), count_of(b));
  return depth;
}

UnionDepth mapped(const Body& a, const Body& b, UnionDepth depth) {
  for (UnionOptimum& optimum : depth.optima)
    for (PieceContact& met : optimum.contacts)
      met.contact = mapped(met.contact, count_of(a, met.a), count_of(b, met.b));
  if (depth.apart) {
    Distance& distance = depth.apart->distance;
    distance.contact = mapped(distance.contact, count_of(a, depth.apart->a), count_of(b, depth.apart->b));
    distance.witness.a.z = distance.witness.b.z = 0;
  }
  return depth;
}

void require_z_0(const std::vector<Point>& points) {
  if (std::ranges::any_of(points, [](const Point& p) { return p.z != 0; }))
    throw std::invalid_argument("a point of a body of the plane has the z 0, found another");
}

/// By a lattice if the points have a narrow one.
bool is_flat_polytope(const Body& body) {
  polytope::NarrowMemory placed;
  kernels::ScanMemory scans;
  const polytope::Points points(body.points);
  if (!polytope::place_narrow(points, points, placed)) return is_flat(files::shape_of(body));
  return polytope::with_pair(placed, points, points, scans,
                             [](const auto& pair) { return depth::facts_of(pair).flat_a; });
}

}  // namespace

mpq_class height_above(const Body& a, const Body& b) {
  const mpq_class sum = extent_along_x(a) + extent_along_x(b);
  // 2^(bits of the numerator - those of the denominator) is more than half of the sum.
  const auto bits = [](const mpz_class& n) { return static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2)); };
  const long exponent = bits(sum.get_num()) - bits(sum.get_den());
  mpq_class power = 1;
  if (exponent >= 0) mpz_mul_2exp(power.get_num_mpz_t(), power.get_num_mpz_t(), static_cast<unsigned long>(exponent));
  else mpz_mul_2exp(power.get_den_mpz_t(), power.get_den_mpz_t(), static_cast<unsigned long>(-exponent));
  while (power <= sum) power *= 2;
  return power;
}

Prisms prisms_of(const Body& a, const Body& b) {
  if (a.dimension != 2 || b.dimension != 2)
    throw std::invalid_argument("a body of the plane and one of space are given: both must be of one of them");
  if (shapes::is_halfspace(a) || shapes::is_halfspace(b)) return {flat_in_space(a), flat_in_space(b), 0};
  mpq_class height = height_above(a, b);
  Body raised_b = raised(b, height);
  return {a.pieces || b.pieces ? raised(a, height) : flat_in_space(a), std::move(raised_b), std::move(height)};
}

// Prisms that are made higher have the same ways out and the same proof, as all else moves away
// from O.
mpq_class proving_height(const Prisms& prisms, const Answer& of_prisms) {
  mpq_class height = prisms.height > 0 ? prisms.height : mpq_class(1);
  const auto* const depth = std::get_if<SignedDepth>(&of_prisms.found);
  if (depth == nullptr) return height;
  while (height <= depth->radius_a + depth->radius_b || compare(*depth->exact(), height) >= 0) height *= 2;
  return height;
}

std::string certificate_in_plane(const Body& a, const Body& b, const Answer& answer, std::string_view id,
                                 ShapeFormat format, Monitor* monitor) {
  const Prisms prisms = prisms_of(a, b);
  const auto* const shapes = std::get_if<SignedDepth>(&answer.prisms->found);
  const std::string text =
      shapes ? certificate_text(files::shape_of(prisms.a), files::shape_of(prisms.b), *shapes, id, format, monitor)
             : certificate_text(prisms.a, prisms.b, *answer.prisms, id, monitor);
  return certificate::in_plane(text, proving_height(prisms, *answer.prisms), prisms.height > 0);
}

OptimalCone cone_in_plane(OptimalCone cone) {
  if (cone.lineality == Lineality::plane) cone = {Lineality::all, {}, {}};
  return cone;
}

Answer in_plane(const Body& a, const Body& b, Answer of_prisms) {
  auto prisms = std::make_shared<const Answer>(std::move(of_prisms));
  return std::visit([&](const auto& found) { return Answer{mapped(a, b, found), std::move(prisms)}; }, prisms->found);
}

bool is_flat_body(const Body& body) {
  if (body.dimension == 3 && !body.pieces && !body.shape) return is_flat_polytope(body);
  if (body.dimension == 3) return !body.pieces && is_flat(*body.shape);
  if (body.pieces || (body.shape && (body.shape->radius > 0 || shapes::is_halfspace(*body.shape)))) return false;
  bool flat = true;
  for_each_hull(body, [&](const std::vector<Point>& points) {
    const Point& o = points.front();
    const auto other = std::ranges::find_if(points, [&](const Point& p) { return p != o; });
    if (other == points.end()) return;
    const mpq_class x = other->x - o.x, y = other->y - o.y;
    flat = std::ranges::all_of(points, [&](const Point& p) { return x * (p.y - o.y) == y * (p.x - o.x); });
  });
  return flat;
}

}  // namespace fathom::answer

namespace fathom {

Body in_plane(Body body) {
  if (body.solid) throw std::invalid_argument("the solid of a mesh is no body of the plane");
  if (body.shape) {
    shapes::require_shape(*body.shape);
    Shape shape = shapes::simplified(*body.shape);
    if (const HalfSpace* const half = std::get_if<HalfSpace>(&shape.core)) {
      answer::require_z_0({half->normal});
    } else {
      const auto points = shapes::polytope_points(shape, most_expanded_points);
      if (!points) throw std::invalid_argument("the core of a body of the plane is a polygon, found a curved one");
      shape.core = hull(*points).core;
    }
    body.shape = std::move(shape);
  }
  answer::for_each_hull(body, answer::require_z_0);
  body.words = nullptr;
  body.faces = nullptr;
  body.dimension = 2;
  return body;
}

}  // namespace fathom
