// SPDX-License-Identifier: GPL-3.0-or-later
// The vertex test's filter: is one vertex difference s of P so far out at the four corner crossings of a block of lines that the whole
// block lies beyond a bound? u -> <s,u> - rho |u| is concave, and all crossings of the block lie in the cone of its corners.
// [proofs/cutting.md]
#pragma once

#include <cstddef>

#include "kernels/filters/line_scan.hpp"

namespace fathom {

/// A squared distance in the images' units, enclosed.
struct LineBound {
  double above = 0;  ///< as image_bound; +infinity allowed
  double below = 0;
};
LineBound line_bound(const mpz_class& numerator, const mpz_class& denominator, long exponent);

/// Lines [first, last) of one set; not empty.
struct LineRun {
  std::size_t first, last;

  [[nodiscard]] std::size_t size() const { return last - first; }
  [[nodiscard]] std::size_t middle() const { return first + size() / 2; }
  friend bool operator==(const LineRun&, const LineRun&) = default;
};

enum class CornerVerdict { beyond, within, unsure };

/// With s = q - p for the points q of line `of_b` of b and p of line `of_a` of a, and w = d x e for the directions of the first and the
/// last lines of both runs: `beyond` proves <s,w> > 0 and <s,w>^2 > bound |w|^2 for all four w; `within` proves that this fails for one.
/// w = 0 is never beyond.
CornerVerdict corners_beyond(const LineImages& a, LineRun run_a, std::size_t of_a, const LineImages& b, LineRun run_b, std::size_t of_b,
                             const LineBound& bound);

/// An estimate, without any guarantee, of <q - p, w>^2 / |w|^2 for lines i and j: what orders a search.
double estimated_squared_distance(const LineImages& a, std::size_t i, const LineImages& b, std::size_t j);

}  // namespace fathom
