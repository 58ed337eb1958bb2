// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/closest_lines.hpp"

#include <limits>

namespace fathom {
namespace {

// The scan of one canonical pair, with buffers that live as long as the whole family's.
class PairScan {
 public:
  PairScan(const EdgeLines& a, const EdgeLines& b, NearestPlanes& nearest, Counters& counters)
      : a_(a), b_(b), nearest_(nearest), counters_(counters) {
    tighten();
  }

  void scan(const CanonicalPair& pair) {
    const std::span<const std::uint32_t> of_a = pair.edges_of_a(), of_b = pair.edges_of_b();
    counters_.pairs_evaluated += static_cast<std::uint64_t>(of_a.size()) * of_b.size();
    // The longer side runs in the inner loop.
    if (of_a.size() <= of_b.size()) {
      block_.gather(b_.images(), of_b);
      for (const std::uint32_t e : of_a) {
        not_farther(a_.images(), e, block_, bound_, unsure_);
        for (const std::uint32_t k : unsure_) decide(e, of_b[k]);
      }
    } else {
      block_.gather(a_.images(), of_a);
      for (const std::uint32_t f : of_b) {
        not_farther(b_.images(), f, block_, bound_, unsure_);
        for (const std::uint32_t k : unsure_) decide(of_a[k], f);
      }
    }
  }

 private:
  void decide(std::uint32_t e, std::uint32_t f) {
    ++counters_.pairs_exact;
    if (offer_edges(a_, e, b_, f, nearest_)) tighten();
  }

  void tighten() {
    bound_ = nearest_.empty() ? std::numeric_limits<double>::infinity()
                              : image_bound(nearest_.numerator(), nearest_.denominator(), a_.images().exponent());
  }

  const EdgeLines& a_;
  const EdgeLines& b_;
  NearestPlanes& nearest_;
  Counters& counters_;
  LineImages block_;
  std::vector<std::uint32_t> unsure_;
  double bound_ = 0;
};

}  // namespace

EdgeLines::EdgeLines(const Polytope& polytope, long exponent) : polytope_(&polytope), images_(exponent) {
  for (std::uint32_t i = 0; i < size(); ++i) images_.push_back(point(i), direction(i));
}

Vector EdgeLines::direction(std::uint32_t edge) const {
  const Edge& e = polytope_->edges[edge];
  return polytope_->vertices[e.to] - polytope_->vertices[e.from];
}

bool offer_edges(const EdgeLines& a, std::uint32_t of_a, const EdgeLines& b, std::uint32_t of_b, NearestPlanes& nearest) {
  const Vector w = cross(a.direction(of_a), b.direction(of_b));
  if (is_zero(w)) return false;
  const mpz_class height = dot(b.point(of_b) - a.point(of_a), w);
  return height > 0 ? nearest.offer(w, height) : nearest.offer(-w, mpz_class(-height));
}

bool closest_lines(const CanonicalSubsets& subsets, const EdgeLines& a, const EdgeLines& b, NearestPlanes& nearest, Counters& counters,
                   const std::function<bool(double)>& keep_going) {
  PairScan scan(a, b, nearest, counters);
  for (std::size_t i = 0; i < subsets.size(); ++i) {
    if (keep_going && i % 1024 == 0 && !keep_going(static_cast<double>(i) / static_cast<double>(subsets.size()))) return false;
    scan.scan(subsets[i]);
  }
  return true;
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
