// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/shapes/shape_prove.hpp"

#include <algorithm>

#include "fathom/numbers.hpp"
#include "kernels/point_algebra.hpp"
#include "reference/rounded/optimal_cone.hpp"
#include "reference/shapes/core.hpp"
#include "verify/golden/records/accepted.hpp"

namespace fathom::golden {
namespace {

bool same(const Atom& atom, const fathom_check::Atom& other) {
  return other.size() == 1 + atom.axes.size() && golden::same(atom.center, other.front()) &&
         std::equal(atom.axes.begin(), atom.axes.end(), other.begin() + 1, other.end(),
                    [](const Point& p, const fathom_check::RationalPoint& q) { return golden::same(p, q); });
}

bool same(const Term& term, const fathom_check::Term& other) {
  return std::equal(term.atoms.begin(), term.atoms.end(), other.begin(), other.end(),
                    [](const Atom& atom, const fathom_check::Atom& found) { return same(atom, found); });
}

/// A body as certificates write it: as simple as it can be, and its points, if it is the hull of some.
struct WrittenBody {
  Shape shape;
  std::optional<std::vector<Point>> points;

  explicit WrittenBody(const families::NamedBody& body)
      : shape(shapes::simplified(families::shape_of(body))), points(shapes::polytope_points(shape, most_expanded_points)) {}

  [[nodiscard]] const HalfSpace* half_space() const { return std::get_if<HalfSpace>(&shape.core); }

  [[nodiscard]] bool is(const fathom_check::Body& body) const {
    if (value_of(body.radius) != shape.radius) return false;
    switch (body.core) {
      case fathom_check::Body::Core::points: return points && golden::same(*points, body.points.items);
      case fathom_check::Body::Core::half_space:
        return half_space() && golden::same(half_space()->normal, body.normal) && half_space()->offset == value_of(body.offset);
      case fathom_check::Body::Core::pieces: return false;
      case fathom_check::Body::Core::shape: break;
    }
    const auto* const terms = std::get_if<std::vector<Term>>(&shape.core);
    return terms && std::equal(terms->begin(), terms->end(), body.terms.begin(), body.terms.end(),
                               [](const Term& term, const fathom_check::Term& found) { return same(term, found); });
  }

  /// The greatest <n,x> of the core, which is no curved one; a half-space has one in the direction of its normal only.
  [[nodiscard]] mpq_class height(const Vector& n) const {
    if (const HalfSpace* const half = half_space()) {
      const mpq_class factor = dot(n, half->normal) / dot(half->normal, half->normal);
      if (factor <= 0 || Point{factor * half->normal.x, factor * half->normal.y, factor * half->normal.z} != Point{n.x, n.y, n.z})
        throw NotProved("the direction is not that of the half-space");
      return factor * half->offset;
    }
    mpq_class best = dot(n, points->front());
    for (const Point& p : *points) best = std::max(best, dot(n, p));
    return best;
  }
};

/// What a certificate says, copied.
struct Stated {
  fathom_check::Claim claim = fathom_check::Claim::bounds;
  bool all = false, cone = false;
  mpq_class low, high;
  std::vector<Vector> directions;
  rounded::ClippedCone clipped;  ///< if accepted, the lineality is independent and the rays are the extreme ones
};

Stated stated(const fathom_check::Certificate& certificate) {
  Stated result{certificate.claim, certificate.all, certificate.has_cone, value_of(certificate.low), value_of(certificate.high), {}, {}};
  for (const fathom_check::Vector& n : certificate.directions.items) result.directions.push_back(value_of(n));
  for (const fathom_check::Vector& v : certificate.lineality.items) result.clipped.lines.push_back(value_of(v));
  for (const fathom_check::Vector& v : certificate.rays.items) result.clipped.rays.push_back(value_of(v));
  return result;
}

/// Of an accepted certificate about these bodies.
ShapeStatement truth_of(const Stated& says, const WrittenBody& a, const WrittenBody& b) {
  const bool plane = a.half_space() || b.half_space();
  const mpq_class rho = a.shape.radius + b.shape.radius;
  ShapeStatement truth{Surd{rho, 0}, says.directions.front(), {}, {}};
  std::vector<Vector> directions = says.directions;
  switch (says.claim) {
    case fathom_check::Claim::depth:
      if (!says.all && !plane) throw NotProved("the certificate does not claim to list all optima");
      truth.value = Surd{rho, says.low};
      break;
    case fathom_check::Claim::touching:
      if (!says.cone && !plane) throw NotProved("the certificate does not claim to list all directions");
      truth.cone = plane ? OptimalCone{Lineality::none, {}, {truth.direction}} : rounded::canonical(says.clipped);
      truth.direction = truth.cone->direction();
      directions = {truth.direction};
      break;
    case fathom_check::Claim::apart: truth.value = Surd{rho, -says.low}; break;
    case fathom_check::Claim::signed_bounds:
      if (says.low == says.high) truth.value = Surd{says.low, 0};
      else truth.value = Bounds{says.low, says.high};
      return truth;
    case fathom_check::Claim::bounds:
    case fathom_check::Claim::disjoint: throw NotProved("the certificate does not prove the signed depth");
  }
  for (const Vector& n : directions) truth.translations.push_back({n, (b.height(n) + a.height(-n)) / dot(n, n), rho});
  return truth;
}

/// A proof cannot deny what is known by construction, unless a generator is wrong.
void compare(const ShapeStatement& truth, const families::KnownDepth& known) {
  const Surd* const exact = std::get_if<Surd>(&truth.value);
  const Bounds* const bounds = std::get_if<Bounds>(&truth.value);
  const bool agrees = exact
                          ? fathom::compare(known.signed_depth, *exact) == 0
                          : fathom::compare(known.signed_depth, bounds->low) >= 0 && fathom::compare(known.signed_depth, bounds->high) <= 0;
  if (!agrees) throw NotProved("source.signed_depth: the certificate proves another one");
}

}  // namespace

ShapeStatement proved_truth(const families::ShapeCase& shapes, std::string_view certificate) {
  const WrittenBody a(shapes.pair.a), b(shapes.pair.b);
  Stated says;
  take_accepted(certificate, shapes.id, [&](const fathom_check::Certificate& read) {
    if (!a.is(read.a) || !b.is(read.b)) throw NotProved("the certificate is about other bodies");
    says = stated(read);
  });
  ShapeStatement truth = truth_of(says, a, b);
  if (shapes.pair.known) compare(truth, *shapes.pair.known);
  return truth;
}

}  // namespace fathom::golden
