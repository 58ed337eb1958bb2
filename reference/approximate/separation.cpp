// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/approximate/separation.hpp"

#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/approximate/body_pair.hpp"
#include "reference/approximate/directions.hpp"
#include "reference/approximate/ray.hpp"

namespace fathom::approximate {
namespace {

constexpr std::uint64_t rays_between_reports = 64;

// What the rays have found so far.
class Search {
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
  Search search;
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
