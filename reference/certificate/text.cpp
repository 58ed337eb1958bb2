// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate as text. Every number is exact and in lowest terms.
#include "fathom/certificate.hpp"

namespace fathom::certificate {
namespace {

class Writer {
 public:
  Writer& word(std::string_view text) {
    separate();
    text_ += text;
    return *this;
  }
  Writer& word(std::size_t n) { return word(std::to_string(n)); }
  Writer& word(const mpz_class& n) {
    separate();
    number(n.get_mpz_t());
    return *this;
  }
  Writer& word(const mpq_class& q) {
    separate();
    number(q.get_num_mpz_t());
    if (q.get_den() == 1) return *this;
    text_ += '/';
    number(q.get_den_mpz_t());
    return *this;
  }
  template <class V>
  Writer& words(const V& v) {
    return word(v.x).word(v.y).word(v.z);
  }
  void end() {
    text_ += '\n';
    line_start_ = true;
  }
  std::string take() { return std::move(text_); }

 private:
  void separate() {
    if (!line_start_) text_ += ' ';
    line_start_ = false;
  }
  // In place: certificates are mostly numbers.
  void number(mpz_srcptr n) {
    const std::size_t begin = text_.size();
    text_.resize(begin + mpz_sizeinbase(n, 10) + 2);
    mpz_get_str(text_.data() + begin, 10, n);
    text_.resize(text_.find('\0', begin));
  }

  std::string text_;
  bool line_start_ = true;
};

// Blanks too: a line may not end with one, and ids are easier to read out of a line without.
std::string escaped(const std::string& id) {
  constexpr char digits[] = "0123456789ABCDEF";
  std::string result;
  for (const char c : id) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte > 0x20 && byte < 0x7f && c != '%') result += c;
    else (result += '%', result += digits[byte >> 4], result += digits[byte & 15]);
  }
  return result;
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

}  // namespace

}  // namespace fathom::certificate

namespace fathom {

std::string certificate_text(const Certificate& certificate) {
  certificate::Writer out;
  out.word("fathom-certificate 1").end();
  if (!certificate.id.empty()) out.word("id").word(certificate::escaped(certificate.id)).end();
  out.word("a").word(certificate.a.size()).end();
  for (const Point& p : certificate.a) out.words(p).end();
  out.word("b").word(certificate.b.size()).end();
  for (const Point& p : certificate.b) out.words(p).end();
  certificate::write_claim(out, certificate);
  const bool inner = certificate.claim == ClaimKind::depth || certificate.claim == ClaimKind::bounds;
  const bool weights = certificate.claim == ClaimKind::touching;
  if (inner) certificate::write_inner(out, certificate.inner);
  if (weights) {
    certificate::write_weights(out, "weights_a", certificate.weights_a);
    certificate::write_weights(out, "weights_b", certificate.weights_b);
  }
  out.word("end").word(certificate.a.size()).word(certificate.b.size()).word(certificate.directions.size());
  out.word(inner ? certificate.inner.vertices.size() : certificate.weights_a.size());
  out.word(inner ? certificate.inner.facets.size() : certificate.weights_b.size()).end();
  return out.take();
}

}  // namespace fathom
