// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/unions/union_prove.hpp"

#include "kernels/point_algebra.hpp"
#include "verify/golden/records/accepted.hpp"

namespace fathom::golden {
namespace {

/// Whether the body of the certificate has these pieces, in this order.
bool same(const Pieces& pieces, const fathom_check::Body& body) {
  if (body.core != fathom_check::Body::Core::pieces || body.pieces.size() != pieces.size()) return false;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::size_t begin = begin_of(body.pieces, i);
    if (body.pieces[i].end - begin != pieces[i].size()) return false;
    for (std::size_t k = 0; k < pieces[i].size(); ++k)
      if (!golden::same(pieces[i][k], body.points.items[begin + k])) return false;
  }
  return true;
}

using Weights = std::vector<fathom_check::Weight>;

Point combined(const std::vector<Point>& piece, const Weights& weights) {
  Point sum;
  for (const fathom_check::Weight& w : weights) {
    if (w.index >= piece.size()) throw NotProved("a weight of a point that there is not");  // the checker refuses it too
    sum = sum + value_of(w.weight) * piece[w.index];
  }
  return sum;
}

UnionGap gap_in(const fathom_check::Certificate& certificate, const Pieces& a, const Pieces& b) {
  const fathom_check::UnionParts& parts = certificate.of_unions;
  if (parts.nearest_a >= a.size() || parts.nearest_b >= b.size()) throw NotProved("a nearest piece that there is not");
  const Point of_a = combined(a[parts.nearest_a], certificate.weights_a.items);
  const Point of_b = combined(b[parts.nearest_b], certificate.weights_b.items);
  return {value_of(certificate.low), parts.nearest_a, parts.nearest_b, of_b - of_a};
}

UnionStatement stated(const fathom_check::Certificate& certificate, const Pieces& a, const Pieces& b) {
  UnionStatement truth;
  switch (certificate.claim) {
    case fathom_check::Claim::depth:
      truth.status = Status::penetrating;
      truth.squared = value_of(certificate.low);
      for (const fathom_check::RationalPoint& t : certificate.of_unions.optima.items) truth.optima.push_back(value_of(t));
      return truth;
    case fathom_check::Claim::touching: truth.status = Status::touching; return truth;
    case fathom_check::Claim::apart: truth.gap = gap_in(certificate, a, b); return truth;
    case fathom_check::Claim::bounds:
    case fathom_check::Claim::disjoint:
    case fathom_check::Claim::signed_bounds: break;
  }
  throw NotProved("the certificate does not prove the depth of unions");
}

/// A proof cannot deny what is known by construction, unless a generator is wrong.
void compare(const UnionStatement& truth, const KnownUnion& known) {
  const mpq_class& squared = truth.gap ? truth.gap->squared : truth.squared;
  if (truth.status != known.status || squared != known.squared || truth.optima.size() != known.optima)
    throw NotProved("source.known: the certificate proves another answer");
}

}  // namespace

UnionStatement proved_truth(const FormedUnions& bodies, std::string_view certificate) {
  const Pieces &a = *bodies.unions.a.pieces, &b = *bodies.unions.b.pieces;
  UnionStatement truth;
  take_accepted(certificate, bodies.unions.id, [&](const fathom_check::Certificate& read) {
    if (!same(a, read.a) || !same(b, read.b)) throw NotProved("the certificate is about other bodies");
    truth = stated(read, a, b);
  });
  if (bodies.known) compare(truth, *bodies.known);
  return truth;
}

}  // namespace fathom::golden
