// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/filters/meeting_points.hpp"
#include "kernels/predicates/direction.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {
namespace {

using error_bound::unit;

// Of the components of g x h; of <g x h, e>; of |g x h|^2; of |g|^2. Normals have components of at most 1.
constexpr double of_direction = 16 * unit, of_determinant = 64 * unit, of_square = 256 * unit, of_normal = 16 * unit;
// Of the numerators of a plane's foot, a line's foot and the meeting of three planes, relative to the sum of the heights' sizes.
constexpr double of_plane_foot = 4 * unit, of_line_foot = 64 * unit, of_meeting = 32 * unit;
// Relative to the sizes of what is added up, as in rational_point.cpp.
constexpr double of_side = 64 * unit, of_order = 256 * unit, of_underflow = 0x1p-350;

// Beyond these, underflow could count.
constexpr double most_height = 0x1p20, least_denominator = 0x1p-40;

// v / w, where each component of v errs by `error_v`, and w by `error_w`.
PointImage quotient(const Vec3<double>& v, double error_v, double w, double error_w, double heights) {
  const double least = std::fabs(w) - error_w;
  if (!(least > least_denominator && heights < most_height)) return {{}, std::numeric_limits<double>::infinity()};
  const Vec3<double> p{v.x / w, v.y / w, v.z / w};
  const double size = largest(p);
  return {p, 2 * (error_v + size * error_w) / least + 4 * unit * size + of_underflow};
}

Vec3<double> scaled(double s, const Vec3<double>& v) { return {s * v.x, s * v.y, s * v.z}; }

}  // namespace

PointImage foot_image(const PlaneImage& g) {
  const Vec3<double>& n = g.normal;
  const double height = std::fabs(g.height);
  return quotient(scaled(g.height, n), of_plane_foot * height, dot(n, n), of_normal, height);
}

MeetingLine::MeetingLine(const PlaneImage& g, const PlaneImage& h) : g_(g), h_(h), direction_(cross(g.normal, h.normal)) {}

bool MeetingLine::surely_exists() const { return largest(direction_) > of_direction; }

PointImage MeetingLine::foot() const {
  const Vec3<double> v = scaled(g_.height, cross(h_.normal, direction_)) + scaled(h_.height, cross(direction_, g_.normal));
  const double heights = std::fabs(g_.height) + std::fabs(h_.height);
  return quotient(v, of_line_foot * heights, dot(direction_, direction_), of_square, heights);
}

std::optional<Sign> MeetingLine::leads_beyond(const PlaneImage& e) const { return sure_sign(dot(direction_, e.normal), of_determinant); }

PointImage MeetingLine::meeting(const PlaneImage& e) const {
  const Vec3<double> v =
      scaled(g_.height, cross(h_.normal, e.normal)) + scaled(h_.height, cross(e.normal, g_.normal)) + scaled(e.height, direction_);
  const double heights = std::fabs(g_.height) + std::fabs(h_.height) + std::fabs(e.height);
  return quotient(v, of_meeting * heights, dot(direction_, e.normal), of_determinant, heights);
}

std::optional<Sign> sure_side(const PlaneImage& plane, const PointImage& p) {
  const double x = plane.normal.x * p.at.x, y = plane.normal.y * p.at.y, z = plane.normal.z * p.at.z;
  const double size = std::fabs(x) + std::fabs(y) + std::fabs(z) + std::fabs(plane.height);
  return sure_sign(x + y + z - plane.height, of_side * size + 4 * p.error + of_underflow);
}

std::optional<Sign> sure_order(const PointImage& p, double squared) {
  const double square = dot(p.at, p.at), error = 8 * p.error * (largest(p.at) + p.error);
  return sure_sign(square - squared, of_order * (square + squared) + error + of_underflow);
}

}  // namespace fathom::kernels
