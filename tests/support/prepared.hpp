// SPDX-License-Identifier: GPL-3.0-or-later
// A case on its way through the rooms, up to the charts, for tests that begin in the middle.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "reference/chart/chart.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "verify/families/families.hpp"
#include "verify/families/random.hpp"

namespace fathom::testing {

/// The sentences of a report, for the message of a failed expectation.
inline std::string text(const kernels::Report& report) {
  std::string result;
  for (const std::string& fault : report.faults) result += fault + "\n";
  return result;
}

inline polytope::Polytope hull_of(const Body& body) { return polytope::hull_of(body.points); }

/// The kernel of the charts; nobody reads its counts.
inline kernels::PerturbedKernel kernel_of(const chart::Charts& charts) {
  static PredicateCounts uncounted;
  return {charts.perturbation, uncounted};
}

/// Points, hulls, diagrams, and the charts of both hemispheres. Charts refer to the diagrams, hence
/// the pointer.
struct Prepared {
  polytope::PlacedPair placed;
  long exponent;
  polytope::Polytope a, b;
  gaussian::GaussianDiagram minus_a, of_b;
  std::vector<chart::Charts> charts;
  kernels::Context context;  // of the charts, and of what the test does with them
};

inline std::unique_ptr<Prepared> prepare(const Case& input, const kernels::Perturbation& perturbation = {}) {
  auto p = std::make_unique<Prepared>();
  p->placed = polytope::place(input.a.points, input.b.points);
  p->exponent = p->placed.exponent();
  p->a = polytope::convex_hull(p->placed.a.points());
  p->b = polytope::convex_hull(p->placed.b.points());
  p->minus_a = gaussian::gaussian_diagram_of_reflection(p->a);
  p->of_b = gaussian::gaussian_diagram(p->b);
  for (const chart::Hemisphere h : chart::both_hemispheres)
    p->charts.push_back(chart::make_charts(p->context, p->minus_a, p->of_b, chart::chart_frame(h), perturbation));
  return p;
}

/// Cases 1 to `seeds` of every family, of one size.
inline std::vector<Case> cases_of_all_families(unsigned seeds, unsigned size) {
  std::vector<Case> cases;
  for (const families::Family& family : families::families()) {
    for (unsigned seed = 1; seed <= seeds; ++seed) cases.push_back(family.make(seed, size));
  }
  return cases;
}

/// A few ways to resolve coincidences: any order of the infinitesimals, any signs. The first is the
/// usual one.
inline std::vector<kernels::Perturbation> perturbations() {
  std::vector<kernels::Perturbation> result(4);
  std::ranges::reverse(result[1].rank);
  result[2].sign.fill(-1);
  families::Random random(7);
  for (std::size_t i = kernels::infinitesimals; i > 1; --i)
    std::swap(result[3].rank[i - 1], result[3].rank[random.next() % i]);
  for (std::int8_t& sign : result[3].sign) sign = random.coin() ? 1 : -1;
  return result;
}

}  // namespace fathom::testing
