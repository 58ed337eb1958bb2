// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate proves status, depth and every optimal direction; all else follows from these and the points, and is computed here by
// the definitions. Then the record is written anew, and must be the same text: so no field can be wrong, missing, repeated or unknown.
#include "verify/golden/records/prove.hpp"

#include <algorithm>

#include "kernels/number/ratio.hpp"
#include "kernels/point_algebra.hpp"
#include "reference/polytope/polytope.hpp"
#include "verify/digest/sha256.hpp"
#include "verify/golden/records/accepted.hpp"
#include "verify/golden/records/faces.hpp"
#include "verify/golden/records/record_line.hpp"
#include "verify/golden/shapes/shape_facts.hpp"
#include "verify/golden/shapes/shape_prove.hpp"
#include "verify/golden/unions/union_prove.hpp"

namespace fathom::golden {
namespace {

/// What an accepted certificate says.
struct Proved {
  Status status = Status::disjoint;
  std::vector<Vector> directions;
  Point common;                ///< touching
  mpq_class distance_squared;  ///< disjoint
};

/// Whether the bodies of the certificate are the hulls of these points.
bool about(const fathom_check::Certificate& certificate, const Case& points) {
  const auto hull_of = [](const fathom_check::Body& body, const std::vector<Point>& expected) {
    return body.radius.num.sign() == 0 && same(expected, body.points.items);
  };
  return hull_of(certificate.a, points.a.points) && hull_of(certificate.b, points.b.points);
}

void take_over(const fathom_check::Certificate& certificate, const Claimed& claimed, Proved& proved) {
  if (!about(certificate, claimed.points)) throw NotProved("the certificate is about other points");
  for (const fathom_check::Vector& n : certificate.directions.items) proved.directions.push_back(value_of(n));
  const bool apart = certificate.claim == fathom_check::Claim::apart;
  switch (certificate.claim) {
    case fathom_check::Claim::depth:
      if (!certificate.all) throw NotProved("the certificate does not claim to list all optima");
      proved.status = Status::penetrating;
      break;
    case fathom_check::Claim::bounds:
    case fathom_check::Claim::signed_bounds: throw NotProved("the certificate proves bounds only");
    case fathom_check::Claim::touching: proved.status = Status::touching; break;
    case fathom_check::Claim::disjoint: throw NotProved("the certificate does not prove how far the bodies are apart");
    case fathom_check::Claim::apart:
      proved.status = Status::disjoint;
      proved.distance_squared = value_of(certificate.low);
      break;
  }
  if (const int format = apart ? 2 : 1; certificate.format != format)
    throw NotProved("the certificate has format " + std::to_string(certificate.format) + ", not " + std::to_string(format));
  for (const fathom_check::Weight& w : certificate.weights_a.items) {
    if (w.index >= claimed.points.a.points.size()) return;  // refused by the checker
    proved.common = proved.common + value_of(w.weight) * claimed.points.a.points[w.index];
  }
}

Proved accepted(std::string_view text, const Claimed& claimed) {
  Proved proved;
  take_accepted(text, claimed.points.id, [&](const fathom_check::Certificate& certificate) { take_over(certificate, claimed, proved); });
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
    default: throw NotProved("the faces in an optimal direction do not span a facet");
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
    translation = factor * n;
  }

  /// Points of both faces with b - a = translation.
  [[nodiscard]] bool witnessed(const Witness& w, const Integers& bodies, const Vector& n) const {
    return w.b - w.a == translation && contains(a, -n, bodies.denominator, w.a) && contains(b, n, bodies.denominator, w.b);
  }
};

Penetration proved_penetration(const Integers& bodies, const Proved& proved, const Witness& witness) {
  Penetration answer{.optima = {}, .meeting = witness, .inner = std::nullopt};
  for (const Vector& n : proved.directions) {
    const Sides sides(bodies, n);
    if (answer.optima.empty() && !sides.witnessed(witness, bodies, n))
      throw NotProved("expected.witness: the points do not prove the contact");
    const ContactKind kind = kind_of(sides.a.corners.size(), sides.b.corners.size());
    answer.optima.push_back({n, sides.support, {kind, sides.a.corners, sides.b.corners}});
  }
  return answer;
}

Distance proved_distance(const Integers& bodies, const Proved& proved, const Witness& witness) {
  const Vector& n = proved.directions.front();
  const Sides sides(bodies, n);
  if (!sides.witnessed(witness, bodies, n)) throw NotProved("expected.distance.witness: the points do not prove the distance");
  return {proved.distance_squared, n, sides.translation, witness};
}

}  // namespace

/// Makes the bodies that the source names: an id stands for one pair of bodies only.
void Prover::make_cases(const Claimed& claimed) {
  if (claimed.points.id != id_of(claimed.recipe, claimed.form)) throw NotProved("id: it is not that of its source");
  constexpr unsigned largest_size = 10'000;  // nobody's text may ask for more work
  if (claimed.recipe.size > largest_size) throw NotProved("source.size: it is larger than that of any record");
  if (recipe_ == claimed.recipe) return;
  recipe_.reset();
  cases_.clear();
  shape_cases_.clear();
  union_cases_.clear();
  switch (kind_of(claimed.recipe.source)) {
    case Kind::polytopes: cases_ = cases_of(claimed.recipe); break;
    case Kind::shapes: shape_cases_ = shape_cases_of(claimed.recipe); break;
    case Kind::unions: union_cases_ = union_cases_of(claimed.recipe); break;
  }
  recipe_ = claimed.recipe;
}

const Case& Prover::prove_source(const Claimed& claimed) {
  make_cases(claimed);
  const auto made = std::ranges::find(cases_, claimed.form, &FormedCase::form);
  if (made == cases_.end() || made->points.a.points != claimed.points.a.points || made->points.b.points != claimed.points.b.points)
    throw NotProved("source: it does not yield these points");
  return made->points;
}

Facts Prover::facts_from(const Claimed& claimed, std::string_view certificate) {
  const Proved proved = accepted(certificate, claimed);
  const Case& points = prove_source(claimed);
  const Integers bodies = integers_of(claimed.points.a.points, claimed.points.b.points);
  Depth answer;
  answer.flat_a = polytope::affine_rank(bodies.a) < 3;
  answer.flat_b = polytope::affine_rank(bodies.b) < 3;
  if (!claimed.witness) throw NotProved("expected.witness: there is none");
  switch (proved.status) {
    case Status::penetrating: answer.outcome = proved_penetration(bodies, proved, *claimed.witness); break;
    case Status::touching: answer.outcome = Touch{proved.directions.front(), proved.common}; break;
    case Status::disjoint: answer.outcome = proved_distance(bodies, proved, *claimed.witness); break;
  }
  return facts_of_answer(claimed.recipe, claimed.form, points, std::move(answer), nullptr, &workspace_);
}

std::string Prover::line_of_points(const Claimed& claimed, std::string_view certificate) {
  Facts facts = facts_from(claimed, certificate);
  facts.certificate_sha256 = digest::digest_of(certificate).sha256;
  row_ = csv_row(facts);
  return line_of(facts);
}

std::string Prover::line_of_shapes(const Claimed& claimed, std::string_view certificate) {
  make_cases(claimed);
  const auto made = std::ranges::find(shape_cases_, claimed.form, &FormedShapes::form);
  if (made == shape_cases_.end()) throw NotProved("source: it has no such form");
  row_.clear();
  return line_of(ShapeFacts{claimed.recipe, *made, proved_truth(made->shapes, certificate), digest::digest_of(certificate).sha256});
}

std::string Prover::line_of_unions(const Claimed& claimed, std::string_view certificate) {
  make_cases(claimed);
  const auto made = std::ranges::find(union_cases_, claimed.form, &FormedUnions::form);
  if (made == union_cases_.end()) throw NotProved("source: it has no such form");
  row_.clear();
  return line_of(UnionFacts{claimed.recipe, *made, proved_truth(*made, certificate), digest::digest_of(certificate).sha256});
}

std::string Prover::line_as_proved(const Claimed& claimed, std::string_view certificate) {
  switch (kind_of(claimed.recipe.source)) {
    case Kind::polytopes: break;
    case Kind::shapes: return line_of_shapes(claimed, certificate);
    case Kind::unions: return line_of_unions(claimed, certificate);
  }
  return line_of_points(claimed, certificate);
}

std::optional<std::string> Prover::faults(std::string_view line, std::string_view certificate) {
  const Claimed claimed = read_record(line);
  const std::string expected = line_as_proved(claimed, certificate);
  if (expected != line) return first_difference(expected, line);
  id_ = claimed.points.id;
  return std::nullopt;
}

std::optional<std::string> Prover::faults_of(std::string_view line, std::string_view certificate) {
  try {
    return faults(line, certificate);
  } catch (const std::exception& fault) {
    return fault.what();
  }
}

std::vector<std::string> Prover::ids() const {
  std::vector<std::string> ids;
  for (const FormedCase& made : cases_) ids.push_back(made.points.id);
  for (const FormedShapes& made : shape_cases_) ids.push_back(made.shapes.id);
  for (const FormedUnions& made : union_cases_) ids.push_back(made.unions.id);
  return ids;
}

std::optional<std::string> faults_of(std::string_view line, std::string_view certificate) { return Prover().faults_of(line, certificate); }

}  // namespace fathom::golden
