// SPDX-License-Identifier: GPL-3.0-or-later
// The vertex test's filter: is one vertex difference s of P so far out at the four corner crossings of a block of lines that the whole
// block lies beyond a bound? u -> <s,u> - rho |u| is concave, and all crossings of the block lie in the cone of its corners.
// [proofs/cutting.md]
#pragma once

#include "kernels/filters/line_filter.hpp"

namespace fathom::kernels {

/// A squared distance in the images' units, enclosed.
struct LineBound {
  double above = 0;  ///< as image_bound; +infinity allowed
  double below = 0;
};
LineBound line_bound(const mpz_class& numerator, const mpz_class& denominator, long exponent);

/// What the vertex test reads of some lines of a chain: the first, the last and one between.
struct BlockSide {
  std::size_t first, middle, last;
};

/// Some rows and some columns.
struct Block {
  BlockSide rows, columns;
};

inline BlockSide side_of(LineRun run) { return {run.first, run.first + run.size() / 2, run.last - 1}; }

enum class CornerVerdict { beyond, within, unsure };

/// With s = q - p for the points q of the middle column and p of the middle row, and w = d x e for the directions d of the first and the
/// last row and e of the first and the last column: `beyond` proves <s,w> > 0 and <s,w>^2 > bound |w|^2 for all four w; `within` proves
/// that this fails for one. w = 0 is never beyond.
CornerVerdict corners_beyond(const LineImages& rows, const LineImages& columns, const Block& block, const LineBound& bound);

/// An estimate, without any guarantee, of <q - p, w>^2 / |w|^2 for lines i and j: what orders a search.
double estimated_squared_distance(const LineImages& a, std::size_t i, const LineImages& b, std::size_t j);

}  // namespace fathom::kernels
