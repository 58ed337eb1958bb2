// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/approximate/separation.hpp"

#include "kernels/float_environment.hpp"
#include "kernels/number/lowest_terms.hpp"
#include "reference/approximate/grid/directions.hpp"
#include "reference/approximate/ray.hpp"

namespace fathom {
namespace {

constexpr std::uint64_t rays_between_reports = 64;

mpq_class quotient(const mpz_class& numerator, const mpz_class& denominator) {
  mpq_class q(numerator, denominator);
  q.canonicalize();
  return q;
}

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
  // The hit point lies on the plane <n,x> = height. Squared distances height^2 / <n,n> are compared.
  void offer(const Vector& n, const mpz_class& height) {
    if (!is_zero(result_.normal)) {
      const mpz_class mine = result_.height * result_.height * dot(n, n), other = height * height * dot(result_.normal, result_.normal);
      if (other > mine || (other == mine && !lexicographically_less(n, result_.normal))) return;
    }
    result_.normal = n;
    result_.height = height;
  }

  ApproxSeparation result_;
};

ApproxSeparation search(const Hierarchy& a, const Hierarchy& b, const DirectionGrid& grid, std::uint64_t rays, const Vector& shift,
                        const std::function<bool(double)>& progress) {
  const RayShooter shooter(a, b);
  Search search;
  for (std::uint64_t i = 0; i < rays; ++i) {
    if (progress && i % rays_between_reports == 0 && !progress(static_cast<double>(i) / static_cast<double>(rays))) throw Interrupted();
    const Vector u = grid.centre(i);
    if (!search.take(u, shooter.shoot(u, shift))) return search.result();
  }
  return search.result();
}

ApproxDepth result_of(const BodyPair& pair, const mpq_class& delta, const std::function<ApproxSeparation(const BodyPair&)>& separate) {
  ApproxDepth result;
  result.delta = delta;
  result.depth.status = pair.status();
  result.depth.direction = pair.separating();
  result.depth.flat_a = pair.flat_a();
  result.depth.flat_b = pair.flat_b();
  if (pair.status() != Status::penetrating) return result;
  const ApproxSeparation found = separate(pair);
  if (is_zero(found.normal)) throw std::logic_error("a ray from the interior of P found it flat or missed it");
  const Vector& n = found.normal;
  Depth& depth = result.depth;
  depth.direction = n;
  depth.translation = pair.translation(quotient(found.height, dot(n, n)), n);
  depth.squared = quotient(found.height * found.height, dot(n, n) * pair.lattice().denominator * pair.lattice().denominator);
  depth.contact = pair.contact(n);
  depth.witness = pair.witness(n, depth.translation);
  depth.extreme_a = static_cast<std::uint32_t>(pair.a().polytope().vertices.size());
  depth.extreme_b = static_cast<std::uint32_t>(pair.b().polytope().vertices.size());
  result.rays = found.rays;
  result.steps = found.steps;
  const mpq_class shrink = pair.lattice().denominator * (1 + delta);
  result.bound_squared = found.reach_squared / (shrink * shrink);
  return result;
}

std::function<bool(double)> named(const ReportProgress& progress) {
  if (!progress) return {};
  return [&progress](double share) { return progress("rays", share); };
}

void require_delta(const mpq_class& delta) {
  require_lowest_terms(delta);
  if (delta < least_delta) throw std::invalid_argument("an approximation needs a positive delta, 1e-9 or more");
}

}  // namespace

ApproxSeparation approx_separation(const Hierarchy& a, const Hierarchy& b, const mpq_class& delta, const Vector& shift,
                                   const std::function<bool(double)>& progress) {
  const DefaultFloatEnvironment environment;
  const DirectionGrid grid(delta, progress ? [&] { return progress(0); } : std::function<bool()>());
  return search(a, b, grid, grid.size(), shift, progress);
}

ApproxSeparation approx_width(const Hierarchy& body, const mpq_class& delta, const std::function<bool(double)>& progress) {
  const DefaultFloatEnvironment environment;
  const DirectionGrid grid(delta, progress ? [&] { return progress(0); } : std::function<bool()>());
  return search(body, body, grid, grid.size() / 2, {0, 0, 0}, progress);
}

ApproxDepth approx_depth(std::span<const Point> a, std::span<const Point> b, const mpq_class& delta, const ReportProgress& progress) {
  const DefaultFloatEnvironment environment;
  require_delta(delta);
  return result_of(BodyPair(a, b, progress), delta, [&](const BodyPair& pair) {
    return approx_separation(pair.a(), pair.b(), delta, {0, 0, 0}, named(progress));
  });
}

ApproxDepth approx_width(std::span<const Point> points, const mpq_class& delta, const ReportProgress& progress) {
  const DefaultFloatEnvironment environment;
  require_delta(delta);
  return result_of(BodyPair(points, points, progress), delta,
                   [&](const BodyPair& pair) { return approx_width(pair.a(), delta, named(progress)); });
}

}  // namespace fathom
