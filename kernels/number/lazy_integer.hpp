// SPDX-License-Identifier: GPL-3.0-or-later
// Integers of any size that are computed when they are needed: of each an enclosure is known, and
// what it is made of. Signs that the enclosure leaves open are those of the integer itself, so
// answers are those of mpz_class, its naive twin.            [proofs/number.md, "Lazy integers"]
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <utility>

#include "kernels/number/wide_float.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

/// A handle of an immutable integer. Not to be shared between threads. Where enclosures would lose
/// digits, in differences of numbers that are nearly equal, the exact ones are subtracted: that is
/// cheap; what is put off are products.
class LazyInteger {
 public:
  /// No number: to be assigned to.
  LazyInteger() = default;
  explicit LazyInteger(long value) : LazyInteger(mpz_class(value)) {}
  explicit LazyInteger(mpz_class value);
  LazyInteger(const LazyInteger& other) : node_(other.node_) { keep(node_); }
  LazyInteger(LazyInteger&& other) noexcept : node_(std::exchange(other.node_, nullptr)) {}
  LazyInteger& operator=(LazyInteger other) noexcept {
    std::swap(node_, other.node_);
    return *this;
  }
  ~LazyInteger() { drop(node_); }

  /// The integer itself, computed by now and kept.
  [[nodiscard]] const mpz_class& exact() const { return value_of(*node_); }
  /// Whether it has been computed.
  [[nodiscard]] bool known() const;
  [[nodiscard]] const WideEnclosure& enclosure() const;
  /// How many integers this thread has computed because their enclosures did not suffice.
  static std::uint64_t computed() { return computed_; }

  friend int sgn(const LazyInteger& a);
  friend int cmp(const LazyInteger& a, const LazyInteger& b);
  friend bool operator==(const LazyInteger& a, const LazyInteger& b) { return cmp(a, b) == 0; }
  friend LazyInteger operator-(const LazyInteger& a);
  friend LazyInteger operator+(const LazyInteger& a, const LazyInteger& b);
  friend LazyInteger operator-(const LazyInteger& a, const LazyInteger& b);
  friend LazyInteger operator*(const LazyInteger& a, const LazyInteger& b);
  friend LazyInteger dot(const Vec3<LazyInteger>& u, const Vec3<LazyInteger>& v);
  friend Vec3<LazyInteger> cross(const Vec3<LazyInteger>& u, const Vec3<LazyInteger>& v);
  /// The plane <n,x> = <n,p> with n = (q - p) x (r - p).
  friend std::pair<Vec3<LazyInteger>, LazyInteger> plane_through(const Vec3<LazyInteger>& p, const Vec3<LazyInteger>& q,
                                                                 const Vec3<LazyInteger>& r);
  friend Vec3<WideEnclosure> enclosure_of_difference(const Vec3<LazyInteger>& v, const Vec3<LazyInteger>& w);

 private:
  struct Node;
  explicit LazyInteger(Node* node) : node_(node) {}
  static Node* keep(Node* node);
  static void drop(Node* node);
  static const mpz_class& value_of(Node& node);
  static WideEnclosure difference(const LazyInteger& a, const LazyInteger& b);
  static LazyInteger minor(const std::array<const Vec3<LazyInteger>*, 3>& points,
                           const std::array<Vec3<WideEnclosure>, 3>& edges, int i, int j);

  static thread_local std::uint64_t computed_;
  Node* node_ = nullptr;
};

inline const mpz_class& to_mpz(const LazyInteger& n) { return n.exact(); }

/// The enclosures of a vector's components; of the difference of two, with few digits lost.
Vec3<WideEnclosure> enclosure(const Vec3<LazyInteger>& v);
Vec3<WideEnclosure> enclosure_of_difference(const Vec3<LazyInteger>& v, const Vec3<LazyInteger>& w);
bool is_zero(const Vec3<LazyInteger>& v);
/// The sign of <u, v - w>.
int order_along(const Vec3<LazyInteger>& u, const Vec3<LazyInteger>& v, const Vec3<LazyInteger>& w);

// As those of mpz_class.

double image(const LazyInteger& c, long exponent);
inline Vec3<double> image(const Vec3<LazyInteger>& v, long exponent) {
  return {image(v.x, exponent), image(v.y, exponent), image(v.z, exponent)};
}
long bit_length(const Vec3<LazyInteger>& v);
double root_from_above(const LazyInteger& numerator, const LazyInteger& denominator, long exponent);

}  // namespace fathom::kernels
