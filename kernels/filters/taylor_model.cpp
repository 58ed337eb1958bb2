// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "kernels/filters/line_frame.hpp"

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
  [[nodiscard]] Number on_edge(double sign) const { return tt + sign * t + least_of_parabola<Number>(ss, s + sign * st); }
};

// t leaves: tt t^2 + (t + st s) t is at least -(t + st s)^2 / (4 tt), attained when that t lies in [-1, 1]. Only for tt > 0.
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
