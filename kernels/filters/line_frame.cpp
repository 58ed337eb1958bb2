// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/filters/line_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernels/filters/taylor_model.hpp"

namespace fathom::kernels {
namespace {

using taylor::combination;
using taylor::operator*;
using Six = std::array<double, 6>;

double dot6(const Six& a, const Six& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 6; ++i) sum += a[i] * b[i];
  return sum;
}

// Turns lines into tuples: D = (<c,c>/<d,c>) d and Q = p - t D with <Q - o, c> near 0, for the run's middle line (o, c).
class Normaliser {
 public:
  Normaliser(const LineImages& lines, std::size_t middle)
      : lines_(lines), c_(lines.direction(middle)), o_(lines.point(middle)), cc_(dot(c_, c_)) {}

  // Whether line i has a tuple; `error` bounds each coordinate's distance from a true one.
  bool tuple(std::size_t i, Six& result, double& error) const {
    const Vec3<double> d = lines_.direction(i), p = lines_.point(i);
    const double along = dot(d, c_);
    if (!(along > cc_ / 4)) return false;
    const double scale = cc_ / along;
    const double t = dot(p - o_, c_) / cc_;
    const Vec3<double> turned{d.x * scale, d.y * scale, d.z * scale};
    result = {turned.x, turned.y, turned.z, p.x - t * turned.x, p.y - t * turned.y, p.z - t * turned.z};
    error = error_bound::tuple(t);
    return true;
  }

 private:
  const LineImages& lines_;
  Vec3<double> c_, o_;
  double cc_;
};

struct Chord {
  Six m{}, e{};
  double ee = 0;

  [[nodiscard]] double parameter(const Six& x) const {
    if (!(ee > 0)) return 0;
    Six y;
    for (std::size_t i = 0; i < 6; ++i) y[i] = x[i] - m[i];
    return std::clamp(dot6(y, e) / ee, -1.0, 1.0);
  }
};

// The parabola through the tuples of the first, the middle and the last line.
LineFrame parabola(const Chord& chord, const Six& middle) {
  LineFrame frame;
  frame.m = chord.m;
  frame.e = chord.e;
  const double s = chord.parameter(middle), bulge = 1 - s * s;
  if (bulge < 0.25) return frame;
  for (std::size_t i = 0; i < 6; ++i) {
    frame.k[i] = (chord.m[i] + chord.e[i] * s - middle[i]) / bulge;
    frame.m[i] -= frame.k[i];
  }
  return frame;
}

TaylorModel model(const LineFrame& f, std::size_t i, bool in_t) {
  TaylorModel m;
  m.c[0] = f.m[i];
  m.c[in_t ? 2 : 1] = f.e[i];
  m.c[in_t ? 5 : 3] = f.k[i];
  m.radius = f.r[i];
  return m;
}

using Models = std::array<TaylorModel, 3>;

Models cross(const Models& d, const Models& e) {
  const auto minor = [&](std::size_t i, std::size_t j) { return combination(1, d[i] * e[j], -1, d[j] * e[i]); };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

TaylorModel dot(const Models& f, const Models& g) { return combination(1, combination(1, f[0] * g[0], 1, f[1] * g[1]), 1, f[2] * g[2]); }

TaylorModel along(const Models& w, const Vec3<double>& g) { return combination(1, combination(g.x, w[0], g.y, w[1]), g.z, w[2]); }

// Three directions, the first along w. Orthonormal up to 16u in each product, or else there is none.
bool orthonormal(const Vec3<double>& w, std::array<Vec3<double>, 3>& basis) {
  const auto normalised = [](const Vec3<double>& v) {
    const double length = std::sqrt(dot(v, v));
    return Vec3<double>{v.x / length, v.y / length, v.z / length};
  };
  if (!(dot(w, w) > 0x1p-900)) return false;
  basis[0] = normalised(w);
  const double x = std::fabs(w.x), y = std::fabs(w.y), z = std::fabs(w.z);
  const Vec3<double> least = x <= y && x <= z ? Vec3<double>{1, 0, 0} : y <= z ? Vec3<double>{0, 1, 0} : Vec3<double>{0, 0, 1};
  basis[1] = normalised(cross(basis[0], least));
  basis[2] = normalised(cross(basis[0], basis[1]));
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      if (!(std::fabs(dot(basis[i], basis[j]) - (i == j)) <= error_bound::orthonormal)) return false;
    }
  }
  return true;
}

}  // namespace

LineFrame line_frame(const LineImages& lines, std::span<const std::uint32_t> run) {
  const Normaliser normaliser(lines, run[run.size() / 2]);
  Six first, middle, last;
  double error = 0;
  if (!normaliser.tuple(run.front(), first, error) || !normaliser.tuple(run.back(), last, error) ||
      !normaliser.tuple(run[run.size() / 2], middle, error)) {
    return {};
  }
  Chord chord;
  for (std::size_t i = 0; i < 6; ++i) {
    chord.m[i] = (first[i] + last[i]) / 2;
    chord.e[i] = (last[i] - first[i]) / 2;
  }
  chord.ee = dot6(chord.e, chord.e);
  LineFrame frame = parabola(chord, middle);
  for (const std::uint32_t line : run) {
    Six x;
    if (!normaliser.tuple(line, x, error)) return {};
    const double s = chord.parameter(x);
    for (std::size_t i = 0; i < 6; ++i) {
      const double fitted = frame.m[i] + (frame.e[i] + frame.k[i] * s) * s;
      const double size = std::fabs(frame.m[i]) + std::fabs(frame.e[i]) + std::fabs(frame.k[i]) + std::fabs(x[i]);
      frame.r[i] = std::max(frame.r[i], taylor::rounded_up(std::fabs(x[i] - fitted) + error + error_bound::parabola * size));
    }
  }
  frame.valid = true;
  return frame;
}

// |w| <= (1 + 2^-44) (y0 + (y1^2 + y2^2) / (2 y0)) for the components y of w in the basis, if y0 > 0.
bool frames_beyond(const LineFrame& a, const LineFrame& b, double bound) {
  if (!a.valid || !b.valid || !std::isfinite(bound)) return false;
  Models d, e, s;
  for (std::size_t i = 0; i < 3; ++i) {
    d[i] = model(a, i, false);
    e[i] = model(b, i, true);
    s[i] = combination(1, model(b, i + 3, true), -1, model(a, i + 3, false));
  }
  const Models w = cross(d, e);
  std::array<Vec3<double>, 3> basis;
  if (!orthonormal({w[0].c[0], w[1].c[0], w[2].c[0]}, basis)) return false;
  const TaylorModel y0 = along(w, basis[0]), y1 = along(w, basis[1]), y2 = along(w, basis[2]);
  const double shortest = taylor::least(y0);
  if (!(shortest > 0)) return false;
  const TaylorModel length = combination(1, y0, 1 / (2 * shortest) * error_bound::raised_quotient, combination(1, y1 * y1, 1, y2 * y2));
  const double rho = std::sqrt(bound) * error_bound::raised_frame_length;
  return taylor::least(combination(1, dot(s, w), -rho, length)) > 0;
}

}  // namespace fathom::kernels
