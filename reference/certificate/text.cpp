// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate as text. Every number is exact and in lowest terms.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fathom/certificate.hpp"
#include "kernels/float_environment.hpp"
#include "reference/certificate/writer.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::certificate {
namespace {

template <class P>
void write_head(Writer& out, std::size_t format, std::string_view id, std::span<const P> a, std::span<const P> b) {
  out.word("fathom-certificate").word(format).end();
  if (!id.empty()) out.word("id").word(escaped(id)).end();
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

// The last line counts what came before.
void write_end(Writer& out, const std::array<std::size_t, 5>& counts) {
  out.word("end");
  for (const std::size_t n : counts) out.word(n);
  out.end();
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
  write_end(out, {a.size(), b.size(), answer.optima.size(), inner.vertices.size(), inner.facets.size()});
  return out.take();
}

std::string text_of(Certificate certificate, std::string_view id) {
  certificate.id = id;
  return certificate_text(certificate);
}

}  // namespace

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

std::string certificate_text(const Certificate& certificate) {
  const bool inner = certificate.claim == ClaimKind::depth || certificate.claim == ClaimKind::bounds;
  certificate::Writer out(certificate::likely_size(certificate.a.size() + certificate.b.size(), inner ? &certificate.inner : nullptr));
  // Format 1 cannot say how far bodies are apart; in all that is written here format 2 differs from it by its number alone.
  const std::size_t format = certificate.claim == ClaimKind::apart ? 2 : 1;
  certificate::write_head(out, format, certificate.id, std::span<const Point>(certificate.a), std::span<const Point>(certificate.b));
  certificate::write_claim(out, certificate);
  if (inner) {
    certificate::write_inner(out, certificate.inner);
  } else {
    certificate::write_weights(out, "weights_a", certificate.weights_a);
    certificate::write_weights(out, "weights_b", certificate.weights_b);
  }
  certificate::write_end(out, {certificate.a.size(), certificate.b.size(), certificate.directions.size(),
                               inner ? certificate.inner.vertices.size() : certificate.weights_a.size(),
                               inner ? certificate.inner.facets.size() : certificate.weights_b.size()});
  return out.take();
}

std::string certificate_text(std::span<const Point> a, std::span<const Point> b, const Depth& answer, std::string_view id,
                             Monitor* monitor) {
  const Penetration* penetration = answer.penetration();
  if (penetration == nullptr || !penetration->inner) return certificate::text_of(make_certificate(a, b, answer, monitor), id);
  polytope::require_bodies(a, b);
  return certificate::text_of_depth(id, a, b, *penetration);
}

std::string certificate_text(std::span<const std::array<double, 3>> a, std::span<const std::array<double, 3>> b, const Depth& answer,
                             std::string_view id, Monitor* monitor) {
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
