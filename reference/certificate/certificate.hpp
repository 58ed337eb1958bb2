// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies and an answer.
// Output  its proof as exact text: an inner polytope and a supporting direction. Here: the checks
//         of proofs, which are twins of the checkers, and the writer of all formats.
//                                                                           [proofs/certificate.md]
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/certificate.hpp"
#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "kernels/messages.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/number/text.hpp"
#include "kernels/vector.hpp"

namespace fathom::certificate {

/// Checks the proof by the definitions, in rationals and over all pairs: the naive twin of the
/// checkers.
[[nodiscard]] kernels::Report validate(const Certificate& certificate);

/// The same for shapes, and all optimal directions of cores that touch by the rules of the format.
/// Throws std::invalid_argument if a shape is none.
[[nodiscard]] kernels::Report validate(const ShapeCertificate& certificate);

/// The same for its patches: their corners are those of the naive twin. Sides and rates are left to
/// the checkers.
void validate_patches(kernels::Report& report, const ShapeCertificate& certificate);

/// Of bodies that touch: differences b - a that leave no room for optimal directions other than
/// those of the cone. Each difference is taken from faces of the bodies: O((m + n) r) for r rays.
ConeProof prove_cone(std::span<const Point> a, std::span<const Point> b, const OptimalCone& cone);

/// Checks the cone by the rules of the format, in rationals.
[[nodiscard]] kernels::Report validate(const ConeProof& proof, std::span<const Point> a, std::span<const Point> b);

/// 2^k in decimal digits, for k from 0 to 63: nearly all denominators.
struct PowerOfTwo {
  char digits[20] = {};
  unsigned size = 0;
};

inline constexpr std::array<PowerOfTwo, 64> powers_of_two = [] {
  std::array<PowerOfTwo, 64> powers;
  for (unsigned k = 0; k < 64; ++k) {
    PowerOfTwo& power = powers[k];
    for (std::uint64_t n = std::uint64_t{1} << k; n > 0; n /= 10) ++power.size;
    std::uint64_t n = std::uint64_t{1} << k;
    for (unsigned i = power.size; i > 0; n /= 10) power.digits[--i] = static_cast<char>('0' + n % 10);
  }
  return powers;
}();

/// Writes words and lines to a text that grows, with one blank between two words of a line.
class Writer {
 public:
  explicit Writer(std::size_t likely_size) : text_(likely_size, '\0') {}

  Writer& word(std::string_view text) {
    char* const at = begin_word(text.size());
    return done(at + text.copy(at, text.size()));
  }
  Writer& word(std::size_t n) { return done(kernels::put_digits(begin_word(20), std::uint64_t{n})); }
  Writer& word(const mpz_class& n) {
    return done(kernels::put_digits(begin_word(kernels::most_digits(n.get_mpz_t())), n.get_mpz_t()));
  }
  Writer& word(const mpq_class& q) {
    const mpz_srcptr n = q.get_num_mpz_t(), d = q.get_den_mpz_t();
    char* const at = kernels::put_digits(begin_word(kernels::most_digits(n) + 1 + kernels::most_digits(d)), n);
    if (mpz_cmp_ui(d, 1) == 0) return done(at);
    *at = '/';
    return done(kernels::put_digits(at + 1, d));
  }
  Writer& word(double value) {
    const kernels::Dyadic n = kernels::dyadic(value);
    if (n.exponent > 0 || n.exponent < -63) return far(n);
    char* at = begin_word(48);
    if (n.mantissa < 0) *at++ = '-';
    at = kernels::put_digits(at, static_cast<std::uint64_t>(n.mantissa < 0 ? -n.mantissa : n.mantissa));
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
  // A number whose power of 2 is not in the table.
  Writer& far(const kernels::Dyadic& n) {
    const kernels::Dyadic above{n.mantissa, std::max(n.exponent, 0L)}, below{1, std::max(-n.exponent, 0L)};
    char* const at = kernels::put_digits(begin_word(most_digits(above) + 1 + most_digits(below)), above);
    if (below.exponent == 0) return done(at);
    *at = '/';
    return done(kernels::put_digits(at + 1, below));
  }
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

  std::string text_;
  std::size_t size_ = 0;
  bool line_start_ = true;
};

/// An id as one word. Blanks are escaped too: a line may not end with one, and ids are easier to
/// read out of a line without.
std::string escaped(std::string_view id);

template <class P>
void write_points(Writer& out, std::string_view name, std::span<const P> points) {
  out.word(name).word(points.size()).end();
  for (const P& p : points) out.words(p).end();
}

/// The points of a core that is a polytope. Throws std::invalid_argument if it is none, or a sum of
/// too many.
std::vector<Point> points_of(const Shape& shape);

/// Throws std::logic_error: an answer and its proof do not agree.
[[noreturn]] void contradiction(const char* what);

// The parts that several formats have.

/// The first lines: the format, and the id if there is one. The last line: all counts.
void write_header(Writer& out, std::size_t format, std::string_view id);
void write_end(Writer& out, std::span<const std::size_t> counts);

/// A solid, with `name` before its points. Adds its counts, and returns for each of its points the
/// number that it has in the text. Throws std::out_of_range for an index that names no point.
std::vector<std::uint32_t> write_solid(Writer& out, std::string_view name, const Solid& solid,
                                       std::vector<std::size_t>& counts);

/// The certificate of bodies of the plane, of that of the bodies that stand for them
/// (reference/answer/plane.hpp): `raised` if there are prisms among these.
std::string in_plane(std::string_view text, const mpq_class& height, bool raised);

/// The certificate of an answer about two unions, of which either may be a polytope, or a solid:
/// then it is about the mesh. Throws as certificate_text does.
std::string union_text(const Body& a, const Body& b, const UnionDepth& answer, std::string_view id, Monitor* monitor);

void write_inner(Writer& out, const InnerPolytope& inner);
void write_weights(Writer& out, std::string_view name, const std::vector<Weight>& weights);

}  // namespace fathom::certificate
