// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/filters/line_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernels/filters/error_bounds.hpp"

namespace fathom::kernels::taylor {
namespace {

using std::abs;

// min of a x^2 + b x over [-1, 1], within rounding.
template <class Number>
Number least_of_parabola(const Number& a, const Number& b) {
  const Number slope = abs(b);
  return a > 0 && slope < a + a ? -(b * b) / (4 * a) : a - slope;
}

template <class Number>
struct Quadratic {
  Number s, t, ss, st, tt;

  [[nodiscard]] Quadratic swapped() const { return {t, s, tt, st, ss}; }
  // t = 1 and t = -1.
  [[nodiscard]] Number on_edge(double sign) const {
    return tt + sign * t + least_of_parabola<Number>(ss, s + sign * st);
  }
};

// t leaves: tt t^2 + (t + st s) t is at least -(t + st s)^2 / (4 tt), attained when that t lies in
// [-1, 1]. Only for tt > 0.
template <class Number>
Number without_t(const Quadratic<Number>& q) {
  const Number k = q.st / (2 * q.tt);
  return least_of_parabola<Number>(q.ss - q.st * k * 0.5, q.s - q.t * k) - q.t * q.t / (4 * q.tt);
}

// When t decides at its ends: q is concave in t, or steeper than it is curved.
template <class Number>
bool t_at_ends(const Quadratic<Number>& q) {
  return q.tt <= 0 || abs(q.t) - abs(q.st) >= 2 * q.tt;
}

// s t >= -(s^2 + t^2) / 2, with either sign.
template <class Number>
Number uncoupled(const Quadratic<Number>& q) {
  const Number k = abs(q.st) * 0.5;
  return least_of_parabola<Number>(q.ss - k, q.s) + least_of_parabola<Number>(q.tt - k, q.t);
}

template <class Number>
Number least_of(const Quadratic<Number>& q) {
  if (t_at_ends(q)) return std::min(q.on_edge(1), q.on_edge(-1));
  const Quadratic<Number> r = q.swapped();
  if (t_at_ends(r)) return std::min(r.on_edge(1), r.on_edge(-1));
  Number best = uncoupled(q);
  // The quotients must be harmless: st / tt may not blow up what cancels.
  if (abs(q.st) <= 4 * q.tt && abs(q.t) <= 4 * q.tt) best = std::max(best, without_t(q));
  if (abs(r.st) <= 4 * r.tt && abs(r.t) <= 4 * r.tt) best = std::max(best, without_t(r));
  return best;
}

}  // namespace

template <class Number>
Number least(const TaylorModel<Number>& f) {
  const Number bound = least_of<Number>({f.c[1], f.c[2], f.c[3], f.c[4], f.c[5]});
  return f.c[0] + bound - rounded_up(f.radius + error_bound::taylor_least<Number> * f.norm());
}

template double least(const TaylorModel<double>& f);
template WideFloat least(const TaylorModel<WideFloat>& f);

}  // namespace fathom::kernels::taylor

namespace fathom::kernels {
namespace {

using std::abs;
using std::sqrt;
using taylor::combination;
using taylor::operator*;
using taylor::operator+;
using taylor::operator-;

template <class Number>
Number dot6(const LineTuple<Number>& a, const LineTuple<Number>& b) {
  Number sum = 0;
  for (std::size_t i = 0; i < 6; ++i) sum = sum + a[i] * b[i];
  return sum;
}

template <class Number>
using Models = std::array<TaylorModel<Number>, 3>;

// d is in s, e in t.
template <class Number>
Models<Number> cross(const Models<Number>& d, const Models<Number>& e) {
  using taylor::product_of_sides;
  const auto minor = [&](std::size_t i, std::size_t j) {
    return product_of_sides(d[i], e[j]) - product_of_sides(d[j], e[i]);
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

template <class Number>
TaylorModel<Number> dot(const Models<Number>& f, const Models<Number>& g) {
  return f[0] * g[0] + f[1] * g[1] + f[2] * g[2];
}

template <class Number>
Vec3<Number> normalised(const Vec3<Number>& v) {
  const Number length = sqrt(fathom::dot(v, v));
  return {v.x / length, v.y / length, v.z / length};
}

// |m| + |e| + |k| in a coordinate: no point of the parabola is larger.
template <class Number>
double size_of_terms(const LineFrame<Number>& f, std::size_t i) {
  return std::fabs(truncated(f.m[i])) + std::fabs(truncated(f.e[i])) + std::fabs(truncated(f.k[i]));
}

template <class Number>
using Basis = std::array<Vec3<Number>, 3>;

// Three directions, the first along w, the second towards d. Orthonormal up to 16u in each product,
// or else there is none.
template <class Number>
bool orthonormal(const Vec3<Number>& w, const Vec3<Number>& d, Basis<Number>& basis) {
  if (!(truncated(fathom::dot(w, w)) > 0x1p-500)) return false;
  basis[0] = normalised(w);
  const Vec3<Number> third = fathom::cross(basis[0], d);
  if (!(truncated(fathom::dot(third, third)) > 0x1p-500)) return false;
  basis[2] = normalised(third);
  basis[1] = fathom::cross(basis[2], basis[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const double expected = i == j ? 1 : 0;
      if (!(abs(fathom::dot(basis[i], basis[j]) - expected) <= error_bound::orthonormal<Number>)) return false;
    }
  }
  return true;
}

// The frame's direction, or its point, in the basis: coordinates from, from + 1 and from + 2.
template <class Number>
Models<Number> turned(const LineFrame<Number>& f, std::size_t from, const Basis<Number>& basis, bool in_t) {
  std::array<double, 3> reach;
  for (std::size_t j = 0; j < 3; ++j)
    reach[j] = f.r[from + j] + error_bound::parabola<Number> * size_of_terms(f, from + j);
  const auto part = [from](const LineTuple<Number>& x) { return Vec3<Number>{x[from], x[from + 1], x[from + 2]}; };
  const Vec3<Number> m = part(f.m), e = part(f.e), k = part(f.k);
  Models<Number> models;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<Number>& g = basis[i];
    models[i].c[0] = fathom::dot(g, m);
    models[i].c[in_t ? 2 : 1] = fathom::dot(g, e);
    models[i].c[in_t ? 5 : 3] = fathom::dot(g, k);
    models[i].radius = taylor::rounded_up(std::fabs(truncated(g.x)) * reach[0] + std::fabs(truncated(g.y)) * reach[1] +
                                          std::fabs(truncated(g.z)) * reach[2]);
  }
  return models;
}

using Wide3 = Vec3<WideFloat>;

// Rounding of what is computed here in binary64: sums and products of a few dozen numbers, none
// negative.
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
  Sizes(const Wide3& m, const Wide3& e, const Wide3& k, double r)
      : centre(length(m)), extent(length(e) + length(k)), residual(r) {}
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
  bool set_kappa(const LineFrame<WideFloat>& a, const LineFrame<WideFloat>& b, double between, double size,
                 double rho) {
    const Sizes d(direction(a.m), direction(a.e), direction(a.k), length(a.r, 0));
    const Sizes e(direction(b.m), direction(b.e), direction(b.k), length(b.r, 0));
    // Of S, the difference of the points.
    const double s_extent = length(point(a.e)) + length(point(a.k)) + length(point(b.e)) + length(point(b.k));
    const double s_residual = length(a.r, 3) + length(b.r, 3), s_whole = between + s_extent + s_residual;
    const double w_extent = d.extent * e.whole() + d.whole() * e.extent,
                 w_residual = d.residual * e.whole() + d.whole() * e.residual;
    const double w_least = size * lowered - w_extent * raised;
    if (!(w_least > 0)) return false;
    const double of_height = s_residual * w_extent + d.residual * (s_extent * e.whole() + s_whole * e.extent) +
                             e.residual * (s_extent * d.whole() + s_whole * d.extent) + s_residual * w_residual +
                             s_whole * d.residual * e.residual;
    const double of_length = w_residual * w_residual / (2 * w_least) + 2 * w_extent * w_residual / w_least +
                             d.residual * e.extent + d.extent * e.residual + d.residual * e.residual;
    // Rounding of the linear parts, and of the points' and directions' tuples that they were made
    // of.
    const double scale = (1 + d.whole()) * (1 + e.whole()) * (1 + s_whole + rho),
                 all = d.residual + e.residual + s_residual;
    kappa = (of_height + rho * of_length + 0x1p-100 * scale * all) * raised;
    return std::isfinite(kappa);
  }
};

// A lower bound of a line's part.
struct Part {
  double least;
  std::uint32_t line;
};

// The parts of all lines of a run, ascending: the residual's and the smooth model's linear s +
// quadratic s^2. False if a line has none.
bool parts_of(const FramedRun& of, const LineTuple<WideFloat>& gradient, const WideFloat& linear,
              const WideFloat& quadratic, std::vector<Part>& parts) {
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

// At least the smooth model's constant part less what is not in the lines' parts: c4 s t, the
// radius, and rounding.
WideFloat least_of_rest(const TaylorModel<WideFloat>& smooth) {
  return smooth.c[0] - abs(smooth.c[4]) -
         taylor::rounded_up(smooth.radius + error_bound::taylor_least<WideFloat> * smooth.norm());
}

}  // namespace

template <class Lines>
ParabolicFit<Lines>::ParabolicFit(const Lines& lines, std::span<const std::uint32_t> run)
    : lines_(lines),
      c_(lines.direction(run[run.size() / 2])),
      o_(lines.point(run[run.size() / 2])),
      cc_(fathom::dot(c_, c_)) {
  inverse_cc_ = 1 / cc_;
  LineTuple<Number> first, middle, last;
  double error = 0;
  if (!tuple(run.front(), first, error) || !tuple(run.back(), last, error) ||
      !tuple(run[run.size() / 2], middle, error))
    return;
  for (std::size_t i = 0; i < 6; ++i) {
    frame_.m[i] = (first[i] + last[i]) * 0.5;
    frame_.e[i] = (last[i] - first[i]) * 0.5;
  }
  chord_m_ = frame_.m;
  const Number ee = dot6(frame_.e, frame_.e);
  if (truncated(ee) > 0x1p-900) inverse_ee_ = 1 / ee;
  bend(middle);
  // No line's tuple is larger than these terms and its residual together.
  for (std::size_t i = 0; i < 6; ++i)
    error_of_terms_ = std::max(error_of_terms_, 2 * error_bound::parabola<Number> * size_of_terms(frame_, i));
  frame_.valid = true;
}

// D = (<c,c>/<d,c>) d and Q = p - t D with <Q - o, c> near 0, for the middle line (o, c).
template <class Lines>
[[gnu::always_inline]] inline bool ParabolicFit<Lines>::tuple(std::size_t i, LineTuple<Number>& result,
                                                              double& error) const {
  const Vec3<Number> d = lines_.direction(i), p = lines_.point(i);
  const Number along = fathom::dot(d, c_);
  if (!(along > cc_ * 0.25)) return false;
  const Number scale = cc_ / along;
  const Number t = fathom::dot(p - o_, c_) * inverse_cc_;
  const Vec3<Number> turned{d.x * scale, d.y * scale, d.z * scale};
  result = {turned.x, turned.y, turned.z, p.x - t * turned.x, p.y - t * turned.y, p.z - t * turned.z};
  error = error_bound::tuple<Number>(truncated(t));
  return true;
}

// The place along the chord.
template <class Lines>
[[gnu::always_inline]] inline typename Lines::Number ParabolicFit<Lines>::parameter(const LineTuple<Number>& x) const {
  const auto part = [&](std::size_t i) { return (x[i] - chord_m_[i]) * frame_.e[i]; };
  const Number along = ((part(0) + part(1)) + (part(2) + part(3))) + (part(4) + part(5));
  return std::clamp<Number>(along * inverse_ee_, -1.0, 1.0);
}

// From the chord to the parabola through the middle line.
template <class Lines>
void ParabolicFit<Lines>::bend(const LineTuple<Number>& middle) {
  const Number s = parameter(middle), bulge = 1 - s * s;
  if (bulge < 0.25) return;
  for (std::size_t i = 0; i < 6; ++i) {
    frame_.k[i] = (chord_m_[i] + frame_.e[i] * s - middle[i]) / bulge;
    frame_.m[i] = frame_.m[i] - frame_.k[i];
  }
}

template <class Lines>
bool ParabolicFit<Lines>::place(std::size_t i, Place& place) const {
  LineTuple<Number> x;
  double error = 0;
  if (!frame_.valid || !tuple(i, x, error)) return false;
  place.s = parameter(x);
  for (std::size_t k = 0; k < 6; ++k)
    place.residual[k] = x[k] - (frame_.m[k] + (frame_.e[k] + frame_.k[k] * place.s) * place.s);
  place.error = error + error_of_terms_;
  return true;
}

template <class Lines>
LineFrame<typename Lines::Number> line_frame(const Lines& lines, std::span<const std::uint32_t> run) {
  const ParabolicFit<Lines> fit(lines, run);
  LineFrame<typename Lines::Number> frame = fit.frame();
  typename ParabolicFit<Lines>::Place place;
  for (const std::uint32_t line : run) {
    if (!fit.place(line, place)) return {};
    for (std::size_t i = 0; i < 6; ++i) {
      frame.r[i] = std::max(frame.r[i], taylor::rounded_up(std::fabs(truncated(place.residual[i])) + place.error));
    }
  }
  return frame;
}

// |w| <= (1 + 256u) (y0 + (y1^2 + y2^2) / (2 y0)) for the components y of w in the basis, if y0 >
// 0. In this basis little else than what matters varies, so that the models cut off little.
template <class Number>
std::optional<TaylorModel<Number>> margin_model(const LineFrame<Number>& a, const LineFrame<Number>& b,
                                                const Number& bound) {
  if (!a.valid || !b.valid) return std::nullopt;
  const Vec3<Number> of_a{a.m[0], a.m[1], a.m[2]}, of_b{b.m[0], b.m[1], b.m[2]};
  Basis<Number> basis;
  if (!orthonormal<Number>(fathom::cross(of_a, of_b), of_a, basis)) return std::nullopt;
  const Models<Number> y = cross(turned(a, 0, basis, false), turned(b, 0, basis, true));
  const Number shortest = taylor::least(y[0]);
  if (!(truncated(shortest) > 0x1p-500)) return std::nullopt;
  const Number half = 0.5 / shortest * error_bound::raised_quotient;
  const TaylorModel<Number> length = combination<Number>(1, y[0], half, y[1] * y[1] + y[2] * y[2]);
  const Models<Number> p = turned(a, 3, basis, false), q = turned(b, 3, basis, true);
  const Number rho = sqrt(bound) * (1 + Number(error_bound::frame_length<Number>));
  TaylorModel<Number> margin =
      combination<Number>(1, dot<Number>({q[0] - p[0], q[1] - p[1], q[2] - p[2]}, y), -rho, length);
  margin.radius =
      taylor::rounded_up(margin.radius + error_bound::frame_volume<Number> * (margin.norm() + margin.radius));
  return margin;
}

bool frames_beyond(const LineFrame<double>& a, const LineFrame<double>& b, double bound) {
  if (!std::isfinite(bound)) return false;
  const std::optional<double> margin = frames_margin(a, b, bound);
  return margin && *margin > 0;
}

template class ParabolicFit<LineImages>;
template class ParabolicFit<WideLines>;
template LineFrame<double> line_frame(const LineImages& lines, std::span<const std::uint32_t> run);
template LineFrame<WideFloat> line_frame(const WideLines& lines, std::span<const std::uint32_t> run);
template std::optional<TaylorModel<double>> margin_model(const LineFrame<double>& a, const LineFrame<double>& b,
                                                         const double& bound);
template std::optional<TaylorModel<WideFloat>> margin_model(const LineFrame<WideFloat>& a,
                                                            const LineFrame<WideFloat>& b, const WideFloat& bound);

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
  const double size = std::max({std::fabs(of_rows.front().least), std::fabs(of_rows.back().least),
                                std::fabs(of_columns.front().least), std::fabs(of_columns.back().least)});
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
