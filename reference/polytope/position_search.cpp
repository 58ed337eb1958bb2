// SPDX-License-Identifier: GPL-3.0-or-later
// Small problems: an active-set method (Wolfe; Lawson and Hanson; in the lifted form the exact kin of Gilbert, Johnson and Keerthi).
// Large ones: Clarkson's sampling for problems of linear-programming type, which calls itself on samples of O(sqrt n) points.
#include "reference/polytope/position_search.hpp"

#include <random>

#include "kernels/number/rational.hpp"

namespace fathom::polytope {
namespace {

constexpr std::size_t small_enough = 2000;  // points; of more, a sample with all forced points is at most 24 sqrt(n) + 26 < n
constexpr std::size_t basis_size = 8;       // points: at most four differences make the answer

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

void draw(Selection& selection, const kernels::PointCloud& a, const kernels::PointCloud& b, std::size_t how_many, std::mt19937_64& random) {
  for (; how_many > 0; --how_many) {
    const std::uint64_t i = random() % (a.size() + b.size());
    if (i < a.size()) selection.a.push_back(static_cast<std::uint32_t>(i));
    else selection.b.push_back(static_cast<std::uint32_t>(i - a.size()));
  }
}

void append(std::vector<std::uint32_t>& to, const std::vector<std::uint32_t>& more) { to.insert(to.end(), more.begin(), more.end()); }

}  // namespace

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

ConeSearch::Nearest ConeSearch::nearest_by_sampling(const Lifted& target, int lift, const std::vector<Difference>& seeds) {
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
    const kernels::PointCloud a(picked(all_a, chosen.a), all_a.exponent()), b(picked(all_b, chosen.b), all_b.exponent());
    Differences sample{a, b};
    Nearest z = ConeSearch(sample, random()).nearest(target, lift, local_seeds);
    for (Difference& d : z.support) d = {chosen.a[d.first], chosen.b[d.second]};
    if (is_zero(z.residual)) return z;

    // The residual is orthogonal to its support, and to the seeds if there is none: they mark the greatest value in the sample.
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

}  // namespace fathom::polytope
