// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rounded/optimal_cone.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "kernels/vector.hpp"
#include "reference/depth/contact.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/solve/depth.hpp"

namespace fathom::rounded {
namespace {

constexpr std::size_t few = 8;  // generators: to clip by all of them takes less than to find those that cut

using Directions = std::set<Vector, LexicographicOrder>;

// p u + q v, primitive.
Vector combined(const mpz_class& p, const Vector& u, const mpz_class& q, const Vector& v) {
  return primitive({p * u.x + q * v.x, p * u.y + q * v.y, p * u.z + q * v.z});
}

// A point over its common denominator.
struct Fraction {
  mpz_class denominator;
  Vector numerators;
};

Fraction fraction(const Point& p) {
  const mpz_class &x = p.x.get_den(), &y = p.y.get_den(), &z = p.z.get_den();
  if (x == y && y == z) return {x, {p.x.get_num(), p.y.get_num(), p.z.get_num()}};
  const mpz_class unit = lcm(lcm(x, y), z);
  return {unit, {p.x.get_num() * (unit / x), p.y.get_num() * (unit / y), p.z.get_num() * (unit / z)}};
}

// p - q, times both denominators.
Vector between(const Fraction& q, const Fraction& p) {
  const auto along = [&](const mpz_class& to, const mpz_class& from) {
    return mpz_class(to * q.denominator - from * p.denominator);
  };
  return {along(p.numerators.x, q.numerators.x), along(p.numerators.y, q.numerators.y),
          along(p.numerators.z, q.numerators.z)};
}

// One line leaves the lineality: the half of it below g becomes a ray, everything else is moved
// along it into the plane of g.
void cut_line(ClippedCone& cone, std::size_t i, const Vector& g) {
  Vector ray = std::move(cone.lines[i]);
  cone.lines.erase(cone.lines.begin() + static_cast<std::ptrdiff_t>(i));
  mpz_class below = -dot(g, ray);
  if (below < 0) (below = -below, ray = -ray);
  for (std::vector<Vector>* const all : {&cone.lines, &cone.rays})
    for (Vector& v : *all) v = combined(below, v, dot(g, v), ray);
  cone.rays.push_back(std::move(ray));
}

void cut_rays(ClippedCone& cone, const Vector& g) {
  if (std::all_of(cone.rays.begin(), cone.rays.end(), [&](const Vector& ray) { return dot(g, ray) <= 0; })) return;
  std::vector<mpz_class> height;
  for (const Vector& ray : cone.rays) height.push_back(dot(g, ray));
  std::vector<Vector> kept;
  const std::size_t size = cone.rays.size();
  for (std::size_t i = 0; i < size; ++i) {
    if (height[i] <= 0) kept.push_back(cone.rays[i]);
    const std::size_t next = (i + 1) % size;
    if (size == 2 && next == 0) break;  // two rays are neighbours once
    if (sgn(height[i]) * sgn(height[next]) < 0)
      kept.push_back(combined(abs(height[next]), cone.rays[i], abs(height[i]), cone.rays[next]));
  }
  cone.rays = std::move(kept);
}

// The greater one of v and -v.
Vector upper(const Vector& v) { return lexicographically_less(v, -v) ? -v : v; }

Vector lower(const Vector& v) { return lexicographically_less(v, -v) ? v : -v; }

// The generators of bodies on a lattice, times the denominator k of the common point in its units:
// k b - v and v - k a, for the point v / k.
class Generators {
 public:
  Generators(const polytope::PlacedPair& pair, const Point& x) : pair_(pair), common_(fraction(on_lattice(pair, x))) {}

  [[nodiscard]] Vector of_a(const Vector& p) const { return common_.numerators - multiple(p); }
  [[nodiscard]] Vector of_b(const Vector& p) const { return multiple(p) - common_.numerators; }

  // One that the direction is not below.
  [[nodiscard]] std::optional<Vector> above(const Vector& u) const {
    Vector g = of_b(pair_.b[kernels::extreme_points(pair_.b, u).front()]);
    if (dot(g, u) > 0) return g;
    g = of_a(pair_.a[kernels::extreme_points(pair_.a, -u).front()]);
    return dot(g, u) > 0 ? std::optional(std::move(g)) : std::nullopt;
  }

 private:
  static Point on_lattice(const polytope::PlacedPair& pair, const Point& x) {
    const auto along = [&](const mpq_class& c, const mpq_class& origin) {
      return mpq_class((c - origin) * pair.denominator);
    };
    return {along(x.x, pair.origin.x), along(x.y, pair.origin.y), along(x.z, pair.origin.z)};
  }

  [[nodiscard]] Vector multiple(const Vector& p) const {
    const mpz_class& k = common_.denominator;
    return k == 1 ? p : Vector{k * p.x, k * p.y, k * p.z};
  }

  const polytope::PlacedPair& pair_;
  Fraction common_;
};

// A generator above one of the rays and lines that span the cone; nullopt if there is none. `below`
// are directions that none is above.
std::optional<Vector> next_cut(const ClippedCone& cone, const Generators& generators, Directions& below) {
  const auto cut = [&](const Vector& u) {
    if (below.contains(u)) return std::optional<Vector>();
    std::optional<Vector> g = generators.above(u);
    if (!g) below.insert(u);
    return g;
  };
  for (const Vector& line : cone.lines)
    for (const Vector& u : {line, -line})
      if (std::optional<Vector> g = cut(u)) return g;
  for (const Vector& ray : cone.rays)
    if (std::optional<Vector> g = cut(ray)) return g;
  return std::nullopt;
}

void require_some(const ClippedCone& cone) {
  if (cone.lines.empty() && cone.rays.empty()) throw std::logic_error("no plane separates bodies that touch");
}

// The sign of h(u).
int support_sign(polytope::Positions a, polytope::Positions b, const Vector& u) {
  const Point &p = a[solve::extreme_points(a, -u).front()], &q = b[solve::extreme_points(b, u).front()];
  return sgn(mpq_class(u.x * (q.x - p.x) + u.y * (q.y - p.y) + u.z * (q.z - p.z)));
}

}  // namespace

ClippedCone whole_space() {
  ClippedCone cone{std::vector<Vector>(3), {}};
  cone.lines[0].x = cone.lines[1].y = cone.lines[2].z = 1;
  return cone;
}

void clip(ClippedCone& cone, const Vector& g) {
  for (std::size_t i = 0; i < cone.lines.size(); ++i)
    if (dot(g, cone.lines[i]) != 0) return cut_line(cone, i, g);
  cut_rays(cone, g);
}

OptimalCone canonical(ClippedCone cone) {
  OptimalCone result{static_cast<Lineality>(cone.lines.size()), {}, std::move(cone.rays)};
  if (cone.lines.size() == 1) {
    const Vector& line = result.axis = upper(primitive(cone.lines[0]));
    for (Vector& ray : result.rays) ray = combined(dot(line, line), ray, -dot(ray, line), line);
  }
  if (cone.lines.size() == 2) {
    result.axis = upper(primitive(cross(cone.lines[0], cone.lines[1])));
    for (Vector& ray : result.rays) ray = dot(ray, result.axis) > 0 ? result.axis : -result.axis;
  }
  std::sort(result.rays.begin(), result.rays.end(), lexicographically_less);
  return result;
}

// Where the bodies meet in the known direction all generators cut; elsewhere only some that are
// above a direction of the cone so far.
OptimalCone optimal_cone(kernels::Context& context, const polytope::PlacedPair& pair, const Point& x,
                         const Vector& known) {
  context.report("optimal cone");
  const bool all = pair.a.size() + pair.b.size() <= few;
  const Vector u = all ? Vector{} : known;  // in direction 0 every point is extreme
  const Generators generators(pair, x);
  ClippedCone cone = whole_space();
  for (const std::uint32_t j : kernels::extreme_points(pair.b, u)) clip(cone, generators.of_b(pair.b[j]));
  for (const std::uint32_t i : kernels::extreme_points(pair.a, -u)) clip(cone, generators.of_a(pair.a[i]));
  Directions below{known};
  while (!all) {
    const std::optional<Vector> g = next_cut(cone, generators, below);
    if (!g) break;
    clip(cone, *g);
    context.check();
  }
  require_some(cone);
  return canonical(std::move(cone));
}

OptimalCone optimal_cone(kernels::Context& context, polytope::Positions a, polytope::Positions b, const Point& x) {
  context.report("optimal cone");
  ClippedCone cone = whole_space();
  const Fraction common = fraction(x);
  const auto clip_all = [&](polytope::Positions points, const auto& generator) {
    for (const Point& p : points) {
      clip(cone, generator(p));
      context.check();
    }
  };
  clip_all(b, [&](const Point& p) { return between(common, fraction(p)); });
  clip_all(a, [&](const Point& p) { return between(fraction(p), common); });
  require_some(cone);
  return canonical(std::move(cone));
}

// The sum of all extreme rays is inside the part orthogonal to the lineality. Without rays the cone
// is a linear space.
Vector inner_direction(const OptimalCone& cone) {
  if (cone.rays.empty()) return cone.direction();
  Vector sum;
  for (const Vector& ray : cone.rays) sum = sum + ray;
  return primitive(sum);
}

// Only the extreme points are placed on a lattice.
Contact contact_along(polytope::Positions a, polytope::Positions b, const Vector& n) {
  const std::vector<std::uint32_t> ids_a = solve::extreme_points(a, -n), ids_b = solve::extreme_points(b, n);
  const auto chosen = [](polytope::Positions points, const std::vector<std::uint32_t>& ids) {
    std::vector<Point> result;
    for (const std::uint32_t i : ids) result.push_back(points[i]);
    return result;
  };
  Contact contact = depth::contact_of(depth::facing_faces(polytope::place(chosen(a, ids_a), chosen(b, ids_b)), n));
  for (std::uint32_t& i : contact.a) i = ids_a[i];
  for (std::uint32_t& i : contact.b) i = ids_b[i];
  return contact;
}

PlanesBetween planes_between(kernels::Context& context, std::optional<polytope::PlacedPair> pair, polytope::Positions a,
                             polytope::Positions b, const Touch& touch) {
  if (!pair) pair = polytope::place_if_slim(a, b, &context);
  OptimalCone cone =
      pair ? optimal_cone(context, *pair, touch.point, touch.direction) : optimal_cone(context, a, b, touch.point);
  const Vector n = inner_direction(cone);
  return {std::move(cone), pair ? depth::contact_of(depth::facing_faces(*pair, n)) : contact_along(a, b, n)};
}

std::vector<Vector> lineality_basis(const OptimalCone& cone) {
  if (cone.lineality == Lineality::all) return whole_space().lines;
  if (cone.lineality == Lineality::line) return {cone.axis};
  std::vector<Vector> basis;
  if (cone.lineality == Lineality::plane) {
    for (const Vector& e : whole_space().lines) {
      const Vector v = primitive(cross(cone.axis, e));
      if (!is_zero(v) && (basis.empty() || (basis.size() == 1 && !is_zero(cross(basis.front(), v)))))
        basis.push_back(v);
    }
  }
  return basis;
}

kernels::Report validate(const OptimalCone& cone, polytope::Positions a, polytope::Positions b) {
  kernels::Report report;
  const bool axis = cone.lineality == Lineality::line || cone.lineality == Lineality::plane;
  report.expect(is_zero(cone.axis) != axis, "an axis of a lineality that has none, or none");
  report.expect(cone.axis == upper(primitive(cone.axis)), "the axis is not canonical");
  report.expect(std::is_sorted(cone.rays.begin(), cone.rays.end(), lexicographically_less), "the rays are not sorted");
  std::vector<Vector> optimal = cone.rays;
  for (const Vector& ray : cone.rays) {
    report.expect(!is_zero(ray) && ray == primitive(ray), "a ray is not primitive");
    if (cone.lineality == Lineality::line)
      report.expect(dot(ray, cone.axis) == 0, "a ray is not orthogonal to the line");
    if (cone.lineality == Lineality::plane)
      report.expect(is_zero(cross(ray, cone.axis)), "a ray is not orthogonal to the plane");
  }
  for (const Vector& line : lineality_basis(cone)) optimal.insert(optimal.end(), {line, -line});
  report.expect(!optimal.empty(), "no direction");
  for (const Vector& u : optimal)
    report.expect(support_sign(a, b, u) == 0, "a plane in an optimal direction does not separate the bodies");
  return report;
}

}  // namespace fathom::rounded

namespace fathom {

Vector OptimalCone::direction() const {
  if (!rays.empty()) return rays.front();
  if (lineality != Lineality::plane) return lineality == Lineality::line ? rounded::lower(axis) : Vector{-1, 0, 0};
  std::optional<Vector> least;
  for (const Vector& e : rounded::whole_space().lines) {
    const Vector v = rounded::lower(primitive(cross(axis, e)));
    if (!is_zero(v) && (!least || lexicographically_less(v, *least))) least = v;
  }
  return *least;
}

}  // namespace fathom
