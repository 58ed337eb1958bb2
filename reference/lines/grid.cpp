// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/grid.hpp"

#include <string>

namespace fathom {
namespace {

LineImages oriented(const LineImages& all, std::span<const std::uint32_t> chosen, const auto& reversed) {
  LineImages images(all.exponent());
  images.gather(all, chosen);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (reversed(i)) images.reverse(i);
  }
  return images;
}

// One crossing of the grid with all it must satisfy.
class CrossingCheck {
 public:
  CrossingCheck(const Grid& grid, const Vector& z, Report& report) : grid_(grid), z_(z), report_(report) {}

  void check(std::size_t i, std::size_t j) {
    const Vector w = cross(grid_.row_direction(i), grid_.column_direction(j));
    const auto expect = [&](bool law, const char* what) {
      report_.expect(law, "crossing (" + std::to_string(i) + "," + std::to_string(j) + ") " + what);
    };
    expect(dot(w, z_) >= 0, "lies in the other hemisphere");
    if (i + 1 < grid_.rows()) expect(dot(w, grid_.row_direction(i + 1)) * grid_.row_sense() >= 0, "is out of order with the next row");
    if (j + 1 < grid_.columns())
      expect(dot(w, grid_.column_direction(j + 1)) * grid_.column_sense() >= 0, "is out of order with the next column");
    if (is_zero(w)) return;
    const Vector s = grid_.column_point(j) - grid_.row_point(i);
    expect(dot(s, w) > 0, "does not lie above O");
    const std::size_t rows[] = {i > 0 ? i - 1 : i, i + 1 < grid_.rows() ? i + 1 : i};
    const std::size_t columns[] = {j > 0 ? j - 1 : j, j + 1 < grid_.columns() ? j + 1 : j};
    for (const std::size_t r : rows) expect(dot(grid_.row_point(r) - grid_.row_point(i), w) >= 0, "leaves A");
    for (const std::size_t c : columns) expect(dot(grid_.column_point(c) - grid_.column_point(j), w) <= 0, "leaves B");
  }

 private:
  const Grid& grid_;
  const Vector& z_;
  Report& report_;
};

}  // namespace

// With both circles pointing upward in the chart, a stored arc d and a query e that rises through it have <d x e, z> > 0. Reversing all
// rows where the outward normal is e x d makes row x column outward everywhere.
Grid::Grid(const CanonicalPair& pair, const Charts& charts, const EdgeLines& a, const EdgeLines& b)
    : charts_(&charts),
      a_(&a),
      b_(&b),
      edges_a_(pair.edges_of_a()),
      edges_b_(pair.edges_of_b()),
      stored_of_(pair.stored_of),
      rising_(pair.rising) {}

// With circles pointing upward, a crossing lies below the next stored arc, above the next query if they rise, and below it if they fall.
int Grid::row_sense() const { return stored_of_ == Colour::a && !rising_ ? 1 : -1; }
int Grid::column_sense() const { return stored_of_ == Colour::a && rising_ ? 1 : -1; }

bool Grid::rows_turned() const { return (stored_of_ == Colour::a) != rising_; }

bool Grid::row_reversed(std::size_t i) const { return charts_->flipped(Colour::a, edge_of_row(i)) != rows_turned(); }

bool Grid::column_reversed(std::size_t j) const { return charts_->flipped(Colour::b, edge_of_column(j)); }

Vector Grid::row_direction(std::size_t i) const {
  const Vector d = a_->direction(edge_of_row(i));
  return row_reversed(i) ? -d : d;
}

Vector Grid::column_direction(std::size_t j) const {
  const Vector d = b_->direction(edge_of_column(j));
  return column_reversed(j) ? -d : d;
}

LineImages Grid::row_images() const {
  return oriented(a_->images(), edges_a_, [&](std::size_t i) { return row_reversed(i); });
}

LineImages Grid::column_images() const {
  return oriented(b_->images(), edges_b_, [&](std::size_t j) { return column_reversed(j); });
}

LineImages Grid::row_images(const std::array<std::size_t, 3>& chosen) const {
  const std::array edges{edges_a_[chosen[0]], edges_a_[chosen[1]], edges_a_[chosen[2]]};
  return oriented(a_->images(), edges, [&](std::size_t i) { return row_reversed(chosen[i]); });
}

LineImages Grid::column_images(const std::array<std::size_t, 3>& chosen) const {
  const std::array edges{edges_b_[chosen[0]], edges_b_[chosen[1]], edges_b_[chosen[2]]};
  return oriented(b_->images(), edges, [&](std::size_t j) { return column_reversed(chosen[j]); });
}

bool Grid::offer(std::size_t row, std::size_t column, NearestPlanes& nearest) const {
  return offer_edges(*a_, edge_of_row(row), *b_, edge_of_column(column), nearest);
}

Report validate(const Grid& grid, const Charts& charts) {
  Report report;
  CrossingCheck check(grid, charts.frame.z.exact(), report);
  for (std::size_t i = 0; i < grid.rows(); ++i) {
    for (std::size_t j = 0; j < grid.columns(); ++j) check.check(i, j);
  }
  return report;
}

}  // namespace fathom
