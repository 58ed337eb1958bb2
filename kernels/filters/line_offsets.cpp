// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "kernels/filters/error_bounds.hpp"
#include "kernels/filters/line_frame.hpp"

namespace fathom::kernels {
namespace {

using Wide3 = Vec3<WideFloat>;

// Rounding of what is computed here in binary64: sums and products of a few dozen numbers, none negative.
constexpr double raised = 1 + 0x1p-40, lowered = 1 - 0x1p-40;

// The direction's or the point's coordinates of a tuple.
Wide3 direction(const LineTuple<WideFloat>& x) { return {x[0], x[1], x[2]}; }
Wide3 point(const LineTuple<WideFloat>& x) { return {x[3], x[4], x[5]}; }

// About |v|, by less than a part in 2^45.
double length(const Wide3& v) {
  const double x = truncated(v.x), y = truncated(v.y), z = truncated(v.z);
  return std::sqrt(x * x + y * y + z * z);
}
double length(const std::array<double, 6>& r, std::size_t from) {
  return std::sqrt(r[from] * r[from] + r[from + 1] * r[from + 1] + r[from + 2] * r[from + 2]);
}

// How large the direction D, or the point Q, of a frame's tuples is.
struct Sizes {
  double centre;    // |m|
  double extent;    // at least |e s + k s^2|
  double residual;  // at least the distance of a line's tuple from the parabola
  Sizes(const Wide3& m, const Wide3& e, const Wide3& k, double r) : centre(length(m)), extent(length(e) + length(k)), residual(r) {}
  // At least the size of any tuple, residual included.
  [[nodiscard]] double whole() const { return centre + extent + residual; }
};

// The parts of the margin that are linear in the residuals, and a bound of all others: Lemma 4.
struct Offsets {
  LineTuple<WideFloat> of_rows, of_columns;
  double kappa = 0;

  // False if no bound is known.
  bool set(const LineFrame<WideFloat>& a, const LineFrame<WideFloat>& b, const WideFloat& bound) {
    const Wide3 d = direction(a.m), e = direction(b.m), s = point(b.m) - point(a.m), w = cross(d, e);
    const WideFloat size = sqrt(dot(w, w)), rho = sqrt(bound);
    if (!(truncated(size) > 0x1p-300)) return false;
    const WideFloat factor = rho / size;
    // s - rho w / |w|.
    const Wide3 rest{s.x - factor * w.x, s.y - factor * w.y, s.z - factor * w.z};
    const Wide3 by_d = cross(e, rest), by_e = cross(rest, d);
    of_rows = {by_d.x, by_d.y, by_d.z, -w.x, -w.y, -w.z};
    of_columns = {by_e.x, by_e.y, by_e.z, w.x, w.y, w.z};
    return set_kappa(a, b, length(s), truncated(size), truncated(rho));
  }

 private:
  bool set_kappa(const LineFrame<WideFloat>& a, const LineFrame<WideFloat>& b, double between, double size, double rho) {
    const Sizes d(direction(a.m), direction(a.e), direction(a.k), length(a.r, 0));
    const Sizes e(direction(b.m), direction(b.e), direction(b.k), length(b.r, 0));
    // Of S, the difference of the points.
    const double s_extent = length(point(a.e)) + length(point(a.k)) + length(point(b.e)) + length(point(b.k));
    const double s_residual = length(a.r, 3) + length(b.r, 3), s_whole = between + s_extent + s_residual;
    const double w_extent = d.extent * e.whole() + d.whole() * e.extent, w_residual = d.residual * e.whole() + d.whole() * e.residual;
    const double w_least = size * lowered - w_extent * raised;
    if (!(w_least > 0)) return false;
    const double of_height = s_residual * w_extent + d.residual * (s_extent * e.whole() + s_whole * e.extent) +
                             e.residual * (s_extent * d.whole() + s_whole * d.extent) + s_residual * w_residual +
                             s_whole * d.residual * e.residual;
    const double of_length = w_residual * w_residual / (2 * w_least) + 2 * w_extent * w_residual / w_least + d.residual * e.extent +
                             d.extent * e.residual + d.residual * e.residual;
    // Rounding of the linear parts, and of the points' and directions' tuples that they were made of.
    const double scale = (1 + d.whole()) * (1 + e.whole()) * (1 + s_whole + rho), all = d.residual + e.residual + s_residual;
    kappa = (of_height + rho * of_length + 0x1p-100 * scale * all) * raised;
    return std::isfinite(kappa);
  }
};

// A lower bound of a line's part.
struct Part {
  double least;
  std::uint32_t line;
};

// The parts of all lines of a run, ascending: the residual's and the smooth model's linear s + quadratic s^2. False if a line has none.
bool parts_of(const FramedRun& of, const LineTuple<WideFloat>& gradient, const WideFloat& linear, const WideFloat& quadratic,
              std::vector<Part>& parts) {
  const ParabolicFit<WideLines> fit(of.lines, of.run);
  double slope = 0;
  for (const WideFloat& g : gradient) slope += std::fabs(truncated(g));
  ParabolicFit<WideLines>::Place place;
  parts.reserve(of.run.size());
  for (const std::uint32_t line : of.run) {
    if (!fit.place(line, place)) return false;
    WideFloat sum = (linear + quadratic * place.s) * place.s;
    for (std::size_t i = 0; i < 6; ++i) sum = sum + gradient[i] * place.residual[i];
    const double part = truncated(sum);
    parts.push_back({part - std::fabs(part) * 0x1p-50 - slope * place.error * raised, line});
  }
  std::ranges::sort(parts, {}, &Part::least);
  return true;
}

// At least the smooth model's constant part less what is not in the lines' parts: c4 s t, the radius, and rounding.
WideFloat least_of_rest(const TaylorModel<WideFloat>& smooth) {
  return smooth.c[0] - abs(smooth.c[4]) - taylor::rounded_up(smooth.radius + error_bound::taylor_least<WideFloat> * smooth.norm());
}

}  // namespace

std::optional<std::vector<LinePair>> pairs_left(const FramedRun& rows, const FramedRun& columns, const WideFloat& bound,
                                                const TaylorModel<WideFloat>& smooth, std::size_t most) {
  Offsets offsets;
  if (!rows.frame.valid || !columns.frame.valid || !offsets.set(rows.frame, columns.frame, bound)) return std::nullopt;
  std::vector<Part> of_rows, of_columns;
  if (!parts_of(rows, offsets.of_rows, smooth.c[1], smooth.c[3], of_rows) ||
      !parts_of(columns, offsets.of_columns, smooth.c[2], smooth.c[5], of_columns)) {
    return std::nullopt;
  }
  // A pair may be near if the sum of its parts is at most this.
  const double size = std::max({std::fabs(of_rows.front().least), std::fabs(of_rows.back().least), std::fabs(of_columns.front().least),
                                std::fabs(of_columns.back().least)});
  const double rest = truncated(offsets.kappa - least_of_rest(smooth));
  const double limit = rest + std::fabs(rest) * 0x1p-50 + size * 0x1p-49 + error_bound::underflow;
  std::vector<LinePair> left;
  for (const Part& row : of_rows) {
    for (const Part& column : of_columns) {
      if (row.least + column.least > limit) break;
      if (left.size() == most) return std::nullopt;
      left.emplace_back(row.line, column.line);
    }
    if (row.least + of_columns.front().least > limit) break;
  }
  return left;
}

}  // namespace fathom::kernels
