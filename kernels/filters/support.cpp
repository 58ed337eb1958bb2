// SPDX-License-Identifier: GPL-3.0-or-later
// The support function of a finite point set: a filter in binary64 over all points, exact
// arithmetic for the few it leaves undecided. [proofs/kernels.md, "Error bounds"]
#include "kernels/filters/support.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "kernels/filters/plane.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/predicates/direction.hpp"

namespace fathom::kernels {
namespace {

constexpr std::size_t block_size =
    128;  // of points: small enough that a second look is cheap, large enough to skip well

constexpr long worth_wide_floats = 1000;  // bits of a product: shorter ones are computed as soon

// The least e >= 0 with |c| <= 2^e.
long exponent_of(const mpz_class& c) {
  if (c == 0) return 0;
  const auto bits = static_cast<long>(mpz_sizeinbase(c.get_mpz_t(), 2));
  const bool power_of_two = static_cast<long>(mpz_scan1(c.get_mpz_t(), 0)) == bits - 1;
  return power_of_two ? bits - 1 : bits;
}

void append_images(std::span<const Vector> points, const Vec3<long>& axes, std::vector<double>& x,
                   std::vector<double>& y, std::vector<double>& z) {
  const DefaultFloatEnvironment environment;
  for (std::vector<double>* images : {&x, &y, &z}) images->reserve(points.size());
  for (const Vector& p : points) {
    x.push_back(image(p.x, axes.x));
    y.push_back(image(p.y, axes.y));
    z.push_back(image(p.z, axes.z));
  }
}

Vec3<long> exponents_of(std::span<const Vector> points) {
  Vec3<long> e{0, 0, 0};
  const auto cover = [](long& exponent, const mpz_class& c) {
    if (mpz_sizeinbase(c.get_mpz_t(), 2) > static_cast<std::size_t>(exponent))
      exponent = std::max(exponent, exponent_of(c));
  };
  for (const Vector& p : points) {
    cover(e.x, p.x);
    cover(e.y, p.y);
    cover(e.z, p.z);
  }
  return e;
}

DirectionImage image_for(const PointCloud& cloud, const Vector& u) {
  const Vec3<long>& e = cloud.axis_exponents();
  const auto stretched = [](const mpz_class& c, long axis) { return c == 0 ? 0 : exponent_of(c) + axis; };
  const long f = std::max({stretched(u.x, e.x), stretched(u.y, e.y), stretched(u.z, e.z)});
  return {image(u.x, f - e.x), image(u.y, f - e.y), image(u.z, f - e.z), slack_of(f)};
}

// Nullopt if the enclosures are too wide for binary64.
std::optional<DirectionImage> image_for(const Vec3<long>& e, const Vec3<WideEnclosure>& u) {
  const std::int64_t f = std::max({u.x.order() + e.x, u.y.order() + e.y, u.z.order() + e.z});
  const auto narrow = [f](const WideEnclosure& c, long axis) {
    return c.error() + axis < f - error_bound::wide_digits;
  };
  if (!narrow(u.x, e.x) || !narrow(u.y, e.y) || !narrow(u.z, e.z)) return std::nullopt;
  const auto image = [f](const WideEnclosure& c, long axis) { return c.value().truncated(f - axis, negligible_image); };
  return DirectionImage{image(u.x, e.x), image(u.y, e.y), image(u.z, e.z), 2 * error_bound::product};
}

// The one place that computes the filter's value of points; two lanes at a time, or one.
template <class Lane>
struct Values {
  Lane x, y, z;
  Lane operator()(const Images& images, std::size_t i) const {
    Lane px, py, pz;
    std::memcpy(&px, images.x.data() + i, sizeof(Lane));
    std::memcpy(&py, images.y.data() + i, sizeof(Lane));
    std::memcpy(&pz, images.z.data() + i, sizeof(Lane));
    return x * px + y * py + z * pz;
  }
};

// A vector type of the compiler, since the order of the maxima is ours to choose and -O2 would not
// choose it.
typedef double Lanes __attribute__((vector_size(16)));

double greatest(const Images& images, const DirectionImage& u, std::size_t begin, std::size_t end) {
  constexpr double lowest = -std::numeric_limits<double>::infinity();
  const Values<Lanes> values{{u.x, u.x}, {u.y, u.y}, {u.z, u.z}};
  Lanes m[4] = {{lowest, lowest}, {lowest, lowest}, {lowest, lowest}, {lowest, lowest}};
  std::size_t i = begin;
  for (; i + 8 <= end; i += 8) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Lanes v = values(images, i + 2 * k);
      m[k] = v > m[k] ? v : m[k];
    }
  }
  double best = lowest;
  for (const Lanes& lanes : m) best = std::max({best, lanes[0], lanes[1]});
  for (const Values<double> value{u.x, u.y, u.z}; i < end; ++i) best = std::max(best, value(images, i));
  return best;
}

void find_maxima(const Images& images, const DirectionImage& u, std::vector<double>& maxima) {
  maxima.clear();
  for (std::size_t begin = 0; begin < images.size(); begin += block_size)
    maxima.push_back(greatest(images, u, begin, std::min(begin + block_size, images.size())));
}

// Calls visit(index, value) for every point whose computed value is at least `level`, in order.
template <class Visit>
void visit_from(const Images& images, const DirectionImage& u, const std::vector<double>& maxima, double level,
                Visit visit) {
  const Values<double> value{u.x, u.y, u.z};
  for (std::size_t block = 0; block < maxima.size(); ++block) {
    if (maxima[block] < level) continue;
    const std::size_t end = std::min((block + 1) * block_size, images.size());
    for (std::size_t i = block * block_size; i < end; ++i)
      if (const double v = value(images, i); v >= level) visit(static_cast<std::uint32_t>(i), v);
  }
}

// Leaves those of the listed points that may maximise <u, p>: none is surely below another.
// `enclosure(i)` is that of point i.
template <class EnclosureOf>
void leave_farthest(const PointCloud& cloud, const Vec3<WideEnclosure>& u, std::vector<std::uint32_t>& listed,
                    EnclosureOf enclosure) {
  const std::vector<std::uint32_t> all = std::move(listed);
  std::vector<WideEnclosure> values;
  values.reserve(all.size());
  for (const std::uint32_t i : all) values.push_back(dot<WideEnclosure>(u, enclosure(i)));
  // Of points that have much in common the difference has more digits than their products with u.
  const auto below = [&](std::size_t k, std::size_t other) {
    if (const auto sure = (values[other] - values[k]).sign()) return *sure == Sign::positive;
    const auto step = [&](int axis) {
      return WideEnclosure::of_difference(
          coordinate<WideEnclosure>(enclosure(all[other]), axis), coordinate(cloud[all[other]], axis),
          coordinate<WideEnclosure>(enclosure(all[k]), axis), coordinate(cloud[all[k]], axis));
    };
    return dot<WideEnclosure>(u, {step(0), step(1), step(2)}).sign() == Sign::positive;
  };
  std::size_t most = 0;
  for (std::size_t k = 1; k < all.size(); ++k)
    if (below(most, k)) most = k;
  listed.clear();
  for (std::size_t k = 0; k < all.size(); ++k)
    if (!below(k, most)) listed.push_back(all[k]);
}

Vec3<WideEnclosure> enclosed(const Vector& v) { return {WideEnclosure(v.x), WideEnclosure(v.y), WideEnclosure(v.z)}; }

// r = <u, p>, without a temporary.
void set_dot(mpz_class& r, const Vector& u, const Vector& p) {
  mpz_mul(r.get_mpz_t(), u.x.get_mpz_t(), p.x.get_mpz_t());
  mpz_addmul(r.get_mpz_t(), u.y.get_mpz_t(), p.y.get_mpz_t());
  mpz_addmul(r.get_mpz_t(), u.z.get_mpz_t(), p.z.get_mpz_t());
}

std::vector<std::uint32_t> extreme_among(const PointCloud& cloud, const Vector& u, std::vector<std::uint32_t> listed) {
  keep_greatest<mpz_class>(listed, [&](mpz_class& value, std::uint32_t i) { set_dot(value, u, cloud[i]); });
  return listed;
}

std::vector<std::uint32_t> all_indices(std::size_t n) {
  std::vector<std::uint32_t> all(n);
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

int axis_of_greatest(const Vector& u) {
  int axis = 0;
  for (const int other : {1, 2})
    if (mpz_cmpabs(coordinate(u, other).get_mpz_t(), coordinate(u, axis).get_mpz_t()) > 0) axis = other;
  return axis;
}

mpz_class shifted(const mpz_class& c, long exponent) { return c << static_cast<mp_bitcnt_t>(exponent); }

}  // namespace

double slack_of(long bits) { return bits + 2 <= 53 ? 0 : 2 * error_bound::product; }

PointCloud::PointCloud(std::vector<Vector> points, long exponent) : points_(std::move(points)), exponent_(exponent) {
  if (exponent < binary_exponent(points_))
    throw std::invalid_argument("the exponent of a point cloud is below that of its points");
  make_images({exponent, exponent, exponent});
}

PointCloud::PointCloud(std::vector<Vector> points) : points_(std::move(points)) {
  const Vec3<long> axes = exponents_of(points_);
  exponent_ = std::max({axes.x, axes.y, axes.z});
  make_images(axes);
}

void PointCloud::make_images(const Vec3<long>& axes) {
  axis_exponents_ = axes;
  append_images(points_, axes, x_, y_, z_);
}

LazyCloud::LazyCloud(const PointCloud& cloud) : cloud_(&cloud), axes_(exponents_of(cloud.points())) {
  append_images(cloud.points(), axes_, x_, y_, z_);
  enclosures_.reserve(cloud.size());
  for (const Vector& p : cloud.points()) enclosures_.push_back(enclosed(p));
}

long binary_exponent(std::span<const Vector> points) {
  const Vec3<long> e = exponents_of(points);
  return std::max({e.x, e.y, e.z});
}

void near_extreme(const Images& images, const DirectionImage& u, ScanMemory& memory) {
  find_maxima(images, u, memory.maxima);
  memory.near.clear();
  visit_from(images, u, memory.maxima, *std::max_element(memory.maxima.begin(), memory.maxima.end()) - u.slack,
             [&memory](std::uint32_t i, double) { memory.near.push_back(i); });
}

std::vector<std::uint32_t> extreme_points(const PointCloud& cloud, const Vector& u) {
  if (cloud.size() == 0 || is_zero(u)) return all_indices(cloud.size());
  const DirectionImage v = image_for(cloud, u);
  ScanMemory memory;
  near_extreme(cloud.images(), v, memory);
  std::vector<std::uint32_t>& near = memory.near;
  if (near.size() == 1 || v.slack == 0) return std::move(near);
  if (bit_length(u) + cloud.exponent() < worth_wide_floats) return extreme_among(cloud, u, std::move(near));
  leave_farthest(cloud, enclosed(u), near, [&](std::uint32_t i) { return enclosed(cloud[i]); });
  return near.size() == 1 ? std::move(near) : extreme_among(cloud, u, std::move(near));
}

std::vector<std::uint32_t> extreme_points(const LazyCloud& cloud, const Vec3<LazyInteger>& u,
                                          std::span<const std::uint32_t> level) {
  const Vec3<WideEnclosure> wide = enclosure(u);
  ScanMemory memory;
  std::vector<std::uint32_t>& near = memory.near;
  if (const std::optional<DirectionImage> v = image_for(cloud.axis_exponents(), wide))
    near_extreme(cloud.images(), *v, memory);
  else near = all_indices(cloud.points().size());
  if (near.size() > 1)
    leave_farthest(cloud.points(), wide, near,
                   [&](std::uint32_t i) -> const Vec3<WideEnclosure>& { return cloud.enclosure(i); });
  const bool all_level =
      near.size() == 1 || std::ranges::all_of(near, [&](std::uint32_t i) { return std::ranges::count(level, i) > 0; });
  if (all_level) return std::move(near);
  return extreme_among(cloud.points(), {u.x.exact(), u.y.exact(), u.z.exact()}, std::move(near));
}

std::vector<std::uint32_t> points_beyond(const PointCloud& cloud, const Vector& u, std::uint32_t k) {
  if (is_zero(u)) return {};
  const DirectionImage v = image_for(cloud, u);
  const Images images = cloud.images();
  const double level = Values<double>{v.x, v.y, v.z}(images, k);
  mpz_class bar, value;
  set_dot(bar, u, cloud[k]);
  std::vector<double> maxima;
  find_maxima(images, v, maxima);
  std::vector<std::uint32_t> beyond;
  visit_from(images, v, maxima, level - v.slack, [&](std::uint32_t i, double computed) {
    if (computed <= level + v.slack) {
      if (v.slack == 0) return;
      set_dot(value, u, cloud[i]);
      if (value <= bar) return;
    }
    beyond.push_back(i);
  });
  return beyond;
}

std::uint32_t likely_extreme_point(const Images& images, const Vec3<double>& u) {
  const DirectionImage v{u.x, u.y, u.z, 0};
  std::size_t begin = 0;
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < images.size(); i += block_size) {
    const double value = greatest(images, v, i, std::min(i + block_size, images.size()));
    if (value > best) {
      best = value;
      begin = i;
    }
  }
  const Values<double> value{v.x, v.y, v.z};
  const std::size_t end = std::min(begin + block_size, images.size());
  for (std::size_t i = begin; i < end; ++i)
    if (value(images, i) >= best) return static_cast<std::uint32_t>(i);
  return static_cast<std::uint32_t>(begin);
}

std::vector<std::uint32_t> extreme_points_naive(std::span<const Vector> points, const Vector& u) {
  std::vector<std::uint32_t> extreme;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const mpz_class ahead =
        extreme.empty() ? mpz_class(1) : mpz_class(dot(u, points[i]) - dot(u, points[extreme.front()]));
    if (ahead > 0) extreme.clear();
    if (ahead >= 0) extreme.push_back(i);
  }
  return extreme;
}

std::vector<std::uint32_t> points_beyond_naive(std::span<const Vector> points, const Vector& u, std::uint32_t k) {
  const mpz_class bar = dot(u, points[k]);
  std::vector<std::uint32_t> beyond;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (dot(u, points[i]) > bar) beyond.push_back(i);
  return beyond;
}

PlanarView::PlanarView(const PointCloud& cloud, const Vector& u) : cloud_(&cloud), u_(u) {
  const Vec3<long>& axes = cloud.axis_exponents();
  image_ = image(enclose({shifted(u.x, axes.x), shifted(u.y, axes.y), shifted(u.z, axes.z)}));
  const int up = axis_of_greatest(u);
  right_ = (up + 1) % 3;
  far_ = (up + 2) % 3;
}

double PlanarView::height(std::uint32_t p, std::uint32_t q) const {
  const PointCloud& c = *cloud_;
  return image_.x * (c.xs()[q] - c.xs()[p]) + image_.y * (c.ys()[q] - c.ys()[p]) + image_.z * (c.zs()[q] - c.zs()[p]);
}

Sign PlanarView::rise(std::uint32_t p, std::uint32_t q) const {
  if (const auto sure = sure_sign(height(p, q), error_bound::rise)) return *sure;
  return sign_of(dot(u_, (*cloud_)[q] - (*cloud_)[p]));
}

Sign PlanarView::turn(std::uint32_t o, std::uint32_t p, std::uint32_t q) const {
  const std::span<const double> rights = right_ == 0 ? cloud_->xs() : right_ == 1 ? cloud_->ys() : cloud_->zs();
  const double t = (rights[p] - rights[o]) * height(o, q) - height(o, p) * (rights[q] - rights[o]);
  if (const auto sure = sure_sign(t, error_bound::turn)) return *sure;
  const Vector op = (*cloud_)[p] - (*cloud_)[o], oq = (*cloud_)[q] - (*cloud_)[o];
  const mpz_class up_p = dot(u_, op), up_q = dot(u_, oq);
  for (const int axis : {right_, far_}) {
    const mpz_class exact = coordinate(op, axis) * up_q - up_p * coordinate(oq, axis);
    if (exact != 0) return sign_of(exact);
  }
  return Sign::zero;
}

}  // namespace fathom::kernels
