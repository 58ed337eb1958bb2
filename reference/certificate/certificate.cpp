// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of polytopes: how they are made, the naive check of them, and their text, format 1.
//                                                                          [verify/check/FORMAT.md]
#include "reference/certificate/certificate.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>

#include "fathom/certificate.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/expanding/expanding_polytope.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/position.hpp"
#include "reference/solve/depth.hpp"

namespace fathom::certificate {
namespace {

Certificate of_bodies(std::span<const Point> a, std::span<const Point> b, ClaimKind claim) {
  Certificate certificate;
  certificate.a.assign(a.begin(), a.end());
  certificate.b.assign(b.begin(), b.end());
  certificate.claim = claim;
  return certificate;
}

// Q, found anew unless the answer brought it along. The search does not look at the answer, so this
// is a check of it too.
InnerPolytope proof_of_depth(std::span<const Point> a, std::span<const Point> b, const Penetration& answer,
                             Monitor* monitor) {
  if (answer.inner) return *answer.inner;
  Options search;
  search.method = Method::certificate;
  search.monitor = monitor;
  search.optima = answer.optima.size();
  Depth found = penetration_depth(a, b, search);
  if (!found.penetration()) contradiction("O is not in the interior of P");
  if (found.squared() != answer.squared()) contradiction("another depth");
  const auto same = [](const Optimum& one, const Optimum& other) { return one.direction == other.direction; };
  if (found.optima_count() != answer.optima.size() + answer.unlisted ||
      !std::ranges::equal(found.optima(), answer.optima, same))
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
  if (is_zero(answer.direction) || support_sign(a, b, answer.direction) != 0)
    contradiction("no plane through O supports P");
  certificate.directions = {answer.direction};
  certificate.weights_a = std::move(origin.a);
  certificate.weights_b = std::move(origin.b);
  return certificate;
}

Certificate proof_of_distance(std::span<const Point> a, std::span<const Point> b, const Distance& answer) {
  if (is_zero(answer.direction) || support_sign(a, b, answer.direction) >= 0)
    contradiction("the direction does not separate the bodies");
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

// ---- the naive check ----

// In rationals, by the definitions, slow. Convexity is global here (every vertex against every
// facet), where the checkers' is local (each edge).

class Check {
 public:
  explicit Check(const Certificate& certificate) : c_(certificate) {}

  kernels::Report run() {
    if (!report_.expect(!c_.a.empty() && !c_.b.empty(), "an empty body")) return report_;
    if (!report_.expect(!c_.directions.empty(), "no direction")) return report_;
    for (const Vector& n : c_.directions)
      if (report_.expect(!is_zero(n), "the zero direction")) direction(n);
    if (c_.claim == ClaimKind::depth) report_.expect(c_.low > 0 && c_.low == c_.high, "not one positive depth");
    if (c_.claim == ClaimKind::bounds)
      report_.expect(c_.low >= 0 && c_.high >= c_.low && c_.high > 0, "not a lower and an upper bound");
    if (c_.claim == ClaimKind::apart) report_.expect(c_.low > 0 && c_.low == c_.high, "not one positive distance");
    if (c_.claim == ClaimKind::depth || c_.claim == ClaimKind::bounds) inner_polytope();
    if (c_.claim == ClaimKind::depth) all_optima();
    else report_.expect(c_.directions.size() == 1, "more than one direction");
    if (c_.claim == ClaimKind::touching || c_.claim == ClaimKind::apart) nearest_points();
    return report_;
  }

 private:
  [[nodiscard]] mpq_class support(const Vector& n) const {
    mpq_class low = dot(n, c_.a.front()), high = dot(n, c_.b.front());
    for (const Point& p : c_.a) low = std::min(low, dot(n, p));
    for (const Point& p : c_.b) high = std::max(high, dot(n, p));
    return high - low;
  }

  void direction(const Vector& n) {
    const mpq_class h = support(n), square = dot(n, n);
    switch (c_.claim) {
      case ClaimKind::depth:
        report_.expect(h > 0 && h * h == c_.low * square, "a direction does not show the depth");
        break;
      case ClaimKind::bounds:
        report_.expect(h > 0 && h * h <= c_.high * square, "the direction does not show the upper bound");
        break;
      case ClaimKind::touching: report_.expect(h == 0, "the plane through O does not support P"); break;
      case ClaimKind::apart:
        report_.expect(h < 0 && h * h == c_.low * square, "the direction does not show the distance");
        break;
    }
  }

  void inner_polytope() {
    expanding::check_inner_polytope(report_, c_.inner, c_.a, c_.b, [&](const Point& n, const mpq_class& height) {
      const mpq_class square = dot(n, n);
      report_.expect(height * height >= c_.low * square, "a facet of Q is too near");
      if (height * height == c_.low * square) tight_.push_back(n);
    });
  }

  [[nodiscard]] static bool parallel(const Vector& n, const Point& m) {
    const Point p{n.x, n.y, n.z};
    return cross(p, m) == Point{} && dot(p, m) > 0;
  }

  void all_optima() {
    for (std::size_t i = 0; i < c_.directions.size(); ++i) {
      const Vector& n = c_.directions[i];
      report_.expect(primitive(n) == n, "a direction is not primitive");
      report_.expect(i == 0 || lexicographically_less(c_.directions[i - 1], n), "the directions are not in order");
      report_.expect(std::any_of(tight_.begin(), tight_.end(), [&](const Point& m) { return parallel(n, m); }),
                     "a direction without a facet");
    }
    if (!c_.complete) return;
    for (const Point& m : tight_)
      report_.expect(
          std::any_of(c_.directions.begin(), c_.directions.end(), [&](const Vector& n) { return parallel(n, m); }),
          "an optimum is missing");
  }

  // Touching: one common point.
  void nearest_points() {
    const Point z = polytope::convex_combination(report_, c_.b, c_.weights_b) -
                    polytope::convex_combination(report_, c_.a, c_.weights_a);
    report_.expect(dot(z, z) == c_.low, "the weighted points are not as near as is said");
  }

  const Certificate& c_;
  kernels::Report report_;
  std::vector<Point> tight_;
};

// ---- the text: every number is exact and in lowest terms ----

template <class P>
void write_head(Writer& out, std::size_t format, std::string_view id, std::span<const P> a, std::span<const P> b) {
  write_header(out, format, id);
  write_points(out, "a", a);
  write_points(out, "b", b);
}

void write_claim(Writer& out, const Certificate& certificate) {
  out.word("claim");
  switch (certificate.claim) {
    case ClaimKind::depth: out.word("depth").word(certificate.low).end(); break;
    case ClaimKind::bounds: out.word("bounds").word(certificate.low).word(certificate.high).end(); break;
    case ClaimKind::touching: out.word("touching").end(); break;
    case ClaimKind::apart: out.word("apart").word(certificate.low).end(); break;
  }
  const bool complete = certificate.claim == ClaimKind::depth && certificate.complete;
  out.word("directions").word(certificate.directions.size()).word(complete ? "all" : "some").end();
  for (const Vector& n : certificate.directions) out.words(n).end();
}

// Generous for coordinates in binary64: a text that is longer costs a copy.
std::size_t likely_size(std::size_t points, const InnerPolytope* inner) {
  return 500 + 120 * points + (inner != nullptr ? 8 * inner->vertices.size() + 24 * inner->facets.size() : 0);
}

// The text of an answer that brings its proof along.
template <class P>
std::string text_of_depth(std::string_view id, std::span<const P> a, std::span<const P> b, const Penetration& answer) {
  const InnerPolytope& inner = *answer.inner;
  Writer out(likely_size(a.size() + b.size(), &inner));
  write_head(out, 1, id, a, b);
  out.word("claim").word("depth").word(answer.squared()).end();
  out.word("directions").word(answer.optima.size()).word(answer.unlisted == 0 ? "all" : "some").end();
  for (const Optimum& optimum : answer.optima) out.words(optimum.direction).end();
  write_inner(out, inner);
  write_end(out, std::array{a.size(), b.size(), answer.optima.size(), inner.vertices.size(), inner.facets.size()});
  return out.take();
}

std::string text_of(Certificate certificate, std::string_view id) {
  certificate.id = id;
  return certificate_text(certificate);
}

}  // namespace

kernels::Report validate(const Certificate& certificate) { return Check(certificate).run(); }

void contradiction(const char* what) {
  throw std::logic_error(std::string("the certificate contradicts the answer: ") + what);
}

void write_header(Writer& out, std::size_t format, std::string_view id) {
  out.word("fathom-certificate").word(format).end();
  if (!id.empty()) out.word("id").word(escaped(id)).end();
}

void write_end(Writer& out, std::span<const std::size_t> counts) {
  out.word("end");
  for (const std::size_t n : counts) out.word(n);
  out.end();
}

void write_inner(Writer& out, const InnerPolytope& inner) {
  out.word("vertices").word(inner.vertices.size()).end();
  for (const auto& [i, j] : inner.vertices) out.word(std::size_t{j}).word(std::size_t{i}).end();
  out.word("facets").word(inner.facets.size()).end();
  for (const std::vector<std::uint32_t>& facet : inner.facets) {
    out.word(facet.size());
    for (const std::uint32_t corner : facet) out.word(std::size_t{corner});
    out.end();
  }
}

void write_weights(Writer& out, std::string_view name, const std::vector<Weight>& weights) {
  out.word(name).word(weights.size()).end();
  for (const Weight& w : weights) out.word(std::size_t{w.index}).word(w.weight).end();
}

std::string escaped(std::string_view id) {
  constexpr char digits[] = "0123456789ABCDEF";
  std::string result;
  for (const char c : id) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte > 0x20 && byte < 0x7f && c != '%') result += c;
    else (result += '%', result += digits[byte >> 4], result += digits[byte & 15]);
  }
  return result;
}

}  // namespace fathom::certificate

namespace fathom {

Certificate make_certificate(std::span<const Point> a, std::span<const Point> b, const Depth& answer,
                             Monitor* monitor) {
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

Certificate make_bounds_certificate(std::span<const Point> a, std::span<const Point> b, const mpq_class& low,
                                    const mpq_class& high, const std::optional<Vector>& hint, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  for (const mpq_class* bound : {&low, &high}) kernels::require_lowest_terms(*bound);
  if (low < 0) throw std::invalid_argument("the lower bound of a squared depth is negative");
  kernels::Context context(monitor);
  const polytope::PlacedPair pair = polytope::place(a, b);
  const mpz_class unit = pair.denominator * pair.denominator;
  expanding::BallExpansion expansion =
      expanding::expand_to_ball(context, pair.a, pair.b, low * unit, high * unit, hint);
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

std::string certificate_text(const Certificate& certificate) {
  const bool inner = certificate.claim == ClaimKind::depth || certificate.claim == ClaimKind::bounds;
  certificate::Writer out(
      certificate::likely_size(certificate.a.size() + certificate.b.size(), inner ? &certificate.inner : nullptr));
  // Format 1 cannot say how far bodies are apart; in all that is written here format 2 differs from
  // it by its number alone.
  const std::size_t format = certificate.claim == ClaimKind::apart ? 2 : 1;
  certificate::write_head(out, format, certificate.id, std::span<const Point>(certificate.a),
                          std::span<const Point>(certificate.b));
  certificate::write_claim(out, certificate);
  if (inner) {
    certificate::write_inner(out, certificate.inner);
  } else {
    certificate::write_weights(out, "weights_a", certificate.weights_a);
    certificate::write_weights(out, "weights_b", certificate.weights_b);
  }
  const std::array counts = {certificate.a.size(), certificate.b.size(), certificate.directions.size(),
                             inner ? certificate.inner.vertices.size() : certificate.weights_a.size(),
                             inner ? certificate.inner.facets.size() : certificate.weights_b.size()};
  certificate::write_end(out, counts);
  return out.take();
}

std::string certificate_text(std::span<const Point> a, std::span<const Point> b, const Depth& answer,
                             std::string_view id, Monitor* monitor) {
  const Penetration* penetration = answer.penetration();
  if (penetration == nullptr || !penetration->inner)
    return certificate::text_of(make_certificate(a, b, answer, monitor), id);
  polytope::require_bodies(a, b);
  return certificate::text_of_depth(id, a, b, *penetration);
}

std::string certificate_text(std::span<const std::array<double, 3>> a, std::span<const std::array<double, 3>> b,
                             const Depth& answer, std::string_view id, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  const Penetration* penetration = answer.penetration();
  if (penetration == nullptr || !penetration->inner)
    return certificate_text(polytope::exact_points(a), polytope::exact_points(b), answer, id, monitor);
  return certificate::text_of_depth(id, a, b, *penetration);
}

std::string certificate_text(const Body& a, const Body& b, const Depth& answer, std::string_view id, Monitor* monitor) {
  if (a.points.in_binary64() && b.points.in_binary64())
    return certificate_text(a.points.binary64(), b.points.binary64(), answer, id, monitor);
  return certificate_text(a.points.exact(), b.points.exact(), answer, id, monitor);
}

}  // namespace fathom
