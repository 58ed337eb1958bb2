// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/grid.hpp"

#include <algorithm>
#include <string>

namespace fathom::lines {

template <gaussian::Colour c>
EdgeLines<c>::EdgeLines(const polytope::Polytope& polytope, long exponent) : polytope_(&polytope), images_(exponent) {
  for (const Edge i : ids()) images_.push_back(point(i), direction(i));
}

template <gaussian::Colour c>
Vector EdgeLines<c>::direction(Edge edge) const {
  const auto& e = polytope_->edges[edge.value];
  return polytope_->vertices[e.to] - polytope_->vertices[e.from];
}

template class EdgeLines<gaussian::Colour::a>;
template class EdgeLines<gaussian::Colour::b>;

bool offer_edges(const EdgeLinesOfA& a, gaussian::EdgeOfA e, const EdgeLinesOfB& b, gaussian::EdgeOfB f,
                 kernels::NearestPlanes& nearest) {
  const Vector w = cross(a.direction(e), b.direction(f));
  if (is_zero(w)) return false;
  const mpz_class height = dot(b.point(f) - a.point(e), w);
  return height > 0 ? nearest.offer(w, height) : nearest.offer(-w, mpz_class(-height));
}

template <gaussian::Colour c>
ChartLines<c>::ChartLines(const chart::ColourChart& chart, const EdgeLines<c>& lines) : chart_(&chart), lines_(&lines) {
  std::vector<gaussian::ArcId> whole(chart.arcs.size());
  std::ranges::transform(chart.arcs, whole.begin(), &chart::ChartArc::arc);
  images_.gather(lines.images(), whole);
  for (const chart::ChartArcId i : chart.arcs.ids()) {
    if (chart.arcs[i].flipped) images_.reverse(i.value);
  }
}

template <gaussian::Colour c>
kernels::WideLine ChartLines<c>::wide(Arc i) const {
  kernels::WideLine line = kernels::wide_line(point(i), lines_->direction(edge(i)), images_.exponent());
  if (arc(i).flipped) line.reverse();
  return line;
}

template <gaussian::Colour c>
kernels::WideLines ChartLines<c>::wide() const {
  return {images_.size(), [this](std::size_t i) { return wide(Arc(static_cast<std::uint32_t>(i))); }};
}

template class ChartLines<gaussian::Colour::a>;
template class ChartLines<gaussian::Colour::b>;

bool offer_arcs(const LineScene& scene, chart::ChartArcOfA e, chart::ChartArcOfB f, kernels::NearestPlanes& nearest) {
  return offer_edges(scene.a.lines(), scene.a.edge(e), scene.b.lines(), scene.b.edge(f), nearest);
}

namespace {

kernels::LineImages gathered(const kernels::LineImages& all, const auto& chosen) {
  kernels::LineImages images;
  images.gather(all, chosen);
  return images;
}

// One crossing of the grid with all it must satisfy.
class CrossingCheck {
 public:
  CrossingCheck(const Grid& grid, kernels::Report& report) : grid_(grid), report_(report) {}

  void check(std::size_t i, std::size_t j) {
    const Vector w = cross(grid_.row_direction(i), grid_.column_direction(j));
    const auto expect = [&](bool law, const char* what) {
      report_.expect(law, "crossing (" + std::to_string(i) + "," + std::to_string(j) + ") " + what);
    };
    expect(dot(w, grid_.scene().pole) >= 0, "lies in the other hemisphere");
    if (i + 1 < grid_.rows())
      expect(kernels::sign_of(dot(w, grid_.row_direction(i + 1))) * grid_.row_sense() != kernels::Sign::negative,
             "is out of order with the next row");
    if (j + 1 < grid_.columns())
      expect(kernels::sign_of(dot(w, grid_.column_direction(j + 1))) * grid_.column_sense() != kernels::Sign::negative,
             "is out of order with the next column");
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
  kernels::Report& report_;
};

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
bool clear(kernels::CornerVerdict verdict, const Grid& grid, const kernels::Block& block,
           const kernels::NearestPlanes& nearest) {
  return verdict == kernels::CornerVerdict::unsure ? exact_corners_clear(grid, block, nearest)
                                                   : verdict == kernels::CornerVerdict::beyond;
}

}  // namespace

// With circles pointing upward, a crossing lies below the next stored arc, above the next query if
// they rise, and below it if they fall.
kernels::Sign Grid::row_sense() const {
  return pair_.stored_of == gaussian::Colour::a && !pair_.rising ? kernels::Sign::positive : kernels::Sign::negative;
}
kernels::Sign Grid::column_sense() const {
  return pair_.stored_of == gaussian::Colour::a && pair_.rising ? kernels::Sign::positive : kernels::Sign::negative;
}

// With both circles pointing upward in the chart, a stored arc d and a query e that rises through
// it have <d x e, z> > 0. Reversing all rows where the outward normal is e x d makes row x column
// outward everywhere.
Vector Grid::row_direction(std::size_t i) const {
  const Vector d = scene_->a.direction(row(i));
  return rows_turned() ? -d : d;
}

kernels::LineImages Grid::turned_rows(const auto& chosen) const {
  kernels::LineImages images = gathered(scene_->a.images(), chosen);
  for (std::size_t i = 0; rows_turned() && i < images.size(); ++i) images.reverse(i);
  return images;
}

kernels::LineImages Grid::row_images() const { return turned_rows(pair_.a); }

kernels::LineImages Grid::column_images() const { return gathered(scene_->b.images(), pair_.b); }

kernels::LineImages Grid::row_images(const std::array<std::size_t, 3>& chosen) const {
  return turned_rows(std::array{row(chosen[0]), row(chosen[1]), row(chosen[2])});
}

kernels::LineImages Grid::column_images(const std::array<std::size_t, 3>& chosen) const {
  return gathered(scene_->b.images(), std::array{column(chosen[0]), column(chosen[1]), column(chosen[2])});
}

kernels::WideLines Grid::wide_rows() const {
  return {rows(), [grid = *this](std::size_t i) {
            kernels::WideLine line = grid.scene_->a.wide(grid.row(i));
            if (grid.rows_turned()) line.reverse();
            return line;
          }};
}

kernels::WideLines Grid::wide_columns() const {
  return {columns(), [grid = *this](std::size_t j) { return grid.scene_->b.wide(grid.column(j)); }};
}

kernels::Report validate(const Grid& grid) {
  kernels::Report report;
  CrossingCheck check(grid, report);
  for (std::size_t i = 0; i < grid.rows(); ++i) {
    for (std::size_t j = 0; j < grid.columns(); ++j) check.check(i, j);
  }
  return report;
}

bool Clearing::vertex_clears(const kernels::Block& block, const kernels::NearestPlanes& nearest,
                             const kernels::LineBound& bound) const {
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
  const kernels::Block whole{kernels::side_of(kernels::LineRun{0, grid.rows()}),
                             kernels::side_of(kernels::LineRun{0, grid.columns()})},
      three{{0, 1, 2}, {0, 1, 2}};
  const kernels::LineImages rows = grid.row_images({whole.rows.first, whole.rows.middle, whole.rows.last}),
                            columns =
                                grid.column_images({whole.columns.first, whole.columns.middle, whole.columns.last});
  return clear(kernels::corners_beyond(rows, columns, three, bound), grid, whole, nearest);
}

}  // namespace fathom::lines
