// SPDX-License-Identifier: GPL-3.0-or-later
// Many small bodies in binary64, as a physics engine has them: one workspace for all, no rationals
// on the way, and a proof of each answer.
#include <array>
#include <fathom/certificate.hpp>
#include <fathom/check.hpp>
#include <fathom/depth.hpp>
#include <fathom/numbers.hpp>
#include <iostream>
#include <vector>

using Points = std::vector<std::array<double, 3>>;

Points box(double x, double y, double z) {
  Points corners;
  for (const double i : {0.0, 1.0})
    for (const double j : {0.0, 1.0})
      for (const double k : {0.0, 1.0}) corners.push_back({x + i, y + j, z + k});
  return corners;
}

int main() {
  fathom::Workspace workspace;
  fathom::Options options;
  options.workspace = &workspace;
  const Points a = box(0, 0, 0);
  for (const double x : {0.25, 0.9, 0.999}) {
    const Points b = box(x, 0.1, 0.1);
    const fathom::Depth depth = fathom::penetration_depth(a, b, options);
    const std::string proof = fathom::certificate_text(a, b, depth);
    std::cout << fathom::root_binary64(depth.squared())
              << (fathom_check::verify(proof).accepted() ? ", proved" : ", refused") << "\n";
  }
}

//> 0.75, proved
//> 0.1, proved
//> 0.001, proved
