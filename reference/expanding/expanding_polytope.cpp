// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/expanding/expanding_polytope.hpp"

#include <queue>
#include <stdexcept>

#include "kernels/filters/double_images.hpp"
#include "kernels/number/ratio.hpp"
#include "reference/expanding/inner_polytope.hpp"
#include "reference/expanding/start.hpp"
#include "reference/expanding/surface.hpp"

namespace fathom::expanding {
namespace {

// A squared distance from O, as a quotient, and a binary64 number that the distance does not exceed.
struct Radius {
  mpz_class numerator, denominator = 1;
  double from_above = 0;
};

// A queue of triangles, the one that seems nearest first.
class Waiting {
 public:
  void add(double distance, TriangleId triangle) { queue_.emplace(-distance, triangle); }
  [[nodiscard]] bool empty() const { return queue_.empty(); }
  TriangleId take() {
    const TriangleId triangle = queue_.top().second;
    queue_.pop();
    return triangle;
  }

 private:
  std::priority_queue<std::pair<double, TriangleId>> queue_;
};

class Expander {
 public:
  Expander(kernels::Context& context, const kernels::PointCloud& a, const kernels::PointCloud& b, std::size_t budget)
      : context_(context), a_(a), b_(b), exponent_(a.exponent()), budget_(budget), differences_{a, b} {
    if (a.size() == 0 || b.size() == 0) throw std::invalid_argument("an expanding polytope of an empty body");
    if (a.exponent() != b.exponent()) throw std::invalid_argument("an expanding polytope of clouds that differ in their exponents");
  }

  // False if P is flat.
  bool start() {
    const auto first = starting_tetrahedron(differences_);
    if (!first) return false;
    surface_.emplace(std::array{vertex((*first)[0]), vertex((*first)[1]), vertex((*first)[2]), vertex((*first)[3])}, exponent_);
    wait_for_all();
    return true;
  }

  ExpansionEnd find_nearest() {
    Radius radius;
    return grow([&](TriangleId t) { return !nearest.empty() && beyond(t, radius, false); },
                [&](const ExactPlane& plane) {
                  if (nearest.offer(plane.normal, plane.height)) radius = radius_of(nearest.numerator(), nearest.denominator());
                  return true;
                });
  }

  // Expands until Q holds the ball. Sets `holds` to whether P does.
  ExpansionEnd fill_ball(const mpq_class& squared, bool& holds) {
    const Radius radius = radius_of(squared.get_num(), squared.get_den());
    bool met = false;  // a facet of P that cuts the ball
    const ExpansionEnd end = grow([&](TriangleId t) { return beyond(t, radius, true); },
                                  [&](const ExactPlane&) {
                                    met = true;
                                    return false;
                                  });
    holds = end == ExpansionEnd::proved && !met;
    return end;
  }

  // Expands until Q's triangles are no nearer than `next`, which shrinks to each facet distance found, ignoring facets at `depth`.
  ExpansionEnd find_next(const mpq_class& depth, mpq_class& next) {
    Radius radius = radius_of(next.get_num(), next.get_den());
    return grow([&](TriangleId t) { return beyond(t, radius, true); },
                [&](const ExactPlane& plane) {
                  const mpq_class squared = kernels::ratio(plane.height * plane.height, dot(plane.normal, plane.normal));
                  if (squared != depth) {
                    next = squared;
                    radius = radius_of(next.get_num(), next.get_den());
                  }
                  return true;
                });
  }

  // Expands until some direction n is known to have h(n)^2 <= squared <n,n>. Sets `direction` to it, or leaves it as it is if there is
  // none.
  ExpansionEnd find_direction(const mpq_class& squared, Vector& direction) {
    wait_for_all();
    while (!waiting_.empty()) {
      const TriangleId t = waiting_.take();
      if (!surface_->triangles()[t].alive) continue;
      const Vector normal = surface_->plane(t).normal;
      if (shows(normal, squared)) {
        direction = primitive(normal);
        return ExpansionEnd::proved;
      }
      std::optional<SurfaceVertex> above = point_above(t);
      if (above && !expand(std::move(*above), t)) return ExpansionEnd::spent;
    }
    return ExpansionEnd::proved;
  }

  // Takes triangle after triangle, except those that `pass_over` skips, and expands Q towards a point of P above it. A triangle with
  // nothing above it lies in the plane of a facet of P, which `go_on` gets.
  template <class PassOver, class GoOn>
  ExpansionEnd grow(PassOver pass_over, GoOn go_on) {
    while (!waiting_.empty()) {
      const TriangleId t = waiting_.take();
      if (!surface_->triangles()[t].alive || pass_over(t)) continue;
      if (std::optional<SurfaceVertex> above = point_above(t)) {
        if (!expand(std::move(*above), t)) return ExpansionEnd::spent;
        continue;
      }
      const ExactPlane& plane = surface_->plane(t);
      if (plane.height <= 0) return ExpansionEnd::not_inside;
      if (!go_on(plane)) return ExpansionEnd::proved;
    }
    return ExpansionEnd::proved;
  }

  bool shows(const Vector& n, const mpq_class& squared) {
    if (is_zero(n)) return false;
    const mpz_class h = dot(n, differences_[differences_.extreme(n)]);
    return h > 0 && h * h * squared.get_den() <= squared.get_num() * dot(n, n);
  }

  InnerPolytope inner() { return inner_polytope(*surface_); }

  kernels::NearestPlanes nearest;
  std::size_t points = 0;

 private:
  SurfaceVertex vertex(polytope::Difference d) const {
    Vector exact = b_[d.second] - a_[d.first];
    const Vec3<double> rounded = kernels::image(exact, exponent_);
    return {d, std::move(exact), rounded};
  }

  [[nodiscard]] Radius radius_of(const mpz_class& numerator, const mpz_class& denominator) const {
    return {numerator, denominator, kernels::root_from_above(numerator, denominator, exponent_)};
  }

  void wait_for(TriangleId t) { waiting_.add(estimated_distance(t), t); }

  void wait_for_all() {
    for (const TriangleId t : surface_->triangles().ids())
      if (surface_->triangles()[t].alive) wait_for(t);
  }

  // Decides nothing but the order.
  double estimated_distance(TriangleId t) {
    const kernels::RoundedPlane& rounded = surface_->triangles()[t].rounded;
    if (rounded.trustworthy()) return rounded.estimated_distance();
    const ExactPlane& plane = surface_->plane(t);
    const double distance = kernels::root_from_above(plane.height * plane.height, dot(plane.normal, plane.normal), exponent_);
    return plane.height < 0 ? -distance : distance;
  }

  // Whether O lies below the plane, at a greater distance than the radius, or perhaps an equal one.
  bool beyond(TriangleId t, const Radius& radius, bool or_equal) {
    if (surface_->triangles()[t].rounded.surely_beyond(radius.from_above)) return true;
    const ExactPlane& plane = surface_->plane(t);
    if (plane.height <= 0) return false;
    const mpz_class mine = plane.height * plane.height * radius.denominator, limit = radius.numerator * dot(plane.normal, plane.normal);
    return or_equal ? mine >= limit : mine > limit;
  }

  // Returns a point of P strictly above the triangle's plane: a guess that an exact sign confirms, or an extreme point. Returns nullopt if
  // the plane supports P.
  std::optional<SurfaceVertex> point_above(TriangleId t) {
    SurfaceVertex guess = vertex(likely_extreme(t));
    if (surface_->side(t, guess) > 0) return guess;
    SurfaceVertex extreme = vertex(differences_.extreme(surface_->plane(t).normal));
    if (surface_->side(t, extreme) > 0) return extreme;
    return std::nullopt;
  }

  polytope::Difference likely_extreme(TriangleId t) {
    const kernels::RoundedPlane& plane = surface_->triangles()[t].rounded;
    Vec3<double> n = plane.estimated_normal();
    if (!plane.trustworthy()) {
      const Vector& exact = surface_->plane(t).normal;
      n = kernels::image(exact, kernels::binary_exponent({&exact, 1}));
    }
    return {kernels::likely_extreme_point(a_, -n), kernels::likely_extreme_point(b_, n)};
  }

  bool expand(SurfaceVertex above, TriangleId t) {
    if (points == budget_) return false;
    context_.report("expanding polytope");
    ++points;
    for (const TriangleId fresh : surface_->insert(std::move(above), t)) wait_for(fresh);
    return true;
  }

  kernels::Context& context_;
  const kernels::PointCloud& a_;
  const kernels::PointCloud& b_;
  long exponent_;
  std::size_t budget_;
  polytope::Differences differences_;
  std::optional<Surface> surface_;
  Waiting waiting_;
};

}  // namespace

Expansion nearest_by_expansion(kernels::Context& context, const kernels::PointCloud& a, const kernels::PointCloud& b, std::size_t budget) {
  Expander expander(context, a, b, budget);
  Expansion result;
  result.end = expander.start() ? expander.find_nearest() : ExpansionEnd::not_inside;
  result.points = expander.points;
  if (result.end != ExpansionEnd::proved) return result;
  result.nearest = std::move(expander.nearest);
  result.inner = expander.inner();
  return result;
}

BallExpansion expand_to_ball(kernels::Context& context, const kernels::PointCloud& a, const kernels::PointCloud& b, const mpq_class& low,
                             const mpq_class& high, const std::optional<Vector>& hint, std::size_t budget) {
  Expander expander(context, a, b, budget);
  BallExpansion result;
  result.end = expander.start() ? expander.fill_ball(low, result.low_holds) : ExpansionEnd::not_inside;
  if (result.end != ExpansionEnd::proved) return result;
  if (result.low_holds) result.inner = expander.inner();
  if (hint && expander.shows(*hint, high)) result.direction = primitive(*hint);
  else result.end = expander.find_direction(high, result.direction);
  result.high_holds = !is_zero(result.direction);
  return result;
}

mpq_class next_nearest_by_expansion(kernels::Context& context, const kernels::PointCloud& a, const kernels::PointCloud& b,
                                    const mpq_class& nearest, const mpq_class& bound) {
  Expander expander(context, a, b, unlimited);
  mpq_class next = bound;
  const ExpansionEnd end = expander.start() ? expander.find_next(nearest, next) : ExpansionEnd::not_inside;
  if (end != ExpansionEnd::proved) throw std::invalid_argument("the next nearest facet is sought of bodies that do not penetrate");
  return next;
}

}  // namespace fathom::expanding
