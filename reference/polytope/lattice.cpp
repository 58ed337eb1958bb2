// SPDX-License-Identifier: GPL-3.0-or-later
// Rationals are multiplied by their common denominator, and what all integers share is divided out.
#include "reference/polytope/lattice.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "fathom/files.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {
namespace {

// A common denominator with at most this many bits never costs much; a longer one is compared with
// the coordinates.
constexpr std::size_t short_enough = 4096;
constexpr std::size_t times_the_widest = 8;
// Of all coordinates together, where the denominator outgrows them: 256 MB.
constexpr std::uint64_t most_bits = std::uint64_t{1} << 31;

// Of this many denominators each is looked up where it comes again; of more, that would take too
// long.
constexpr std::size_t most_divisors = 64;

std::size_t bits(const mpz_class& n) { return mpz_sizeinbase(n.get_mpz_t(), 2); }

/// Asks the context, if there is one, once in a megabit of numbers: what is done to a few long ones
/// takes as long as what is done to many short ones.
class Asking {
 public:
  explicit Asking(kernels::Context* context) : context_(context) {}
  void after(const mpq_class& q) { after_limbs(mpz_size(q.get_num_mpz_t()) + mpz_size(q.get_den_mpz_t())); }
  void after(const mpz_class& n) { after_limbs(mpz_size(n.get_mpz_t())); }
  void after(const Point& p) {
    for (const mpq_class* q : {&p.x, &p.y, &p.z}) after(*q);
  }

 private:
  void after_limbs(std::size_t limbs) {
    if (context_ == nullptr || (limbs_ += limbs) < (std::size_t{1} << 20) / GMP_NUMB_BITS) return;
    limbs_ = 0;
    context_->check();
  }

  kernels::Context* context_;
  std::size_t limbs_ = 0;
};

/// Until f(coordinate) is false; tells whether it never was.
template <class F>
bool all_coordinates(polytope::Positions a, polytope::Positions b, F f) {
  for (const polytope::Positions body : {a, b}) {
    for (const Point& p : body)
      if (!f(p.x) || !f(p.y) || !f(p.z)) return false;
  }
  return true;
}

/// The most bits that a common denominator in proportion to the coordinates has.
std::size_t in_proportion(polytope::Positions a, polytope::Positions b) {
  std::size_t widest = 0;
  all_coordinates(a, b, [&](const mpq_class& q) {
    widest = std::max({widest, bits(q.get_num()), bits(q.get_den())});
    return true;
  });
  return std::max(short_enough, times_the_widest * widest);
}

/// The common denominator; 0 as soon as more(its bits) is false. Denominators repeat a great deal,
/// so divisibility is asked first.
template <class More>
mpz_class common_denominator(polytope::Positions a, polytope::Positions b, Asking& asking, More more) {
  mpz_class common = 1;
  const bool all = all_coordinates(a, b, [&](const mpq_class& q) {
    asking.after(q);
    if (mpz_divisible_p(common.get_mpz_t(), q.get_den_mpz_t())) return true;
    mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), q.get_den_mpz_t());
    return more(bits(common));
  });
  return all ? common : mpz_class(0);
}

/// Multiplies coordinates along one axis by a denominator, with integral results: what a
/// coordinate's own denominator leaves of it is kept for the next one.
class Multiples {
 public:
  explicit Multiples(const mpz_class& denominator) : denominator_(denominator), factor_(denominator) {}

  mpz_class operator()(const mpq_class& q) {
    if (q.get_den() != of_) {
      of_ = q.get_den();
      mpz_divexact(factor_.get_mpz_t(), denominator_.get_mpz_t(), of_.get_mpz_t());
    }
    return q.get_num() * factor_;
  }

 private:
  const mpz_class& denominator_;
  mpz_class of_ = 1, factor_;
};

std::vector<Vector> shifted_multiples(polytope::Positions body, const mpz_class& denominator, const Vector& origin,
                                      Asking& asking) {
  std::vector<Vector> result;
  result.reserve(body.size());
  Multiples x(denominator), y(denominator), z(denominator);
  for (const Point& p : body) {
    asking.after(p);
    Vector v{x(p.x), y(p.y), z(p.z)};
    v.x -= origin.x;
    v.y -= origin.y;
    v.z -= origin.z;
    result.push_back(std::move(v));
  }
  return result;
}

/// Points such as 1/3, 4/3, 7/3 need a denominator, their differences do not: divides out what all
/// coordinates and it share.
void coarsen(mpz_class& denominator, std::vector<Vector>& a, std::vector<Vector>& b, Asking& asking) {
  const auto for_each_coordinate = [&](auto f) {
    for (std::vector<Vector>* body : {&a, &b})
      for (Vector& v : *body)
        for (mpz_class* c : {&v.x, &v.y, &v.z}) {
          asking.after(*c);
          f(c->get_mpz_t());
        }
  };
  mpz_class shared = denominator;
  for_each_coordinate([&](mpz_ptr c) {
    if (shared != 1) mpz_gcd(shared.get_mpz_t(), shared.get_mpz_t(), c);
  });
  if (shared == 1) return;
  mpz_divexact(denominator.get_mpz_t(), denominator.get_mpz_t(), shared.get_mpz_t());
  for_each_coordinate([&](mpz_ptr c) { mpz_divexact(c, c, shared.get_mpz_t()); });
}

std::vector<Point> offsets(polytope::Positions body, const Point& origin, Asking& asking) {
  std::vector<Point> result;
  result.reserve(body.size());
  for (const Point& p : body) {
    result.push_back(p - origin);
    asking.after(result.back());
  }
  return result;
}

/// Requires many numbers to be in lowest terms, by one greatest common divisor for each
/// denominator: with the product of its numerators, modulo itself. Only so many denominators are
/// remembered.
class LowestTerms {
 public:
  void require(const mpq_class& q) {
    const mpz_class& divisor = q.get_den();
    if (divisor == 1) return;
    const std::optional<kernels::ShortRational> number = kernels::short_rational(q);
    if (number && (number->divisor == 1 || short_.add(*number))) return;
    const bool at_once = sgn(divisor) <= 0 || mpz_popcount(divisor.get_mpz_t()) == 1;  // a bit tells of powers of two
    if (at_once || long_.size() == most_divisors) return kernels::require_lowest_terms(q);
    auto known = std::ranges::find(long_, divisor, [](const mpq_class& p) -> const mpz_class& { return p.get_den(); });
    if (known == long_.end()) {
      long_.push_back(q);
      return;
    }
    mpz_class& product = known->get_num();
    product *= q.get_num();
    mpz_tdiv_r(product.get_mpz_t(), product.get_mpz_t(), divisor.get_mpz_t());
  }
  void finish() const {
    short_.require_lowest_terms();
    std::ranges::for_each(long_, kernels::require_lowest_terms);
  }

 private:
  kernels::Divisors short_;
  std::vector<mpq_class> long_;  // products of numerators, over their denominator
};

void require_bodies(polytope::Positions a, polytope::Positions b, Asking& asking) {
  if (a.empty() || b.empty()) throw std::invalid_argument("a body needs at least one point");
  LowestTerms terms;
  all_coordinates(a, b, [&](const mpq_class& q) {
    terms.require(q);
    asking.after(q);
    return true;
  });
  terms.finish();
}

/// For points whose common denominator is much longer than they are: what differences do not need
/// is left out first, and there are limits.
PlacedPair place_wide(polytope::Positions a, polytope::Positions b, Asking& asking) {
  const Point& origin = b.front();
  const std::vector<Point> from_a = offsets(a, origin, asking), from_b = offsets(b, origin, asking);
  const std::uint64_t coordinates = 3 * (a.size() + b.size());
  mpz_class denominator =
      common_denominator(from_a, from_b, asking, [&](std::size_t size) { return size * coordinates <= most_bits; });
  if (denominator == 0) {
    throw InputError("input", 0,
                     "the denominators of the " + std::to_string(a.size() + b.size()) +
                         " points share too little: " + "over a common one all coordinates together would pass " +
                         std::to_string(most_bits >> 23) + " MB");
  }
  const Vector no_shift{0, 0, 0};
  std::vector<Vector> of_a = shifted_multiples(from_a, denominator, no_shift, asking),
                      of_b = shifted_multiples(from_b, denominator, no_shift, asking);
  return place_integers(std::move(of_a), std::move(of_b), std::move(denominator), origin);
}

}  // namespace

void require_bodies(polytope::Positions a, polytope::Positions b) {
  Asking nobody(nullptr);
  require_bodies(a, b, nobody);
}

std::optional<PlacedPair> place_if_slim(polytope::Positions a, polytope::Positions b, kernels::Context* context) {
  Asking asking(context);
  require_bodies(a, b, asking);
  std::size_t limit = short_enough;
  mpz_class denominator = common_denominator(a, b, asking, [&](std::size_t size) {
    if (size > limit && limit == short_enough) limit = in_proportion(a, b);
    return size <= limit;
  });
  if (denominator == 0) return std::nullopt;
  const Vector no_shift{0, 0, 0}, origin = shifted_multiples({&b.front(), 1}, denominator, no_shift, asking)[0];
  std::vector<Vector> of_a = shifted_multiples(a, denominator, origin, asking),
                      of_b = shifted_multiples(b, denominator, origin, asking);
  coarsen(denominator, of_a, of_b, asking);
  return place_integers(std::move(of_a), std::move(of_b), std::move(denominator), b.front());
}

PlacedPair place(polytope::Positions a, polytope::Positions b, kernels::Context* context) {
  if (std::optional<PlacedPair> slim = place_if_slim(a, b, context)) return std::move(*slim);
  Asking asking(context);
  return place_wide(a, b, asking);
}

PlacedPair place_integers(std::vector<Vector> a, std::vector<Vector> b, mpz_class denominator, Point origin) {
  const long exponent = std::max(kernels::binary_exponent(a), kernels::binary_exponent(b));
  return {std::move(denominator), std::move(origin), kernels::PointCloud(std::move(a), exponent),
          kernels::PointCloud(std::move(b), exponent)};
}

template <class Integer>
mpq_class PlacedPairIn<Integer>::in_units(const Integer& n) const {
  mpq_class q;
  if (sgn(n) == 0) return q;
  mpz_class &above = q.get_num(), &below = q.get_den();
  above = to_mpz(n);
  const long halvings = std::min<long>(-power, mpz_scan1(above.get_mpz_t(), 0));
  if (halvings < 0) above <<= -halvings;
  else if (halvings > 0) mpz_tdiv_q_2exp(above.get_mpz_t(), above.get_mpz_t(), halvings);
  if (denominator != 1) {
    const mpz_class shared = gcd(above, denominator);
    mpz_divexact(above.get_mpz_t(), above.get_mpz_t(), shared.get_mpz_t());
    mpz_divexact(below.get_mpz_t(), denominator.get_mpz_t(), shared.get_mpz_t());
  }
  below <<= -power - halvings;
  return q;
}

template <class Integer>
Point PlacedPairIn<Integer>::position(const Vector& v,
                                      const mpz_class& divisor) const requires std::same_as<Integer, mpz_class> {
  const mpz_class unit = denominator * divisor;
  return {origin.x + kernels::ratio(v.x, unit), origin.y + kernels::ratio(v.y, unit),
          origin.z + kernels::ratio(v.z, unit)};
}

template <class Integer>
Vector PlacedPairIn<Integer>::vector(const Point& position) const requires std::same_as<Integer, mpz_class> {
  const Point p = denominator * (position - origin);
  return {p.x.get_num(), p.y.get_num(), p.z.get_num()};
}

template mpq_class PlacedPairIn<kernels::Integer127>::in_units(const kernels::Integer127&) const;
template mpq_class PlacedPairIn<kernels::Integer255>::in_units(const kernels::Integer255&) const;
template mpq_class PlacedPairIn<NarrowInteger>::in_units(const NarrowInteger&) const;
template mpq_class PlacedPair::in_units(const mpz_class&) const;
template Point PlacedPair::position(const Vector&, const mpz_class&) const;
template Vector PlacedPair::vector(const Point&) const;

std::vector<Weight> weights_of(std::span<const Difference> differences, std::span<const mpq_class> weights,
                               std::uint32_t Difference::*side) {
  std::map<std::uint32_t, mpq_class> sums;
  for (std::size_t i = 0; i < differences.size(); ++i) sums[differences[i].*side] += weights[i];
  std::vector<Weight> result;
  for (const auto& [index, weight] : sums) result.push_back({index, weight});
  return result;
}

mpz_class support_naive(std::span<const Vector> a, std::span<const Vector> b, const Vector& u) {
  return dot(u, b[kernels::extreme_points_naive(b, u).front()] - a[kernels::extreme_points_naive(a, -u).front()]);
}

std::optional<Vec3<mpq_class>> convex_combination(std::span<const Vector> points, std::span<const Weight> weights) {
  Vec3<mpq_class> sum;
  mpq_class total;
  for (const Weight& w : weights) {
    if (w.index >= points.size() || w.weight <= 0) return std::nullopt;
    const Vector& p = points[w.index];
    total += w.weight;
    sum.x += w.weight * p.x;
    sum.y += w.weight * p.y;
    sum.z += w.weight * p.z;
  }
  return total == 1 ? std::optional(sum) : std::nullopt;
}

Point convex_combination(kernels::Report& report, const std::vector<Point>& points,
                         const std::vector<Weight>& weights) {
  Point sum;
  mpq_class total;
  for (const Weight& w : weights) {
    if (!report.expect(w.index < points.size() && w.weight > 0, "a weight that is none")) continue;
    total += w.weight;
    sum = sum + w.weight * points[w.index];
  }
  report.expect(total == 1, "weights do not sum to 1");
  return sum;
}

}  // namespace fathom::polytope
