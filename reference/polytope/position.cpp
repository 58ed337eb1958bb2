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
template <class Integer>
struct Lifted {
  Vec3<Integer> v;
  Integer w;
};

/// <g, h> in R^4.
template <class Integer>
Integer dot(const Lifted<Integer>& g, const Lifted<Integer>& h) {
  return Integer(g.w * h.w + dot(g.v, h.v));
}

/// The point of a cone that is nearest to a target, as a combination with positive weights; exact.
template <class Integer>
struct NearestInCone {
  std::vector<std::size_t> support;  ///< indices of the generators that it combines, ascending
  std::vector<Integer> weights;      ///< > 0, one for each of them, over `denominator`
  Integer denominator = 1;           ///< > 0
  Lifted<Integer> residual;          ///< a positive multiple of target - nearest
};

constexpr std::size_t most = 4;
/// Products of generators; the last column holds those with the target.
template <class Integer>
using Matrix = std::array<std::array<Integer, most + 1>, most>;

template <class Integer>
Matrix<Integer> gram(std::span<const Lifted<Integer>> generators, const Lifted<Integer>& target) {
  const std::size_t n = generators.size();
  Matrix<Integer> m;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) m[i][j] = m[j][i] = dot(generators[i], generators[j]);
    m[i][most] = dot(generators[i], target);
  }
  return m;
}

template <class Integer>
struct Solution {
  std::vector<Integer> numerators;
  Integer determinant = 1;
};

/// The determinant of the first `size` rows of m in these columns, along the first of them.
template <class Integer>
Integer determinant(const Matrix<Integer>& m, std::span<const std::size_t> rows, std::span<const std::size_t> columns) {
  if (columns.size() == 1) return m[rows[0]][columns[0]];
  if (columns.size() == 2)
    return Integer(m[rows[0]][columns[0]] * m[rows[1]][columns[1]] - m[rows[0]][columns[1]] * m[rows[1]][columns[0]]);
  Integer sum = 0;
  std::array<std::size_t, most> rest{};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    std::remove_copy(columns.begin(), columns.end(), rest.begin(), columns[k]);
    const Integer term = m[rows[0]][columns[k]] * determinant(m, rows.subspan(1), {rest.data(), columns.size() - 1});
    sum = k % 2 == 0 ? Integer(sum + term) : Integer(sum - term);
  }
  return sum;
}

// The weights of the projection onto the span of `support`, by Cramer's rule: no number is longer
// than the determinant of a Gram matrix, but for sums of few. Such a matrix of independent vectors
// is positive definite, and so its determinant is positive.
template <class Integer>
Solution<Integer> project(const Matrix<Integer>& gram, const std::vector<std::size_t>& support) {
  Solution<Integer> s;
  s.determinant = determinant<Integer>(gram, support, support);
  for (std::size_t i = 0; i < support.size(); ++i) {
    std::vector<std::size_t> columns = support;
    columns[i] = most;
    s.numerators.push_back(determinant<Integer>(gram, support, columns));
  }
  return s;
}

// Short numbers make a search in integers of any size faster. Those of fixed size are long enough,
// and only the sign of what follows matters.
void divide_by_common_divisor(Lifted<mpz_class>& g) {
  const mpz_class d = gcd(gcd(gcd(g.w, g.v.x), g.v.y), g.v.z);
  if (d <= 1) return;
  for (mpz_class* c : {&g.v.x, &g.v.y, &g.v.z, &g.w}) mpz_divexact(c->get_mpz_t(), c->get_mpz_t(), d.get_mpz_t());
}
template <class Integer>
void divide_by_common_divisor(Lifted<Integer>&) {}

// determinant * target - sum of numerators * generators.
template <class Integer>
Lifted<Integer> residual(std::span<const Lifted<Integer>> generators, const Lifted<Integer>& target,
                         const std::vector<std::size_t>& support, const Solution<Integer>& s) {
  Lifted<Integer> r{s.determinant * target.v, Integer(s.determinant * target.w)};
  for (std::size_t i = 0; i < support.size(); ++i) {
    const Lifted<Integer>& g = generators[support[i]];
    r.v = r.v - s.numerators[i] * g.v;
    r.w = Integer(r.w - s.numerators[i] * g.w);
  }
  divide_by_common_divisor(r);
  return r;
}

template <class Integer>
bool reaches_none(const Lifted<Integer>& residual, std::span<const Lifted<Integer>> generators, unsigned subset) {
  for (std::size_t i = 0; i < generators.size(); ++i)
    if ((subset >> i & 1U) == 0 && sgn(dot(residual, generators[i])) > 0) return false;
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
template <class Integer>
NearestInCone<Integer> nearest_in_cone(std::span<const Lifted<Integer>> generators, const Lifted<Integer>& target) {
  const std::size_t n = generators.size();
  if (n == 0 || n > most) throw std::logic_error("nearest_in_cone: one to four generators expected");
  const Matrix<Integer> products = gram(generators, target);
  const unsigned last = 1U << (n - 1), all = 2 * last - 1;
  for (int size = static_cast<int>(n); size > 0; --size) {
    for (unsigned subset = last; subset <= all; ++subset) {
      if (std::popcount(subset) != size) continue;
      NearestInCone<Integer> z;
      for (std::size_t i = 0; i < n; ++i)
        if (subset >> i & 1U) z.support.push_back(i);
      Solution<Integer> s = project(products, z.support);
      if (!std::ranges::all_of(s.numerators, [](const Integer& w) { return sgn(w) > 0; })) continue;
      z.residual = residual(generators, target, z.support, s);
      if (!reaches_none(z.residual, generators, subset)) continue;
      z.weights = std::move(s.numerators);
      z.denominator = std::move(s.determinant);
      return z;
    }
  }
  throw std::logic_error("nearest_in_cone: the last generator is not needed, or the generators are dependent");
}

/// A point of the cone that some vectors (p, s) span, p a difference, and the residual of a target.
template <class Integer>
struct NearestInSearch {
  std::vector<Difference> support;
  std::vector<Integer> weights;  ///< > 0, over `denominator`
  Integer denominator = 1;
  Lifted<Integer> residual;  ///< zero if the target is in the cone; else a proof that it is not, see below
};

/// Searches the cone that all differences of two clouds span for the point nearest to a target,
/// without listing the differences.
template <class Body>
class ConeSearch {
 public:
  using Integer = IntegerOf<Body>;
  using Nearest = NearestInSearch<Integer>;

  explicit ConeSearch(DifferencesOf<Body>& differences) : differences_(differences) {}

  /// Searches the cone of all (p, lift), p a difference, for `target`. If the target is not in it,
  /// the residual r is a positive multiple of target - nearest: <r, target> > 0 and <r, (p, lift)>
  /// <= 0 for every p. With lift = 1 and target (0, 1) the search stops early, with some r such
  /// that <r.v, p> < 0 for every p. `seeds`: some differences, at least one. Unless lift = 1, O
  /// must be a positive combination of them. Expected time linear in the number of points.
  ///                                                                           [proofs/position.md]
  Nearest nearest(const Lifted<Integer>& target, int lift, const std::vector<Difference>& seeds);

 private:
  template <class OtherBody>
  friend class ConeSearch;
  ConeSearch(DifferencesOf<Body>& sample, std::uint64_t seed) : differences_(sample), seed_(seed), sample_(true) {}
  Nearest nearest_directly(const Lifted<Integer>& target, int lift);
  Nearest nearest_by_sampling(const Lifted<Integer>& target, int lift, const std::vector<Difference>& seeds);

  DifferencesOf<Body>& differences_;
  std::uint64_t seed_ = 0;  // fixed for a whole problem: the same input gives the same answer
  bool sample_ = false;     // of a larger problem: then the search may not stop early
};

// Small problems: an active-set method (Wolfe; Lawson and Hanson; in the lifted form the exact kin
// of Gilbert, Johnson and Keerthi). Large ones: Clarkson's sampling for problems of
// linear-programming type, which calls itself on samples of O(sqrt n) points.

// Of more points, a sample with all forced points is at most 24 sqrt(n) + 26 < n.
constexpr std::size_t small_enough = most_points_without_samples;
constexpr std::size_t basis_size = 8;  // points: at most four differences make the answer

template <class Integer>
bool is_zero(const Lifted<Integer>& g) {
  return is_zero(g.v) && sgn(g.w) == 0;
}

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

template <class Body>
typename ConeSearch<Body>::Nearest ConeSearch<Body>::nearest(const Lifted<Integer>& target, int lift,
                                                             const std::vector<Difference>& seeds) {
  if (differences_.a.size() + differences_.b.size() <= small_enough) return nearest_directly(target, lift);
  return nearest_by_sampling(target, lift, seeds);
}

template <class Body>
typename ConeSearch<Body>::Nearest ConeSearch<Body>::nearest_directly(const Lifted<Integer>& target, int lift) {
  Nearest z;
  z.residual = target;
  std::vector<Lifted<Integer>> generators;  // of z.support
  while (!is_zero(z.residual)) {
    const Difference d = differences_.extreme(z.residual.v);
    generators.push_back({differences_[d], lift});
    z.support.push_back(d);
    const bool separated = lift == 1 && !sample_ && sgn(dot(z.residual.v, generators.back().v)) < 0;
    if (separated || sgn(dot(z.residual, generators.back())) <= 0) {
      z.support.pop_back();
      break;
    }
    NearestInCone<Integer> next = nearest_in_cone<Integer>(generators, target);
    for (std::size_t i = 0; i < next.support.size(); ++i) {
      std::swap(generators[i], generators[next.support[i]]);
      std::swap(z.support[i], z.support[next.support[i]]);
    }
    generators.resize(next.support.size());
    z.support.resize(next.support.size());
    z.weights = std::move(next.weights);
    z.denominator = std::move(next.denominator);
    z.residual = std::move(next.residual);
  }
  return z;
}

template <class Body>
typename ConeSearch<Body>::Nearest ConeSearch<Body>::nearest_by_sampling(const Lifted<Integer>& target, int lift,
                                                                         const std::vector<Difference>& seeds) {
  if constexpr (!std::is_same_v<Integer, mpz_class>) {
    throw std::invalid_argument("position_of_origin: more points than integers of fixed size are for");
  } else {
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
}

// Independent vectors that span the same space.
template <class Integer>
std::vector<Vec3<Integer>> basis(const std::vector<Vec3<Integer>>& vectors) {
  std::vector<Vec3<Integer>> chosen;
  for (const Vec3<Integer>& v : vectors) {
    const bool independent = chosen.empty()       ? !is_zero(v)
                             : chosen.size() == 1 ? !is_zero(cross(chosen[0], v))
                             : chosen.size() == 2 ? sgn(det(chosen[0], chosen[1], v)) != 0
                                                  : false;
    if (independent) chosen.push_back(v);
  }
  return chosen;
}

// A nonzero vector orthogonal to at most two independent ones.
template <class Integer>
Vec3<Integer> normal_to(const std::vector<Vec3<Integer>>& independent) {
  if (independent.empty()) return {1, 0, 0};
  if (independent.size() == 2) return cross(independent[0], independent[1]);
  const Vec3<Integer> v = cross(independent[0], Vec3<Integer>{1, 0, 0});
  return is_zero(v) ? cross(independent[0], Vec3<Integer>{0, 1, 0}) : v;
}

// Whether O is in the interior of the hull: no u != 0 has <u, p> <= 0 for all p. If the vectors
// span R^3 but such u exist, they form a cone without lines; on one of its extreme rays two
// independent constraints are tight, so u is normal to two of the vectors.
template <class Integer>
bool surrounds(const std::vector<Vec3<Integer>>& vectors) {
  if (basis(vectors).size() < 3) return false;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3<Integer> u = cross(vectors[i], vectors[j]);
      if (is_zero(u)) continue;
      bool above = false, below = false;
      for (std::size_t k = 0; k < vectors.size() && !(above && below); ++k) {
        const int side = sgn(dot(u, vectors[k]));
        above = above || side > 0;
        below = below || side < 0;
      }
      if (!(above && below)) return false;
    }
  }
  return true;
}

template <class Body>
std::vector<Vec3<IntegerOf<Body>>> vectors_of(const std::vector<Difference>& list,
                                              const DifferencesOf<Body>& differences) {
  std::vector<Vec3<IntegerOf<Body>>> vectors;
  for (const Difference& d : list) vectors.push_back(differences[d]);
  return vectors;
}

// Drops what the rest can do without; by Steinitz at most six remain.
template <class Body>
std::vector<Difference> irredundant(std::vector<Difference> surrounding, const DifferencesOf<Body>& differences) {
  for (std::size_t i = surrounding.size(); surrounding.size() > 4 && i-- > 0;) {
    std::vector<Difference> rest = surrounding;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    if (surrounds(vectors_of(rest, differences))) surrounding = std::move(rest);
  }
  std::sort(surrounding.begin(), surrounding.end());
  return surrounding;
}

// Given O in the relative interior of the hull of `around`: decides between inside and boundary.
template <class Body>
void decide_interior(PositionOfOrigin& answer, DifferencesOf<Body>& differences, ConeSearch<Body>& cone,
                     std::vector<Difference> around) {
  using Integer = IntegerOf<Body>;
  while (true) {
    const std::vector<Vec3<Integer>> spanned = basis(vectors_of(around, differences));
    if (spanned.size() == 3) {
      answer.position = Position::inside;
      answer.surrounding = irredundant(std::move(around), differences);
      return;
    }
    answer.position = Position::boundary;
    const Vec3<Integer> normal = normal_to(spanned);
    answer.normal = primitive(to_vector(normal));
    const Difference d = differences.extreme(normal);
    const Vec3<Integer> q = differences[d];
    if (sgn(dot(normal, q)) == 0) return;
    typename ConeSearch<Body>::Nearest back = cone.nearest({-q, 0}, 0, around);
    if (!is_zero(back.residual.v)) {
      answer.normal = primitive(to_vector(back.residual.v));
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

template <class Body>
PositionOfOrigin position_of_origin(DifferencesOf<Body> differences) {
  require_bodies(differences, "position_of_origin");
  ConeSearch<Body> cone(differences);
  PositionOfOrigin answer;
  const auto origin = cone.nearest({{0, 0, 0}, 1}, 1, {{0, 0}});
  if (!is_zero(origin.residual.v)) {
    answer.normal = primitive(to_vector(origin.residual.v));
  } else {
    answer.a = weights_of(origin.support, origin.weights, origin.denominator, &Difference::first);
    answer.b = weights_of(origin.support, origin.weights, origin.denominator, &Difference::second);
    decide_interior(answer, differences, cone, origin.support);
  }
  answer.scans = differences.scans;
  return answer;
}
template PositionOfOrigin position_of_origin(Differences);
template PositionOfOrigin position_of_origin(DifferencesIn<NarrowInteger>);

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
