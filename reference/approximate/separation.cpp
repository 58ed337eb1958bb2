// SPDX-License-Identifier: GPL-3.0-or-later
// A face of the cube is cut into side x side cells along the values g(t) of evenly spaced t in [-1,
// 1], with g(t) = (4 t + t^3) / 5: close enough to tan(pi t / 4) that the cells look about equally
// large from O, and a third fewer are needed than with g(t) = t.
#include "reference/approximate/separation.hpp"

#include <stdexcept>

#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/approximate/ray.hpp"

namespace fathom::approximate {
namespace {

/// Where a cell lies: on the positive or the negative side of an axis, in a row and a column.
struct Place {
  int axis;
  bool negative;
  std::int64_t row, column;
};

Place place(std::uint64_t cell, std::uint64_t side) {
  const std::uint64_t face = cell / (side * side), rest = cell % (side * side);
  return {static_cast<int>(face % 3), face >= 3, static_cast<std::int64_t>(rest / side),
          static_cast<std::int64_t>(rest % side)};
}

/// 5 side^3 g(i / side).
mpz_class bent(std::int64_t i, std::uint64_t side) {
  const mpz_class t = static_cast<long>(i), n = static_cast<unsigned long>(side);
  return t * (4 * n * n + t * t);
}

/// The point of the face at i / side and j / side, which run from -1 to 1.
Vector on_face(const Place& p, std::int64_t i, std::int64_t j, std::uint64_t side) {
  const mpz_class n = static_cast<unsigned long>(side);
  const mpz_class height = (p.negative ? -5 : 5) * n * n * n, y = bent(i, side), z = bent(j, side);
  const Vector v = p.axis == 0 ? Vector{height, y, z} : p.axis == 1 ? Vector{z, height, y} : Vector{y, z, height};
  return primitive(v);
}

/// Cells are carried into each other by the symmetries of the cube; one of each orbit is looked at:
/// on the face of positive x, in one eighth of it. The cone of directions that a centre covers is
/// convex, so that a cell is covered if its four corners are.
bool all_covered(kernels::Context& context, std::uint64_t side, const mpq_class& delta) {
  const Place face{0, false, 0, 0};
  const auto n = static_cast<std::int64_t>(side);
  for (std::int64_t i = n % 2 == 0 ? 1 : 0; i < n; i += 2) {
    context.check();
    for (std::int64_t j = n % 2 == 0 ? 1 : 0; j <= i; j += 2) {
      const Vector centre = on_face(face, i, j, side);
      for (const int di : {-1, 1}) {
        for (const int dj : {-1, 1}) {
          if (!covers(centre, on_face(face, i + di, j + dj, side), delta)) return false;
        }
      }
    }
  }
  return true;
}

// What the rays have found so far.
class RaysFromOrigin {
 public:
  /// False if the search is over: O is not inside P.
  bool take(const Vector& u, const RayHit& hit) {
    ++result_.rays;
    result_.steps += hit.steps;
    result_.inside = hit.hits;
    if (!hit.hits || sgn(hit.factor) == 0) {
      result_.normal = result_.ray = {0, 0, 0};
      result_.height = 0;
      result_.reach_squared = 0;
      return false;
    }
    offer(hit.normal, mpq_class(hit.factor * dot(hit.normal, u)).get_num());
    const mpq_class reach_squared = hit.factor * hit.factor * dot(u, u);
    if (result_.rays == 1 || reach_squared < result_.reach_squared) {
      result_.reach_squared = reach_squared;
      result_.ray = u;
    }
    return true;
  }

  [[nodiscard]] const ApproxSeparation& result() const { return result_; }

 private:
  // The hit point lies on the plane <n,x> = height. Squared distances height^2 / <n,n> are
  // compared.
  void offer(const Vector& n, const mpz_class& height) {
    if (!is_zero(result_.normal)) {
      const mpz_class mine = result_.height * result_.height * dot(n, n),
                      other = height * height * dot(result_.normal, result_.normal);
      if (other > mine || (other == mine && !lexicographically_less(n, result_.normal))) return;
    }
    result_.normal = n;
    result_.height = height;
  }

  ApproxSeparation result_;
};

ApproxSeparation search(kernels::Context& context, const polytope::Hierarchy& a, const polytope::Hierarchy& b,
                        const DirectionGrid& grid, std::uint64_t rays, const Vector& shift) {
  const RayShooter shooter(a, b);
  RaysFromOrigin search;
  for (std::uint64_t i = 0; i < rays; ++i) {
    if (i % rays_between_reports == 0) context.report("rays", static_cast<double>(i) / static_cast<double>(rays));
    const Vector u = grid.centre(i);
    if (!search.take(u, shooter.shoot(u, shift))) return search.result();
  }
  return search.result();
}

ApproxPenetration result_of(const BodyPair& pair, const mpq_class& delta, const ApproxSeparation& found) {
  if (is_zero(found.normal)) throw std::logic_error("a ray from the interior of P found it flat or missed it");
  const Vector& n = found.normal;
  const mpz_class& unit = pair.placed().denominator;
  const mpq_class shrink = unit * (1 + delta);
  ApproxPenetration result;
  result.squared = kernels::ratio(found.height * found.height, dot(n, n) * unit * unit);
  result.bound_squared = found.reach_squared / (shrink * shrink);
  result.direction = n;
  result.translation = pair.translation(kernels::ratio(found.height, dot(n, n)), n);
  BodyPair::Meeting meeting = pair.meeting(n, result.translation);
  result.contact = std::move(meeting.contact);
  result.witness = std::move(meeting.witness);
  result.rays = found.rays;
  result.steps = found.steps;
  return result;
}

void require_delta(const mpq_class& delta) {
  kernels::require_lowest_terms(delta);
  if (delta < least_delta) throw std::invalid_argument("an approximation needs a positive delta, 1e-9 or more");
}

}  // namespace

bool covers(const Vector& p, const Vector& v, const mpq_class& delta) {
  const mpz_class along = dot(v, p);
  if (along <= 0) return false;
  const mpz_class numerator = (delta.get_num() + delta.get_den()) * along;
  const mpz_class& denominator = delta.get_den();
  return numerator * numerator >= denominator * denominator * dot(v, v) * dot(p, p);
}

// The search begins where 4/3 / side^2 is just above 2 delta + delta^2, which is a cell or two from
// its end.
DirectionGrid::DirectionGrid(kernels::Context& context, const mpq_class& delta) : side_(1) {
  if (delta < least_delta) throw std::invalid_argument("a grid of directions needs a positive delta, 1e-9 or more");
  const mpq_class squared_tangent = delta * (2 + delta);
  const mpz_class square = mpz_class(4 * squared_tangent.get_den()) / mpz_class(3 * squared_tangent.get_num()),
                  begin = sqrt(square);
  if (begin > 1) side_ = begin.get_ui();  // less than 2^20
  while (!all_covered(context, side_, delta)) ++side_;
}

Vector DirectionGrid::centre(std::uint64_t cell) const {
  const Place p = place(cell, side_);
  const auto n = static_cast<std::int64_t>(side_);
  return on_face(p, 2 * p.row + 1 - n, 2 * p.column + 1 - n, side_);
}

std::array<Vector, 4> DirectionGrid::corners(std::uint64_t cell) const {
  const Place p = place(cell, side_);
  const auto n = static_cast<std::int64_t>(side_);
  const std::int64_t i = 2 * p.row - n, j = 2 * p.column - n;
  return {on_face(p, i, j, side_), on_face(p, i + 2, j, side_), on_face(p, i + 2, j + 2, side_),
          on_face(p, i, j + 2, side_)};
}

ApproxSeparation approx_separation(kernels::Context& context, const polytope::Hierarchy& a,
                                   const polytope::Hierarchy& b, const mpq_class& delta, const Vector& shift) {
  const kernels::DefaultFloatEnvironment environment;
  const DirectionGrid grid(context, delta);
  return search(context, a, b, grid, grid.size(), shift);
}

ApproxSeparation approx_width(kernels::Context& context, const polytope::Hierarchy& body, const mpq_class& delta) {
  const kernels::DefaultFloatEnvironment environment;
  const DirectionGrid grid(context, delta);
  return search(context, body, body, grid, grid.size() / 2, {0, 0, 0});
}

}  // namespace fathom::approximate

namespace fathom {

ApproxDepth Hierarchies::approx_depth(const mpq_class& delta, Monitor* monitor) const {
  const kernels::DefaultFloatEnvironment environment;
  approximate::require_delta(delta);
  kernels::Context context(monitor);
  const BodyPair& pair = *pair_;
  if (pair.separation()) return {{pair.facts(), *pair.separation()}, delta};
  return {{pair.facts(),
           approximate::result_of(pair, delta, approximate::approx_separation(context, pair.a(), pair.b(), delta))},
          delta};
}

ApproxDepth approx_depth(std::span<const Point> a, std::span<const Point> b, const mpq_class& delta, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  approximate::require_delta(delta);
  return Hierarchies(a, b, monitor).approx_depth(delta, monitor);
}

ApproxDepth approx_width(std::span<const Point> points, const mpq_class& delta, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  approximate::require_delta(delta);
  kernels::Context context(monitor);
  const BodyPair pair(context, points, points);
  if (pair.separation()) return {{pair.facts(), *pair.separation()}, delta};
  return {{pair.facts(), approximate::result_of(pair, delta, approximate::approx_width(context, pair.a(), delta))},
          delta};
}

}  // namespace fathom
