// SPDX-License-Identifier: GPL-3.0-or-later
// The frame test: lines of a run lie near a parabola in their parameter space. A Taylor model of N - rho |w| over two such frames bounds
// all pairs of the runs at once, to third order in the runs' extent. In binary64, and in wide floats for near ties.  [proofs/cutting.md]
#pragma once

#include <optional>
#include <span>

#include "kernels/filters/line_filter.hpp"

namespace fathom::kernels {

/// The six coordinates of a line: direction D, point Q.
template <class Number>
using LineTuple = std::array<Number, 6>;

/// The lines of a run as tuples: for each line there are a positive multiple D of its direction, a point Q on it and an s in [-1, 1] with
/// |(D, Q) - (m + e s + k s^2)| <= r in every coordinate. Q avoids long ways along the lines.
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

/// Fits a parabola to the lines of a run, of which there is at least one, in chain order. Lines is LineImages or WideLines.
template <class Lines>
class ParabolicFit {
 public:
  using Number = typename Lines::Number;

  ParabolicFit(const Lines& lines, std::span<const std::uint32_t> run);

  /// m, e and k; r is 0.
  [[nodiscard]] const LineFrame<Number>& frame() const { return frame_; }
  /// A line's tuple is the parabola's point at s in [-1, 1] and the residual. Each coordinate of that errs by at most `error`, and 8u
  /// of itself.
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

/// A model of a lower bound of the margin <q - p, w> - sqrt(bound) |w|, w = d x e, for the lines (p, d) of the first frame and (q, e) of
/// the second, as tuples at s and t; nullopt if a frame is not valid, or if some w might be 0. `bound` is a squared distance in images, as
/// from image_bound or wide_bound; it must be finite.
template <class Number>
std::optional<TaylorModel<Number>> margin_model(const LineFrame<Number>& a, const LineFrame<Number>& b, const Number& bound);

/// A lower bound of that margin over all pairs of lines.
template <class Number>
std::optional<Number> frames_margin(const LineFrame<Number>& a, const LineFrame<Number>& b, const Number& bound) {
  const std::optional<TaylorModel<Number>> model = margin_model(a, b, bound);
  return model ? std::optional(taylor::least(*model)) : std::nullopt;
}

/// True only if <q - p, w> > 0 and <q - p, w>^2 > bound |w|^2 for every pair of lines. `bound` may be infinite. False means unsure.
bool frames_beyond(const LineFrame<double>& a, const LineFrame<double>& b, double bound);

}  // namespace fathom::kernels
