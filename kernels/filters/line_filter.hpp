// SPDX-License-Identifier: GPL-3.0-or-later
// The floating-point filters of the closest lines: they throw out pairs of lines that are proved to
// be farther apart than a bound, one by one in a few nanoseconds, or a block of them at once.
// Whatever they are unsure of they return, for exact arithmetic to decide. They are sound in every
// rounding mode; the error bounds are derived in proofs/closest_lines.md.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "kernels/number/wide_float.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

/// Binary64 images of lines, one array per coordinate. Points are scaled by 2^-exponent into [-1,
/// 1], directions each by a power of two of its own so that the largest component lies in [1/2, 1];
/// either is within 2^-53 a coordinate.
class LineImages {
 public:
  using Number = double;

  explicit LineImages(long exponent = 0) : exponent_(exponent) {}

  /// |coordinates of point| <= 2^exponent; direction not zero.
  void push_back(const Vector& point, const Vector& direction);
  /// Makes this the images of the chosen lines, which are given by numbers or by ids.
  void gather(const LineImages& all, const auto& chosen) {
    exponent_ = all.exponent_;
    for (const auto coordinate :
         {&LineImages::px, &LineImages::py, &LineImages::pz, &LineImages::dx, &LineImages::dy, &LineImages::dz}) {
      const std::vector<double>& from = all.*coordinate;
      std::vector<double>& to = this->*coordinate;
      to.resize(chosen.size());
      for (std::size_t i = 0; i < chosen.size(); ++i) to[i] = from[static_cast<std::uint32_t>(chosen[i])];
    }
  }
  /// Turns the direction of line i round.
  void reverse(std::size_t i);

  [[nodiscard]] std::size_t size() const { return px.size(); }
  [[nodiscard]] long exponent() const { return exponent_; }
  [[nodiscard]] Vec3<double> point(std::size_t i) const { return {px[i], py[i], pz[i]}; }
  [[nodiscard]] Vec3<double> direction(std::size_t i) const { return {dx[i], dy[i], dz[i]}; }

  std::vector<double> px, py, pz, dx, dy, dz;

 private:
  long exponent_;
};

/// An upper bound of numerator/denominator * 4^-exponent, which is >= 0: less than 2^-48 of it
/// above; but never below the least normal number, and +infinity for some values from 2^1000 on.
double image_bound(const mpz_class& numerator, const mpz_class& denominator, long exponent);

/// Replaces `unsure` by the indices of the lines of `many`, ascending, whose squared distance to
/// line `one` of `lines` is not proved to exceed `bound` strictly (parallel lines among them).
/// `bound` is a squared distance in images, >= 0, +infinity allowed. Both sets must have the same
/// exponent.
void not_farther(const LineImages& lines, std::size_t one, const LineImages& many, double bound,
                 std::vector<std::uint32_t>& unsure);

/// Lines [first, last) of one set; not empty.
struct LineRun {
  std::size_t first, last;

  [[nodiscard]] std::size_t size() const { return last - first; }
  friend bool operator==(const LineRun&, const LineRun&) = default;
};

/// The same among the lines of a run of `many` only.
void not_farther(const LineImages& lines, std::size_t one, const LineImages& many, LineRun run, double bound,
                 std::vector<std::uint32_t>& unsure);

/// The same for one pair: true only if line i of `a` is proved to be strictly farther from line j
/// of `b` than the bound.
bool surely_farther(const LineImages& a, std::size_t i, const LineImages& b, std::size_t j, double bound);

/// Images of arcs: the nodes at both ends, scaled like directions.
class ArcImages {
 public:
  void push_back(const Vector& from, const Vector& to);
  std::vector<double> fx, fy, fz, tx, ty, tz;
};

/// Lines with their arcs: line i's direction is the normal of arc i's great circle. A view.
struct LineSet {
  const LineImages& images;
  const ArcImages& arcs;
};

/// As not_farther, but a pair is also left out when its arcs are proved not to cross. Arcs that
/// touch are never proved not to cross.
void crossing_and_not_farther(const LineSet& lines, std::size_t one, const LineSet& many, double bound,
                              std::vector<std::uint32_t>& unsure);

// Blocks, by the vertex test: is one vertex difference s of P so far out at the four corner
// crossings of a block of lines that the whole block lies beyond a bound? u -> <s,u> - rho |u| is
// concave, and all crossings of the block lie in the cone of its corners. [proofs/cutting.md]

/// A squared distance in the images' units, enclosed.
struct LineBound {
  double above = 0;  ///< as image_bound; +infinity allowed
  double below = 0;
};
LineBound line_bound(const mpz_class& numerator, const mpz_class& denominator, long exponent);

/// What the vertex test reads of some lines of a chain: the first, the last and one between.
struct BlockSide {
  std::size_t first, middle, last;
};

/// Some rows and some columns.
struct Block {
  BlockSide rows, columns;
};

inline BlockSide side_of(LineRun run) { return {run.first, run.first + run.size() / 2, run.last - 1}; }

enum class CornerVerdict { beyond, within, unsure };

/// With s = q - p for the points q of the middle column and p of the middle row, and w = d x e for
/// the directions d of the first and the last row and e of the first and the last column: `beyond`
/// proves <s,w> > 0 and <s,w>^2 > bound |w|^2 for all four w; `within` proves that this fails for
/// one. w = 0 is never beyond.
CornerVerdict corners_beyond(const LineImages& rows, const LineImages& columns, const Block& block,
                             const LineBound& bound);

/// An estimate, without any guarantee, of <q - p, w>^2 / |w|^2 for lines i and j: what orders a
/// search.
double estimated_squared_distance(const LineImages& a, std::size_t i, const LineImages& b, std::size_t j);

// Lines in wide floats, for near ties: a filter between the one in binary64 and exact arithmetic,
// and what wide frames are made of. [proofs/closest_lines.md, "Wide filter"]

/// A line scaled as those of LineImages are: the point by 2^-exponent into [-1, 1], the direction
/// by a power of two of its own so that the largest component lies in [1/2, 1]; either is within
/// 2^-120 a coordinate.
struct WideLine {
  Vec3<WideFloat> point, direction;

  void reverse() { direction = -direction; }
};

/// |coordinates of point| <= 2^exponent; direction not zero.
WideLine wide_line(const Vector& point, const Vector& direction, long exponent);

/// Lines that are made when they are first asked for: seldom are all of them. Not to be shared
/// between threads.
class WideLines {
 public:
  using Number = WideFloat;
  using Make = std::function<WideLine(std::size_t)>;

  WideLines(std::size_t size, Make make) : size_(size), make_(std::move(make)) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const WideLine& operator[](std::size_t i) const;
  [[nodiscard]] const Vec3<WideFloat>& point(std::size_t i) const { return (*this)[i].point; }
  [[nodiscard]] const Vec3<WideFloat>& direction(std::size_t i) const { return (*this)[i].direction; }

 private:
  std::size_t size_;
  Make make_;
  mutable std::vector<std::uint32_t> place_;  // one more than the index among those made, or 0; empty before the first
  mutable std::deque<WideLine> made_;         // which stay where they are
};

/// An upper bound of numerator/denominator * 4^-exponent, which is >= 0: by less than a part in
/// 2^113.
WideFloat wide_bound(const mpz_class& numerator, const mpz_class& denominator, long exponent);

/// True only if the lines are not parallel and their squared distance exceeds `bound` strictly.
/// `bound` is a squared distance in images, >= 0, as from wide_bound. Both lines must have the same
/// exponent.
bool surely_farther(const WideLine& a, const WideLine& b, const WideFloat& bound);

}  // namespace fathom::kernels
