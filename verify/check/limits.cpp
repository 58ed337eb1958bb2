// SPDX-License-Identifier: Apache-2.0
#include "limits.hpp"

#include <algorithm>
#include <limits>

#include "budget.hpp"
#include "vectors.hpp"

namespace fathom_check {
namespace {

using Count = std::uint64_t;

/// No amount of work is counted above this.
constexpr Count too_much = most_work + 1;
static_assert(most_work < std::numeric_limits<Count>::max() / 2);

Count sum(Count s, Count t) { return std::min(too_much, std::min(too_much, s) + std::min(too_much, t)); }
Count product(Count s, Count t) { return s != 0 && t > most_work / s ? too_much : s * t; }

/// How wide numbers become over their common denominator, if `vectors` of them are kept.
class Width {
 public:
  Width(Count vectors, std::size_t line) : vectors_(vectors), line_(line) {}

  void take(const Rational& r) {
    numerator_ = std::max(numerator_, bits(r.num));
    if (mpz_divisible_p(denominator_.get_mpz_t(), r.den.get_mpz_t())) return;
    mpz_lcm(denominator_.get_mpz_t(), denominator_.get_mpz_t(), r.den.get_mpz_t());
    if (vectors_ * bits(denominator_) > largest_size) throw too_large(line_);
  }
  [[nodiscard]] Count value() const { return bits(denominator_) + numerator_; }
  [[nodiscard]] const mpz_class& denominator() const { return denominator_; }

  static Fault too_large(std::size_t line) {
    return malformed(line, "a certificate larger than the limit, " + std::to_string(largest_size) + " in its size");
  }

 private:
  Count vectors_, numerator_ = 0;
  std::size_t line_;
  mpz_class denominator_ = 1;
};

/// What a product of numbers of these sizes takes.
Count cost(Count s, Count t) {
  constexpr Count fixed = 256, linear_from = 4'000;
  return product(fixed + std::max(s, t), fixed + std::min({s, t, linear_from}));
}

Count widest_direction(const Certificate& c) {
  Count widest = 0;
  for (const Vector& n : c.directions.items) widest = std::max({widest, bits(n.x), bits(n.y), bits(n.z)});
  return widest;
}

Count widest_of_claim(const Certificate& c) {
  if (c.claim != Claim::depth && c.claim != Claim::bounds) return 0;
  return std::max({bits(c.low.num), bits(c.low.den), bits(c.high.num), bits(c.high.den)});
}

Count squared_corners(const Facets& facets) {
  Count sum = 0;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const Count corners = facets.ends[f] - facets.begin_of(f);
    sum += corners * corners;
  }
  return sum;
}

}  // namespace

void require_limits(Certificate& c, std::size_t line) {
  const Count points = c.a.items.size() + c.b.items.size(), directions = c.directions.items.size(), facets = c.facets.items.size();
  const Count weights = c.weights_a.items.size() + c.weights_b.items.size(), vectors = points + c.vertices.items.size() + 3 * facets;
  Width of_points(vectors, line), of_weights(weights, line);
  for (const auto* part : {&c.a, &c.b})
    for (const RationalPoint& p : part->items)
      for (const Rational* r : {&p.x, &p.y, &p.z}) of_points.take(*r);
  for (const auto* part : {&c.weights_a, &c.weights_b})
    for (const Weight& weight : part->items) of_weights.take(weight.weight);
  const Count w = of_points.value(), x = of_weights.value();
  if (vectors * w + weights * x > largest_size) throw Width::too_large(line);
  const Count of_directions = product(product(points, directions), cost(w, widest_direction(c)));
  const Count of_facets = product(points + 4 * squared_corners(c.facets.items), cost(w, w));
  const Count of_distances = product(4 * (directions + facets), cost(w, widest_of_claim(c)));
  const Count work = sum(sum(of_directions, of_facets), sum(of_distances, product(4 * weights, cost(w + x, w + x))));
  if (work > most_work) throw malformed(line, "a certificate of more work than the limit, " + std::to_string(most_work));
  c.scale = of_points.denominator();
}

}  // namespace fathom_check
