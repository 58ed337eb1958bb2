// SPDX-License-Identifier: Apache-2.0
// Bodies in motion: apart on each piece of time, near to each other at the end of others, and at
// last in contact.                                                       [FORMAT.md, section 17]
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "checks.hpp"
#include "vectors.hpp"

namespace fathom_check {

namespace {

using Piece = MotionParts::Piece;
using PieceKind = MotionParts::Piece::Kind;

/// A homogeneous polynomial of v and u: the coefficients of v^(n-k) u^k.
struct Polynomial {
  std::vector<mpz_class> coefficients;
};

Polynomial operator+(Polynomial p, const Polynomial& q) {
  for (std::size_t k = 0; k < p.coefficients.size(); ++k) p.coefficients[k] += q.coefficients[k];
  return p;
}
Polynomial operator-(Polynomial p) {
  for (mpz_class& x : p.coefficients) x = -x;
  return p;
}
Polynomial operator-(const Polynomial& p, const Polynomial& q) { return p + -q; }
Polynomial operator*(const Polynomial& p, const Polynomial& q) {
  Polynomial result{std::vector<mpz_class>(p.coefficients.size() + q.coefficients.size() - 1)};
  for (std::size_t i = 0; i < p.coefficients.size(); ++i)
    for (std::size_t j = 0; j < q.coefficients.size(); ++j)
      result.coefficients[i + j] += p.coefficients[i] * q.coefficients[j];
  return result;
}

/// Of polynomials, or of rational numbers.
template <class T>
struct Triple {
  T x, y, z;
};
template <class T>
struct Turn {
  T r;
  Triple<T> v;
};

template <class T>
Triple<T> operator+(const Triple<T>& u, const Triple<T>& v) {
  return {u.x + v.x, u.y + v.y, u.z + v.z};
}
template <class T>
Triple<T> operator-(const Triple<T>& u, const Triple<T>& v) {
  return {u.x - v.x, u.y - v.y, u.z - v.z};
}
template <class T>
Triple<T> operator*(const T& k, const Triple<T>& v) {
  return {k * v.x, k * v.y, k * v.z};
}
template <class T>
T dot(const Triple<T>& u, const Triple<T>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}
template <class T>
Triple<T> cross(const Triple<T>& u, const Triple<T>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
template <class T>
T length2(const Turn<T>& q) {
  return q.r * q.r + dot(q.v, q.v);
}
/// x turned by q, times the squared length of q.
template <class T>
Triple<T> turned(const Turn<T>& q, const Triple<T>& x) {
  const Triple<T> half = dot(q.v, x) * q.v + q.r * cross(q.v, x);
  return T(q.r * q.r - dot(q.v, q.v)) * x + half + half;
}
template <class T>
Turn<T> back(const Turn<T>& q) {
  return {q.r, {-q.v.x, -q.v.y, -q.v.z}};
}

/// Where D + <u,a> - <v,b> is positive for all a and b the bodies are apart.
struct Conditions {
  Polynomial distance;
  Triple<Polynomial> u, v;
};

Triple<Polynomial> constant(const Vector& n) { return {{{n.x.value()}}, {{n.y.value()}}, {{n.z.value()}}}; }

Conditions conditions(const Piece& piece, const Turn<Polynomial>& a, const Turn<Polynomial>& b,
                      const Triple<Polynomial>& d) {
  const Triple<Polynomial> n = constant(piece.n), g = constant(piece.g);
  if (piece.kind == PieceKind::of_b) {
    const Triple<Polynomial> h = turned(b, n);
    return {length2(a) * dot(h, d), turned(back(a), h), Polynomial(length2(a) * length2(b)) * n};
  }
  const Triple<Polynomial> h = turned(a, n);
  if (piece.kind == PieceKind::of_a)
    return {length2(b) * dot(h, d), Polynomial(length2(a) * length2(b)) * n, turned(back(b), h)};
  const Triple<Polynomial> k = turned(b, g);
  return {dot(cross(h, k), d), cross(n, turned(back(a), k)), cross(turned(back(b), h), g)};
}

class Motions {
 public:
  Motions(const Certificate& c, const Scaled& bodies) : c_(&c), points_{bodies.a.all_points(), bodies.b.all_points()} {}

  void check() {
    const MotionParts& parts = c_->of_motions;
    mpq_class begin = 0;
    bool before = true;  // whether `near` may not stand here
    bool any = false;
    for (const Piece& piece : parts.pieces) {
      const mpq_class end = value(piece.end);
      if (end < begin) throw refused(piece.line, "this piece ends before it begins");
      if (end > 1) throw refused(piece.line, "this piece ends after the time 1");
      const bool near = piece.kind == PieceKind::near;
      if (near && before) throw refused(piece.line, "'near' stands first or behind another 'near'");
      if (near) require_near(end, value(piece.delta), piece.weights[0], piece.weights[1], piece.line);
      else require_apart(piece, begin, end);
      begin = end;
      before = near;
      any = any || near;
    }
    if (!parts.pieces.empty() && before) throw refused(parts.line, "'near' stands last");
    check_claim(begin, any);
  }

 private:
  void check_claim(const mpq_class& end, bool near) const {
    const bool pieces = !c_->of_motions.pieces.empty();
    if (c_->claim != Claim::contact) {
      if (!pieces || end != 1) throw refused(c_->of_motions.line, "the pieces do not end at the time 1");
      if (near != (c_->claim == Claim::grazing))
        throw refused(c_->claim_line, "'near' goes with a claim of grazing, which has one, or of contact");
      return;
    }
    const mpq_class t = value(c_->low);
    if (pieces ? t <= end : t != 0) throw refused(c_->claim_line, "the contact is not behind the pieces");
    if (t > 1) throw refused(c_->claim_line, "the contact is after the time 1");
    require_near(t, 0, c_->weights_a, c_->weights_b, c_->claim_line);
  }

  /// The number that goes from x to y as the time goes from 0 to 1, on the piece, times the
  /// denominators of its ends.
  static Polynomial on(const mpq_class& begin, const mpq_class& end, const mpz_class& x, const mpz_class& y) {
    const auto at = [&](const mpq_class& t) -> mpz_class { return (t.get_den() - t.get_num()) * x + t.get_num() * y; };
    return {{end.get_den() * at(begin), begin.get_den() * at(end)}};
  }
  [[nodiscard]] static mpz_class over(const mpz_class& unit, const Rational& q) {
    return q.num.value() * (unit / q.den.value());
  }
  [[nodiscard]] static Triple<mpz_class> over(const mpz_class& unit, const RationalPoint& p) {
    return {over(unit, p.x), over(unit, p.y), over(unit, p.z)};
  }
  static Triple<Polynomial> on(const mpq_class& begin, const mpq_class& end, const mpz_class& unit,
                               const RationalPoint& from, const RationalPoint& to) {
    const Triple<mpz_class> x = over(unit, from), y = over(unit, to);
    return {on(begin, end, x.x, y.x), on(begin, end, x.y, y.y), on(begin, end, x.z, y.z)};
  }

  void require_apart(const Piece& piece, const mpq_class& begin, const mpq_class& end) {
    std::array<Turn<Polynomial>, 2> turns;
    std::array<Triple<Polynomial>, 2> places;
    const mpz_class& unit = c_->of_motions.turning;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& [turn, place] = c_->of_motions.motions[k];
      turns[k] = {on(begin, end, over(unit, turn[0].r), over(unit, turn[1].r)),
                  on(begin, end, unit, turn[0].v, turn[1].v)};
      places[k] = on(begin, end, c_->scale, place[0], place[1]);
    }
    Conditions of = conditions(piece, turns[0], turns[1], places[0] - places[1]);
    const Polynomial one{{1, 1}};  // v + u: raises to degree 5
    of.u = one * of.u;
    of.v = one * of.v;
    const mpz_class units = begin.get_den() * end.get_den();
    mpz_class least, most, height;
    for (std::size_t k = 0; k < of.distance.coefficients.size(); ++k) {
      const auto at = [k](const Triple<Polynomial>& vector) -> MutableVector {
        return {vector.x.coefficients[k], vector.y.coefficients[k], vector.z.coefficients[k]};
      };
      find_largest(least, scratch_, negated(at(of.u)), points_[0]);
      find_largest(most, scratch_, at(of.v), points_[1]);
      height = of.distance.coefficients[k] - units * (least + most);
      if (height <= 0) throw refused(piece.line, "this direction does not show that the bodies are apart on the piece");
    }
  }

  /// At the time t the weights yield points at most delta from each other.
  void require_near(const mpq_class& t, const mpq_class& delta, const Part<std::vector<Weight>>& weights_a,
                    const Part<std::vector<Weight>>& weights_b, std::size_t line) const {
    if (delta < 0) throw refused(line, "a distance is not negative: this one is");
    const Triple<mpq_class> z = place(0, t, weights_a, line) - place(1, t, weights_b, line);
    const mpq_class most = delta * c_->scale;
    if (dot(z, z) > most * most) throw refused(weights_b.line, "the weights yield points that are too far apart");
  }
  /// In the units of the points.
  [[nodiscard]] Triple<mpq_class> place(std::size_t body, const mpq_class& t, const Part<std::vector<Weight>>& weights,
                                        std::size_t line) const {
    const auto at = [&t](const Rational& x, const Rational& y) -> mpq_class {
      return (1 - t) * value(x) + t * value(y);
    };
    const auto vector_at = [&at](const RationalPoint& x, const RationalPoint& y) -> Triple<mpq_class> {
      return {at(x.x, y.x), at(x.y, y.y), at(x.z, y.z)};
    };
    const auto& [turns, places] = c_->of_motions.motions[body];
    const Turn<mpq_class> q{at(turns[0].r, turns[1].r), vector_at(turns[0].v, turns[1].v)};
    const mpq_class length = length2(q);
    if (length == 0) throw refused(line, "a quaternion is zero at this time");
    const Combination sum = convex_combination(weights.items.data(), weights.items.data() + weights.items.size(),
                                               points_[body], weights.line);
    const auto share = [&sum, &length](const mpz_class& x) -> mpq_class { return mpq_class(x) / (sum.den * length); };
    const Triple<mpq_class> corner{share(sum.sum.x), share(sum.sum.y), share(sum.sum.z)};
    return mpq_class(c_->scale) * vector_at(places[0], places[1]) + turned(q, corner);
  }

  const Certificate* c_;
  std::array<Points, 2> points_;
  mpz_class scratch_;
};

}  // namespace

void check_motions(const Certificate& certificate, Arithmetic arithmetic) {
  const Scaled bodies = scaled(certificate, arithmetic);
  Motions(certificate, bodies).check();
}

}  // namespace fathom_check
