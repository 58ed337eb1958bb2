// SPDX-License-Identifier: GPL-3.0-or-later
// Seen along v, a line is a point of the plane: one that is common to A, to B and to the box around
// x, each the hull of some points. To find the one where B's height above A is greatest is a linear
// program in the weights of these points; its prices are the two planes.
#include "reference/patch/local_depth.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "kernels/number/irrational.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"

namespace fathom::patch {
namespace {

// ---- a linear program ----

/// Two for "a point of A is one of B", two for what else is asked of it, and one for each of the
/// three that weights sum to 1.
constexpr std::size_t equations = 7;
using Coefficients = std::array<mpq_class, equations>;
using IntegerColumn = std::array<mpz_class, equations>;
const Coefficients right_sides{0, 0, 0, 0, 1, 1, 1};

/// The least number > 0 that makes integers of them all.
template <class Numbers>
mpz_class unit_of(const Numbers& numbers) {
  mpz_class unit = 1;
  for (const mpq_class& x : numbers)
    if (x.get_den() != 1) unit = lcm(unit, x.get_den());
  return unit;
}
mpz_class in_units(const mpq_class& x, const mpz_class& unit) { return x.get_num() * (unit / x.get_den()); }

/// The greatest sum of cost times weight, of weights >= 0 for which the columns add up to the
/// right sides. The revised simplex method; from a step that gains nothing on, until one does, by
/// the rule of Bland [1977], so that it ends. Columns and costs are integers: so all columns are
/// priced without fractions.
class WeightProgram {
 public:
  explicit WeightProgram(std::vector<IntegerColumn> columns) : columns_(std::move(columns)) {
    for (std::size_t i = 0; i < equations; ++i) {
      basis_[i] = columns_.size() + i;  // an artificial variable for each equation
      inverse_[i][i] = 1;
      level_[i] = right_sides[i];
    }
  }

  /// Finds weights; else its prices prove that there are none. To be called first, and once.
  bool feasible() {
    std::vector<mpz_class> costs(columns_.size() + equations);
    std::fill(costs.end() - equations, costs.end(), -1);
    maximize(costs);
    for (std::size_t i = 0; i < equations; ++i)
      if (basis_[i] >= columns_.size() && level_[i] > 0) return false;
    // Where no column replaces an artificial variable, its equation follows from the others.
    for (std::size_t i = 0; i < equations; ++i)
      for (std::size_t j = 0; basis_[i] >= columns_.size() && j < columns_.size(); ++j)
        if (const Coefficients step = through_basis(columns_[j]); sgn(step[i]) != 0) pivot(j, i, step);
    return true;
  }

  /// Costs of the columns, and then 0 of the artificial variables.
  void maximize(const std::vector<mpz_class>& costs) {
    for (bool stalled = false;;) {
      set_prices(costs);
      const std::optional<std::size_t> enters = entering(costs, stalled);
      if (!enters) return;
      const Coefficients step = through_basis(columns_[*enters]);
      std::optional<std::size_t> leaves;
      for (std::size_t i = 0; i < equations; ++i) {
        if (sgn(step[i]) <= 0) continue;
        const int order = leaves ? cmp(mpq_class(level_[i] * step[*leaves]), mpq_class(level_[*leaves] * step[i])) : -1;
        if (order < 0 || (order == 0 && basis_[i] < basis_[*leaves])) leaves = i;
      }
      if (!leaves) throw std::logic_error("weights that sum to 1 have no bound");
      stalled = sgn(level_[*leaves]) == 0;
      pivot(*enters, *leaves, step);
    }
  }

  [[nodiscard]] const Coefficients& prices() const { return prices_; }

  /// Calls use(column, weight) for all weights that are not 0.
  template <class Use>
  void for_each_weight(const Use& use) const {
    for (std::size_t i = 0; i < equations; ++i)
      if (basis_[i] < columns_.size() && sgn(level_[i]) != 0) use(basis_[i], level_[i]);
  }

 private:
  void set_prices(const std::vector<mpz_class>& costs) {
    for (std::size_t k = 0; k < equations; ++k) {
      prices_[k] = 0;
      for (std::size_t i = 0; i < equations; ++i)
        if (sgn(costs[basis_[i]]) != 0 && sgn(inverse_[i][k]) != 0) prices_[k] += costs[basis_[i]] * inverse_[i][k];
    }
  }

  /// The column that gains most, or the first that gains.
  [[nodiscard]] std::optional<std::size_t> entering(const std::vector<mpz_class>& costs, bool first) const {
    const mpz_class unit = unit_of(prices_);
    IntegerColumn prices;
    for (std::size_t k = 0; k < equations; ++k) prices[k] = in_units(prices_[k], unit);
    std::optional<std::size_t> best;
    mpz_class most = 0, gain;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      gain = unit * costs[j];
      for (std::size_t k = 0; k < equations; ++k)
        if (sgn(columns_[j][k]) != 0) gain -= prices[k] * columns_[j][k];
      if (gain <= most) continue;
      best = j, most = gain;
      if (first) break;
    }
    return best;
  }

  [[nodiscard]] Coefficients through_basis(const IntegerColumn& column) const {
    Coefficients result;
    for (std::size_t i = 0; i < equations; ++i)
      for (std::size_t k = 0; k < equations; ++k)
        if (sgn(column[k]) != 0 && sgn(inverse_[i][k]) != 0) result[i] += inverse_[i][k] * column[k];
    return result;
  }

  void pivot(std::size_t enters, std::size_t leaves, const Coefficients& step) {
    level_[leaves] /= step[leaves];
    for (mpq_class& entry : inverse_[leaves]) entry /= step[leaves];
    for (std::size_t i = 0; i < equations; ++i) {
      if (i == leaves || sgn(step[i]) == 0) continue;
      level_[i] -= step[i] * level_[leaves];
      for (std::size_t k = 0; k < equations; ++k) inverse_[i][k] -= step[i] * inverse_[leaves][k];
    }
    basis_[leaves] = enters;
  }

  std::vector<IntegerColumn> columns_;
  std::array<std::size_t, equations> basis_;
  std::array<Coefficients, equations> inverse_;
  Coefficients level_, prices_;
};

// ---- the lines near a point ----

using SeenAlong = LinesAlong::SeenAlong;

/// The points of the plane that are common to A and B, and to a box, or where B's height above A is
/// not too small.
class Region {
 public:
  Region(const std::vector<SeenAlong>& a, const std::vector<SeenAlong>& b, const std::vector<SeenAlong>& box)
      : a_(a), b_(b), unit_(unit_of_plane({&a, &b, &box})), program_(in_box(box)), empty_(!program_.feasible()) {}
  Region(const std::vector<SeenAlong>& a, const std::vector<SeenAlong>& b, const mpq_class& least)
      : a_(a), b_(b), unit_(unit_of_plane({&a, &b})), program_(above(least)), empty_(!program_.feasible()) {}

  [[nodiscard]] bool empty() const { return empty_; }

  /// Moves to where B's height above A is greatest.
  void highest() {
    std::vector<mpq_class> costs = no_costs();
    for (std::size_t i = 0; i < a_.size(); ++i) costs[i] = -a_[i].height;
    for (std::size_t j = 0; j < b_.size(); ++j) costs[a_.size() + j] = b_[j].height;
    maximize(costs);
  }
  /// Moves to a point that is farthest to one side.
  void farthest(const mpq_class& x, const mpq_class& y) {
    std::vector<mpq_class> costs = no_costs();
    for (std::size_t i = 0; i < a_.size(); ++i) costs[i] = x * a_[i].x + y * a_[i].y;
    maximize(costs);
  }

  /// The point, by its heights on A and on B.
  [[nodiscard]] std::array<SeenAlong, 2> here() const {
    std::array<SeenAlong, 2> result;
    program_.for_each_weight([&](std::size_t j, const mpq_class& weight) {
      if (j >= a_.size() + b_.size()) return;
      const SeenAlong& p = j < a_.size() ? a_[j] : b_[j - a_.size()];
      SeenAlong& sum = result[j < a_.size() ? 0 : 1];
      sum.x += weight * p.x, sum.y += weight * p.y, sum.height += weight * p.height;
    });
    return result;
  }
  /// Of the equations in the plane, as for coordinates and costs that are no integers.
  [[nodiscard]] std::array<mpq_class, 4> prices() const {
    std::array<mpq_class, 4> result;
    for (std::size_t k = 0; k < result.size(); ++k)
      result[k] = program_.prices()[k] * kernels::ratio(unit_, unit_of_costs_);
    return result;
  }

 private:
  [[nodiscard]] static mpz_class unit_of_plane(const std::vector<const std::vector<SeenAlong>*>& sets) {
    std::vector<mpq_class> all;
    for (const auto* points : sets)
      for (const SeenAlong& p : *points) all.insert(all.end(), {p.x, p.y});
    return unit_of(all);
  }
  /// Of a point in the plane: two that are for the first equations, and two for the next.
  [[nodiscard]] IntegerColumn column(const SeenAlong& p, int first, int second, std::array<int, 3> sums) const {
    const mpz_class x = in_units(p.x, unit_), y = in_units(p.y, unit_);
    return {first * x, first * y, second * x, second * y, sums[0], sums[1], sums[2]};
  }
  /// A point of A is one of the box.
  [[nodiscard]] std::vector<IntegerColumn> in_box(const std::vector<SeenAlong>& box) {
    std::vector<IntegerColumn> result;
    for (const SeenAlong& p : a_) result.push_back(column(p, 1, 1, {1, 0, 0}));
    for (const SeenAlong& p : b_) result.push_back(column(p, -1, 0, {0, 1, 0}));
    for (const SeenAlong& p : box) result.push_back(column(p, 0, -1, {0, 0, 1}));
    columns_ = result.size();
    return result;
  }
  /// B's height less A's and `least` is between 0 and what it is at most.
  [[nodiscard]] std::vector<IntegerColumn> above(const mpq_class& least) {
    const auto higher = [](const SeenAlong& p, const SeenAlong& q) { return p.height < q.height; };
    const mpq_class most = std::max(mpq_class(0), mpq_class(std::ranges::max_element(b_, higher)->height -
                                                            std::ranges::min_element(a_, higher)->height - least));
    std::vector<mpq_class> heights{most, least};
    for (const auto* points : {&a_, &b_})
      for (const SeenAlong& p : *points) heights.push_back(p.height);
    const mpz_class unit = unit_of(heights);
    std::vector<IntegerColumn> result;
    for (const SeenAlong& p : a_) {
      result.push_back(column(p, 1, 0, {1, 0, 0}));
      result.back()[2] = -in_units(p.height, unit);
    }
    for (const SeenAlong& p : b_) {
      result.push_back(column(p, -1, 0, {0, 1, 0}));
      result.back()[2] = in_units(p.height - least, unit);
    }
    result.push_back({0, 0, 0, 0, 0, 0, 1});
    result.push_back({0, 0, -in_units(most, unit), 0, 0, 0, 1});
    columns_ = result.size();
    return result;
  }
  [[nodiscard]] std::vector<mpq_class> no_costs() const { return std::vector<mpq_class>(columns_ + equations); }
  void maximize(const std::vector<mpq_class>& costs) {
    unit_of_costs_ = unit_of(costs);
    std::vector<mpz_class> integers;
    integers.reserve(costs.size());
    for (const mpq_class& cost : costs) integers.push_back(in_units(cost, unit_of_costs_));
    program_.maximize(integers);
  }

  const std::vector<SeenAlong>&a_, &b_;
  mpz_class unit_, unit_of_costs_ = 1;
  std::size_t columns_ = 0;
  WeightProgram program_;
  bool empty_;
};

bool same(const SeenAlong& p, const SeenAlong& q) { return p.x == q.x && p.y == q.y; }

/// Adds the corners of the region from p, counter-clockwise, to q, but for p.
void add_between(Region& region, const SeenAlong& p, const SeenAlong& q, std::vector<SeenAlong>& corners) {
  const mpq_class x = q.y - p.y, y = p.x - q.x;  // to the right of the way from p to q
  region.farthest(x, y);
  const SeenAlong r = region.here()[0];
  if (x * r.x + y * r.y > x * p.x + y * p.y) {
    add_between(region, p, r, corners);
    add_between(region, r, q, corners);
  } else {
    corners.push_back(q);
  }
}

/// Its corners in order. Points that are farthest to one side may lie between two corners: they are
/// left out at last.
std::vector<SeenAlong> corners_of(Region& region) {
  const auto farthest = [&](int x, int y) {
    region.farthest(x, y);
    return region.here()[0];
  };
  SeenAlong first = farthest(1, 0), last = farthest(-1, 0);
  if (first.x == last.x) {
    first = farthest(0, 1), last = farthest(0, -1);
    return same(first, last) ? std::vector{first} : std::vector{first, last};
  }
  std::vector<SeenAlong> all;
  add_between(region, first, last, all);
  add_between(region, last, first, all);
  for (std::size_t k = 0; all.size() > 2 && k < all.size();) {
    const SeenAlong &p = all[(k + all.size() - 1) % all.size()], &q = all[k], &r = all[(k + 1) % all.size()];
    if ((q.x - p.x) * (r.y - p.y) != (q.y - p.y) * (r.x - p.x)) ++k;
    else if (all.size() > 3 || (q.x - p.x) * (q.x - r.x) + (q.y - p.y) * (q.y - r.y) < 0)
      all.erase(all.begin() + static_cast<std::ptrdiff_t>(k)), k = 0;
    else ++k;
  }
  return all;
}

}  // namespace

LinesAlong::LinesAlong(const Vector& v, std::span<const Point> a, std::span<const Point> b) : v_(v), axes_{1, 2, 0} {
  if (sgn(v.x) == 0) axes_ = sgn(v.y) != 0 ? std::array{2, 0, 1} : std::array{0, 1, 2};
  for (const Point& p : a) a_.push_back(seen(p));
  for (const Point& p : b) b_.push_back(seen(p));
}

GreatestOverlap LinesAlong::greatest(const Point& x, const mpq_class& within) const {
  const std::vector<SeenAlong> near = box(x, within);
  Region region(a_, b_, near);
  GreatestOverlap result;
  if (!region.empty()) {
    region.highest();
    const auto& [a, b] = region.here();
    result.overlap = LineOverlap{lifted(a.x, a.y, a.height), lifted(b.x, b.y, b.height), b.height - a.height};
  }
  // As linear functions of the plane and of the height, which v alone raises:
  const std::array<mpq_class, 4> prices = region.prices();
  const int rises = region.empty() ? 0 : 1;
  const auto function = [&](const mpq_class& of_x, const mpq_class& of_y) {
    std::array<mpq_class, 3> c;
    const auto along = [&](int axis) {
      return mpq_class(kernels::coordinate(v_, axes_[static_cast<std::size_t>(axis)]));
    };
    c[static_cast<std::size_t>(axes_[0])] = of_x, c[static_cast<std::size_t>(axes_[1])] = of_y;
    c[static_cast<std::size_t>(axes_[2])] = (rises - of_x * along(0) - of_y * along(1)) / along(2);
    return Point{c[0], c[1], c[2]};
  };
  result.planes = {function(prices[0], prices[1]), function(prices[0] + prices[2], prices[1] + prices[3])};
  return result;
}

std::vector<LineOverlap> LinesAlong::corners(const Point& x, const mpq_class& within) const {
  const std::vector<SeenAlong> near = box(x, within);
  Region region(a_, b_, near);
  return region.empty() ? std::vector<LineOverlap>() : lines_at(corners_of(region));
}

std::vector<LineOverlap> LinesAlong::at_least(const mpq_class& least) const {
  Region region(a_, b_, least);
  return region.empty() ? std::vector<LineOverlap>() : lines_at(corners_of(region));
}

std::vector<LineOverlap> LinesAlong::with_slack(const mpq_class& support, const mpq_class& squared) const {
  constexpr unsigned slack_bits = 40;
  const mpq_class length_squared(dot(v_, v_));
  return at_least(support / length_squared - kernels::enclosed({0, squared / length_squared}, slack_bits).high);
}

std::vector<LineOverlap> LinesAlong::lines_at(const std::vector<SeenAlong>& corners) const {
  std::vector<LineOverlap> result;
  for (const SeenAlong& corner : corners) result.push_back(*at(lifted(corner.x, corner.y, 0)));
  return result;
}

SeenAlong LinesAlong::seen(const Point& p) const {
  const std::array<const mpq_class*, 3> of_p{&p.x, &p.y, &p.z};
  const auto [i, j, k] = axes_;
  const mpq_class height = *of_p[static_cast<std::size_t>(k)] / kernels::coordinate(v_, k);
  return {*of_p[static_cast<std::size_t>(i)] - height * kernels::coordinate(v_, i),
          *of_p[static_cast<std::size_t>(j)] - height * kernels::coordinate(v_, j), height};
}

Point LinesAlong::lifted(const mpq_class& x, const mpq_class& y, const mpq_class& height) const {
  std::array<mpq_class, 3> c;
  c[static_cast<std::size_t>(axes_[0])] = x, c[static_cast<std::size_t>(axes_[1])] = y;
  return Point{c[0], c[1], c[2]} + height * v_;
}

std::vector<SeenAlong> LinesAlong::box(const Point& x, const mpq_class& within) const {
  if (sgn(within) == 0) return {seen(x)};
  std::vector<SeenAlong> result;
  for (const mpq_class& dx : {mpq_class(-within), within})
    for (const mpq_class& dy : {mpq_class(-within), within})
      for (const mpq_class& dz : {mpq_class(-within), within}) result.push_back(seen({x.x + dx, x.y + dy, x.z + dz}));
  return result;
}

mpq_class bound(const TwoPlanes& planes, std::span<const Point> a, std::span<const Point> b, const Point& x,
                const mpq_class& within) {
  const auto& [u, w] = planes;
  mpq_class high = dot(u, b[0]), low = dot(w, a[0]);
  for (const Point& p : b) high = std::max(high, dot(u, p));
  for (const Point& p : a) low = std::min(low, dot(w, p));
  const Point turn = w - u;
  return high - low + dot(turn, x) + within * (abs(turn.x) + abs(turn.y) + abs(turn.z));
}

}  // namespace fathom::patch
