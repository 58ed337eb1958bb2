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
TaylorModel<Number> model(const LineFrame<Number>& f, std::size_t i, bool in_t) {
  TaylorModel<Number> m;
  m.c[0] = f.m[i];
  m.c[in_t ? 2 : 1] = f.e[i];
  m.c[in_t ? 5 : 3] = f.k[i];
  m.radius = f.r[i];
  return m;
}

template <class Number>
using Models = std::array<TaylorModel<Number>, 3>;

template <class Number>
Models<Number> cross(const Models<Number>& d, const Models<Number>& e) {
  const auto minor = [&](std::size_t i, std::size_t j) { return d[i] * e[j] - d[j] * e[i]; };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

template <class Number>
TaylorModel<Number> dot(const Models<Number>& f, const Models<Number>& g) {
  return f[0] * g[0] + f[1] * g[1] + f[2] * g[2];
}

template <class Number>
TaylorModel<Number> along(const Models<Number>& w, const Vec3<Number>& g) {
  return combination<Number>(1, combination<Number>(g.x, w[0], g.y, w[1]), g.z, w[2]);
}

template <class Number>
Vec3<Number> normalised(const Vec3<Number>& v) {
  const Number length = sqrt(fathom::dot(v, v));
  return {v.x / length, v.y / length, v.z / length};
}

// Three directions, the first along w. Orthonormal up to 16u in each product, or else there is none.
template <class Number>
bool orthonormal(const Vec3<Number>& w, std::array<Vec3<Number>, 3>& basis) {
  if (!(truncated(fathom::dot(w, w)) > 0x1p-500)) return false;
  basis[0] = normalised(w);
  const Number x = abs(w.x), y = abs(w.y), z = abs(w.z);
  const Vec3<Number> least = x <= y && x <= z ? Vec3<Number>{1, 0, 0} : y <= z ? Vec3<Number>{0, 1, 0} : Vec3<Number>{0, 0, 1};
  basis[1] = normalised(fathom::cross(basis[0], least));
  basis[2] = normalised(fathom::cross(basis[0], basis[1]));
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const double expected = i == j ? 1 : 0;
      if (!(abs(fathom::dot(basis[i], basis[j]) - expected) <= error_bound::orthonormal<Number>)) return false;
    }
  }
  return true;
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
  if (ee > 0) inverse_ee_ = 1 / ee;
  bend(middle);
  frame_.valid = true;
}

// D = (<c,c>/<d,c>) d and Q = p - t D with <Q - o, c> near 0, for the middle line (o, c).
template <class Lines>
bool ParabolicFit<Lines>::tuple(std::size_t i, LineTuple<Number>& result, double& error) const {
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
typename Lines::Number ParabolicFit<Lines>::parameter(const LineTuple<Number>& x) const {
  LineTuple<Number> y;
  for (std::size_t i = 0; i < 6; ++i) y[i] = x[i] - chord_m_[i];
  return std::clamp<Number>(dot6(y, frame_.e) * inverse_ee_, -1.0, 1.0);
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
  double size = 0;
  for (std::size_t k = 0; k < 6; ++k) {
    place.residual[k] = x[k] - (frame_.m[k] + (frame_.e[k] + frame_.k[k] * place.s) * place.s);
    size = std::max(size, std::fabs(truncated(frame_.m[k])) + std::fabs(truncated(frame_.e[k])) + std::fabs(truncated(frame_.k[k])) +
                              std::fabs(truncated(x[k])));
  }
  place.error = taylor::rounded_up(error + error_bound::parabola<Number> * size);
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

// |w| <= (1 + 256u) (y0 + (y1^2 + y2^2) / (2 y0)) for the components y of w in the basis, if y0 > 0.
template <class Number>
std::optional<TaylorModel<Number>> margin_model(const LineFrame<Number>& a, const LineFrame<Number>& b, const Number& bound) {
  if (!a.valid || !b.valid) return std::nullopt;
  Models<Number> d, e, s;
  for (std::size_t i = 0; i < 3; ++i) {
    d[i] = model(a, i, false);
    e[i] = model(b, i, true);
    s[i] = model(b, i + 3, true) - model(a, i + 3, false);
  }
  const Models<Number> w = cross(d, e);
  std::array<Vec3<Number>, 3> basis;
  if (!orthonormal<Number>({w[0].c[0], w[1].c[0], w[2].c[0]}, basis)) return std::nullopt;
  const TaylorModel<Number> y0 = along(w, basis[0]), y1 = along(w, basis[1]), y2 = along(w, basis[2]);
  const Number shortest = taylor::least(y0);
  if (!(truncated(shortest) > 0x1p-500)) return std::nullopt;
  const Number half = 0.5 / shortest * error_bound::raised_quotient;
  const TaylorModel<Number> length = combination<Number>(1, y0, half, y1 * y1 + y2 * y2);
  const Number rho = sqrt(bound) * (1 + Number(error_bound::frame_length<Number>));
  return combination<Number>(1, dot(s, w), -rho, length);
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
