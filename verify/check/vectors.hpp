// SPDX-License-Identifier: Apache-2.0
// Integer vectors. All of the checks are made of these. Each function writes its result over the
// one that it is given, whose memory is used again: so the loops of the checks allocate nothing.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "certificate.hpp"
#include "fixed.hpp"

namespace fathom_check {

/// A vector that is computed, and then compared or kept.
struct MutableVector {
  mpz_class x, y, z;
};

template <class U, class V>
void dot(mpz_class& result, const U& u, const V& v) {
  mpz_mul(result.get_mpz_t(), u.x.get_mpz_t(), v.x.get_mpz_t());
  mpz_addmul(result.get_mpz_t(), u.y.get_mpz_t(), v.y.get_mpz_t());
  mpz_addmul(result.get_mpz_t(), u.z.get_mpz_t(), v.z.get_mpz_t());
}

inline bool operator<(const mpz_class& n, const Integer& of_arena) {
  return mpz_cmp(n.get_mpz_t(), of_arena.get_mpz_t()) < 0;
}

/// Neither operand may be the result.
template <class U, class V>
void cross(MutableVector& result, const U& u, const V& v) {
  const auto minor = [](mpz_class& r, const auto& a, const auto& b, const auto& c, const auto& d) {
    mpz_mul(r.get_mpz_t(), a.get_mpz_t(), d.get_mpz_t());
    mpz_submul(r.get_mpz_t(), b.get_mpz_t(), c.get_mpz_t());
  };
  minor(result.x, u.y, u.z, v.y, v.z);
  minor(result.y, u.z, u.x, v.z, v.x);
  minor(result.z, u.x, u.y, v.x, v.y);
}

inline void subtract(MutableVector& result, const Vector& u, const Vector& v) {
  mpz_sub(result.x.get_mpz_t(), u.x.get_mpz_t(), v.x.get_mpz_t());
  mpz_sub(result.y.get_mpz_t(), u.y.get_mpz_t(), v.y.get_mpz_t());
  mpz_sub(result.z.get_mpz_t(), u.z.get_mpz_t(), v.z.get_mpz_t());
}

inline void add(MutableVector& sum, const MutableVector& v) {
  sum.x += v.x;
  sum.y += v.y;
  sum.z += v.z;
}

/// Some points that lie one behind another.
class Points {
 public:
  /// Those from `first` to `last`. `words` are the same points, or there are none.
  Points(const std::vector<Vector>& all, const std::vector<Words>& words, std::size_t first, std::size_t last)
      : begin_(all.data() + first), end_(all.data() + last), words_(words.empty() ? nullptr : words.data() + first) {}
  [[nodiscard]] const Vector* begin() const { return begin_; }
  [[nodiscard]] const Vector* end() const { return end_; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
  [[nodiscard]] const Vector& operator[](std::size_t k) const { return begin_[k]; }
  /// The same points, below 2^62 in size; null if one of their coordinates is larger.
  [[nodiscard]] const Words* words() const { return words_; }

 private:
  const Vector *begin_, *end_;
  const Words* words_;
};

constexpr std::size_t most_bits_of_words = 62;  ///< in `words` of points, so that a difference is a word too

/// find_largest in integers of a fixed size. Each |<s,p>| is below 3 * 2^62 * 2^63 < 2^127 for an s
/// of words, which have at most 63 bits, and below 3 * 2^62 * 2^127 < 2^255 for one of 127 bits.
template <class Number, class Entry>
void find_largest_fixed(mpz_class& largest, const FixedVector<Entry>& s, const Points& points) {
  Number most, height;
  dot(most, s, points.words()[0]);
  for (std::size_t k = 1; k < points.size(); ++k) {
    dot(height, s, points.words()[k]);
    if (most < height) most = height;
  }
  copy(largest, most);
}

/// The largest <s,p> of these points, of which there is at least one.
template <class S>
void find_largest(mpz_class& largest, mpz_class& scratch, const S& s, const Points& points) {
  const mpz_srcptr x = s.x.get_mpz_t(), y = s.y.get_mpz_t(), z = s.z.get_mpz_t();
  const std::size_t size = points.words() == nullptr ? SIZE_MAX : std::max({bits(x), bits(y), bits(z)});
  if (size <= 63) return find_largest_fixed<Int128>(largest, Words{to_word(x), to_word(y), to_word(z)}, points);
  if (size <= 127)
    return find_largest_fixed<Int256>(largest, FixedVector<Int128>{to_int128(x), to_int128(y), to_int128(z)}, points);
  dot(largest, s, points[0]);
  for (const Vector& p : points) {
    dot(scratch, s, p);
    if (scratch > largest) swap(scratch, largest);
  }
}

inline MutableVector copied(const Vector& v) { return {v.x.value(), v.y.value(), v.z.value()}; }
inline MutableVector negated(const Vector& v) { return {-v.x.value(), -v.y.value(), -v.z.value()}; }
inline MutableVector negated(const MutableVector& v) { return {-v.x, -v.y, -v.z}; }

inline Vector kept(Arena& arena, const MutableVector& v) { return {arena.keep(v.x), arena.keep(v.y), arena.keep(v.z)}; }

/// Finds the greatest common divisor of the three entries.
template <class V>
void find_gcd(mpz_class& result, const V& v) {
  mpz_gcd(result.get_mpz_t(), v.x.get_mpz_t(), v.y.get_mpz_t());
  mpz_gcd(result.get_mpz_t(), result.get_mpz_t(), v.z.get_mpz_t());
}

/// Divides by a common divisor of all three entries.
inline void divide(MutableVector& v, const mpz_class& divisor) {
  for (mpz_class* const entry : {&v.x, &v.y, &v.z})
    mpz_divexact(entry->get_mpz_t(), entry->get_mpz_t(), divisor.get_mpz_t());
}

/// In lexicographic order, strictly.
template <class U, class V>
bool ascending(const U& u, const V& v) {
  if (const int x = mpz_cmp(u.x.get_mpz_t(), v.x.get_mpz_t())) return x < 0;
  if (const int y = mpz_cmp(u.y.get_mpz_t(), v.y.get_mpz_t())) return y < 0;
  return mpz_cmp(u.z.get_mpz_t(), v.z.get_mpz_t()) < 0;
}

inline bool is_zero(const Vector& v) { return v.x.sign() == 0 && v.y.sign() == 0 && v.z.sign() == 0; }
inline bool is_zero(const MutableVector& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

inline std::size_t bits(const mpz_class& n) { return bits(n.get_mpz_t()); }
inline std::size_t bits(const Integer& n) { return bits(n.get_mpz_t()); }

}  // namespace fathom_check
