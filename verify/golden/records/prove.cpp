// SPDX-License-Identifier: GPL-3.0-or-later
// Proves records: reads the truth about two bodies from a certificate, and compares records with
// it. The checker's own parser reads certificates, and their content is used only after the checker
// has accepted them.

#include "verify/golden/records/prove.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "fathom/numbers.hpp"
#include "fathom/shape.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/answer/plane.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/rounded/optimal_cone.hpp"
#include "reference/shapes/core.hpp"
#include "verify/check/certificate.hpp"
#include "verify/check/limits.hpp"
#include "verify/check/reader.hpp"
#include "verify/digest/sha256.hpp"
#include "verify/golden/records/facts.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {
namespace {

using fathom_check::Certificate;
using fathom_check::Claim;

/// Returns the certificate with this id, about bodies of the plane or of space. Throws NotProved if
/// the checker does not accept it, or if `text` holds anything else.
Certificate accepted(std::string_view text, const std::string& id, bool of_plane = false) {
  fathom_check::Lines lines(text, fathom_check::longest_line);
  fathom_check::Reader reader(lines);
  std::optional<fathom_check::Reader::Found> found = reader.read();
  if (!found) throw NotProved("the certificate is not accepted: ");
  if (const fathom_check::Verdict verdict = judged(*found); !verdict.accepted())
    throw NotProved("the certificate is not accepted: " + fathom_check::verdict_line(verdict, id));
  if (found->certificate.id != id)
    throw NotProved("the certificate is that of another record, '" + found->certificate.id + "'");
  if (found->certificate.raising.has_value() != of_plane) throw NotProved("the certificate is about other bodies");
  if (reader.read()) throw NotProved("expected one certificate, found more");
  return std::move(found->certificate);
}

// ---- the checker's values, and ours ----

mpq_class value_of(const fathom_check::Rational& q) { return kernels::ratio(q.num.value(), q.den.value()); }
Point value_of(const fathom_check::RationalPoint& p) { return {value_of(p.x), value_of(p.y), value_of(p.z)}; }
Vector value_of(const fathom_check::Vector& v) { return {v.x.value(), v.y.value(), v.z.value()}; }

std::vector<Vector> values_of(const std::vector<fathom_check::Vector>& vectors) {
  std::vector<Vector> values;
  for (const fathom_check::Vector& v : vectors) values.push_back(value_of(v));
  return values;
}

bool same(const Point& p, const fathom_check::RationalPoint& q) {
  const auto equal = [](const mpq_class& x, const fathom_check::Rational& y) {
    return x.get_num() * y.den.value() == y.num.value() * x.get_den();
  };
  return equal(p.x, q.x) && equal(p.y, q.y) && equal(p.z, q.z);
}

bool same(const Atom& atom, const fathom_check::Atom& other) {
  return other.size() == 1 + atom.axes.size() && same(atom.center, other.front()) &&
         std::equal(atom.axes.begin(), atom.axes.end(), other.begin() + 1, other.end(),
                    [](const Point& p, const fathom_check::RationalPoint& q) { return same(p, q); });
}

bool same(const Term& term, const fathom_check::Term& other) {
  return std::equal(term.atoms.begin(), term.atoms.end(), other.begin(), other.end(),
                    [](const Atom& atom, const fathom_check::Atom& found) { return same(atom, found); });
}

bool same(const std::vector<Point>& points, const std::vector<fathom_check::RationalPoint>& others) {
  return std::equal(points.begin(), points.end(), others.begin(), others.end(),
                    [](const auto& p, const auto& q) { return same(p, q); });
}

/// Returns whether the body of the certificate is the hull of these points. Those of the plane are
/// raised by the checker itself, to as many levels, each in the order in which they are listed.
bool same(const std::vector<Point>& points, const fathom_check::Body& body) {
  const std::vector<fathom_check::RationalPoint>& found = body.points.items;
  if (body.levels == 1) return same(points, found);
  bool equal = found.size() == body.levels * points.size();
  for (std::size_t i = 0; equal && i < found.size(); ++i) {
    const Point p = value_of(found[i]), &expected = points[i % points.size()];
    equal = p.x == expected.x && p.y == expected.y;
  }
  return equal;
}

/// Returns whether the body of the certificate has these pieces, in this order.
bool same(const Pieces& pieces, const fathom_check::Body& body) {
  if (body.core != fathom_check::Body::Core::pieces || body.pieces.size() != pieces.size()) return false;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::size_t begin = begin_of(body.pieces, i);
    if (body.pieces[i].end - begin != pieces[i].size()) return false;
    for (std::size_t k = 0; k < pieces[i].size(); ++k)
      if (!same(pieces[i][k], body.points.items[begin + k])) return false;
  }
  return true;
}

/// Returns the convex combination of the points with these weights.
Point combined(const std::vector<Point>& points, const std::vector<fathom_check::Weight>& weights) {
  Point sum;
  for (const fathom_check::Weight& w : weights) {
    if (w.index >= points.size())
      throw NotProved("a weight of a point that there is not");  // the checker refuses such a certificate too
    const mpq_class weight = value_of(w.weight);
    const Point& p = points[w.index];
    sum = {sum.x + weight * p.x, sum.y + weight * p.y, sum.z + weight * p.z};
  }
  return sum;
}

// ---- polytopes ----

/// The statements of an accepted certificate.
struct Proved {
  Status status = Status::disjoint;
  std::vector<Vector> directions;
  Point common;                ///< touching
  mpq_class distance_squared;  ///< disjoint
};

Proved stated(const Certificate& certificate, const HullPair& hulls, bool contacts) {
  const auto hull_of = [](const fathom_check::Body& body, const std::vector<Point>& expected) {
    return body.radius.num.sign() == 0 && same(expected, body.points.items);
  };
  if (!hull_of(certificate.a, hulls.a.points) || !hull_of(certificate.b, hulls.b.points))
    throw NotProved("the certificate is about other points");
  Proved proved{Status::disjoint, values_of(certificate.directions.items), {}, {}};
  switch (certificate.claim) {
    case Claim::depth:
      if (!certificate.all) throw NotProved("the certificate does not claim to list all optima");
      proved.status = Status::penetrating;
      break;
    case Claim::bounds:
    case Claim::signed_bounds: throw NotProved("the certificate proves bounds only");
    case Claim::touching: proved.status = Status::touching; break;
    case Claim::solid:
    case Claim::disjoint: throw NotProved("the certificate does not prove how far the bodies are apart");
    case Claim::apart: proved.distance_squared = value_of(certificate.low); break;
  }
  if (const int format = contacts ? 4 : proved.status == Status::disjoint ? 2 : 1; certificate.format != format)
    throw NotProved("the certificate has format " + std::to_string(certificate.format) + ", not " +
                    std::to_string(format));
  proved.common = combined(hulls.a.points, certificate.weights_a.items);
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

/// The faces of both bodies in one direction, and their distance.
struct Sides {
  SupportingFace a, b;  ///< in the directions -n and n
  mpq_class support;    ///< h(n)
  mpq_class factor;     ///< h(n) / <n,n>
  Point translation;

  Sides(const Integers& bodies, const Vector& n)
      : a(face_in_direction(bodies.a, -n)), b(face_in_direction(bodies.b, n)) {
    support = kernels::ratio(a.height + b.height, bodies.denominator);
    factor = support / dot(n, n);
    translation = {factor * n.x, factor * n.y, factor * n.z};
  }

  /// Returns whether the points lie on both faces and b - a is the translation.
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
      throw NotProved("expected.witness: the points do not prove the contact");
    const ContactKind kind = kind_of(sides.a.corners.size(), sides.b.corners.size());
    answer.optima.push_back({n, sides.support, {kind, sides.a.corners, sides.b.corners}});
  }
  return answer;
}

Distance proved_distance(const Integers& bodies, const Proved& proved, const Witness& witness) {
  const Vector& n = proved.directions.front();
  const Sides sides(bodies, n);
  if (!sides.witnessed(witness, bodies, n))
    throw NotProved("expected.distance.witness: the points do not prove the distance");
  return {proved.distance_squared, n, sides.translation, witness};
}

HullStatement truth_in(const HullPair& hulls, const FormedCase& made, const std::optional<Witness>& witness,
                       std::string_view certificate, Workspace* workspace) {
  const Proved proved = stated(accepted(certificate, made.id), hulls, made.contacts);
  if (!witness) throw NotProved("expected.witness: there is none");
  const Integers bodies = integers_of(hulls.a.points, hulls.b.points);
  Depth answer;
  answer.flat_a = polytope::affine_rank(bodies.a) < 3;
  answer.flat_b = polytope::affine_rank(bodies.b) < 3;
  switch (proved.status) {
    case Status::penetrating: answer.outcome = proved_penetration(bodies, proved, *witness); break;
    case Status::touching: answer.outcome = Touch{proved.directions.front(), proved.common}; break;
    case Status::disjoint: answer.outcome = proved_distance(bodies, proved, *witness); break;
  }
  return truth_of(hulls, std::move(answer), nullptr, workspace);
}

// ---- shapes ----

/// A body in the simplest form, as certificates write it; and its points, if it is the hull of
/// points.
struct WrittenBody {
  Shape shape;
  std::optional<std::vector<Point>> points;

  explicit WrittenBody(const families::NamedBody& body) : WrittenBody(families::shape_of(body)) {}
  explicit WrittenBody(const Shape& body)
      : shape(shapes::simplified(body)), points(shapes::polytope_points(shape, most_expanded_points)) {}

  [[nodiscard]] const HalfSpace* half_space() const { return std::get_if<HalfSpace>(&shape.core); }

  [[nodiscard]] bool is(const fathom_check::Body& body) const {
    if (value_of(body.radius) != shape.radius) return false;
    switch (body.core) {
      case fathom_check::Body::Core::points: return points && same(*points, body);
      case fathom_check::Body::Core::half_space:
        return half_space() && same(half_space()->normal, body.normal) && half_space()->offset == value_of(body.offset);
      case fathom_check::Body::Core::shape: break;
      case fathom_check::Body::Core::pieces:
      case fathom_check::Body::Core::solid:
      case fathom_check::Body::Core::none: return false;
    }
    const auto* const terms = std::get_if<std::vector<Term>>(&shape.core);
    return terms && std::equal(terms->begin(), terms->end(), body.terms.begin(), body.terms.end(),
                               [](const Term& term, const fathom_check::Term& found) { return same(term, found); });
  }

  /// Returns the greatest <n,x> of the core, which must not be curved; a half-space has one only in
  /// the direction of its normal.
  [[nodiscard]] mpq_class height(const Vector& n) const {
    if (const HalfSpace* const half = half_space()) {
      const mpq_class factor = dot(n, half->normal) / dot(half->normal, half->normal);
      if (factor <= 0 ||
          Point{factor * half->normal.x, factor * half->normal.y, factor * half->normal.z} != Point{n.x, n.y, n.z})
        throw NotProved("the direction is not that of the half-space");
      return factor * half->offset;
    }
    mpq_class best = dot(n, points->front());
    for (const Point& p : *points) best = std::max(best, dot(n, p));
    return best;
  }
};

/// Returns the cone of an accepted certificate: the checker has made sure that its lineality is
/// independent and its rays are extreme.
std::optional<OptimalCone> cone_of(const Certificate& certificate) {
  if (!certificate.has_cone) return std::nullopt;
  OptimalCone cone = rounded::canonical({values_of(certificate.lineality.items), values_of(certificate.rays.items)});
  return certificate.raising ? answer::cone_in_plane(std::move(cone)) : cone;
}

ShapeStatement stated(const Certificate& certificate, const WrittenBody& a, const WrittenBody& b) {
  if (!a.is(certificate.a) || !b.is(certificate.b)) throw NotProved("the certificate is about other bodies");
  const bool plane = a.half_space() || b.half_space();
  const mpq_class rho = a.shape.radius + b.shape.radius, low = value_of(certificate.low),
                  high = value_of(certificate.high);
  std::vector<Vector> directions = values_of(certificate.directions.items);
  ShapeStatement truth{Surd{rho, 0}, directions.front(), {}, {}};
  switch (certificate.claim) {
    case Claim::depth:
      if (!certificate.all && !plane) throw NotProved("the certificate does not claim to list all optima");
      truth.value = Surd{rho, low};
      break;
    case Claim::touching:
      if (!certificate.has_cone && !plane) throw NotProved("the certificate does not claim to list all directions");
      truth.cone = plane ? OptimalCone{Lineality::none, {}, {truth.direction}} : cone_of(certificate);
      truth.direction = truth.cone->direction();
      directions = {truth.direction};
      break;
    case Claim::apart: truth.value = Surd{rho, -low}; break;
    case Claim::signed_bounds:
      if (low == high) truth.value = Surd{low, 0};
      else truth.value = Bounds{low, high};
      return truth;
    default: throw NotProved("the certificate does not prove the signed depth");
  }
  for (const Vector& n : directions) truth.translations.push_back({n, (b.height(n) + a.height(-n)) / dot(n, n), rho});
  return truth;
}

/// Returns whether the proved truth contradicts the answer known by construction, which happens
/// only if a generator is wrong.
bool denies(const ShapeStatement& truth, const families::KnownDepth& known) {
  if (const Surd* const exact = std::get_if<Surd>(&truth.value)) return compare(known.signed_depth, *exact) != 0;
  const auto& [low, high] = std::get<Bounds>(truth.value);
  return compare(known.signed_depth, low) < 0 || compare(known.signed_depth, high) > 0;
}

ShapeStatement truth_in(const families::NamedPair& shapes, const FormedCase& made, const std::optional<Witness>&,
                        std::string_view certificate, Workspace*) {
  const WrittenBody a(shapes.a), b(shapes.b);
  ShapeStatement truth = stated(accepted(certificate, made.id), a, b);
  if (shapes.known && denies(truth, *shapes.known))
    throw NotProved("source.signed_depth: the certificate proves another one");
  return truth;
}

// ---- bodies of the plane ----

PlaneStatement truth_in(const families::PlanePair& plane, const FormedCase& made, const std::optional<Witness>&,
                        std::string_view certificate, Workspace*) {
  const Certificate proof = accepted(certificate, made.id, true);
  const WrittenBody a(*plane.a.shape), b(*plane.b.shape);
  PlaneStatement truth{stated(proof, a, b), {}};
  if (proof.claim == Claim::touching) return truth;
  const Integers cores = integers_of(*a.points, *b.points);
  for (const AlongNormal& way : truth.shapes.translations) {
    const Sides sides(cores, way.normal);
    truth.contacts.push_back({answer::kind_in_plane(sides.a.corners.size() > 1, sides.b.corners.size() > 1),
                              sides.a.corners, sides.b.corners});
  }
  return truth;
}

// ---- unions ----

UnionGap gap_in(const Certificate& certificate, const Unions& unions) {
  const std::uint32_t a = certificate.of_unions.nearest_a, b = certificate.of_unions.nearest_b;
  if (a >= unions.a.size() || b >= unions.b.size()) throw NotProved("a nearest piece that there is not");
  const Point of_a = combined(unions.a[a], certificate.weights_a.items),
              of_b = combined(unions.b[b], certificate.weights_b.items);
  return {value_of(certificate.low), a, b, {of_b.x - of_a.x, of_b.y - of_a.y, of_b.z - of_a.z}};
}

UnionStatement stated(const Certificate& certificate, const Unions& unions) {
  if (!same(unions.a, certificate.a) || !same(unions.b, certificate.b))
    throw NotProved("the certificate is about other bodies");
  UnionStatement truth;
  switch (certificate.claim) {
    case Claim::depth:
      truth.status = Status::penetrating;
      truth.squared = value_of(certificate.low);
      for (const fathom_check::RationalPoint& t : certificate.of_unions.optima.items)
        truth.optima.push_back(value_of(t));
      return truth;
    case Claim::touching: truth.status = Status::touching; return truth;
    case Claim::apart: truth.gap = gap_in(certificate, unions); return truth;
    default: throw NotProved("the certificate does not prove the depth of unions");
  }
}

UnionStatement truth_in(const Unions& unions, const FormedCase& made, const std::optional<Witness>&,
                        std::string_view certificate, Workspace*) {
  UnionStatement truth = stated(accepted(certificate, made.id), unions);
  if (!unions.known) return truth;
  const auto& [status, squared, optima] = *unions.known;
  if (truth.status != status || (truth.gap ? truth.gap->squared : truth.squared) != squared ||
      truth.optima.size() != optima)
    throw NotProved("source.known: the certificate proves another answer");
  return truth;
}

// ---- contacts ----

std::vector<Point> points_of(const fathom_check::Body& body) {
  std::vector<Point> points;
  for (const fathom_check::RationalPoint& p : body.points.items) points.push_back(value_of(p));
  return points;
}

/// Returns whether patch `number` of the certificate has this direction and these corners, in this
/// order. A half-space has no points, and no weights.
bool same(const Patch& patch, const Certificate& certificate, std::size_t number) {
  const fathom_check::PatchParts& proved = certificate.of_patches;
  const std::vector<Point> a = points_of(certificate.a), b = points_of(certificate.b);
  const auto end_at = [&](const std::vector<Point>& points, std::size_t begin, std::size_t end, const Point& p) {
    const auto first = proved.weights.begin();
    return points.empty() || combined(points, {first + static_cast<std::ptrdiff_t>(begin),
                                               first + static_cast<std::ptrdiff_t>(end)}) == p;
  };
  const std::size_t begin = begin_of(proved.corner_lists, number);
  if (patch.direction != value_of(certificate.directions.items[number]) ||
      proved.corner_lists[number].end - begin != patch.corners.size())
    return false;
  for (std::size_t k = 0; k < patch.corners.size(); ++k) {
    const auto& [end_a, end_b] = proved.corners.items[begin + k];
    if (!end_at(a, proved.begin_of(begin + k), end_a, patch.a(k).core) || !end_at(b, end_a, end_b, patch.b(k).core))
      return false;
  }
  return true;
}

bool same(const std::variant<DirectionalDerivative, LeftOut>& derivative, const Twist& motion,
          const fathom_check::PatchParts::Rate& rate) {
  const auto* const found = std::get_if<DirectionalDerivative>(&derivative);
  return found && same(motion.v, rate.v) && same(motion.w, rate.w) && found->sign() == rate.sign.sign() &&
         found->root() == value_of(rate.root);
}

}  // namespace

RecordStatement proved_truth(const FormedCase& made, const std::optional<Witness>& witness,
                             std::string_view certificate, Workspace* workspace) {
  return std::visit(
      [&](const auto& bodies) { return RecordStatement(truth_in(bodies, made, witness, certificate, workspace)); },
      made.bodies);
}

ContactFacts proved_contacts(const FormedCase& made, std::string_view text) {
  const Certificate certificate = accepted(text, made.id);
  ContactStatement found = contacts_of(made.bodies, {});
  const ContactGeometry& geometry = found.contacts.manifold.geometry;
  const fathom_check::PatchParts& proved = certificate.of_patches;
  bool patches = !geometry.patches.empty() && proved.corner_lists.size() == geometry.patches.size();
  for (std::size_t i = 0; patches && i < geometry.patches.size(); ++i)
    patches = same(geometry.patches[i], certificate, i);
  if (!patches) throw NotProved("expected.manifold.patches: the certificate proves others");
  const std::span<const Twist> motions = recorded_motions();
  if (!has_half_space(certificate)) insist_on_cone(geometry, cone_of(certificate));
  const bool rates = !geometry.cone || has_half_space(certificate);
  if (proved.rates.items.size() != (rates ? motions.size() : 0))
    throw NotProved("expected.derivatives: the certificate does not prove them");
  for (std::size_t i = 0; i < proved.rates.items.size(); ++i)
    if (!same(found.contacts.derivatives[i], motions[i], proved.rates.items[i]))
      throw NotProved("expected.derivatives: the certificate proves others");
  return std::move(found.contacts);
}

// ---- records ----

const FormedCase& case_in(const std::vector<FormedCase>& cases, Form form) {
  const auto made = std::ranges::find(cases, form, &FormedCase::form);
  if (made == cases.end()) throw NotProved("source: it has no such form");
  return *made;
}

// The certificate proves status, depth and every optimal direction; the other fields follow from
// these and the bodies. The record is then written anew, and must have the same text: so no field
// can be wrong, missing, repeated or unknown.

/// Returns the bodies that the source of the record generates; an id stands for one pair of bodies
/// only.
const FormedCase& Prover::source_of(const ReadRecord& claimed) {
  if (claimed.id != id_of(claimed.recipe, claimed.form)) throw NotProved("id: it is not that of its source");
  constexpr unsigned largest_size = 10'000;  // limits the work that an untrusted text can cause
  if (claimed.recipe.size > largest_size) throw NotProved("source.size: it is larger than that of any record");
  if (recipe_ != claimed.recipe) {
    recipe_.reset();
    cases_ = cases_of(claimed.recipe);
    recipe_ = claimed.recipe;
  }
  if (!claimed.hulls) return case_in(cases_, claimed.form);
  const auto made = std::ranges::find(cases_, claimed.form, &FormedCase::form);
  const HullPair* const hulls = made == cases_.end() ? nullptr : &std::get<HullPair>(made->bodies);
  if (!hulls || hulls->a.points != claimed.hulls->a.points || hulls->b.points != claimed.hulls->b.points)
    throw NotProved("source: it does not yield these points");
  return *made;
}

std::optional<std::string> Prover::faults(std::string_view line, std::string_view certificate) {
  const ReadRecord claimed = read_record(line);
  const FormedCase& made = source_of(claimed);
  RecordStatement truth = proved_truth(made, claimed.witness, certificate, &workspace_);
  std::optional<ContactFacts> contacts;
  if (made.contacts) contacts = proved_contacts(made, certificate);
  const Facts facts =
      facts_of(claimed.recipe, made, std::move(truth), digest::digest_of(certificate).sha256, std::move(contacts));
  const std::string expected = line_of(facts);
  if (expected != line) return first_difference(expected, line);
  id_ = claimed.id;
  row_ = csv_row(facts);
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
  for (const FormedCase& made : cases_) ids.push_back(made.id);
  return ids;
}

std::optional<std::string> faults_of(std::string_view line, std::string_view certificate) {
  return Prover().faults_of(line, certificate);
}

}  // namespace fathom::golden
