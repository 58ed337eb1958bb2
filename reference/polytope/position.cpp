// SPDX-License-Identifier: GPL-3.0-or-later
// O is in P iff (0, 1) is in the cone of all (p, 1). If it is, O lies in the relative interior of
// the hull of some differences T; T grows,
// by a dimension each time, until a supporting plane through O is found or T surrounds O.
// [proofs/position.md]

#include "reference/polytope/position.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::polytope {
namespace {

/// A vector of R^4.
struct Lifted {
  Vector v;
  mpz_class w;
};

/// <g, h> in R^4.
mpz_class dot(const Lifted& g, const Lifted& h) {
  mpz_class r = g.w * h.w;
  mpz_addmul(r.get_mpz_t(), g.v.x.get_mpz_t(), h.v.x.get_mpz_t());
  mpz_addmul(r.get_mpz_t(), g.v.y.get_mpz_t(), h.v.y.get_mpz_t());
  mpz_addmul(r.get_mpz_t(), g.v.z.get_mpz_t(), h.v.z.get_mpz_t());
  return r;
}

/// The point of a cone that is nearest to a target, as a combination with positive weights; exact.
struct NearestInCone {
  std::vector<std::size_t> support;  ///< indices of the generators that it combines, ascending
  std::vector<mpz_class> weights;    ///< > 0, one for each of them, over `denominator`
  mpz_class denominator = 1;         ///< > 0
  Lifted residual;                   ///< target - nearest, times a positive rational: zero, or without a common divisor
};

constexpr std::size_t most = 4;
using Row = std::array<mpz_class, most + 1>;
using Matrix = std::array<Row, most>;  // products of generators; the last column holds those with the target

Matrix gram(std::span<const Lifted> generators, const Lifted& target) {
  const std::size_t n = generators.size();
  Matrix m;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) m[i][j] = m[j][i] = dot(generators[i], generators[j]);
    m[i][most] = dot(generators[i], target);
  }
  return m;
}

struct Solution {
  std::vector<mpz_class> numerators;
  mpz_class determinant;
};

// The weights of the projection onto the span of `support`, by fraction-free elimination (Bareiss,
// Gauss-Jordan form). A Gram matrix of independent vectors is positive definite: every pivot is
// positive, and so is the determinant.
Solution project(const Matrix& gram, const std::vector<std::size_t>& support) {
  const std::size_t n = support.size();
  Matrix m;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i][j] = gram[support[i]][support[j]];
    m[i][n] = gram[support[i]][most];
  }
  Solution s;
  s.determinant = 1;
  mpz_class next;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      for (std::size_t j = k + 1; j <= n; ++j) {
        mpz_mul(next.get_mpz_t(), m[k][k].get_mpz_t(), m[i][j].get_mpz_t());
        mpz_submul(next.get_mpz_t(), m[i][k].get_mpz_t(), m[k][j].get_mpz_t());
        mpz_divexact(m[i][j].get_mpz_t(), next.get_mpz_t(), s.determinant.get_mpz_t());
      }
    }
    s.determinant = m[k][k];
  }
  for (std::size_t i = 0; i < n; ++i) s.numerators.push_back(m[i][n]);
  return s;
}

void divide_by_common_divisor(Lifted& g) {
  const mpz_class d = gcd(gcd(gcd(g.w, g.v.x), g.v.y), g.v.z);
  if (d <= 1) return;
  for (mpz_class* c : {&g.v.x, &g.v.y, &g.v.z, &g.w}) mpz_divexact(c->get_mpz_t(), c->get_mpz_t(), d.get_mpz_t());
}

// determinant * target - sum of numerators * generators, without its common divisor.
Lifted residual(std::span<const Lifted> generators, const Lifted& target, const std::vector<std::size_t>& support,
                const Solution& s) {
  Lifted r{{s.determinant * target.v.x, s.determinant * target.v.y, s.determinant * target.v.z},
           s.determinant * target.w};
  for (std::size_t i = 0; i < support.size(); ++i) {
    const Lifted& g = generators[support[i]];
    r.v.x -= s.numerators[i] * g.v.x;
    r.v.y -= s.numerators[i] * g.v.y;
    r.v.z -= s.numerators[i] * g.v.z;
    r.w -= s.numerators[i] * g.w;
  }
  divide_by_common_divisor(r);
  return r;
}

bool all_positive(const std::vector<mpz_class>& weights) {
  for (const mpz_class& w : weights)
    if (w <= 0) return false;
  return true;
}

bool reaches_none(const Lifted& residual, std::span<const Lifted> generators, unsigned subset) {
  for (std::size_t i = 0; i < generators.size(); ++i)
    if ((subset >> i & 1U) == 0 && dot(residual, generators[i]) > 0) return false;
  return true;
}

/// The nearest point of the cone of `generators` to `target`. There are one to four of them,
/// linearly independent, and the target lies strictly nearer to their cone than to the cone of all
/// but the last (so the last one is in the support). The residual is orthogonal to the support and
/// has no positive product with any generator, which proves the point nearest.
// Subsets of the generators are tried, largest first: the nearest point z of the cone is the
// orthogonal projection onto the span of its support, with positive weights there and <target - z,
// g> <= 0 for all generators g. These conditions are also sufficient, and as the generators are
// independent exactly one subset meets them.
NearestInCone nearest_in_cone(std::span<const Lifted> generators, const Lifted& target) {
  const std::size_t n = generators.size();
  if (n == 0 || n > most) throw std::logic_error("nearest_in_cone: one to four generators expected");
  const Matrix products = gram(generators, target);
  const unsigned last = 1U << (n - 1), all = 2 * last - 1;
  for (int size = static_cast<int>(n); size > 0; --size) {
    for (unsigned subset = last; subset <= all; ++subset) {
      if (std::popcount(subset) != size) continue;
      NearestInCone z;
      for (std::size_t i = 0; i < n; ++i)
        if (subset >> i & 1U) z.support.push_back(i);
      Solution s = project(products, z.support);
      if (!all_positive(s.numerators)) continue;
      z.residual = residual(generators, target, z.support, s);
      if (!reaches_none(z.residual, generators, subset)) continue;
      z.weights = std::move(s.numerators);
      z.denominator = std::move(s.determinant);
      return z;
    }
  }
  throw std::logic_error("nearest_in_cone: the last generator is not needed, or the generators are dependent");
}

/// Searches the cone that all differences of two clouds span for the point nearest to a target,
/// without listing the differences.
class ConeSearch {
 public:
  explicit ConeSearch(Differences& differences) : differences_(differences) {}

  /// A point of the cone as a combination of differences, and the residual to the target.
  struct Nearest {
    std::vector<Difference> support;
    std::vector<mpq_class> weights;  ///< > 0
    Lifted residual;                 ///< zero if the target is in the cone; else a proof that it is not, see below
  };

  /// Searches the cone of all (p, lift), p a difference, for `target`. If the target is not in it,
  /// the residual r is a positive multiple of target - nearest: <r, target> > 0 and <r, (p, lift)>
  /// <= 0 for every p. With lift = 1 and target (0, 1) the search stops early, with some r such
  /// that <r.v, p> < 0 for every p. `seeds`: some differences, at least one. Unless lift = 1, O
  /// must be a positive combination of them. Expected time linear in the number of points.
  ///                                                                           [proofs/position.md]
  Nearest nearest(const Lifted& target, int lift, const std::vector<Difference>& seeds);

 private:
  ConeSearch(Differences& sample, std::uint64_t seed) : differences_(sample), seed_(seed), sample_(true) {}
  Nearest nearest_directly(const Lifted& target, int lift);
  Nearest nearest_by_sampling(const Lifted& target, int lift, const std::vector<Difference>& seeds);

  Differences& differences_;
  std::uint64_t seed_ = 0;  // fixed for a whole problem: the same input gives the same answer
  bool sample_ = false;     // of a larger problem: then the search may not stop early
};

// Small problems: an active-set method (Wolfe; Lawson and Hanson; in the lifted form the exact kin
// of Gilbert, Johnson and Keerthi). Large ones: Clarkson's sampling for problems of
// linear-programming type, which calls itself on samples of O(sqrt n) points.

constexpr std::size_t small_enough =
    2000;  // points; of more, a sample with all forced points is at most 24 sqrt(n) + 26 < n
constexpr std::size_t basis_size = 8;  // points: at most four differences make the answer

bool is_zero(const Lifted& g) { return fathom::is_zero(g.v) && g.w == 0; }

std::size_t root_below(std::size_t n) {
  std::size_t root = 1;
  while ((root + 1) * (root + 1) <= n) ++root;
  return root;
}

// Some points of both clouds, by their indices there. Repetitions do no harm.
struct Selection {
  std::vector<std::uint32_t> a, b;
};

std::vector<Vector> picked(const kernels::PointCloud& cloud, const std::vector<std::uint32_t>& ids) {
  std::vector<Vector> points;
  points.reserve(ids.size());
  for (const std::uint32_t i : ids) points.push_back(cloud[i]);
  return points;
}

void draw(Selection& selection, const kernels::PointCloud& a, const kernels::PointCloud& b, std::size_t how_many,
          std::mt19937_64& random) {
  for (; how_many > 0; --how_many) {
    const std::uint64_t i = random() % (a.size() + b.size());
    if (i < a.size()) selection.a.push_back(static_cast<std::uint32_t>(i));
    else selection.b.push_back(static_cast<std::uint32_t>(i - a.size()));
  }
}

void append(std::vector<std::uint32_t>& to, const std::vector<std::uint32_t>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

ConeSearch::Nearest ConeSearch::nearest(const Lifted& target, int lift, const std::vector<Difference>& seeds) {
  return differences_.a.size() + differences_.b.size() <= small_enough ? nearest_directly(target, lift)
                                                                       : nearest_by_sampling(target, lift, seeds);
}

ConeSearch::Nearest ConeSearch::nearest_directly(const Lifted& target, int lift) {
  Nearest z;
  z.residual = target;
  std::vector<Lifted> generators;  // of z.support
  while (!is_zero(z.residual)) {
    const Difference d = differences_.extreme(z.residual.v);
    generators.push_back({differences_[d], lift});
    z.support.push_back(d);
    const bool separated = lift == 1 && !sample_ && dot(z.residual.v, generators.back().v) < 0;
    if (separated || dot(z.residual, generators.back()) <= 0) {
      z.support.pop_back();
      break;
    }
    NearestInCone next = nearest_in_cone(generators, target);
    z.weights.clear();
    for (std::size_t i = 0; i < next.support.size(); ++i) {
      std::swap(generators[i], generators[next.support[i]]);
      std::swap(z.support[i], z.support[next.support[i]]);
      z.weights.push_back(kernels::ratio(next.weights[i], next.denominator));
    }
    generators.resize(next.support.size());
    z.support.resize(next.support.size());
    z.residual = std::move(next.residual);
  }
  return z;
}

ConeSearch::Nearest ConeSearch::nearest_by_sampling(const Lifted& target, int lift,
                                                    const std::vector<Difference>& seeds) {
  const kernels::PointCloud &all_a = differences_.a, &all_b = differences_.b;
  const std::size_t root = root_below(all_a.size() + all_b.size());
  std::mt19937_64 random(seed_++);
  Selection forced;
  for (const Difference& d : seeds) {
    forced.a.push_back(d.first);
    forced.b.push_back(d.second);
  }
  std::vector<Difference> local_seeds;
  for (std::uint32_t i = 0; i < seeds.size(); ++i) local_seeds.emplace_back(i, i);

  while (true) {
    Selection chosen = forced;
    draw(chosen, all_a, all_b, basis_size * root, random);
    const kernels::PointCloud a(picked(all_a, chosen.a), all_a.exponent()),
        b(picked(all_b, chosen.b), all_b.exponent());
    Differences sample{a, b};
    Nearest z = ConeSearch(sample, random()).nearest(target, lift, local_seeds);
    for (Difference& d : z.support) d = {chosen.a[d.first], chosen.b[d.second]};
    if (is_zero(z.residual)) return z;

    // The residual is orthogonal to its support, and to the seeds if there is none: they mark the
    // greatest value in the sample.
    const Difference mark = z.support.empty() ? seeds.front() : z.support.front();
    const std::vector<std::uint32_t> beyond_a = kernels::points_beyond(all_a, -z.residual.v, mark.first);
    const std::vector<std::uint32_t> beyond_b = kernels::points_beyond(all_b, z.residual.v, mark.second);
    ++differences_.scans;
    const std::size_t violators = beyond_a.size() + beyond_b.size();
    if (violators == 0) return z;
    if (violators > 2 * root) continue;  // an unlucky sample, at most one in two
    append(forced.a, beyond_a);
    append(forced.b, beyond_b);
  }
}

// Independent vectors that span the same space.
std::vector<Vector> basis(const std::vector<Vector>& vectors) {
  std::vector<Vector> chosen;
  for (const Vector& v : vectors) {
    const bool independent = chosen.empty()       ? !is_zero(v)
                             : chosen.size() == 1 ? !is_zero(cross(chosen[0], v))
                             : chosen.size() == 2 ? det(chosen[0], chosen[1], v) != 0
                                                  : false;
    if (independent) chosen.push_back(v);
  }
  return chosen;
}

// A nonzero vector orthogonal to at most two independent ones.
Vector normal_to(const std::vector<Vector>& independent) {
  if (independent.empty()) return {1, 0, 0};
  if (independent.size() == 2) return primitive(cross(independent[0], independent[1]));
  const Vector v = cross(independent[0], Vector{1, 0, 0});
  return primitive(is_zero(v) ? cross(independent[0], Vector{0, 1, 0}) : v);
}

// Whether O is in the interior of the hull: no u != 0 has <u, p> <= 0 for all p. If the vectors
// span R^3 but such u exist, they form a cone without lines; on one of its extreme rays two
// independent constraints are tight, so u is normal to two of the vectors.
bool surrounds(const std::vector<Vector>& vectors) {
  if (basis(vectors).size() < 3) return false;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vector u = cross(vectors[i], vectors[j]);
      if (is_zero(u)) continue;
      bool above = false, below = false;
      for (std::size_t k = 0; k < vectors.size() && !(above && below); ++k) {
        const mpz_class side = dot(u, vectors[k]);
        above = above || side > 0;
        below = below || side < 0;
      }
      if (!(above && below)) return false;
    }
  }
  return true;
}

std::vector<Vector> vectors_of(const std::vector<Difference>& list, const Differences& differences) {
  std::vector<Vector> vectors;
  for (const Difference& d : list) vectors.push_back(differences[d]);
  return vectors;
}

// Drops what the rest can do without; by Steinitz at most six remain.
std::vector<Difference> irredundant(std::vector<Difference> surrounding, const Differences& differences) {
  for (std::size_t i = surrounding.size(); surrounding.size() > 4 && i-- > 0;) {
    std::vector<Difference> rest = surrounding;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    if (surrounds(vectors_of(rest, differences))) surrounding = std::move(rest);
  }
  std::sort(surrounding.begin(), surrounding.end());
  return surrounding;
}

// Given O in the relative interior of the hull of `around`: decides between inside and boundary.
void decide_interior(PositionOfOrigin& answer, Differences& differences, ConeSearch& cone,
                     std::vector<Difference> around) {
  while (true) {
    const std::vector<Vector> spanned = basis(vectors_of(around, differences));
    if (spanned.size() == 3) {
      answer.position = Position::inside;
      answer.surrounding = irredundant(std::move(around), differences);
      return;
    }
    answer.position = Position::boundary;
    answer.normal = normal_to(spanned);
    const Difference d = differences.extreme(*answer.normal);
    const Vector q = differences[d];
    if (dot(*answer.normal, q) == 0) return;
    ConeSearch::Nearest back = cone.nearest({-q, 0}, 0, around);
    if (!is_zero(back.residual.v)) {
      answer.normal = primitive(back.residual.v);
      return;
    }
    answer.normal.reset();
    around.push_back(d);
    around.insert(around.end(), back.support.begin(), back.support.end());
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
  }
}

void expect_normal(kernels::Report& report, const PositionOfOrigin& answer, std::span<const Vector> a,
                   std::span<const Vector> b) {
  if (!report.expect(answer.normal.has_value(), "a normal is missing")) return;
  const Vector& u = *answer.normal;
  report.expect(!is_zero(u) && primitive(u) == u, "the normal is not a primitive vector");
  const mpz_class h = support_naive(a, b, u);
  if (answer.position == Position::outside) report.expect(h < 0, "the normal does not separate the bodies strictly");
  else report.expect(h == 0, "the normal does not support P in O");
}

void expect_common_point(kernels::Report& report, const PositionOfOrigin& answer, std::span<const Vector> a,
                         std::span<const Vector> b) {
  const auto in_a = convex_combination(a, answer.a), in_b = convex_combination(b, answer.b);
  report.expect(in_a.has_value(), "the weights of A are not convex weights of its points");
  report.expect(in_b.has_value(), "the weights of B are not convex weights of its points");
  if (in_a && in_b) report.expect(*in_a == *in_b, "the weighted points of A and B differ");
}

void expect_surrounding(kernels::Report& report, const PositionOfOrigin& answer, std::span<const Vector> a,
                        std::span<const Vector> b) {
  std::vector<Vector> differences;
  for (const auto& [i, j] : answer.surrounding) {
    if (!report.expect(i < a.size() && j < b.size(), "a surrounding pair has an index out of range")) return;
    differences.push_back(b[j] - a[i]);
  }
  report.expect(surrounds(differences), "the surrounding differences do not have O in the interior of their hull");
}

}  // namespace

PositionOfOrigin position_of_origin(const kernels::PointCloud& a, const kernels::PointCloud& b) {
  if (a.size() == 0 || b.size() == 0) throw std::invalid_argument("position_of_origin: an empty body");
  if (a.exponent() != b.exponent())
    throw std::invalid_argument("position_of_origin: the clouds differ in their exponents");
  Differences differences{a, b};
  ConeSearch cone(differences);
  PositionOfOrigin answer;
  const ConeSearch::Nearest origin = cone.nearest({{0, 0, 0}, 1}, 1, {{0, 0}});
  if (!is_zero(origin.residual.v)) {
    answer.normal = primitive(origin.residual.v);
  } else {
    answer.a = weights_of(origin.support, origin.weights, &Difference::first);
    answer.b = weights_of(origin.support, origin.weights, &Difference::second);
    decide_interior(answer, differences, cone, origin.support);
  }
  answer.scans = differences.scans;
  return answer;
}

kernels::Report validate(const PositionOfOrigin& answer, std::span<const Vector> a, std::span<const Vector> b) {
  kernels::Report report;
  if (!report.expect(!a.empty() && !b.empty(), "an empty body")) return report;
  const bool inside = answer.position == Position::inside, outside = answer.position == Position::outside;
  if (inside) report.expect(!answer.normal, "a point of the interior has no normal");
  else expect_normal(report, answer, a, b);
  if (outside) report.expect(answer.a.empty() && answer.b.empty(), "disjoint bodies have no common point");
  else expect_common_point(report, answer, a, b);
  if (inside) expect_surrounding(report, answer, a, b);
  else report.expect(answer.surrounding.empty(), "differences surround O though it is not inside");
  return report;
}

}  // namespace fathom::polytope
