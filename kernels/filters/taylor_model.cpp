// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/filters/taylor_model.hpp"

#include <algorithm>

namespace fathom::kernels::taylor {
namespace {

// min of a x^2 + b x over [-1, 1], within rounding.
double least_of_parabola(double a, double b) {
  const double slope = std::fabs(b);
  return a > 0 && slope < 2 * a ? -(b * b) / (4 * a) : a - slope;
}

struct Quadratic {
  double s, t, ss, st, tt;

  [[nodiscard]] Quadratic swapped() const { return {t, s, tt, st, ss}; }
  // t = 1 and t = -1.
  [[nodiscard]] double on_edge(double sign) const { return tt + sign * t + least_of_parabola(ss, s + sign * st); }
};

// t leaves: tt t^2 + (t + st s) t is at least -(t + st s)^2 / (4 tt), attained when that t lies in [-1, 1]. Only for tt > 0.
double without_t(const Quadratic& q) {
  const double k = q.st / (2 * q.tt);
  return least_of_parabola(q.ss - q.st * k / 2, q.s - q.t * k) - q.t * q.t / (4 * q.tt);
}

// When t decides at its ends: q is concave in t, or steeper than it is curved.
bool t_at_ends(const Quadratic& q) { return q.tt <= 0 || std::fabs(q.t) - std::fabs(q.st) >= 2 * q.tt; }

// s t >= -(s^2 + t^2) / 2, with either sign.
double uncoupled(const Quadratic& q) {
  const double k = std::fabs(q.st) / 2;
  return least_of_parabola(q.ss - k, q.s) + least_of_parabola(q.tt - k, q.t);
}

double least_of(const Quadratic& q) {
  if (t_at_ends(q)) return std::min(q.on_edge(1), q.on_edge(-1));
  const Quadratic r = q.swapped();
  if (t_at_ends(r)) return std::min(r.on_edge(1), r.on_edge(-1));
  double best = uncoupled(q);
  // The quotients must be harmless: st / tt may not blow up what cancels.
  if (std::fabs(q.st) <= 4 * q.tt && std::fabs(q.t) <= 4 * q.tt) best = std::max(best, without_t(q));
  if (std::fabs(r.st) <= 4 * r.tt && std::fabs(r.t) <= 4 * r.tt) best = std::max(best, without_t(r));
  return best;
}

}  // namespace

double least(const TaylorModel& f) {
  const double bound = least_of({f.c[1], f.c[2], f.c[3], f.c[4], f.c[5]});
  return f.c[0] + bound - rounded_up(f.radius + error_bound::taylor_least * f.norm());
}

}  // namespace fathom::kernels::taylor
