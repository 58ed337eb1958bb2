// SPDX-License-Identifier: Apache-2.0
// Half-spaces that hold P, and how near their planes are to O.
#include "checks.hpp"
#include "limits.hpp"
#include "vectors.hpp"

namespace fathom_check {
namespace {

class Directions {
 public:
  Directions(const Certificate& certificate, const Scaled& bodies, const Bound& low, const Bound& high)
      : c_(&certificate), bodies_(&bodies), low_(&low), high_(&high) {}

  void check() {
    const Part<std::vector<Vector>>& part = c_->directions;
    for (std::size_t k = 0; k < part.items.size(); ++k) check_direction(part.items[k], part.lines[k]);
    if (c_->all) check_order(part);
  }

 private:
  using Core = Body::Core;

  void check_direction(const Vector& n, std::size_t line) {
    if (is_zero(n)) throw refused(line, "a direction that is zero proves nothing");
    toward_b_ = copied(n);
    power_ = bodies_->units.take(toward_b_);
    toward_a_ = negated(toward_b_);
    h_ = height(c_->a, bodies_->a, toward_a_, line) + height(c_->b, bodies_->b, toward_b_, line);
    check_upper(n, line);
    if (!has_half_space(*c_) || c_->claim == Claim::disjoint) return;
    const bool a = c_->a.core == Core::half_space;
    h_ = a ? height(c_->a, bodies_->a, toward_a_, line) + support(bodies_->b, toward_b_)
           : height(c_->b, bodies_->b, toward_b_, line) + support(bodies_->a, toward_a_);
    if (compare_with(*low_, n) < 0)
      throw refused(line, "the boundary of P may be nearer in this direction than claimed");
  }

  void check_upper(const Vector& n, std::size_t line) {
    const Claim claim = c_->claim;
    if (claim == Claim::touching && h_ != 0) throw refused(line, "O does not lie on the plane of this direction");
    if ((claim == Claim::disjoint || claim == Claim::apart) && h_ >= 0)
      throw refused(line, "this direction does not separate the bodies");
    if ((claim == Claim::depth || claim == Claim::bounds) && h_ <= 0)
      throw refused(line, "O does not lie below the plane of this direction");
    if (claim == Claim::touching || claim == Claim::disjoint) return;
    const int reached = compare_with(*high_, n);
    if (reached > 0) throw refused(line, "the boundary of P is farther in this direction than claimed");
    if ((claim == Claim::depth || claim == Claim::apart) && reached < 0)
      throw refused(line, "the boundary of P is nearer in this direction than claimed");
  }

  /// How h, squared with its sign, compares with the bound times <n,n>.
  int compare_with(const Bound& bound, const Vector& n) {
    mpz_class reached = h_.get_num() * h_.get_num() * bound.den;
    if (h_ < 0) reached = -reached;
    dot(product_, n, n);
    product_ *= bound.num;
    product_ *= h_.get_den();
    product_ *= h_.get_den();
    if (power_ > 0) reached <<= static_cast<mp_bitcnt_t>(2 * power_);
    if (power_ < 0) product_ <<= static_cast<mp_bitcnt_t>(-2 * power_);
    return cmp(reached, product_);
  }

  /// H_X(s) of the page.
  mpq_class height(const Body& body, const ScaledBody& scaled, const MutableVector& s, std::size_t line) {
    if (body.core == Core::shape) return height_of_shape(body, scaled, s);
    if (body.core == Core::points) return support(scaled, s);
    MutableVector across;
    cross(across, s, scaled.normal);
    dot(product_, s, scaled.normal);
    if (!is_zero(across) || product_ <= 0) throw refused(line, "this direction is not that of the half-space");
    mpz_class squared;
    dot(squared, scaled.normal, scaled.normal);
    mpq_class multiple(product_, squared);
    multiple.canonicalize();
    return scaled.offset * multiple;
  }

  /// The largest product with a core point.
  mpq_class support(const ScaledBody& scaled, const MutableVector& s) {
    find_largest(product_, scratch_, s, scaled.all_points());
    return product_;
  }

  mpq_class height_of_shape(const Body& body, const ScaledBody& scaled, const MutableVector& s) {
    const Part<std::vector<Rational>>& part = body.heights;
    if (part.items.size() != scaled.terms.size()) throw refused(part.line, "there is not one height for each term");
    mpz_class sum = 0, common = 1;
    for (std::size_t t = 0; t < part.items.size(); ++t) {
      for (const std::vector<Vector>& atom : scaled.terms[t])
        if (!is_above(part.items[t], atom, s)) throw refused(part.lines[t], "this height is too small");
      mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), part.items[t].den.get_mpz_t());
    }
    for (const Rational& t : part.items) {
      mpz_divexact(product_.get_mpz_t(), common.get_mpz_t(), t.den.get_mpz_t());
      mpz_addmul(sum.get_mpz_t(), product_.get_mpz_t(), t.num.get_mpz_t());
    }
    mpq_class result(sum * c_->scale, common);
    result.canonicalize();
    return result;
  }

  /// Whether no point x of the atom has <s,x> > t: t - <s,center> >= 0, and its square is not less
  /// than the sum of all <s,axis>^2.
  bool is_above(const Rational& t, const std::vector<Vector>& atom, const MutableVector& s) {
    dot(product_, s, atom.front());
    mpz_class gap = t.num.value() * c_->scale;  // times the height's denominator, as is all here
    mpz_submul(gap.get_mpz_t(), product_.get_mpz_t(), t.den.get_mpz_t());
    if (gap < 0) return false;
    mpz_class squared = 0;
    for (std::size_t axis = 1; axis < atom.size(); ++axis) {
      dot(product_, s, atom[axis]);
      squared += product_ * product_;
    }
    mpz_mul(squared.get_mpz_t(), squared.get_mpz_t(), t.den.get_mpz_t());
    mpz_mul(squared.get_mpz_t(), squared.get_mpz_t(), t.den.get_mpz_t());
    return gap * gap >= squared;
  }

  static void check_order(const Part<std::vector<Vector>>& part) {
    mpz_class common;
    for (std::size_t k = 0; k < part.items.size(); ++k) {
      find_gcd(common, part.items[k]);
      if (common != 1) throw refused(part.lines[k], "of all directions, each must be primitive");
      if (k > 0 && !ascending(part.items[k - 1], part.items[k]))
        throw refused(part.lines[k], "of all directions, each must be above the one before it");
    }
  }

  const Certificate* c_;
  const Scaled* bodies_;
  const Bound *low_, *high_;
  MutableVector toward_a_, toward_b_;  ///< -n and n, in the units of the points
  mpq_class h_;                        ///< times 2^power_
  long power_ = 0;
  mpz_class product_, scratch_;
};

}  // namespace

void check_directions(const Certificate& certificate, const Scaled& bodies, const Bound& low, const Bound& high) {
  Directions(certificate, bodies, low, high).check();
}

}  // namespace fathom_check
