// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "reference/lines/grid.hpp"

namespace fathom::lines {
namespace {

// The vertex test in exact arithmetic.
bool exact_corners_clear(const Grid& grid, const kernels::Block& block, const kernels::NearestPlanes& nearest) {
  const Vector s = grid.column_point(block.columns.middle) - grid.row_point(block.rows.middle);
  for (const std::size_t i : {block.rows.first, block.rows.last}) {
    const Vector d = grid.row_direction(i);
    for (const std::size_t j : {block.columns.first, block.columns.last}) {
      const Vector w = cross(d, grid.column_direction(j));
      if (!nearest.nearer_than(w, dot(s, w))) return false;
    }
  }
  return true;
}

// The filter's verdict on the block, or exact arithmetic's where the filter is unsure.
bool clear(kernels::CornerVerdict verdict, const Grid& grid, const kernels::Block& block, const kernels::NearestPlanes& nearest) {
  return verdict == kernels::CornerVerdict::unsure ? exact_corners_clear(grid, block, nearest) : verdict == kernels::CornerVerdict::beyond;
}

}  // namespace

bool Clearing::vertex_clears(const kernels::Block& block, const kernels::NearestPlanes& nearest, const kernels::LineBound& bound) const {
  return clear(kernels::corners_beyond(rows_, columns_, block, bound), grid_, block, nearest);
}

double Clearing::estimate(const kernels::Block& block) const {
  double least = kernels::estimated_squared_distance(rows_, block.rows.middle, columns_, block.columns.middle);
  for (const std::size_t i : {block.rows.first, block.rows.last}) {
    for (const std::size_t j : {block.columns.first, block.columns.last}) {
      least = std::min(least, kernels::estimated_squared_distance(rows_, i, columns_, j));
    }
  }
  return least;
}

bool vertex_clears(const Grid& grid, const kernels::NearestPlanes& nearest, const kernels::LineBound& bound) {
  const kernels::Block whole{kernels::side_of(kernels::LineRun{0, grid.rows()}), kernels::side_of(kernels::LineRun{0, grid.columns()})},
      three{{0, 1, 2}, {0, 1, 2}};
  const kernels::LineImages rows = grid.row_images({whole.rows.first, whole.rows.middle, whole.rows.last}),
                            columns = grid.column_images({whole.columns.first, whole.columns.middle, whole.columns.last});
  return clear(kernels::corners_beyond(rows, columns, three, bound), grid, whole, nearest);
}

}  // namespace fathom::lines
