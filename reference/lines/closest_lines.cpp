// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/closest_lines.hpp"

#include <algorithm>

#include "reference/lines/cutting.hpp"
#include "reference/lines/sampled.hpp"

namespace fathom {
namespace {

// Up to so many pairs are scanned without asking the vertex test first.
constexpr std::uint64_t tiny = 64;
// Of each large pair, the crossings of about so many rows with as many columns are looked at first.
constexpr std::size_t stride_lines = 32;

// Every k-th edge, for about stride_lines of them.
std::vector<std::uint32_t> strided(std::span<const std::uint32_t> edges, std::mt19937_64& random) {
  const std::size_t step = std::max<std::size_t>(1, edges.size() / stride_lines);
  std::vector<std::uint32_t> chosen;
  for (std::size_t i = random() % step; i < edges.size(); i += step) chosen.push_back(edges[i]);
  return chosen;
}

// One global best over all canonical pairs: small pairs first, then the large ones, promising ones first.
class Family {
 public:
  Family(const CanonicalSubsets& subsets, const Charts& charts, const EdgeLines& a, const EdgeLines& b, LineSearch& search,
         const ClosestLinesOptions& options)
      : subsets_(subsets), charts_(charts), a_(a), b_(b), search_(search), options_(options) {}

  bool run() {
    if (!search_.proceed(0)) return false;
    std::uint64_t lines = 0;
    for (std::size_t i = 0; i < subsets_.size(); ++i) lines += lines_of(i);
    std::uint64_t done = 0;
    const auto proceed = [&](std::size_t i) {
      done += lines_of(i);
      return i % 64 != 0 || search_.proceed(static_cast<double>(done) / static_cast<double>(lines));
    };
    std::vector<Promise> large;
    for (std::size_t i = 0; i < subsets_.size(); ++i) {
      if (search_.stopped()) return false;
      if (!start(i)) {
        if (!proceed(i)) return false;
      } else if (!clears(i)) {
        large.push_back({promise(i), i});
      }
    }
    std::ranges::sort(large, {}, [](const Promise& p) { return std::pair(p.squared, p.pair); });
    for (const Promise& p : large) {
      if (!clears(p.pair)) cut(p.pair);
      if (search_.stopped() || !proceed(p.pair)) return false;
    }
    return true;
  }

 private:
  struct Promise {
    double squared;
    std::size_t pair;
  };

  std::uint64_t lines_of(std::size_t i) const { return subsets_[i].stored.size() + subsets_[i].queries.size(); }

  Grid grid(std::size_t i) const { return Grid(subsets_[i], charts_, a_, b_); }

  bool clears(std::size_t i) { return vertex_clears(grid(i), search_.nearest(), search_.bound()); }

  // Deals with a pair that is small; tells whether it is large.
  bool start(std::size_t i) {
    const CanonicalPair pair = subsets_[i];
    const std::uint64_t pairs = static_cast<std::uint64_t>(pair.stored.size()) * pair.queries.size();
    if (pairs > options_.scanned) return true;
    if (pairs <= tiny || !clears(i)) search_.scan(pair.edges_of_a(), pair.edges_of_b());
    return false;
  }

  // Looks at a part of the pair, and estimates how near its nearest crossing is.
  double promise(std::size_t i) {
    const CanonicalPair pair = subsets_[i];
    const std::vector<std::uint32_t> of_a = strided(pair.edges_of_a(), search_.random()),
                                     of_b = strided(pair.edges_of_b(), search_.random());
    search_.scan(of_a, of_b);
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t e : of_a) {
      for (const std::uint32_t f : of_b) least = std::min(least, estimated_squared_distance(a_.images(), e, b_.images(), f));
    }
    return least;
  }

  void cut(std::size_t i) {
    const Grid g = grid(i);
    if (options_.engine == ClosestLines::cutting) {
      closest_by_cutting(g, search_, options_.cutting_size);
    } else {
      closest_by_sampling(g, search_, options_.sampled_size);
    }
  }

  const CanonicalSubsets& subsets_;
  const Charts& charts_;
  const EdgeLines& a_;
  const EdgeLines& b_;
  LineSearch& search_;
  const ClosestLinesOptions& options_;
};

bool scan_all(const CanonicalSubsets& subsets, LineSearch& search) {
  for (std::size_t i = 0; i < subsets.size(); ++i) {
    if (i % 1024 == 0 && !search.proceed(static_cast<double>(i) / static_cast<double>(subsets.size()))) return false;
    search.scan(subsets[i].edges_of_a(), subsets[i].edges_of_b());
    if (search.stopped()) return false;
  }
  return true;
}

}  // namespace

bool closest_lines(const CanonicalSubsets& subsets, const Charts& charts, const EdgeLines& a, const EdgeLines& b, NearestPlanes& nearest,
                   Counters& counters, const ClosestLinesOptions& options) {
  LineSearch search(a, b, nearest, counters, options.keep_going, options.seed);
  if (options.engine == ClosestLines::naive) return scan_all(subsets, search);
  return Family(subsets, charts, a, b, search, options).run();
}

Report validate_separation(const CanonicalSubsets& subsets, const EdgeLines& a, const EdgeLines& b, const Vector& z) {
  Report report;
  for (std::size_t k = 0; k < subsets.size(); ++k) {
    const CanonicalPair pair = subsets[k];
    for (const std::uint32_t e : pair.edges_of_a()) {
      for (const std::uint32_t f : pair.edges_of_b()) {
        const Vector w = cross(a.direction(e), b.direction(f));
        const mpz_class height = dot(b.point(f) - a.point(e), w);
        report.expect(sgn(height) * sgn(dot(w, z)) >= 0 && (is_zero(w) || height != 0),
                      "C4: edge " + std::to_string(f) + " of B is not above edge " + std::to_string(e) + " of A");
      }
    }
  }
  return report;
}

}  // namespace fathom
