// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "view/stages/charts_picture.hpp"

namespace fathom::atlas {
namespace {

using std::numbers::pi;

constexpr double least_angle = 1e-9;  // radians
constexpr double flatness = 0.2;      // pixels
constexpr unsigned first_splits = 3, most_splits = 12;

Place scaled(const Place& p, double by) { return {p[0] * by, p[1] * by, p[2] * by}; }
double length(const Place& p) { return std::hypot(p[0], p[1], p[2]); }

struct Refiner {
  const SphereArc& arc;
  const Projection& project;
  std::vector<Pixel>& result;

  void add(double begin, const Pixel& first, double end, const Pixel& last, unsigned splits) const {
    const double middle = (begin + end) / 2;
    const Pixel pixel = project(arc.at(middle));
    const double off = std::hypot(pixel.x - (first.x + last.x) / 2, pixel.y - (first.y + last.y) / 2);
    if (splits < most_splits && (splits < first_splits || off > flatness)) {
      add(begin, first, middle, pixel, splits + 1);
      add(middle, pixel, end, last, splits + 1);
    } else if (std::hypot(last.x - result.back().x, last.y - result.back().y) > flatness / 2 || end == arc.end) {
      result.push_back(last);
    }
  }
};

}  // namespace

double dot(const Place& p, const Place& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

Place cross(const Place& p, const Place& q) { return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]}; }

Place SphereArc::at(double t) const {
  const double c = std::cos(t), s = std::sin(t);
  return {c * from[0] + s * side[0], c * from[1] + s * side[1], c * from[2] + s * side[2]};
}

std::optional<SphereArc> arc_of(const stages::StagedBody& body, stages::Index edge) {
  const auto& [from, to] = body.arcs[edge];
  if (from && to && body.rank == 3) {
    const Place &p = body.nodes[*from], &q = body.nodes[*to];
    const Place circle = cross(p, q);
    const double size = length(circle);
    if (size < least_angle) return std::nullopt;
    return SphereArc{p, cross(scaled(circle, 1 / size), p), 0, std::atan2(size, dot(p, q))};
  }
  if (edge >= body.circles.size()) return std::nullopt;
  const Place& circle = body.circles[edge];
  if (from) return SphereArc{body.nodes[*from], cross(circle, body.nodes[*from]), 0, pi};
  // A full circle begins anywhere on it.
  const Place axis = std::abs(circle[0]) < 0.6 ? Place{1, 0, 0} : Place{0, 1, 0};
  const Place start = cross(circle, axis);
  const Place unit = scaled(start, 1 / length(start));
  return SphereArc{unit, cross(circle, unit), 0, 2 * pi};
}

std::vector<SphereArc> parts_in(const SphereArc& arc, const Place& z) {
  const double a = dot(arc.from, z), b = dot(arc.side, z);
  if (std::hypot(a, b) < least_angle) return {arc};  // all of it lies on the equator
  const double top = std::atan2(b, a);
  std::vector<SphereArc> parts;
  for (const int turn : {-1, 0, 1}) {
    SphereArc part = arc;
    part.begin = std::max(arc.begin, top - pi / 2 + 2 * pi * turn);
    part.end = std::min(arc.end, top + pi / 2 + 2 * pi * turn);
    if (part.end - part.begin > least_angle) parts.push_back(part);
  }
  return parts;
}

std::vector<Pixel> polyline(const SphereArc& arc, const Projection& project) {
  std::vector<Pixel> result{project(arc.at(arc.begin))};
  const Pixel last = project(arc.at(arc.end));
  Refiner{arc, project, result}.add(arc.begin, result.front(), arc.end, last, 0);
  return result;
}

std::string path_text(const std::vector<Pixel>& pixels) {
  std::string result;
  for (const Pixel& pixel : pixels) result += fmt::format("{}{:.1f} {:.1f}", result.empty() ? 'M' : 'L', pixel.x, pixel.y);
  return result;
}

}  // namespace fathom::atlas
