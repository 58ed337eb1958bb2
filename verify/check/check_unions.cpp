// SPDX-License-Identifier: Apache-2.0
// Which checks belong to which claim about unions; separations, of which all of them have some.
#include <algorithm>

#include "budget.hpp"
#include "unions.hpp"

namespace fathom_check {
namespace {

void check_pieces(const Body& body, const ScaledBody& scaled) {
  for (std::size_t k = 0; k < body.pieces.size(); ++k)
    if (const Points points = piece(body, scaled, k); !has_interior(points.begin(), points.end()))
      throw refused(body.pieces[k].line, "the points of this piece lie in one plane");
}

class Separations {
 public:
  Separations(const Certificate& certificate, const Scaled& bodies, const Bound& low)
      : c_(&certificate), bodies_(&bodies), separation_(certificate, low) {}

  /// The list of this number, for the place t / den.
  void check(std::size_t list, const MutableVector& t, const mpz_class& den) {
    const UnionParts& parts = c_->of_unions;
    const std::size_t first = begin_of(parts.separation_lists, list), count = parts.separation_lists[list].end - first;
    const std::size_t m = c_->a.pieces.size(), n = c_->b.pieces.size();
    if (count != m * n)
      throw refused(parts.separation_lists[list].line, "there is not one separation for each pair of pieces");
    for (std::size_t k = 0; k < count; ++k) {
      const Vector& u = parts.separations.items[first + k];
      find_height(u, k / n, k % n);
      separation_.check(u, height_, 1, t, den, parts.separations.lines[first + k]);
    }
  }

 private:
  /// h_ij(u), in units of 1 / scale.
  void find_height(const Vector& u, std::size_t i, std::size_t j) {
    find_largest(height_, scratch_, u, piece(c_->b, bodies_->b, j));
    find_largest(of_a_, scratch_, negated(u), piece(c_->a, bodies_->a, i));
    height_ += of_a_;
  }

  const Certificate* c_;
  const Scaled* bodies_;
  Separation separation_;
  mpz_class height_, of_a_, scratch_;
};

bool below(const Rational& r, const Rational& s) {
  return r.num.value() * s.den.value() < s.num.value() * r.den.value();
}

bool below(const RationalPoint& p, const RationalPoint& q) {
  if (!same(p.x, q.x)) return below(p.x, q.x);
  if (!same(p.y, q.y)) return below(p.y, q.y);
  return below(p.z, q.z);
}

}  // namespace

Points piece(const Body& body, const ScaledBody& scaled, std::size_t number) {
  return {scaled.points, scaled.words, begin_of(body.pieces, number), body.pieces[number].end};
}

void Separation::check(const Vector& u, const mpz_class& num, const mpz_class& den, const MutableVector& t,
                       const mpz_class& den_t, std::size_t line) {
  if (is_zero(u)) throw refused(line, "a direction that is zero proves nothing");
  const bool gap = c_->claim == Claim::apart;
  if (gap) {
    dot(reached_, u, u);
    reached_ *= low_->num;  // which is negative
    reached_ *= den * den;
    needed_ = num * num;
    needed_ *= low_->den;
  } else {
    dot(reached_, u, t);
    reached_ *= c_->scale * den;
    needed_ = num * den_t;
  }
  if (gap ? num >= 0 : reached_ < needed_) throw refused(line, "this direction does not separate the two pieces");
  if (gap && needed_ < -reached_) throw refused(line, "the two pieces may be nearer to each other than claimed");
}

void check_optima(const Certificate& c, const CheckApart& check_apart) {
  const Part<std::vector<RationalPoint>>& optima = c.of_unions.optima;
  if (optima.items.empty()) throw refused(optima.line, "there is no optimum");
  mpz_class reached;
  for (std::size_t k = 0; k < optima.items.size(); ++k) {
    const RationalPoint& p = optima.items[k];
    if (k > 0 && !below(optima.items[k - 1], p))
      throw refused(optima.lines[k], "an optimum must be above the one before it");
    const auto [t, den] = homogeneous(p);
    dot(reached, t, t);
    if (reached * c.low.den.value() != c.low.num.value() * den * den)
      throw refused(optima.lines[k], "the length of this translation is not the depth");
    check_apart(k, t, den);
  }
}

void check_unions(const Certificate& c, const Scaled& bodies, const Bound& low) {
  check_pieces(c.a, bodies.a);
  check_pieces(c.b, bodies.b);
  const UnionParts& parts = c.of_unions;
  if (c.claim == Claim::depth) {
    Separations separations(c, bodies, low);
    check_optima(c, [&separations](std::size_t optimum, const MutableVector& t, const mpz_class& den) {
      separations.check(optimum, t, den);
    });
    Arena integers;
    check_tree(c, check_polytopes(c, bodies, integers), low);
    return;
  }
  Separations(c, bodies, low).check(0, {}, 1);
  if (parts.nearest_a >= c.a.pieces.size()) throw refused(parts.nearest_line, "a has no piece of this number");
  if (parts.nearest_b >= c.b.pieces.size()) throw refused(parts.nearest_line, "b has no piece of this number");
  check_weights(c, piece(c.a, bodies.a, parts.nearest_a), piece(c.b, bodies.b, parts.nearest_b), low);
}

}  // namespace fathom_check
