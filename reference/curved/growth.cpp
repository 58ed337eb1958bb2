// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/curved/growth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernels/number/rational.hpp"
#include "kernels/predicates/direction.hpp"

namespace fathom::curved {
Estimates::Estimates(const Lattice& lattice, const Goal& goal)
    : exponent_(lattice.exponent), fine_(lattice.fine), share_(goal.share().get_d()) {
  const auto scaled = [&](const mpq_class& length) { return shifted(length / lattice.fine_unit, -exponent_).get_d(); };
  extent_ = scaled(goal.extent());
  rho_ = scaled(goal.rho());
}

double Estimates::root(const mpz_class& numerator, const mpz_class& denominator) const {
  return kernels::root_from_above(numerator, denominator, exponent_);
}

double Estimates::distance(const mpz_class& height, const Vector& normal) const {
  const double magnitude = root(mpz_class(height * height), dot(normal, normal));
  return sgn(height) < 0 ? -magnitude : magnitude;
}

bool Estimates::perhaps_met(double low, double high) const {
  const double size = std::max({extent_, std::fabs(low + rho_), std::fabs(high + rho_)});
  return high - low <= 2 * share_ * size + 0x1p-46;
}

unsigned Estimates::precision(double gap) const {
  if (!(gap > 0x1p-44)) return fine_;
  return static_cast<unsigned>(
      std::min(std::max(6L - std::ilogb(gap), 8L), static_cast<long>(fine_)));  // few bits may be asked for
}

Growth::Corner Growth::corner(polytope::Difference d) const {
  return {d, oracle_[d], kernels::image(oracle_[d], oracle_.exponent())};
}

void Growth::start(const std::array<polytope::Difference, 4>& points) {
  refer_to(*oracle_.lowest());
  surface_.start({corner(points[0]), corner(points[1]), corner(points[2]), corner(points[3])});
  for (const TriangleId t : surface_.triangles().ids()) wait_for(t, false);
}

double Growth::key(const mpz_class& height, const Vector& normal) const {
  const mpz_class length = dot(normal, normal);
  const mpz_class difference = height * abs(height) * reference_.length - reference_.square * length,
                  scale = length * reference_.length;
  long i = 0, j = 0;
  const double quotient = mpz_get_d_2exp(&i, difference.get_mpz_t()) / mpz_get_d_2exp(&j, scale.get_mpz_t());
  return std::ldexp(quotient, static_cast<int>(std::max(i - j - 2 * oracle_.exponent(), -1000L)));
}

double Growth::distance(double key) const {
  const double square = key + reference_.rounded;
  return square < 0 ? -std::sqrt(-square) : std::sqrt(square);
}

// All keys change, but not their order.
void Growth::refer_to(const Ceiling& ceiling) {
  reference_ = {ceiling.height * abs(ceiling.height), dot(ceiling.direction, ceiling.direction), 0};
  const double root = estimates_.ceiling(ceiling);
  reference_.rounded = root * std::fabs(root);
  std::vector<Waiting> waiting = std::move(waiting_);
  waiting_.clear();
  for (const Waiting& w : waiting)
    if (surface_.triangles()[w.triangle].alive) wait_for(w.triangle, w.exact);
}

// Binary64 decides nothing but the order. Planes that are not far, and those that come first, are
// asked for exactly.
void Growth::wait_for(TriangleId t, bool exact) {
  const kernels::RoundedPlane& rounded = surface_.triangles()[t].rounded;
  const double far = distance(0x1p-8);
  if (!exact && rounded.trustworthy() && rounded.estimated_distance() > far) {
    waiting_.push_back({rounded.estimated_distance() * rounded.estimated_distance() - reference_.rounded, false, t});
  } else {
    const expanding::ExactPlane<mpz_class>& plane = surface_.plane(t);
    waiting_.push_back({key(plane.height, plane.normal), true, t});
  }
  std::push_heap(waiting_.begin(), waiting_.end());
}

std::optional<Growth::Waiting> Growth::nearest() {
  while (!waiting_.empty()) {
    std::pop_heap(waiting_.begin(), waiting_.end());
    const Waiting first = waiting_.back();
    waiting_.pop_back();
    if (!surface_.triangles()[first.triangle].alive) continue;
    if (first.exact) return first;
    wait_for(first.triangle, true);
  }
  return std::nullopt;
}

// A triangle that nothing is above lies as near to the boundary of P as points can: it is passed
// over.
void Growth::run() {
  while (const std::optional<Waiting> first = nearest()) {
    const Ceiling& lowest = *oracle_.lowest();
    const double high = estimates_.ceiling(lowest), low = distance(first->key);
    if (sgn(lowest.height) == 0 || (estimates_.perhaps_met(low, high) && met())) {
      ask_exactly(first->triangle);
      return;
    }
    if (oracle_.spent() || (oracle_.calls() >= checkpoint_ && hopeless(high - low))) return;
    expand(first->triangle, high - low);
    const double improved = key(oracle_.lowest()->height, oracle_.lowest()->direction);
    if (improved < 0x1p24 * (first->key - improved)) refer_to(*oracle_.lowest());
  }
}

bool Growth::met() {
  std::optional<mpq_class> low = squared();
  if (!low && common_) low = 0;
  if (!low) return false;
  const Ceiling& ceiling = *oracle_.lowest();
  const mpq_class& unit = oracle_.lattice().fine_unit;
  const mpq_class high =
      kernels::ratio(ceiling.height * ceiling.height, dot(ceiling.direction, ceiling.direction)) * unit * unit;
  return goal_.met(goal_.from_below(*low), goal_.from_above(high));
}

// Whether the gap is expected to stay too wide until all calls are spent. Never while the sign of
// the bounds is open. Where optima form a continuum it shrinks by one factor whenever the calls
// double; if it did so at the last two checkpoints, it is expected to do so again. Else it is
// expected to shrink by that factor with every as many calls as there were between them, though it
// will do so ever faster.
bool Growth::hopeless(double gap) {
  const std::size_t between = checkpoint_ / 2;
  checkpoint_ *= 2;
  const double factor = last_gap_ / gap, last_factor = std::exchange(last_factor_, factor);
  last_gap_ = gap;
  if (last_factor == 0) return false;
  const bool by_doubling = factor < 1.2 * last_factor;
  double expected = gap;
  if (factor > 1.1)
    for (std::size_t calls = oracle_.calls(); calls < oracle_.budget() && expected > estimates_.allowed();
         calls += by_doubling ? calls : between)
      expected /= factor;
  if (expected <= estimates_.allowed()) return false;
  const std::optional<mpq_class> low = squared();
  return low && goal_.from_below(*low) > 0;
}

void Growth::expand(TriangleId t, double gap) {
  const Vector n = oracle_.shortened(surface_.plane(t).normal);
  for (const unsigned precision : {estimates_.precision(gap), oracle_.lattice().fine}) {
    if (oracle_.spent()) return;
    const Corner above = corner(oracle_.ask(n, precision));
    if (surface_.side(t, above) <= 0) continue;
    for (const TriangleId fresh : surface_.insert(above, t)) wait_for(fresh, false);
    return;
  }
}

// The facet of a core has a short normal, in which the bounds may meet.
void Growth::ask_exactly(TriangleId t) {
  const Vector n = primitive(surface_.plane(t).normal);
  if (!oracle_.spent() && kernels::binary_exponent(n) <= most_exact_bits) oracle_.ask(n, oracle_.lattice().fine);
}

std::optional<mpq_class> Growth::squared() {
  const expanding::ExactPlane<mpz_class>* nearest = nullptr;
  double from_above = 0;
  mpz_class square, length;
  for (const TriangleId t : surface_.triangles().ids()) {
    if (!surface_.triangles()[t].alive) continue;
    if (nearest != nullptr && surface_.triangles()[t].rounded.surely_beyond(from_above)) continue;
    const expanding::ExactPlane<mpz_class>& plane = surface_.plane(t);
    if (plane.height <= 0) return std::nullopt;
    if (nearest != nullptr && compare({plane.normal, plane.height}, {nearest->normal, nearest->height}) >= 0) continue;
    nearest = &plane;
    from_above = estimates_.root(mpz_class(plane.height * plane.height), dot(plane.normal, plane.normal));
  }
  const mpq_class& unit = oracle_.lattice().fine_unit;
  return kernels::ratio(nearest->height * nearest->height, dot(nearest->normal, nearest->normal)) * unit * unit;
}

}  // namespace fathom::curved
