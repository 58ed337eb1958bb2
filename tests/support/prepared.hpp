// SPDX-License-Identifier: GPL-3.0-or-later
// A case on its way through the rooms, up to the charts, for tests that begin in the middle.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kernels/support.hpp"
#include "reference/chart/chart.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "verify/families/families.hpp"

namespace fathom::testing {

/// The sentences of a report, for the message of a failed expectation.
inline std::string text(const Report& report) {
  std::string result;
  for (const std::string& fault : report.faults) result += fault + "\n";
  return result;
}

/// Lattice, hulls, diagrams, and the charts of both hemispheres. Charts refer to the diagrams, hence the pointer.
struct Prepared {
  Lattice lattice;
  long exponent;
  Polytope a, b;
  GaussianDiagram minus_a, of_b;
  std::vector<Charts> charts;
};

inline std::unique_ptr<Prepared> prepare(const Case& input) {
  auto p = std::make_unique<Prepared>();
  p->lattice = common_lattice(input.a.points, input.b.points);
  p->exponent = std::max(binary_exponent(p->lattice.a), binary_exponent(p->lattice.b));
  p->a = convex_hull(p->lattice.a);
  p->b = convex_hull(p->lattice.b);
  p->minus_a = gaussian_diagram_of_reflection(p->a);
  p->of_b = gaussian_diagram(p->b);
  for (unsigned attempt = 0; p->charts.size() < 2; ++attempt) {
    p->charts.clear();
    for (const bool lower : {false, true}) {
      std::optional<Charts> charts = make_charts(p->minus_a, p->of_b, chart_frame(attempt, lower));
      if (charts) p->charts.push_back(std::move(*charts));
    }
  }
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


}  // namespace fathom::testing
