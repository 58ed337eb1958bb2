// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/clearing.hpp"

#include <algorithm>
#include <array>

namespace fathom {
namespace {

std::uint32_t middle(Clearing::Lines lines) { return lines[lines.size() / 2]; }

LineRun span_of(Clearing::Lines lines) { return {lines.front(), std::size_t{lines.back()} + 1}; }

// The vertex test in exact arithmetic, on the corners and the middle lines of a block.
bool exact_corners_clear(const Grid& grid, LineRun rows, std::size_t of_row, LineRun columns, std::size_t of_column,
                         const NearestPlanes& nearest) {
  const Vector s = grid.column_point(of_column) - grid.row_point(of_row);
  for (const std::size_t i : {rows.first, rows.last - 1}) {
    const Vector d = grid.row_direction(i);
    for (const std::size_t j : {columns.first, columns.last - 1}) {
      const Vector w = cross(d, grid.column_direction(j));
      if (!nearest.nearer_than(w, dot(s, w))) return false;
    }
  }
  return true;
}

// The filter's verdict on the block, or exact arithmetic's where it has none.
bool clear(CornerVerdict verdict, const Grid& grid, LineRun rows, std::size_t of_row, LineRun columns, std::size_t of_column,
           const NearestPlanes& nearest) {
  if (verdict != CornerVerdict::unsure) return verdict == CornerVerdict::beyond;
  return exact_corners_clear(grid, rows, of_row, columns, of_column, nearest);
}

}  // namespace

bool Clearing::vertex_clears(Lines rows, Lines columns, const NearestPlanes& nearest, const LineBound& bound) const {
  const LineRun r = span_of(rows), c = span_of(columns);
  const CornerVerdict verdict = corners_beyond(rows_, r, middle(rows), columns_, c, middle(columns), bound);
  return clear(verdict, grid_, r, middle(rows), c, middle(columns), nearest);
}

double Clearing::estimate(Lines rows, Lines columns) const {
  double least = estimated_squared_distance(rows_, middle(rows), columns_, middle(columns));
  for (const std::uint32_t i : {rows.front(), rows.back()}) {
    for (const std::uint32_t j : {columns.front(), columns.back()}) {
      least = std::min(least, estimated_squared_distance(rows_, i, columns_, j));
    }
  }
  return least;
}

bool vertex_clears(const Grid& grid, const NearestPlanes& nearest, const LineBound& bound) {
  const LineRun rows{0, grid.rows()}, columns{0, grid.columns()};
  const LineImages a = grid.row_images({0, rows.middle(), grid.rows() - 1}),
                   b = grid.column_images({0, columns.middle(), grid.columns() - 1});
  return clear(corners_beyond(a, {0, 3}, 1, b, {0, 3}, 1, bound), grid, rows, rows.middle(), columns, columns.middle(), nearest);
}

}  // namespace fathom
