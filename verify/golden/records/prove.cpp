// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate proves status, depth and every optimal direction; all else follows from these and the points, and is computed here by
// the definitions. Then the record is written anew, and must be the same text: so no field can be wrong, missing, repeated or unknown.
#include "verify/golden/records/prove.hpp"

#include "kernels/number/ratio.hpp"
#include "reference/polytope/polytope.hpp"
#include "verify/check/limits.hpp"
#include "verify/check/reader.hpp"
#include "verify/digest/sha256.hpp"
#include "verify/golden/records/faces.hpp"
#include "verify/golden/records/record_facts.hpp"
#include "verify/golden/records/record_line.hpp"
#include "verify/golden/records/record_reader.hpp"

namespace fathom::golden {
namespace {

struct Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What an accepted certificate says.
struct Proved {
  Status status = Status::disjoint;
  std::vector<Vector> directions;
  Point common;  ///< touching
};

mpq_class value_of(const fathom_check::Rational& q) { return kernels::ratio(q.num.value(), q.den.value()); }

bool same(const Point& p, const fathom_check::RationalPoint& q) {
  const auto equal = [](const mpq_class& x, const fathom_check::Rational& y) {
    return x.get_num() * y.den.value() == y.num.value() * x.get_den();
  };
  return equal(p.x, q.x) && equal(p.y, q.y) && equal(p.z, q.z);
}

bool same(const std::vector<Point>& points, const std::vector<fathom_check::RationalPoint>& others) {
  return std::equal(points.begin(), points.end(), others.begin(), others.end(), [](const auto& p, const auto& q) { return same(p, q); });
}

void take_over(const fathom_check::Certificate& certificate, const Claimed& claimed, Proved& proved) {
  if (certificate.id != claimed.points.id) throw Refusal("the certificate is that of another record, '" + certificate.id + "'");
  if (certificate.format != 1) throw Refusal("the certificate has format " + std::to_string(certificate.format) + ", not 1");
  if (!same(claimed.points.a.points, certificate.a.points.items) || !same(claimed.points.b.points, certificate.b.points.items))
    throw Refusal("the certificate is about other points");
  for (const fathom_check::Vector& n : certificate.directions.items) proved.directions.push_back({n.x.value(), n.y.value(), n.z.value()});
  switch (certificate.claim) {
    case fathom_check::Claim::depth:
      if (!certificate.all) throw Refusal("the certificate does not claim to list all optima");
      proved.status = Status::penetrating;
      break;
    case fathom_check::Claim::bounds: throw Refusal("the certificate proves bounds only");
    case fathom_check::Claim::touching: proved.status = Status::touching; break;
    case fathom_check::Claim::disjoint: proved.status = Status::disjoint; break;
    case fathom_check::Claim::apart:
    case fathom_check::Claim::signed_bounds: throw Refusal("the certificate makes a claim of format 2");
  }
  for (const fathom_check::Weight& w : certificate.weights_a.items) {
    if (w.index >= claimed.points.a.points.size()) return;  // refused by the checker
    const Point& p = claimed.points.a.points[w.index];
    const mpq_class weight = value_of(w.weight);
    proved.common = {proved.common.x + weight * p.x, proved.common.y + weight * p.y, proved.common.z + weight * p.z};
  }
}

/// Nothing that take_over reads is used unless the checker accepts it all.
Proved accepted(std::string_view text, const Claimed& claimed) {
  fathom_check::Lines lines(text, fathom_check::longest_line);
  fathom_check::Reader reader(lines);
  Proved proved;
  std::optional<std::string> refusal;
  const auto verdict = reader.next([&](const fathom_check::Certificate& certificate) {
    try {
      take_over(certificate, claimed, proved);
    } catch (const Refusal& fault) {
      refusal = fault.what();
    }
  });
  if (!verdict || !verdict->accepted())
    throw Refusal("the certificate is not accepted: " + (verdict ? fathom_check::verdict_line(*verdict, claimed.points.id) : ""));
  if (refusal) throw Refusal(*refusal);
  if (reader.next()) throw Refusal("expected one certificate, found more");
  return proved;
}

ContactKind kind_of(std::size_t corners_of_a, std::size_t corners_of_b) {
  const auto rank = [](std::size_t corners) { return corners < 3 ? corners : std::size_t{3}; };
  switch (10 * rank(corners_of_a) + rank(corners_of_b)) {
    case 31: return ContactKind::facet_vertex;
    case 13: return ContactKind::vertex_facet;
    case 32: return ContactKind::facet_edge;
    case 23: return ContactKind::edge_facet;
    case 33: return ContactKind::facet_facet;
    case 22: return ContactKind::edge_edge;
    default: throw Refusal("the faces in an optimal direction do not span a facet");
  }
}

/// Both bodies seen in one direction.
struct Sides {
  SupportingFace a, b;  ///< in the directions -n and n
  mpq_class support;    ///< h(n)
  mpq_class factor;     ///< h(n) / <n,n>
  Point translation;

  Sides(const Integers& bodies, const Vector& n) : a(face_in_direction(bodies.a, -n)), b(face_in_direction(bodies.b, n)) {
    support = kernels::ratio(a.height + b.height, bodies.denominator);
    factor = support / dot(n, n);
    translation = {factor * n.x, factor * n.y, factor * n.z};
  }

  /// Points of both faces with b - a = translation.
  [[nodiscard]] bool witnessed(const Witness& w, const Integers& bodies, const Vector& n) const {
    const Point apart{w.b.x - w.a.x, w.b.y - w.a.y, w.b.z - w.a.z};
    return apart == translation && contains(a, -n, bodies.denominator, w.a) && contains(b, n, bodies.denominator, w.b);
  }
};

Penetration proved_penetration(const Integers& bodies, const Proved& proved, const Witness& witness) {
  Penetration answer{.optima = {}, .meeting = witness, .inner = std::nullopt};
  for (const Vector& n : proved.directions) {
    const Sides sides(bodies, n);
    if (answer.optima.empty() && !sides.witnessed(witness, bodies, n))
      throw Refusal("expected.witness: the points do not prove the contact");
    const ContactKind kind = kind_of(sides.a.corners.size(), sides.b.corners.size());
    answer.optima.push_back({n, sides.support, {kind, sides.a.corners, sides.b.corners}});
  }
  return answer;
}

Distance proved_distance(const Integers& bodies, const Vector& n, const Witness& witness) {
  const Sides sides(bodies, n);
  if (!sides.witnessed(witness, bodies, n)) throw Refusal("expected.distance.witness: the points do not prove the distance");
  return {sides.factor * sides.factor * dot(n, n), n, sides.translation, witness};
}

/// The points must be those that the source names: an id stands for one pair of bodies only.
void prove_source(const Claimed& claimed) {
  if (claimed.points.id != id_of(claimed.recipe, claimed.form)) throw Refusal("id: it is not that of its source");
  constexpr unsigned largest_size = 10'000;  // nobody's text may ask for more work
  if (claimed.recipe.size > largest_size) throw Refusal("source.size: it is larger than that of any record");
  std::optional<Case> made = base_case(claimed.recipe);
  if (claimed.form != Form::given) made = in_format(*made, claimed.form) ? std::nullopt : rounded_case(*made, claimed.form);
  if (!made || made->a.points != claimed.points.a.points || made->b.points != claimed.points.b.points)
    throw Refusal("source: it does not yield these points");
}

Facts facts_from(const Claimed& claimed, const Proved& proved) {
  prove_source(claimed);
  const std::vector<Point>&a = claimed.points.a.points, &b = claimed.points.b.points;
  const Integers bodies = integers_of(a, b);
  Depth answer;
  answer.flat_a = polytope::affine_rank(bodies.a) < 3;
  answer.flat_b = polytope::affine_rank(bodies.b) < 3;
  if (!claimed.witness) throw Refusal("expected.witness: there is none");
  switch (proved.status) {
    case Status::penetrating: answer.outcome = proved_penetration(bodies, proved, *claimed.witness); break;
    case Status::touching: answer.outcome = Touch{proved.directions.front(), proved.common}; break;
    case Status::disjoint: answer.outcome = proved_distance(bodies, proved.directions.front(), *claimed.witness); break;
  }
  return facts_of_answer(claimed.recipe, claimed.form, claimed.points, std::move(answer));
}

std::optional<std::string> faults(std::string_view line, std::string_view certificate) {
  const Claimed claimed = read_record(line);
  Facts facts = facts_from(claimed, accepted(certificate, claimed));
  facts.certificate_sha256 = digest::digest_of(certificate).sha256;
  const std::string expected = line_of(facts);
  if (expected == line) return std::nullopt;
  return first_difference(expected, line);
}

}  // namespace

std::optional<std::string> faults_of(std::string_view line, std::string_view certificate) {
  try {
    return faults(line, certificate);
  } catch (const std::exception& fault) {
    return fault.what();
  }
}

}  // namespace fathom::golden
