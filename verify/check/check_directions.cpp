// SPDX-License-Identifier: Apache-2.0
// Half-spaces that hold P, and how near their planes are to O.
#include "budget.hpp"
#include "checks.hpp"
#include "vectors.hpp"

namespace fathom_check {
namespace {

class Directions {
 public:
  Directions(const Certificate& certificate, const Scaled& bodies, const Bound& squared)
      : c_(&certificate), bodies_(&bodies), squared_(&squared) {}

  void check() {
    const Part<std::vector<Vector>>& part = c_->directions;
    for (std::size_t k = 0; k < part.items.size(); ++k) check_direction(part.items[k], part.lines[k]);
    if (c_->all) check_order(part);
  }

 private:
  void check_direction(const Vector& n, std::size_t line) {
    if (is_zero(n)) throw refused(line, "a direction that is zero proves nothing");
    find_support(n);
    if (c_->claim == Claim::touching) {
      if (h_ != 0) throw refused(line, "O does not lie on the plane of this direction");
    } else if (c_->claim == Claim::disjoint) {
      if (h_ >= 0) throw refused(line, "this direction does not separate the bodies");
    } else {
      check_distance(n, line);
    }
  }

  /// h(n) = max <n,b> - min <n,a>.
  void find_support(const Vector& n) {
    dot(h_, n, bodies_->b.front());
    for (const Vector& b : bodies_->b) {
      dot(height_, n, b);
      if (height_ > h_) swap(height_, h_);
    }
    dot(min_a_, n, bodies_->a.front());
    for (const Vector& a : bodies_->a) {
      dot(height_, n, a);
      if (height_ < min_a_) swap(height_, min_a_);
    }
    h_ -= min_a_;
  }

  /// Whether h^2 compares with squared * <n,n> as the claim demands.
  void check_distance(const Vector& n, std::size_t line) const {
    if (h_ <= 0) throw refused(line, "O does not lie below the plane of this direction");
    mpz_class allowed;
    dot(allowed, n, n);
    allowed *= squared_->num;
    const mpz_class reached = h_ * h_ * squared_->den;
    if (reached > allowed) throw refused(line, "the boundary of P is farther in this direction than claimed");
    if (c_->claim == Claim::depth && reached < allowed) throw refused(line, "the boundary of P is nearer in this direction than claimed");
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
  const Bound* squared_;
  mpz_class h_, height_, min_a_;
};

}  // namespace

void check_directions(const Certificate& certificate, const Scaled& bodies, const Bound& squared) {
  Directions(certificate, bodies, squared).check();
}

}  // namespace fathom_check
