// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/predicates/perturbation.hpp"

#include <algorithm>

namespace fathom::kernels {
namespace {

constexpr unsigned tilt_a = 9, tilt_b = 10, tilt_c = 11;

using Matrix = std::array<Vec3<Infinitesimal>, 3>;  // rows

// Products with 0 are left out: many components are.
Infinitesimal scaled(const Infinitesimal& s, const mpz_class& by) {
  return by == 0 ? Infinitesimal() : s * Infinitesimal(by);
}

Vec3<Infinitesimal> times(const Matrix& m, const Vector& d) {
  const auto row = [&](const Vec3<Infinitesimal>& r) { return scaled(r.x, d.x) + scaled(r.y, d.y) + scaled(r.z, d.z); };
  return {row(m[0]), row(m[1]), row(m[2])};
}

}  // namespace

bool Perturbation::concerns(Role role, unsigned level) const {
  const auto which = static_cast<unsigned>(std::ranges::find(rank, level) - rank.begin());
  if (which == infinitesimals) return false;
  switch (role) {
    case Role::fixed: return false;
    case Role::node_of_a:
    case Role::circle_of_a: return which < tilt_a;
    case Role::vertical: return which == tilt_a || which == tilt_b;
    case Role::pole: return which > tilt_a || (which == tilt_a && rank[tilt_c] < level);  // a enters as ac
  }
  return false;
}

Vector Perturbation::tilt_of_vertical(unsigned level) const {
  return rank[tilt_a] == level ? Vector{sign[tilt_a], 0, 0} : Vector{0, 0, sign[tilt_b]};
}

Vec3<Infinitesimal> Perturbation::moved(const Vector& d, Role role, unsigned level) const {
  const auto e = [&](unsigned i) {
    return rank[i] <= level ? Infinitesimal(Monomial(rank[i]), sign[i]) : Infinitesimal();
  };
  switch (role) {
    case Role::fixed: break;
    case Role::node_of_a:
    case Role::circle_of_a: {
      Matrix m{{{e(0), e(1), e(2)}, {e(3), e(4), e(5)}, {e(6), e(7), e(8)}}};
      m[0].x += 1;
      m[1].y += 1;
      m[2].z += 1;
      if (role == Role::node_of_a) return times(m, d);
      // The rows of the cofactor matrix are the cross products of the other two rows.
      return times({cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])}, d);
    }
    case Role::vertical: return {e(tilt_a), 1, e(tilt_b)};
    case Role::pole: {
      const Infinitesimal upward(d.z);  // 1, or -1 for the lower hemisphere
      return {upward * e(tilt_c), upward * (-(e(tilt_a) * e(tilt_c)) - e(tilt_b)), upward};
    }
  }
  return {d.x, d.y, d.z};
}

}  // namespace fathom::kernels
