// SPDX-License-Identifier: GPL-3.0-or-later
// A direction u of doubles is an exact direction, so it proves that p is extreme if <u,p> is
// greater than <u,q> for every other q by more than twice the error of the computed values.
//                                                               [proofs/kernels.md, "Error bounds"]
//
// The search. In the metric in which the points spread alike in all directions, the way from their
// centre to p is a good guess for u. While some q is farther, u is turned towards p - q.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernels/filters/error_bounds.hpp"
#include "kernels/filters/support.hpp"

namespace fathom::kernels {
namespace {

using Triple = std::array<double, 3>;

constexpr double least_size = 0x1p-900;
constexpr double almost_nothing = 0x1p-50;  // keeps the metric of flat sets finite
constexpr std::size_t leaf_size = 24;
constexpr int turns = 20;

double product(const Triple& u, const Triple& p) { return u[0] * p[0] + u[1] * p[1] + u[2] * p[2]; }
Triple minus(const Triple& p, const Triple& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

double size_of(const Triple& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

double quotient(double c) { return c; }
double quotient(const mpq_class& q) {
  const mpz_srcptr num = q.get_num_mpz_t(), den = q.get_den_mpz_t();
  if (mpz_size(num) <= 1 && mpz_size(den) == 1) {
    const double size = static_cast<double>(mpz_getlimbn(num, 0)) / static_cast<double>(mpz_getlimbn(den, 0));
    return sgn(q) < 0 ? -size : size;
  }
  const double above = q.get_num().get_d(), below = q.get_den().get_d();
  return std::isfinite(above) && std::isfinite(below) ? above / below : q.get_d();
}

const mpq_class& component(const Point& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }
double component(const Triple& p, int axis) { return p[static_cast<std::size_t>(axis)]; }

// Doubles are compared as bits: small ones may be flushed to zero. So 0 and -0 differ, and then
// nothing is said.
bool is_zero(const mpq_class& c) { return c == 0; }
bool is_zero(double c) { return std::bit_cast<std::uint64_t>(c) == 0; }
bool equal(const Point& p, const Point& q) { return p == q; }
bool equal(const Triple& p, const Triple& q) {
  using Bits = std::array<std::uint64_t, 3>;
  return std::bit_cast<Bits>(p) == std::bit_cast<Bits>(q);
}

/// P is Point, or Triple.
template <class P>
struct Image {
  Triple at;
  const P* exact;
  [[nodiscard]] bool same_as(const Image& other) const {
    return exact == other.exact || (at == other.at && equal(*exact, *other.exact));
  }
};

/// Scales one coordinate of all points. False if its numbers are too large or too small for
/// doubles.
template <class P>
bool scale(std::vector<Image<P>>& points, int axis) {
  double size = 0;
  for (Image<P>& p : points) {
    p.at[axis] = quotient(component(*p.exact, axis));
    size = std::max(size, std::abs(p.at[axis]));
  }
  if (!std::isfinite(size)) return false;
  if (size < least_size)
    return std::ranges::all_of(points, [&](const Image<P>& p) { return is_zero(component(*p.exact, axis)); });
  const double unit = std::ldexp(1, -std::ilogb(size) - 1);  // to multiply by it rounds as ldexp does
  for (Image<P>& p : points) p.at[axis] *= unit;
  return true;
}

/// Points in boxes within boxes. The computed value of a box's corner is no less than that of any
/// point in it: rounding is monotone.
template <class Image>
class Boxes {
 public:
  /// Puts the points in another order: those of a box lie together.
  explicit Boxes(std::vector<Image>& points) : points_(points) { split(0, points.size()); }

  /// The farthest of the points that do not equal `self`; null if no value is greater than `least`.
  [[nodiscard]] const Image* farthest_but(const Image& self, const Triple& u, double least) const {
    Search search{self, u, least, nullptr};
    look(0, search);
    return search.found;
  }

 private:
  struct Box {
    Triple low, high;
    std::size_t begin, end, second;  // second: the other half, the first follows the box itself; 0 if it is not split
  };
  struct Search {
    const Image& self;
    const Triple& u;
    double value;
    const Image* found;
  };

  std::size_t split(std::size_t begin, std::size_t end) {
    const std::size_t at = boxes_.size();
    Box box{points_[begin].at, points_[begin].at, begin, end, 0};
    for (std::size_t i = begin; i < end; ++i) {
      for (int c = 0; c < 3; ++c) {
        box.low[c] = std::min(box.low[c], points_[i].at[c]);
        box.high[c] = std::max(box.high[c], points_[i].at[c]);
      }
    }
    boxes_.push_back(box);
    if (end - begin <= leaf_size) return at;
    const Triple extent = minus(box.high, box.low);
    const auto axis = std::max_element(extent.begin(), extent.end()) - extent.begin();
    const std::size_t middle = begin + (end - begin) / 2;
    const auto to = [&](std::size_t i) { return points_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(to(begin), to(middle), to(end),
                     [&](const Image& p, const Image& q) { return p.at[axis] < q.at[axis]; });
    split(begin, middle);
    boxes_[at].second = split(middle, end);
    return at;
  }

  static double bound(const Box& box, const Triple& u) {
    return product(u, {u[0] < 0 ? box.low[0] : box.high[0], u[1] < 0 ? box.low[1] : box.high[1],
                       u[2] < 0 ? box.low[2] : box.high[2]});
  }

  void look(std::size_t at, Search& search) const {
    const Box& box = boxes_[at];
    if (!(bound(box, search.u) > search.value)) return;
    if (box.second != 0) {
      look(at + 1, search);
      look(box.second, search);
      return;
    }
    for (std::size_t i = box.begin; i < box.end; ++i) {
      const double value = product(search.u, points_[i].at);
      if (!(value > search.value) || points_[i].same_as(search.self)) continue;
      search.value = value;
      search.found = &points_[i];
    }
  }

  std::vector<Image>& points_;
  std::vector<Box> boxes_;
};

/// The inverse of the points' covariance, which is kept away from singular: times(v) by its
/// Cholesky factor.
class Metric {
 public:
  template <class Image>
  Metric(const std::vector<Image>& points, const Triple& centre) {
    for (const Image& p : points) {
      const Triple d = minus(p.at, centre);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j) factor_[i][j] += d[i] * d[j];
    }
    for (int i = 0; i < 3; ++i) {
      const double spread = factor_[i][i];
      for (int j = 0; j <= i; ++j) {
        for (int k = 0; k < j; ++k) factor_[i][j] -= factor_[i][k] * factor_[j][k];
        if (j < i) factor_[i][j] *= factor_[j][j];
      }
      factor_[i][i] = spread > 0 ? 1 / std::sqrt(std::max(factor_[i][i], almost_nothing * spread)) : 1;
    }
  }

  [[nodiscard]] Triple times(const Triple& v) const {
    const auto& [x, y, z] = factor_;
    Triple u{v[0] * x[0], 0, 0};
    u[1] = (v[1] - y[0] * u[0]) * y[1];
    u[2] = (v[2] - z[0] * u[0] - z[1] * u[1]) * z[2];
    u[2] *= z[2];
    u[1] = (u[1] - z[1] * u[2]) * y[1];
    u[0] = (u[0] - y[0] * u[1] - z[0] * u[2]) * x[0];
    return u;
  }

 private:
  std::array<Triple, 3> factor_{};  // lower triangle; the inverses of the diagonal
};

template <class Image>
bool seen_extreme(const Image& self, const Boxes<Image>& boxes, Triple u, const Metric& metric) {
  for (int turn = 0; turn < turns; ++turn) {
    const double size = size_of(u);
    if (!(size > 0)) return false;
    for (double& c : u) c *= 1 / size;
    const double value = product(u, self.at);
    if (!std::isfinite(value)) return false;
    const Image* farther = boxes.farthest_but(self, u, value - error_bound::difference_of_heights);
    if (farther == nullptr) return true;
    const Triple away = minus(self.at, farther->at), turned = metric.times(away);
    const double lack = -product(u, away) / product(away, turned);
    for (int c = 0; c < 3; ++c) u[c] += 2 * lack * turned[c];
  }
  return false;
}

template <class P>
bool all_seen(std::span<const P> exact) {
  std::vector<Image<P>> points;
  points.reserve(exact.size());
  for (const P& p : exact) points.push_back({{}, &p});
  if (!scale(points, 0) || !scale(points, 1) || !scale(points, 2)) return false;
  Triple centre{};
  for (const Image<P>& p : points)
    for (int c = 0; c < 3; ++c) centre[c] += p.at[c] / static_cast<double>(points.size());
  const Boxes boxes(points);
  const Metric metric(points, centre);
  return std::ranges::all_of(
      points, [&](const Image<P>& p) { return seen_extreme(p, boxes, metric.times(minus(p.at, centre)), metric); });
}

}  // namespace

bool all_seen_extreme(std::span<const Point> points) { return all_seen(points); }
bool all_seen_extreme(std::span<const std::array<double, 3>> points) { return all_seen(points); }

}  // namespace fathom::kernels
