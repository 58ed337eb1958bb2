// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of signed depths: proofs about the cores, found as for point sets, and the radii beside them.
#include <stdexcept>
#include <utility>

#include "fathom/certificate.hpp"
#include "kernels/float_environment.hpp"
#include "reference/certificate/cone_proof.hpp"
#include "reference/rounded/half_space.hpp"
#include "reference/shapes/core.hpp"

namespace fathom::certificate {
namespace {

[[noreturn]] void contradiction(const char* what) {
  throw std::logic_error(std::string("the certificate contradicts the answer: ") + what);
}

std::vector<Point> points_of(const Shape& shape) {
  std::optional<std::vector<Point>> points = shapes::polytope_points(shape, most_expanded_points);
  if (!points) throw std::invalid_argument("a sum has too many points to be written out, or a core is curved");
  return std::move(*points);
}

// The same core as one hull.
void set_points(Shape& shape, const std::vector<Point>& points) {
  if (std::get<std::vector<Term>>(shape.core).size() > 1) shape.core = hull(points).core;
}

void prove(const Depth& cores, const SignedDepth& answer, ShapeCertificate& certificate, Monitor* monitor) {
  const std::vector<Point> a = points_of(certificate.a), b = points_of(certificate.b);
  set_points(certificate.a, a);
  set_points(certificate.b, b);
  Certificate of_points = make_certificate(a, b, cores, monitor);
  certificate.claim = cores.touch() ? ShapeClaim::touching : cores.distance() ? ShapeClaim::apart : ShapeClaim::depth;
  certificate.low = of_points.low;
  certificate.high = of_points.high;
  certificate.directions = std::move(of_points.directions);
  certificate.complete = cores.penetration() != nullptr && of_points.complete;
  certificate.inner = std::move(of_points.inner);
  certificate.weights_a = std::move(of_points.weights_a);
  certificate.weights_b = std::move(of_points.weights_b);
  if (!answer.cone) return;
  certificate.directions = {answer.direction()};
  certificate.cone = prove_cone(a, b, *answer.cone);
}

void prove(const PlaneSupport& plane, const SignedDepth& answer, ShapeCertificate& certificate, Monitor*) {
  const bool half_is_a = std::holds_alternative<HalfSpace>(certificate.a.core);
  Shape& convex = half_is_a ? certificate.b : certificate.a;
  const HalfSpace& half = std::get<HalfSpace>((half_is_a ? certificate.a : certificate.b).core);
  set_points(convex, points_of(convex));
  const rounded::Side where = half_is_a ? rounded::Side::a : rounded::Side::b;
  const PlaneSupport found = rounded::plane_support(half, where, std::get<std::vector<Term>>(convex.core));
  if (found.direction != plane.direction || found.support != plane.support) contradiction("another support");
  const int side = sgn(plane.support);
  certificate.claim = side > 0 ? ShapeClaim::depth : side < 0 ? ShapeClaim::apart : ShapeClaim::touching;
  certificate.low = certificate.high = abs(answer.exact()->root);
  certificate.directions = {plane.direction};
}

void prove(const Bracket& bracket, const SignedDepth& answer, ShapeCertificate& certificate, Monitor*) {
  certificate.claim = ShapeClaim::signed_bounds;
  if (const Bounds* bounds = answer.bounds()) {
    certificate.low = bounds->low;
    certificate.high = bounds->high;
  } else {
    if (answer.exact()->root != 0) contradiction("bounds that are a root");
    certificate.low = certificate.high = answer.exact()->rational;
  }
  certificate.directions = {bracket.direction};
  certificate.heights_a = bracket.heights_a;
  certificate.heights_b = bracket.heights_b;
  certificate.inner_a = bracket.inner_a;
  certificate.inner_b = bracket.inner_b;
  certificate.inner = bracket.polytope;
  certificate.weights_a = bracket.weights_a;
  certificate.weights_b = bracket.weights_b;
}

}  // namespace

}  // namespace fathom::certificate

namespace fathom {

ShapeCertificate make_certificate(const Shape& a, const Shape& b, const SignedDepth& answer, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  shapes::require_shape(a);
  shapes::require_shape(b);
  ShapeCertificate certificate;
  certificate.a = shapes::simplified(a);
  certificate.b = shapes::simplified(b);
  if (certificate.a.radius != answer.radius_a || certificate.b.radius != answer.radius_b) certificate::contradiction("other radii");
  std::visit([&](const auto& core) { certificate::prove(core, answer, certificate, monitor); }, answer.core);
  return certificate;
}

}  // namespace fathom
