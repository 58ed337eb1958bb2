// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/certificate/certificate.hpp"

#include <algorithm>
#include <stdexcept>

#include "fathom/certificate.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/expanding/expanding_polytope.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/position.hpp"
#include "reference/solve/deciding_points.hpp"

namespace fathom::certificate {
namespace {

Certificate of_bodies(std::span<const Point> a, std::span<const Point> b, ClaimKind claim) {
  Certificate certificate;
  certificate.a.assign(a.begin(), a.end());
  certificate.b.assign(b.begin(), b.end());
  certificate.claim = claim;
  return certificate;
}

[[noreturn]] void contradiction(const char* what) {
  throw std::logic_error(std::string("the certificate contradicts the answer: ") + what);
}

// Q, found anew unless the answer brought it along. The search does not look at the answer, so this is a check of it too.
InnerPolytope proof_of_depth(std::span<const Point> a, std::span<const Point> b, const Penetration& answer, Monitor* monitor) {
  if (answer.inner) return *answer.inner;
  Options search;
  search.method = Method::certificate;
  search.monitor = monitor;
  search.optima = answer.optima.size();
  Depth found = penetration_depth(a, b, search);
  if (!found.penetration()) contradiction("O is not in the interior of P");
  if (found.squared() != answer.squared()) contradiction("another depth");
  const auto same = [](const Optimum& one, const Optimum& other) { return one.direction == other.direction; };
  if (found.optima_count() != answer.optima.size() + answer.unlisted || !std::ranges::equal(found.optima(), answer.optima, same))
    contradiction("other optima");
  return std::move(*std::get<Penetration>(found.outcome).inner);
}

// The sign of h(n).
int support_sign(std::span<const Point> a, std::span<const Point> b, const Vector& n) {
  const Point &p = a[solve::extreme_points(a, -n).front()], &q = b[solve::extreme_points(b, n).front()];
  return sgn(mpq_class(n.x * (q.x - p.x) + n.y * (q.y - p.y) + n.z * (q.z - p.z)));
}

Certificate proof_of_touch(std::span<const Point> a, std::span<const Point> b, const Touch& answer) {
  Certificate certificate = of_bodies(a, b, ClaimKind::touching);
  const polytope::PlacedPair pair = polytope::place(a, b);
  polytope::PositionOfOrigin origin = polytope::position_of_origin(pair.a, pair.b);
  if (origin.position != polytope::Position::boundary) contradiction("the bodies do not touch");
  if (is_zero(answer.direction) || support_sign(a, b, answer.direction) != 0) contradiction("no plane through O supports P");
  certificate.directions = {answer.direction};
  certificate.weights_a = std::move(origin.a);
  certificate.weights_b = std::move(origin.b);
  return certificate;
}

Certificate proof_of_distance(std::span<const Point> a, std::span<const Point> b, const Distance& answer) {
  if (is_zero(answer.direction) || support_sign(a, b, answer.direction) >= 0) contradiction("the direction does not separate the bodies");
  const polytope::PlacedPair pair = polytope::place(a, b);
  polytope::NearestPoints nearest = polytope::nearest_points(pair.a, pair.b);
  if (nearest.normal != answer.direction) contradiction("another direction");
  const mpz_class unit = pair.denominator * pair.denominator * dot(nearest.normal, nearest.normal);
  if (kernels::ratio(nearest.height * nearest.height, unit) != answer.squared) contradiction("another distance");
  Certificate certificate = of_bodies(a, b, ClaimKind::apart);
  certificate.low = certificate.high = answer.squared;
  certificate.directions = {answer.direction};
  certificate.weights_a = std::move(nearest.a);
  certificate.weights_b = std::move(nearest.b);
  return certificate;
}

}  // namespace

}  // namespace fathom::certificate

namespace fathom {

Certificate make_certificate(std::span<const Point> a, std::span<const Point> b, const Depth& answer, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  polytope::require_bodies(a, b);
  if (answer.touch()) return certificate::proof_of_touch(a, b, *answer.touch());
  if (answer.distance()) return certificate::proof_of_distance(a, b, *answer.distance());
  Certificate certificate = certificate::of_bodies(a, b, ClaimKind::depth);
  certificate.low = certificate.high = answer.squared();
  for (const Optimum& optimum : answer.optima()) certificate.directions.push_back(optimum.direction);
  certificate.complete = answer.penetration()->unlisted == 0;
  certificate.inner = certificate::proof_of_depth(a, b, *answer.penetration(), monitor);
  return certificate;
}

Certificate make_bounds_certificate(std::span<const Point> a, std::span<const Point> b, const mpq_class& low, const mpq_class& high,
                                    const std::optional<Vector>& hint, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  for (const mpq_class* bound : {&low, &high}) kernels::require_lowest_terms(*bound);
  if (low < 0) throw std::invalid_argument("the lower bound of a squared depth is negative");
  kernels::Context context(monitor);
  const polytope::PlacedPair pair = polytope::place(a, b);
  const mpz_class unit = pair.denominator * pair.denominator;
  expanding::BallExpansion expansion = expanding::expand_to_ball(context, pair.a, pair.b, low * unit, high * unit, hint);
  if (expansion.end != expanding::ExpansionEnd::proved) throw std::invalid_argument("the bodies do not penetrate");
  if (!expansion.low_holds) throw std::invalid_argument("the lower bound exceeds the squared depth");
  if (!expansion.high_holds) throw std::invalid_argument("the upper bound is below the squared depth");
  Certificate certificate = certificate::of_bodies(a, b, ClaimKind::bounds);
  certificate.low = low;
  certificate.high = high;
  certificate.directions = {std::move(expansion.direction)};
  certificate.inner = std::move(expansion.inner);
  return certificate;
}

}  // namespace fathom
