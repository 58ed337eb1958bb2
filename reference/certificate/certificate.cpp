// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/certificate/certificate.hpp"

#include <algorithm>
#include <stdexcept>

#include "kernels/float_environment.hpp"
#include "kernels/number/lowest_terms.hpp"
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
  const Clouds clouds(a, b);
  ExpansionOptions steps;
  steps.on_step = [&options] {
    if (options.progress && !options.progress("certificate", 0)) throw Interrupted();
  };
  Expansion expansion = nearest_by_expansion(clouds.a, clouds.b, steps);
  if (expansion.end != ExpansionEnd::proved) contradiction("O is not in the interior of P");
  mpq_class squared(expansion.nearest.numerator(), expansion.nearest.denominator());
  squared.canonicalize();
  if (squared != clouds.squared(answer.squared)) contradiction("another depth");
  const auto same = [](const Vector& n, const Optimum& optimum) { return n == optimum.direction; };
  const auto& directions = expansion.nearest.directions();
  if (!std::equal(directions.begin(), directions.end(), answer.optima.begin(), answer.optima.end(), same)) contradiction("other optima");
  return std::move(expansion.inner);
}

// h(n) of the clouds.
mpz_class support(const Clouds& clouds, const Vector& n) {
  return dot(n, clouds.b[extreme_points(clouds.b, n).front()] - clouds.a[extreme_points(clouds.a, -n).front()]);
}

void prove_touching(Certificate& certificate, const Depth& answer) {
  const Clouds clouds(certificate.a, certificate.b);
  PositionOfOrigin origin = position_of_origin(clouds.a, clouds.b);
  if (origin.position != Position::boundary) contradiction("the bodies do not touch");
  certificate.directions = {answer.direction ? *answer.direction : *origin.normal};
  if (is_zero(certificate.directions.front()) || support(clouds, certificate.directions.front()) != 0)
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
  if (!answer.direction || support(Clouds(a, b), *answer.direction) >= 0) contradiction("the direction does not separate the bodies");
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
