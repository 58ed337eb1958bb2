// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/filters/line_filter.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "kernels/filters/error_bounds.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/predicates/direction.hpp"

namespace fathom::kernels {
namespace {

// Each step below is justified in proofs/closest_lines.md, "Filter".

// Two neighbours at a time, or one. A vector type of the compiler, since -O2 alone would not
// vectorise these loops.
typedef double Lanes __attribute__((vector_size(16)));
constexpr std::size_t lanes = sizeof(Lanes) / sizeof(double);

template <class Lane>
Lane load(const std::vector<double>& from, std::size_t j) {
  Lane lane;
  std::memcpy(&lane, from.data() + j, sizeof(Lane));
  return lane;
}

template <class Lane>
Lane larger(Lane a, Lane b) {
  return a > b ? a : b;
}

template <class Lane>
Lane smaller(Lane a, Lane b) {
  return a < b ? a : b;
}

// Positive only if line j is strictly farther from the line (p, d) than the bound.
struct Farther {
  Vec3<double> p, d;
  double bound;

  Farther(const LineImages& lines, std::size_t i, double squared_bound)
      : p(lines.point(i)), d(lines.direction(i)), bound(squared_bound * error_bound::raised_bound) {}

  template <class Lane>
  Lane margin(const LineImages& many, std::size_t j) const {
    const Lane ex = load<Lane>(many.dx, j), ey = load<Lane>(many.dy, j), ez = load<Lane>(many.dz, j);
    const Lane wx = d.y * ez - d.z * ey;
    const Lane wy = d.z * ex - d.x * ez;
    const Lane wz = d.x * ey - d.y * ex;
    const Lane height =
        (p.x - load<Lane>(many.px, j)) * wx + (p.y - load<Lane>(many.py, j)) * wy + (p.z - load<Lane>(many.pz, j)) * wz;
    const Lane least = larger<Lane>(larger<Lane>(height, -height) - error_bound::height_over_line, Lane{});
    return least * least - bound * (wx * wx + wy * wy + wz * wz + error_bound::squared_length);
  }
};

// Positive only if both ends of arc j lie strictly on one side of the great circle d.
struct OnOneSide {
  Vec3<double> d;

  template <class Lane>
  Lane margin(const ArcImages& many, std::size_t j) const {
    const Lane from = d.x * load<Lane>(many.fx, j) + d.y * load<Lane>(many.fy, j) + d.z * load<Lane>(many.fz, j);
    const Lane to = d.x * load<Lane>(many.tx, j) + d.y * load<Lane>(many.ty, j) + d.z * load<Lane>(many.tz, j);
    return larger<Lane>(smaller<Lane>(from, to), smaller<Lane>(-from, -to)) - error_bound::product;
  }
};

// Positive only if the arcs one and j do not cross. They cross when <f,e>, -<t,e>, -<f',d> and
// <t',d> have one sign, for the ends f, t of the one and f', t' of the other, on the circles d and
// e.
double not_crossing(const LineSet& lines, std::size_t one, const LineSet& many, std::size_t j) {
  const auto side = [](const ArcImages& a, std::size_t i, const LineImages& l, std::size_t k) {
    return std::pair(a.fx[i] * l.dx[k] + a.fy[i] * l.dy[k] + a.fz[i] * l.dz[k],
                     a.tx[i] * l.dx[k] + a.ty[i] * l.dy[k] + a.tz[i] * l.dz[k]);
  };
  const auto [from, to] = side(lines.arcs, one, many.images, j);
  const auto [many_from, many_to] = side(many.arcs, j, lines.images, one);
  const double least = smaller(smaller(from, -to), smaller(-many_from, many_to));
  const double most = larger(larger(from, -to), larger(-many_from, many_to));
  return smaller(most, -least) - error_bound::product;
}

// Replaces `unsure` by the indices j in the run whose margin is not positive. Most blocks have
// none, and end with one comparison.
template <class Test, class Many>
void collect(const Test& test, const Many& many, LineRun run, std::vector<std::uint32_t>& unsure) {
  constexpr std::size_t block = 64;
  unsure.clear();
  double margin[block];
  std::uint32_t found[block];
  for (std::size_t begin = run.first; begin < run.last; begin += block) {
    const std::size_t n = std::min(block, run.last - begin);
    Lanes least = {1, 1};
    std::size_t k = 0;
    for (; k + lanes <= n; k += lanes) {
      const Lanes m = test.template margin<Lanes>(many, begin + k);
      std::memcpy(margin + k, &m, sizeof m);
      least = smaller<Lanes>(m, least);
    }
    if (k < n) {  // the last of an odd number
      margin[k] = test.template margin<double>(many, begin + k);
      least[0] = std::min(margin[k], least[0]);
    }
    if (least[0] > 0 && least[1] > 0) continue;
    std::size_t size = 0;
    for (k = 0; k < n; ++k) {
      found[size] = static_cast<std::uint32_t>(begin + k);
      size += !(margin[k] > 0);
    }
    unsure.insert(unsure.end(), found, found + size);
  }
}

struct Crossing {
  double height, squared_length;
};

Crossing crossing(const Vec3<double>& s, const LineImages& a, std::size_t i, const LineImages& b, std::size_t j) {
  const Vec3<double> w = cross(a.direction(i), b.direction(j));
  return {dot(s, w), dot(w, w)};
}

// The reverse of the proof that a line is farther: 0 <= height' <= H + E bounds the height from
// above, W - S the length from below.
CornerVerdict verdict(const Crossing& c, const LineBound& bound) {
  const double low = c.height - error_bound::height_over_line;
  if (low > 0 &&
      low * low - bound.above * error_bound::raised_bound * (c.squared_length + error_bound::squared_length) > 0) {
    return CornerVerdict::beyond;
  }
  const double high = c.height + error_bound::height_over_line;
  if (high <= 0) return CornerVerdict::within;
  const double shortest = c.squared_length - error_bound::squared_length;
  if (shortest > 0 && bound.below * error_bound::lowered_bound * shortest - high * high > 0)
    return CornerVerdict::within;
  return CornerVerdict::unsure;
}

}  // namespace

void LineImages::push_back(const Vector& point, const Vector& direction) {
  const Vec3<double> p = image(point, exponent_), d = direction_image(direction);
  px.push_back(p.x);
  py.push_back(p.y);
  pz.push_back(p.z);
  dx.push_back(d.x);
  dy.push_back(d.y);
  dz.push_back(d.z);
}

void LineImages::reverse(std::size_t i) {
  dx[i] = -dx[i];
  dy[i] = -dy[i];
  dz[i] = -dz[i];
}

double image_bound(const mpz_class& numerator, const mpz_class& denominator, long exponent) {
  long n_exponent = 0, d_exponent = 0;
  const double n = mpz_get_d_2exp(&n_exponent, numerator.get_mpz_t());
  const double d = mpz_get_d_2exp(&d_exponent, denominator.get_mpz_t());
  const long shift = n_exponent - d_exponent - 2 * exponent;
  if (shift > 1000 && n > 0) return std::numeric_limits<double>::infinity();
  // Truncation makes n too small by less than one unit, and d no larger; quotient and product round
  // by one unit each: 8 are enough.
  return std::max(std::ldexp(n / d * error_bound::raised_quotient, static_cast<int>(std::max(shift, -4000L))),
                  std::numeric_limits<double>::min());
}

void not_farther(const LineImages& lines, std::size_t one, const LineImages& many, double bound,
                 std::vector<std::uint32_t>& unsure) {
  not_farther(lines, one, many, {0, many.size()}, bound, unsure);
}

void not_farther(const LineImages& lines, std::size_t one, const LineImages& many, LineRun run, double bound,
                 std::vector<std::uint32_t>& unsure) {
  collect(Farther(lines, one, bound), many, run, unsure);
}

bool surely_farther(const LineImages& a, std::size_t i, const LineImages& b, std::size_t j, double bound) {
  return Farther(a, i, bound).margin<double>(b, j) > 0;
}

void ArcImages::push_back(const Vector& from, const Vector& to) {
  const Vec3<double> f = direction_image(from), t = direction_image(to);
  fx.push_back(f.x);
  fy.push_back(f.y);
  fz.push_back(f.z);
  tx.push_back(t.x);
  ty.push_back(t.y);
  tz.push_back(t.z);
}

void crossing_and_not_farther(const LineSet& lines, std::size_t one, const LineSet& many, double bound,
                              std::vector<std::uint32_t>& unsure) {
  const Farther farther(lines.images, one, bound);
  // Short arcs seldom meet the great circle: this test comes first, over all, and the two that cost
  // more over the rest.
  collect(OnOneSide{farther.d}, many.arcs, {0, many.images.size()}, unsure);
  std::erase_if(unsure, [&](std::uint32_t j) {
    return farther.margin<double>(many.images, j) > 0 || not_crossing(lines, one, many, j) > 0;
  });
}

LineBound line_bound(const mpz_class& numerator, const mpz_class& denominator, long exponent) {
  LineBound bound{image_bound(numerator, denominator, exponent), 0};
  // image_bound exceeds the value by less than a part in 2^48, unless it was raised to the least
  // normal number or cut at infinity.
  const bool raised = bound.above <= 2 * std::numeric_limits<double>::min();
  if (std::isfinite(bound.above) && !raised) bound.below = bound.above * error_bound::below_raised;
  return bound;
}

CornerVerdict corners_beyond(const LineImages& rows, const LineImages& columns, const Block& block,
                             const LineBound& bound) {
  const Vec3<double> s = columns.point(block.columns.middle) - rows.point(block.rows.middle);
  CornerVerdict worst = CornerVerdict::beyond;
  for (const std::size_t i : {block.rows.first, block.rows.last}) {
    for (const std::size_t j : {block.columns.first, block.columns.last}) {
      const CornerVerdict corner = verdict(crossing(s, rows, i, columns, j), bound);
      if (corner == CornerVerdict::within) return corner;
      if (corner == CornerVerdict::unsure) worst = corner;
    }
  }
  return worst;
}

double estimated_squared_distance(const LineImages& a, std::size_t i, const LineImages& b, std::size_t j) {
  const Crossing c = crossing(b.point(j) - a.point(i), a, i, b, j);
  return c.height * c.height / c.squared_length;
}

WideLine wide_line(const Vector& point, const Vector& direction, long exponent) {
  return {wide_image(point, exponent), wide_image(direction, binary_exponent({&direction, 1}))};
}

const WideLine& WideLines::operator[](std::size_t i) const {
  if (place_.empty()) place_.resize(size_);
  if (place_[i] == 0) {
    made_.push_back(make_(i));
    place_[i] = static_cast<std::uint32_t>(made_.size());
  }
  return made_[place_[i] - 1];
}

WideFloat wide_bound(const mpz_class& numerator, const mpz_class& denominator, long exponent) {
  return WideFloat::scaled(numerator, 2 * exponent) / WideFloat::scaled(denominator, 0) *
         (1 + WideFloat(8 * WideFloat::unit));
}

// As the filter in binary64, with smaller units.
bool surely_farther(const WideLine& a, const WideLine& b, const WideFloat& bound) {
  const Vec3<WideFloat> w = cross(a.direction, b.direction);
  const WideFloat least = abs(dot(a.point - b.point, w)) - error_bound::height_over_line_of<WideFloat>;
  if (least <= 0) return false;
  const WideFloat raised = bound * (1 + WideFloat(16 * WideFloat::unit));
  return least * least > raised * (dot(w, w) + error_bound::squared_length_of<WideFloat>);
}

}  // namespace fathom::kernels
