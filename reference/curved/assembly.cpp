// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/curved/assembly.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "kernels/number/irrational.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/curved/oracle.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::curved {
namespace {

// floor(sqrt(x) * 2^exponent) / 2^exponent, or the ceiling. x >= 0.
mpq_class root(const mpq_class& x, long exponent, bool up) {
  const mpq_class scaled = kernels::times_power_of_two(x, 2 * exponent);
  const mpz_class whole = up ? rounded_up(scaled) : mpz_class(scaled.get_num() / scaled.get_den());
  mpz_class result, rest;
  mpz_sqrtrem(result.get_mpz_t(), rest.get_mpz_t(), whole.get_mpz_t());
  if (up && rest != 0) ++result;
  return kernels::times_power_of_two(mpq_class(result), -exponent);
}

constexpr unsigned weight_bits = 12;  // more than the goal's

// Numbers a list of points, each once.
class Names {
 public:
  explicit Names(std::vector<InnerPoint>& points) : points_(points) {}

  std::uint32_t operator()(InnerPoint point) {
    const auto [place, fresh] = names_.try_emplace(std::move(point), static_cast<std::uint32_t>(points_.size()));
    if (fresh) points_.push_back(place->first);
    return place->second;
  }

 private:
  struct Before {
    bool operator()(const AtomPoint& p, const AtomPoint& q) const {
      return p.atom != q.atom ? p.atom < q.atom : p.local < q.local;
    }
    bool operator()(const InnerPoint& p, const InnerPoint& q) const {
      return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end(), *this);
    }
  };

  std::vector<InnerPoint>& points_;
  std::map<InnerPoint, std::uint32_t, Before> names_;
};

// Multiples of 2^-bits near the weights, which sum to 1 as they do; of the small ones none is
// larger than the weight.
std::vector<mpz_class> rounded_weights(const polytope::SimplexFoot<mpz_class>& z, unsigned bits) {
  std::vector<mpz_class> result;
  mpz_class rest = mpz_class(1) << bits;
  for (const mpz_class& weight : z.weights) {
    result.emplace_back((weight << bits) / z.denominator);
    rest -= result.back();
  }
  *std::max_element(result.begin(), result.end()) += rest;
  return result;
}

}  // namespace

mpz_class rounded_up(const mpq_class& value) {
  mpz_class result;
  mpz_cdiv_q(result.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
  return result;
}

Goal::Goal(unsigned bits, unsigned status_bits, mpq_class extent, mpq_class rho)
    : status_bits_(status_bits),
      extent_(std::move(extent)),
      rho_(std::move(rho)),
      share_(kernels::times_power_of_two(15, -static_cast<long>(bits) - 4)),
      status_share_(kernels::times_power_of_two(15, -static_cast<long>(status_bits) - 4)) {}

long Goal::finest(const mpq_class& x) const {
  if (extent_ == 0 && x == 0) return 0;
  const long order = extent_ == 0 ? kernels::binary_order(x) / 2 - 1 : kernels::binary_order(extent_);
  return static_cast<long>(status_bits_) + 6 - order;
}

mpq_class Goal::from_below(const mpq_class& x) const {
  return rho_ + (x < 0 ? mpq_class(-root(-x, finest(x), true)) : root(x, finest(x), false));
}

mpq_class Goal::from_above(const mpq_class& x) const {
  return rho_ + (x < 0 ? mpq_class(-root(-x, finest(x), false)) : root(x, finest(x), true));
}

mpq_class Goal::exact_or_below(const mpq_class& x) const {
  const auto exact = kernels::rational_root(x);
  return exact ? mpq_class(rho_ + *exact) : from_below(x);
}

mpq_class Goal::exact_or_above(const mpq_class& x) const {
  const auto exact = kernels::rational_root(x);
  return exact ? mpq_class(rho_ + *exact) : from_above(x);
}

bool Goal::met(const mpq_class& low, const mpq_class& high) const {
  const mpq_class width = high - low;
  if (!decided(low, high)) return width <= status_share_ * extent_;
  return width <= share_ * std::max({extent_, std::min(mpq_class(abs(low)), mpq_class(abs(high)))});
}

// ---- the two sides of the bounds ----

mpq_class signed_square(const mpq_class& height, const Vector& n) {
  return height * abs(height) / mpq_class(dot(n, n));
}

std::vector<mpq_class> short_heights(const std::vector<TermHeight>& heights, const Vector& n, const Goal& goal) {
  const bool exact = std::all_of(heights.begin(), heights.end(), [](const TermHeight& h) { return h.exact; });
  mpq_class sum;
  for (const TermHeight& h : heights) sum += h.height;
  const long spare =
      4 + kernels::binary_order(mpq_class(mpz_class(heights.size()))) - kernels::binary_order(mpq_class(dot(n, n))) / 2;
  const long finest = goal.finest(signed_square(sum, n)) + spare;
  std::vector<mpq_class> result;
  for (const TermHeight& h : heights)
    result.push_back(exact ? h.height
                           : kernels::times_power_of_two(
                                 mpq_class(rounded_up(kernels::times_power_of_two(h.height, finest))), -finest));
  return result;
}

mpq_class Assembly::square_of(const polytope::SimplexFoot<mpz_class>& z) const {
  const mpq_class& unit = oracle_.lattice().fine_unit;
  return -kernels::ratio(dot(z.point, z.point), mpz_class(z.denominator * z.denominator)) * unit * unit;
}

mpq_class Assembly::upper() const {
  const Ceiling& ceiling = *oracle_.lowest();
  return signed_square(ceiling.height * oracle_.lattice().fine_unit, ceiling.direction);
}

bool Assembly::closed() const { return lower_ == upper(); }

bool Assembly::met(const mpq_class& lower) const {
  const mpq_class upper = this->upper();
  return lower == upper || goal_.met(goal_.from_below(lower), goal_.from_above(upper));
}

void Assembly::set_lower(const NearestFoot& nearest) {
  const polytope::SimplexFoot<mpz_class>& z = nearest.foot;
  const mpq_class exact = square_of(z);
  Combination combination;
  const auto take = [&](std::size_t i, mpq_class weight) {
    if (weight == 0) return;
    combination.a.push_back(oracle_.inner_point(nearest.corners[i].ids.first, true));
    combination.b.push_back(oracle_.inner_point(nearest.corners[i].ids.first, false));
    combination.weights.push_back(std::move(weight));
  };
  if (exact == 0 || exact == upper()) {
    for (std::size_t i = 0; i < nearest.corners.size(); ++i) take(i, kernels::ratio(z.weights[i], z.denominator));
    lower_ = exact;
  } else {
    const unsigned bits = oracle_.lattice().fine + weight_bits;
    const std::vector<mpz_class> weights = rounded_weights(z, bits);
    Vector sum;
    for (std::size_t i = 0; i < nearest.corners.size(); ++i) {
      const Vector& p = nearest.corners[i].p;
      sum = {sum.x + weights[i] * p.x, sum.y + weights[i] * p.y, sum.z + weights[i] * p.z};
      take(i, kernels::times_power_of_two(mpq_class(weights[i]), -static_cast<long>(bits)));
    }
    const mpq_class unit = kernels::times_power_of_two(oracle_.lattice().fine_unit, -static_cast<long>(bits));
    lower_ = -mpq_class(dot(sum, sum)) * unit * unit;
  }
  set_weights(combination);
}

void Assembly::set_weights(const Combination& combination) {
  bracket_ = {};
  Names name_a(bracket_.inner_a), name_b(bracket_.inner_b);
  std::vector<polytope::Difference> ids;
  for (std::size_t i = 0; i < combination.weights.size(); ++i)
    ids.emplace_back(name_a(combination.a[i]), name_b(combination.b[i]));
  bracket_.weights_a = polytope::weights_of(ids, combination.weights, &polytope::Difference::first);
  bracket_.weights_b = polytope::weights_of(ids, combination.weights, &polytope::Difference::second);
}

void Assembly::set_lower(const mpq_class& squared, InnerPolytope inner) {
  lower_ = squared;
  bracket_ = {};
  Names name_a(bracket_.inner_a), name_b(bracket_.inner_b);
  for (auto& [a, b] : inner.vertices) {
    const std::uint32_t point = a;
    a = name_a(oracle_.inner_point(point, true));
    b = name_b(oracle_.inner_point(point, false));
  }
  bracket_.polytope = std::move(inner);
}

void Assembly::set_lower(const mpq_class& squared, Revolution around) {
  lower_ = squared;
  bracket_ = {};
  bracket_.around = std::move(around);
}

bool Assembly::meets_in_face() {
  const Vector& n = oracle_.lowest()->direction;
  const std::vector<TermHeight> heights = oracle_.heights(n);
  if (!std::all_of(heights.begin(), heights.end(), [](const TermHeight& h) { return h.exact; })) return false;
  const std::optional<Combination> foot = foot_in_face(context_, a_, b_, n, heights);
  if (!foot) return false;
  lower_ = signed_square(
      std::accumulate(heights.begin(), heights.end(), mpq_class(),
                      [](const mpq_class& sum, const TermHeight& h) { return mpq_class(sum + h.height); }),
      n);
  set_weights(*foot);
  return true;
}

CurvedBounds Assembly::take() {
  bracket_.direction = oracle_.lowest()->direction;
  const std::vector<mpq_class> heights = short_heights(oracle_.heights(bracket_.direction), bracket_.direction, goal_);
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(a_.size());
  bracket_.heights_a.assign(heights.begin(), middle);
  bracket_.heights_b.assign(middle, heights.end());
  const mpq_class upper =
      signed_square(std::accumulate(heights.begin(), heights.end(), mpq_class()), bracket_.direction);
  const bool equal = lower_ == upper;
  return {equal ? goal_.exact_or_below(lower_) : goal_.from_below(lower_),
          equal ? goal_.exact_or_above(upper) : goal_.from_above(upper),
          {},
          std::move(bracket_),
          oracle_.calls()};
}

}  // namespace fathom::curved
