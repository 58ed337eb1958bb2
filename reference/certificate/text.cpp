// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate as text. Every number is exact and in lowest terms.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <span>

#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/dyadic.hpp"
#include "reference/polytope/narrow_pair.hpp"
#include "reference/polytope/placed_pair.hpp"

namespace fathom::certificate {
namespace {

// 2^k in decimal digits, for k from 0 to 63: nearly all denominators.
struct PowerOfTwo {
  char digits[20] = {};
  unsigned size = 0;
};

constexpr std::array<PowerOfTwo, 64> powers_of_two = [] {
  std::array<PowerOfTwo, 64> powers;
  for (unsigned k = 0; k < 64; ++k) {
    PowerOfTwo& power = powers[k];
    for (std::uint64_t n = std::uint64_t{1} << k; n > 0; n /= 10) ++power.size;
    std::uint64_t n = std::uint64_t{1} << k;
    for (unsigned i = power.size; i > 0; n /= 10) power.digits[--i] = static_cast<char>('0' + n % 10);
  }
  return powers;
}();

// Writes words and lines to a text that grows; numbers of one or two limbs without GMP.
class Writer {
 public:
  explicit Writer(std::size_t likely_size) : text_(likely_size, '\0') {}

  Writer& word(std::string_view text) {
    char* const at = begin_word(text.size());
    return done(at + text.copy(at, text.size()));
  }
  Writer& word(std::size_t n) { return done(put(begin_word(20), std::uint64_t{n})); }
  Writer& word(const mpz_class& n) { return done(put(begin_word(size_of(n)), n)); }
  Writer& word(const mpq_class& q) {
    char* at = put(begin_word(size_of(q.get_num()) + size_of(q.get_den())), q.get_num());
    if (mpz_cmp_ui(q.get_den_mpz_t(), 1) == 0) return done(at);
    *at++ = '/';
    return done(put(at, q.get_den()));
  }
  Writer& word(double value) {
    const kernels::Dyadic n = kernels::dyadic(value);
    if (n.exponent > 0 || n.exponent < -63) return word(exact_value(value));
    char* at = begin_word(48);
    if (n.mantissa < 0) *at++ = '-';
    at = put(at, static_cast<std::uint64_t>(n.mantissa < 0 ? -n.mantissa : n.mantissa));
    if (n.exponent == 0) return done(at);
    *at++ = '/';
    const PowerOfTwo& power = powers_of_two[static_cast<std::size_t>(-n.exponent)];
    return done(std::copy(std::begin(power.digits), std::end(power.digits), at) - (20 - power.size));
  }
  template <class NT>
  Writer& words(const Vec3<NT>& v) {
    return word(v.x).word(v.y).word(v.z);
  }
  Writer& words(const Point& p) { return word(p.x).word(p.y).word(p.z); }
  Writer& words(const std::array<double, 3>& p) { return word(p[0]).word(p[1]).word(p[2]); }
  void end() {
    *room(1) = '\n';
    ++size_;
    line_start_ = true;
  }
  std::string take() {
    text_.resize(size_);
    return std::move(text_);
  }

 private:
  __extension__ using Double = unsigned __int128;
  static constexpr std::uint64_t ten_to_19 = 10'000'000'000'000'000'000U;

  // Where the next characters go, at most so many.
  char* room(std::size_t most) {
    if (text_.size() - size_ < most) text_.resize(2 * text_.size() + most);
    return text_.data() + size_;
  }
  // A blank, if one is due, and where the word goes, which has at most so many characters.
  char* begin_word(std::size_t most) {
    char* at = room(most + 1);
    if (!line_start_) *at++ = ' ';
    line_start_ = false;
    return at;
  }
  Writer& done(const char* end) {
    size_ = static_cast<std::size_t>(end - text_.data());
    return *this;
  }

  // With the sign, and what mpz_get_str needs; 2^128 has 39 digits.
  static std::size_t size_of(const mpz_class& n) { return mpz_size(n.get_mpz_t()) <= 2 ? 42 : mpz_sizeinbase(n.get_mpz_t(), 10) + 2; }
  static char* put(char* at, std::uint64_t n) { return std::to_chars(at, at + 20, n).ptr; }
  static char* put(char* at, const mpz_class& number) {
    const mpz_srcptr n = number.get_mpz_t();
    if (mpz_size(n) > 2) {
      mpz_get_str(at, 10, n);
      return at + std::strlen(at);
    }
    if (mpz_sgn(n) < 0) *at++ = '-';
    return put_two(at, static_cast<Double>(mpz_getlimbn(n, 1)) << 64 | mpz_getlimbn(n, 0));
  }
  static char* put_two(char* at, Double n) {
    if (n < ten_to_19) return put(at, static_cast<std::uint64_t>(n));
    at = put_two(at, n / ten_to_19);
    char digits[20];
    const char* const end = put(digits, static_cast<std::uint64_t>(n % ten_to_19));
    at = std::fill_n(at, 19 - (end - digits), '0');
    return std::copy(static_cast<const char*>(digits), end, at);
  }

  std::string text_;
  std::size_t size_ = 0;
  bool line_start_ = true;
};

// Blanks too: a line may not end with one, and ids are easier to read out of a line without.
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

template <class P>
void write_points(Writer& out, std::string_view name, std::span<const P> points) {
  out.word(name).word(points.size()).end();
  for (const P& p : points) out.words(p).end();
}

template <class P>
void write_head(Writer& out, std::string_view id, std::span<const P> a, std::span<const P> b) {
  out.word("fathom-certificate 1").end();
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
    case ClaimKind::disjoint: out.word("disjoint").end(); break;
  }
  const bool complete = certificate.claim == ClaimKind::depth && certificate.complete;
  out.word("directions").word(certificate.directions.size()).word(complete ? "all" : "some").end();
  for (const Vector& n : certificate.directions) out.words(n).end();
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
  write_head(out, id, a, b);
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

}  // namespace fathom::certificate

namespace fathom {

std::string certificate_text(const Certificate& certificate) {
  const bool inner = certificate.claim == ClaimKind::depth || certificate.claim == ClaimKind::bounds;
  const bool weights = certificate.claim == ClaimKind::touching;
  certificate::Writer out(certificate::likely_size(certificate.a.size() + certificate.b.size(), inner ? &certificate.inner : nullptr));
  certificate::write_head(out, certificate.id, std::span<const Point>(certificate.a), std::span<const Point>(certificate.b));
  certificate::write_claim(out, certificate);
  if (inner) certificate::write_inner(out, certificate.inner);
  if (weights) {
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
