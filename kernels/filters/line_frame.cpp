// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/filters/line_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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
  const auto minor = [&](std::size_t i, std::size_t j) { return product_of_sides(d[i], e[j]) - product_of_sides(d[j], e[i]); };
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

// Three directions, the first along w, the second towards d. Orthonormal up to 16u in each product, or else there is none.
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
  for (std::size_t j = 0; j < 3; ++j) reach[j] = f.r[from + j] + error_bound::parabola<Number> * size_of_terms(f, from + j);
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

}  // namespace

template <class Lines>
ParabolicFit<Lines>::ParabolicFit(const Lines& lines, std::span<const std::uint32_t> run)
    : lines_(lines), c_(lines.direction(run[run.size() / 2])), o_(lines.point(run[run.size() / 2])), cc_(fathom::dot(c_, c_)) {
  inverse_cc_ = 1 / cc_;
  LineTuple<Number> first, middle, last;
  double error = 0;
  if (!tuple(run.front(), first, error) || !tuple(run.back(), last, error) || !tuple(run[run.size() / 2], middle, error)) return;
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
[[gnu::always_inline]] inline bool ParabolicFit<Lines>::tuple(std::size_t i, LineTuple<Number>& result, double& error) const {
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
  for (std::size_t k = 0; k < 6; ++k) place.residual[k] = x[k] - (frame_.m[k] + (frame_.e[k] + frame_.k[k] * place.s) * place.s);
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

// |w| <= (1 + 256u) (y0 + (y1^2 + y2^2) / (2 y0)) for the components y of w in the basis, if y0 > 0. In this basis little else than what
// matters varies, so that the models cut off little.
template <class Number>
std::optional<TaylorModel<Number>> margin_model(const LineFrame<Number>& a, const LineFrame<Number>& b, const Number& bound) {
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
  TaylorModel<Number> margin = combination<Number>(1, dot<Number>({q[0] - p[0], q[1] - p[1], q[2] - p[2]}, y), -rho, length);
  margin.radius = taylor::rounded_up(margin.radius + error_bound::frame_volume<Number> * (margin.norm() + margin.radius));
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
template std::optional<TaylorModel<double>> margin_model(const LineFrame<double>& a, const LineFrame<double>& b, const double& bound);
template std::optional<TaylorModel<WideFloat>> margin_model(const LineFrame<WideFloat>& a, const LineFrame<WideFloat>& b,
                                                            const WideFloat& bound);

}  // namespace fathom::kernels
