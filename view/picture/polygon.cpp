// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace fathom::picture {
namespace {

template <class P>
using Number = std::remove_cvref_t<decltype(P::x)>;

template <class P>
Number<P> turn(const P& p, const P& q, const P& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// The part of a path where `inside` is not negative. `inside` is linear.
template <class P, class Inside>
std::vector<P> half(const std::vector<P>& path, bool closed, const Inside& inside) {
  std::vector<P> result;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const P& p = path[i];
    const Number<P> at_p = inside(p);
    if (at_p >= 0) result.push_back(p);
    if (i + 1 == path.size() && !closed) break;
    const P& q = path[(i + 1) % path.size()];
    const Number<P> at_q = inside(q);
    if ((at_p < 0) == (at_q < 0)) continue;
    const Number<P> t = at_p / (at_p - at_q);
    result.push_back({Number<P>(p.x + t * (q.x - p.x)), Number<P>(p.y + t * (q.y - p.y))});
  }
  return result;
}

template <class P>
std::vector<P> inside_box(std::vector<P> path, bool closed, const P& low, const P& high) {
  path = half(path, closed, [&](const P& p) { return Number<P>(p.x - low.x); });
  path = half(path, closed, [&](const P& p) { return Number<P>(high.x - p.x); });
  path = half(path, closed, [&](const P& p) { return Number<P>(p.y - low.y); });
  return half(path, closed, [&](const P& p) { return Number<P>(high.y - p.y); });
}

template <class P>
std::vector<P> around(std::vector<P> places) {
  std::ranges::sort(places, [](const P& p, const P& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
  const auto last =
      std::unique(places.begin(), places.end(), [](const P& p, const P& q) { return p.x == q.x && p.y == q.y; });
  places.erase(last, places.end());
  if (places.size() < 3) return places;
  std::vector<P> result;
  const auto add = [&](const P& p, std::size_t fixed) {
    while (result.size() >= fixed + 2 && !(turn(result[result.size() - 2], result.back(), p) > 0)) result.pop_back();
    result.push_back(p);
  };
  for (const P& p : places) add(p, 0);
  const std::size_t lower = result.size() - 1;
  for (auto p = places.rbegin() + 1; p != places.rend(); ++p) add(*p, lower);
  result.pop_back();
  return result;
}

/// Shares of a segment, from 0 to 1.
struct Part {
  double from, to;
};

/// What of the segment lies in the closed polygon; from >= to if nothing does.     [Cyrus and Beck]
Part part_inside(const Dot& p, const Dot& q, const std::vector<Dot>& polygon) {
  Part part{0, 1};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Dot &r = polygon[i], &s = polygon[(i + 1) % polygon.size()];
    const double at_p = turn(r, s, p), at_q = turn(r, s, q);
    if (at_p < 0 && at_q < 0) return {1, 0};
    if (at_p < 0) part.from = std::max(part.from, at_p / (at_p - at_q));
    else if (at_q < 0) part.to = std::min(part.to, at_p / (at_p - at_q));
  }
  return part;
}

/// What is left of [0, 1] without these parts.
std::vector<Part> rest_of(std::vector<Part> covered) {
  constexpr double least = 1e-6;  // shorter ones are of rounding
  std::ranges::sort(covered, {}, &Part::from);
  std::vector<Part> rest;
  double reached = 0;
  for (const Part& part : covered) {
    if (part.from > reached + least) rest.push_back({reached, part.from});
    reached = std::max(reached, part.to);
  }
  if (reached < 1 - least) rest.push_back({reached, 1});
  return rest;
}

Dot between(const Dot& p, const Dot& q, double share) { return {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)}; }

}  // namespace

std::vector<std::pair<Dot, Dot>> united_outline(const std::vector<std::vector<Dot>>& polygons) {
  constexpr double beside =
      0.05;  // pixels: where a side is asked about, just outside its polygon, as its neighbour over a seam is there
  std::vector<std::pair<Dot, Dot>> result;
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    const std::vector<Dot>& own = polygons[k];
    for (std::size_t i = 0; i < own.size(); ++i) {
      const Dot &p = own[i], &q = own[(i + 1) % own.size()];
      const double right = q.x - p.x, up = q.y - p.y, length = std::hypot(right, up);
      if (!(length > 0)) continue;
      const Dot out{beside * up / length, -beside * right / length};
      const Dot r{p.x + out.x, p.y + out.y}, s{q.x + out.x, q.y + out.y};
      std::vector<Part> covered;
      for (std::size_t other = 0; other < polygons.size(); ++other) {
        if (other == k || polygons[other].size() < 3) continue;
        const Part part = part_inside(r, s, polygons[other]);
        if (part.from < part.to) covered.push_back(part);
      }
      for (const Part& part : rest_of(std::move(covered)))
        result.emplace_back(between(p, q, part.from), between(p, q, part.to));
    }
  }
  return result;
}

std::vector<Dot> clipped(std::vector<Dot> path, bool closed, const Dot& low, const Dot& high) {
  if (!std::ranges::all_of(path, [](const Dot& d) { return std::isfinite(d.x) && std::isfinite(d.y); })) return {};
  return inside_box(std::move(path), closed, low, high);
}

std::vector<Spot> clipped(std::vector<Spot> path, bool closed, const Spot& low, const Spot& high) {
  return inside_box(std::move(path), closed, low, high);
}

std::vector<Dot> outline(std::vector<Dot> dots) { return around(std::move(dots)); }
std::vector<Spot> outline(std::vector<Spot> places) { return around(std::move(places)); }

}  // namespace fathom::picture
