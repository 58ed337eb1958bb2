// SPDX-License-Identifier: GPL-3.0-or-later
// The frame test and the offset test: all pairs of two runs of lines are bounded at once, by Taylor
// models over the parabolas that the runs lie near. Sound in every rounding mode; the constants are
// derived in proofs/cutting.md.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "kernels/filters/error_bounds.hpp"
#include "kernels/filters/line_filter.hpp"
#include "kernels/number/wide_float.hpp"

namespace fathom::kernels {

// Quadratic Taylor models in two variables: a polynomial in floating-point numbers and a radius
// that holds everything that the polynomial leaves out, truncation and rounding alike.

/// All functions f with |f(s,t) - (c0 + c1 s + c2 t + c3 s^2 + c4 s t + c5 t^2)| <= radius for s, t
/// in [-1, 1]. Operations are inclusion isotonic: the result holds f + g, f g, ... for all f, g
/// that the operands hold. Number is double or WideFloat.
template <class Number>
struct TaylorModel {
  std::array<Number, 6> c{};
  double radius = 0;

  /// At least (1 - 7u) |f| for every f held, less the radius, with the u of binary64.
  [[nodiscard]] double linear() const { return size(1) + size(2); }
  [[nodiscard]] double quadratic() const { return size(3) + size(4) + size(5); }
  [[nodiscard]] double norm() const { return size(0) + linear() + quadratic(); }

 private:
  [[nodiscard]] double size(std::size_t i) const { return std::fabs(truncated(c[i])); }
};

namespace taylor {

// Each radius is a sum of fewer than 30 products of non-negative numbers: this makes up for its own
// rounding, and for underflow.
inline double rounded_up(double radius) { return radius * error_bound::raised_radius + error_bound::underflow; }

// What a product cuts off, rounds, and inherits.
template <class Number>
double radius_of_product(const TaylorModel<Number>& f, const TaylorModel<Number>& g) {
  const double fl = f.linear(), fq = f.quadratic(), gl = g.linear(), gq = g.quadratic();
  const double fn = std::fabs(truncated(f.c[0])) + fl + fq, gn = std::fabs(truncated(g.c[0])) + gl + gq;
  const double cut_off = fl * gq + fq * gl + fq * gq;
  const double rounding = error_bound::taylor_product<Number> * fn * gn;
  return rounded_up(cut_off + rounding + fn * g.radius + gn * f.radius + f.radius * g.radius);
}

template <class Number>
TaylorModel<Number> operator*(const TaylorModel<Number>& f, const TaylorModel<Number>& g) {
  return {{f.c[0] * g.c[0], f.c[0] * g.c[1] + f.c[1] * g.c[0], f.c[0] * g.c[2] + f.c[2] * g.c[0],
           f.c[0] * g.c[3] + f.c[3] * g.c[0] + f.c[1] * g.c[1],
           f.c[0] * g.c[4] + f.c[4] * g.c[0] + f.c[1] * g.c[2] + f.c[2] * g.c[1],
           f.c[0] * g.c[5] + f.c[5] * g.c[0] + f.c[2] * g.c[2]},
          radius_of_product(f, g)};
}

/// The product where f is a model in s alone, and g in t alone.
template <class Number>
TaylorModel<Number> product_of_sides(const TaylorModel<Number>& f, const TaylorModel<Number>& g) {
  return {{f.c[0] * g.c[0], f.c[1] * g.c[0], f.c[0] * g.c[2], f.c[3] * g.c[0], f.c[1] * g.c[2], f.c[0] * g.c[5]},
          radius_of_product(f, g)};
}

/// f plus g, or f minus g: of_pair(x, y) is x + y, or x - y.
template <class Number, class OfPair>
TaylorModel<Number> termwise(const TaylorModel<Number>& f, const TaylorModel<Number>& g, OfPair of_pair) {
  TaylorModel<Number> h;
  for (std::size_t i = 0; i < 6; ++i) h.c[i] = of_pair(f.c[i], g.c[i]);
  h.radius = rounded_up(f.radius + g.radius + error_bound::taylor_sum<Number> * (f.norm() + g.norm()));
  return h;
}
template <class Number>
TaylorModel<Number> operator+(const TaylorModel<Number>& f, const TaylorModel<Number>& g) {
  return termwise(f, g, std::plus<>());
}
template <class Number>
TaylorModel<Number> operator-(const TaylorModel<Number>& f, const TaylorModel<Number>& g) {
  return termwise(f, g, std::minus<>());
}

/// a f + b g.
template <class Number>
TaylorModel<Number> combination(const Number& a, const TaylorModel<Number>& f, const Number& b,
                                const TaylorModel<Number>& g) {
  TaylorModel<Number> h;
  for (std::size_t i = 0; i < 6; ++i) h.c[i] = a * f.c[i] + b * g.c[i];
  const double of_f = std::fabs(truncated(a)), of_g = std::fabs(truncated(b));
  const double absolute = of_f * f.norm() + of_g * g.norm();
  h.radius = rounded_up(of_f * f.radius + of_g * g.radius + error_bound::taylor_sum<Number> * absolute);
  return h;
}

/// Returns a lower bound, over the whole square, of every function that the model holds. The radius
/// must be finite.
template <class Number>
Number least(const TaylorModel<Number>& f);

extern template double least(const TaylorModel<double>& f);
extern template WideFloat least(const TaylorModel<WideFloat>& f);

}  // namespace taylor

// The frame test: lines of a run lie near a parabola in their parameter space. A Taylor model of N
// - rho |w| over two such frames bounds
// all pairs of the runs at once, to third order in the runs' extent. In binary64, and in wide
// floats for near ties.  [proofs/cutting.md]

/// The six coordinates of a line: direction D, point Q.
template <class Number>
using LineTuple = std::array<Number, 6>;

/// The lines of a run as tuples: for each line there are a positive multiple D of its direction, a
/// point Q on it and an s in [-1, 1] with |(D, Q) - (m + e s + k s^2)| <= r in every coordinate. Q
/// avoids long ways along the lines.
template <class Number>
struct LineFrame {
  LineTuple<Number> m{}, e{}, k{};
  std::array<double, 6> r{};
  bool valid = false;  ///< false when the directions of the run turn by more than an acute angle: there is no frame

  /// The frame of the parabola's own points.
  [[nodiscard]] LineFrame smooth() const {
    LineFrame frame = *this;
    frame.r = {};
    return frame;
  }
};

/// Fits a parabola to the lines of a run, of which there is at least one, in chain order. Lines is
/// LineImages or WideLines.
template <class Lines>
class ParabolicFit {
 public:
  using Number = typename Lines::Number;

  ParabolicFit(const Lines& lines, std::span<const std::uint32_t> run);

  /// m, e and k; r is 0.
  [[nodiscard]] const LineFrame<Number>& frame() const { return frame_; }
  /// A line's tuple is the parabola's point at s in [-1, 1] and the residual. Each coordinate of
  /// that errs by at most `error`, and 8u of itself.
  struct Place {
    Number s;
    LineTuple<Number> residual;
    double error;
  };
  /// Sets the place of line i; returns false if the line has no tuple.
  bool place(std::size_t i, Place& place) const;

 private:
  bool tuple(std::size_t i, LineTuple<Number>& result, double& error) const;
  [[nodiscard]] Number parameter(const LineTuple<Number>& x) const;
  void bend(const LineTuple<Number>& middle);

  const Lines& lines_;
  Vec3<Number> c_, o_;  // the middle line
  Number cc_, inverse_cc_;
  LineTuple<Number> chord_m_{};
  Number inverse_ee_ = 0;  // 0 if the chord is a point
  LineFrame<Number> frame_;
  double error_of_terms_ = 0;
};

/// The frame of the given lines. Linear.
template <class Lines>
LineFrame<typename Lines::Number> line_frame(const Lines& lines, std::span<const std::uint32_t> run);

/// A model of a lower bound of the margin <q - p, w> - sqrt(bound) |w|, w = d x e, for the lines
/// (p, d) of the first frame and (q, e) of the second, as tuples at s and t; nullopt if a frame is
/// not valid, or if some w might be 0. `bound` is a squared distance in images, as from image_bound
/// or wide_bound; it must be finite.
template <class Number>
std::optional<TaylorModel<Number>> margin_model(const LineFrame<Number>& a, const LineFrame<Number>& b,
                                                const Number& bound);

/// A lower bound of that margin over all pairs of lines.
template <class Number>
std::optional<Number> frames_margin(const LineFrame<Number>& a, const LineFrame<Number>& b, const Number& bound) {
  const std::optional<TaylorModel<Number>> model = margin_model(a, b, bound);
  return model ? std::optional(taylor::least(*model)) : std::nullopt;
}

/// True only if <q - p, w> > 0 and <q - p, w>^2 > bound |w|^2 for every pair of lines. `bound` may
/// be infinite. False means unsure.
bool frames_beyond(const LineFrame<double>& a, const LineFrame<double>& b, double bound);

// The offset test: where lines lie near two parabolas, but not as near as the ties between them
// are, each line's own distance from its parabola is kept, as one number. A pair's margin is that
// of the parabolas plus both numbers, up to what they do to each other. [proofs/cutting.md, Lemma
// 4]

/// A run of lines in chain order, with its frame.
struct FramedRun {
  const WideLines& lines;
  std::span<const std::uint32_t> run;
  const LineFrame<WideFloat>& frame;
};

/// A row and a column.
using LinePair = std::pair<std::uint32_t, std::uint32_t>;

/// Returns all pairs of a row and a column that are not proved to have <q - p, w> > 0 and <q - p,
/// w>^2 > bound |w|^2, w = d x e; nullopt if they are more than `most`, or if nothing can be said.
/// Time O(n log n) for n lines, and the pairs. `bound` is as for margin_model, and `smooth` that
/// model for the smooth frames of both runs.
std::optional<std::vector<LinePair>> pairs_left(const FramedRun& rows, const FramedRun& columns, const WideFloat& bound,
                                                const TaylorModel<WideFloat>& smooth, std::size_t most);

}  // namespace fathom::kernels
