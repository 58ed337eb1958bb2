// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/certificate/certificate.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "kernels/float_environment.hpp"
#include "kernels/number/lowest_terms.hpp"
#include "reference/depth/deciding_points.hpp"
#include "reference/expanding/expanding_polytope.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom {
namespace {

// Both bodies in the form in which proofs are found.
struct Clouds {
  Lattice lattice;
  PointCloud a, b;

  Clouds(std::span<const Point> of_a, std::span<const Point> of_b) : lattice(common_lattice(of_a, of_b)) {
    const long exponent = std::max(binary_exponent(lattice.a), binary_exponent(lattice.b));
    a = PointCloud(lattice.a, exponent);
    b = PointCloud(lattice.b, exponent);
  }

  // A squared length in the clouds' unit.
  [[nodiscard]] mpq_class squared(const mpq_class& in_space) const { return in_space * lattice.denominator * lattice.denominator; }
};

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
InnerPolytope proof_of_depth(std::span<const Point> a, std::span<const Point> b, const Depth& answer, const Options& options) {
  if (answer.inner) return *answer.inner;
  Options search;
  search.method = Method::certificate;
  search.expansion_budget = std::numeric_limits<std::size_t>::max();
  search.progress = [&options](const std::string&, double) { return !options.progress || options.progress("certificate", 0); };
  Depth found = penetration_depth(a, b, search);
  if (!found.inner) contradiction("O is not in the interior of P");
  if (found.squared != answer.squared) contradiction("another depth");
  const auto same = [](const Optimum& one, const Optimum& other) { return one.direction == other.direction; };
  if (!std::ranges::equal(found.optima, answer.optima, same)) contradiction("other optima");
  return std::move(*found.inner);
}

// The sign of h(n).
int support_sign(std::span<const Point> a, std::span<const Point> b, const Vector& n) {
  const Point &p = a[extreme_points(a, -n).front()], &q = b[extreme_points(b, n).front()];
  return sgn(mpq_class(n.x * (q.x - p.x) + n.y * (q.y - p.y) + n.z * (q.z - p.z)));
}

void prove_touching(Certificate& certificate, const Depth& answer) {
  const Clouds clouds(certificate.a, certificate.b);
  PositionOfOrigin origin = position_of_origin(clouds.a, clouds.b);
  if (origin.position != Position::boundary) contradiction("the bodies do not touch");
  certificate.directions = {answer.direction ? *answer.direction : *origin.normal};
  if (is_zero(certificate.directions.front()) || support_sign(certificate.a, certificate.b, certificate.directions.front()) != 0)
    contradiction("no plane through O supports P");
  certificate.weights_a = std::move(origin.a);
  certificate.weights_b = std::move(origin.b);
}

}  // namespace

Certificate make_certificate(std::span<const Point> a, std::span<const Point> b, const Depth& answer, const Options& options) {
  const DefaultFloatEnvironment environment;
  switch (answer.status) {
    case Status::penetrating: {
      Certificate certificate = of_bodies(a, b, ClaimKind::depth);
      certificate.low = certificate.high = answer.squared;
      for (const Optimum& optimum : answer.optima) certificate.directions.push_back(optimum.direction);
      certificate.inner = proof_of_depth(a, b, answer, options);
      return certificate;
    }
    case Status::touching: {
      Certificate certificate = of_bodies(a, b, ClaimKind::touching);
      prove_touching(certificate, answer);
      return certificate;
    }
    case Status::disjoint: break;
  }
  Certificate certificate = of_bodies(a, b, ClaimKind::disjoint);
  if (!answer.direction || support_sign(a, b, *answer.direction) >= 0) contradiction("the direction does not separate the bodies");
  certificate.directions = {*answer.direction};
  return certificate;
}

Certificate make_bounds_certificate(std::span<const Point> a, std::span<const Point> b, const mpq_class& low, const mpq_class& high,
                                    const std::optional<Vector>& hint) {
  const DefaultFloatEnvironment environment;
  for (const mpq_class* bound : {&low, &high}) require_lowest_terms(*bound);
  if (low < 0) throw std::invalid_argument("the lower bound of a squared depth is negative");
  const Clouds clouds(a, b);
  BallExpansion expansion = expand_to_ball(clouds.a, clouds.b, clouds.squared(low), clouds.squared(high), hint);
  if (expansion.end != ExpansionEnd::proved) throw std::invalid_argument("the bodies do not penetrate");
  if (!expansion.low_holds) throw std::invalid_argument("the lower bound exceeds the squared depth");
  if (!expansion.high_holds) throw std::invalid_argument("the upper bound is below the squared depth");
  Certificate certificate = of_bodies(a, b, ClaimKind::bounds);
  certificate.low = low;
  certificate.high = high;
  certificate.directions = {std::move(expansion.direction)};
  certificate.inner = std::move(expansion.inner);
  return certificate;
}

}  // namespace fathom
