// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/solids/arrangement.hpp"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "kernels/predicates/direction.hpp"
#include "reference/polytope/hull.hpp"

namespace fathom::solids {

namespace {

using polytope::hash_value;

std::size_t hash_of(const Vector& v, const mpz_class& w) { return hash_value(v) * 0x9e3779b97f4a7c15 + hash_value(w); }

/// Divides the numbers by what they share, with this sign.
void reduce(std::initializer_list<mpz_class*> numbers, int sign) {
  mpz_class shared;
  for (const mpz_class* n : numbers)
    if (shared != 1) mpz_gcd(shared.get_mpz_t(), shared.get_mpz_t(), n->get_mpz_t());
  if (sign < 0) shared = -shared;
  if (shared == 1) return;
  for (mpz_class* n : numbers) mpz_divexact(n->get_mpz_t(), n->get_mpz_t(), shared.get_mpz_t());
}

/// Normal to the plane through three points, on the side where they appear counter-clockwise.
Vector normal_through(const kernels::RationalPoint& a, const kernels::RationalPoint& b,
                      const kernels::RationalPoint& c) {
  return cross(a.w * b.v - b.w * a.v, a.w * c.v - c.w * a.v);
}

/// Which component of v, not zero, is the first that is not 0.
int first_axis(const Vector& v) { return v.x != 0 ? 0 : v.y != 0 ? 1 : 2; }

/// The id of the element for which `is_it`, or of a new one, which `make` returns.
template <class I, class T, class IsIt, class Make>
I interned(kernels::IdVector<I, T>& all, std::unordered_multimap<std::size_t, std::uint32_t>& known, std::size_t hash,
           IsIt is_it, Make make) {
  const auto [begin, end] = known.equal_range(hash);
  for (auto entry = begin; entry != end; ++entry)
    if (is_it(all[I(entry->second)])) return I(entry->second);
  const I id(static_cast<std::uint32_t>(all.size()));
  all.push_back(make());
  known.emplace(hash, id.value);
  return id;
}

}  // namespace

PointId Arrangement::point(Vector v, mpz_class w) {
  reduce({&w, &v.x, &v.y, &v.z}, sgn(w));
  return interned(
      points_, known_points_, hash_of(v, w), [&](const kernels::RationalPoint& p) { return p.v == v && p.w == w; },
      [&] { return kernels::rational_point(v, w, exponent_); });
}

PointId Arrangement::point_at(const Point& position) {
  const auto& [x, y, z] = position;
  const mpz_class w = lcm(lcm(x.get_den(), y.get_den()), z.get_den());
  const auto over_w = [&](const mpq_class& c) { return mpz_class(c.get_num() * (w / c.get_den())); };
  return point({over_w(x), over_w(y), over_w(z)}, w);
}

std::optional<PlaneSide> Arrangement::plane(PointId p, PointId q, PointId r) {
  const kernels::RationalPoint& origin = points_[p];
  Vector normal = normal_through(origin, points_[q], points_[r]);
  if (is_zero(normal)) return std::nullopt;
  mpz_class height = dot(normal, origin.v);
  if (origin.w != 1) normal = origin.w * normal;
  const int sign = sgn(kernels::coordinate(normal, first_axis(normal)));
  reduce({&normal.x, &normal.y, &normal.z, &height}, sign);
  return PlaneSide{plane(normal, height), sign < 0};
}

PlaneId Arrangement::plane_across(int axis, PointId p) {
  const Vector normal{axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0};
  return plane(normal, kernels::coordinate(points_[p].v, axis));
}

PlaneId Arrangement::plane(const Vector& normal, const mpz_class& height) {
  return interned(
      planes_, known_planes_, hash_of(normal, height),
      [&](const kernels::OrientedPlane& e) { return e.normal == normal && e.height == height; },
      [&] { return kernels::oriented_plane(normal, height, exponent_); });
}

LineId Arrangement::line(Vector direction, Vector moment) {
  const int axis = first_axis(direction);
  reduce({&direction.x, &direction.y, &direction.z, &moment.x, &moment.y, &moment.z},
         sgn(kernels::coordinate(direction, axis)));
  return interned(
      lines_, known_lines_, hash_value(direction) * 31 + hash_value(moment),
      [&](const SpaceLine& l) { return l.direction == direction && l.moment == moment; },
      [&] {
        return SpaceLine{direction, moment, axis, {kernels::direction_image(direction), 0}};
      });
}

LineId Arrangement::line(PointId p, PointId q) {
  const kernels::RationalPoint &from = points_[p], &to = points_[q];
  return line(from.w * to.v - to.w * from.v, cross(from.v, to.v));
}

LineId Arrangement::line(PlaneId e, PlaneId f) {
  const kernels::OrientedPlane &g = planes_[e], &h = planes_[f];
  return line(cross(g.normal, h.normal), h.height * g.normal - g.height * h.normal);
}

PointId Arrangement::meeting(LineId l, PlaneId e) {
  const SpaceLine& line = lines_[l];
  const kernels::OrientedPlane& plane = planes_[e];
  return point(cross(plane.normal, line.moment) + plane.height * line.direction, dot(plane.normal, line.direction));
}

int Arrangement::turn(PlaneSide e, PlaneSide f, LineId l) const {
  const kernels::OrientedPlane &g = planes_[e.plane], &h = planes_[f.plane];
  const SpaceLine& line = lines_[l];
  const std::optional<kernels::Sign> sure = kernels::MeetingLine(g.image, h.image).leads_beyond(line.image);
  const int sign = sure ? to_int(*sure) : sgn(det(g.normal, h.normal, line.direction));
  return e.reversed == f.reversed ? sign : -sign;
}

int Arrangement::turn(PlaneSide e, PointId p, PointId q, PointId r) const {
  const int sign = sgn(dot(planes_[e.plane].normal, normal_through(points_[p], points_[q], points_[r])));
  return e.reversed ? -sign : sign;
}

namespace {

bool is_before(const Arrangement& space, const ChainEnd& a, const ChainEnd& b) {
  return a.line != b.line ? a.line < b.line : space.before(a.line, a.point, b.point);
}

/// Sets of numbers. The root of a set is its least one.
class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::uint32_t i, std::uint32_t k) {
    const auto [low, high] = std::minmax({root(i), root(k)});
    parent_[high] = low;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// A segment in one facet of a chunk.
struct FacetEdge {
  ChainEdge edge;
  std::uint32_t facet;
};

// Facets that meet at one segment: two of a chunk that is convex there, on both sides of it.
void add_if_reflex(const Arrangement& space, const Chunk& chunk, PointId low, PointId high,
                   const std::vector<const FacetEdge*>& there, std::vector<ReflexEdge>& found) {
  if (there.size() < 2) return;
  const auto side = [&](std::size_t i) { return chunk[there[i]->facet].side; };
  if (there.size() == 2) {
    const std::size_t up = there[0]->edge.times > 0 ? 0 : 1;
    if (side(0).plane != side(1).plane && space.turn(side(up), side(1 - up), there[0]->edge.line) > 0) return;
  }
  for (std::size_t i = 0; i + 1 < there.size(); i += 2) found.push_back({low, high, side(i).plane, side(i + 1).plane});
}

// The segments [begin, end) lie on one line.
void add_reflex_on_line(const Arrangement& space, const Chunk& chunk, std::vector<FacetEdge>::const_iterator begin,
                        std::vector<FacetEdge>::const_iterator end, std::vector<ReflexEdge>& found) {
  const ChainEdge& first = begin->edge;
  std::vector<const FacetEdge*> there;
  if (std::all_of(begin, end,
                  [&](const FacetEdge& e) { return e.edge.low == first.low && e.edge.high == first.high; })) {
    for (auto e = begin; e != end; ++e) there.push_back(&*e);
    add_if_reflex(space, chunk, first.low, first.high, there, found);
    return;
  }
  std::vector<PointId> points;
  for (auto e = begin; e != end; ++e) points.insert(points.end(), {e->edge.low, e->edge.high});
  std::ranges::sort(points, [&](PointId p, PointId q) { return space.before(first.line, p, q); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto before = [&](PointId p, PointId q) { return space.before(first.line, p, q); };
  const auto place = [&](PointId p) {
    return static_cast<std::size_t>(std::lower_bound(points.begin(), points.end(), p, before) - points.begin());
  };
  std::vector<std::vector<const FacetEdge*>> over(points.size());
  for (auto e = begin; e != end; ++e)
    for (std::size_t i = place(e->edge.low); points[i] != e->edge.high; ++i) over[i].push_back(&*e);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    add_if_reflex(space, chunk, points[i], points[i + 1], over[i], found);
}

}  // namespace

std::vector<ChainEdge> edges_between(const Arrangement& space, std::vector<ChainEnd> ends) {
  std::ranges::sort(ends, [&](const ChainEnd& a, const ChainEnd& b) { return is_before(space, a, b); });
  std::vector<ChainEdge> edges;
  std::int64_t times = 0;
  PointId last;
  for (std::size_t i = 0; i < ends.size();) {
    const ChainEnd& end = ends[i];
    std::int64_t sum = 0;
    for (; i < ends.size() && ends[i].line == end.line && ends[i].point == end.point; ++i) sum += ends[i].times;
    if (sum == 0) continue;
    if (times != 0) edges.push_back({end.line, last, end.point, times});
    times -= sum;
    last = end.point;
  }
  return edges;
}

std::vector<ChainEdge> normalised(const Arrangement& space, const std::vector<ChainEdge>& edges) {
  std::vector<ChainEnd> ends;
  ends.reserve(2 * edges.size());
  for (const ChainEdge& e : edges) {
    ends.push_back({e.line, e.low, -e.times});
    ends.push_back({e.line, e.high, e.times});
  }
  return edges_between(space, std::move(ends));
}

std::vector<ReflexEdge> reflex_edges(const Arrangement& space, const Chunk& chunk) {
  std::vector<FacetEdge> all;
  for (std::uint32_t f = 0; f < chunk.size(); ++f)
    for (const ChainEdge& edge : chunk[f].edges) all.push_back({edge, f});
  std::ranges::sort(all, {}, [](const FacetEdge& e) { return std::tuple(e.edge.line, e.edge.low, e.facet); });
  std::vector<ReflexEdge> found;
  for (auto begin = all.begin(); begin != all.end();) {
    const auto end =
        std::find_if(begin, all.end(), [&](const FacetEdge& e) { return e.edge.line != begin->edge.line; });
    add_reflex_on_line(space, chunk, begin, end, found);
    begin = end;
  }
  return found;
}

std::vector<PointId> Cutter::points_of(const Chunk& chunk) {
  std::vector<PointId> points;
  for (const ChainFacet& facet : chunk)
    for (const ChainEdge& e : facet.edges) points.push_back(e.from());
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

Cutter::Sides Cutter::look(PlaneId e, const std::vector<PointId>& points) {
  sides_.resize(space_.point_count());
  Sides found;
  for (const PointId p : points) {
    const int side = space_.side(e, p);
    sides_[p.value] = static_cast<std::int8_t>(side);
    found.above += side > 0 ? 1 : 0;
    found.below += side < 0 ? 1 : 0;
  }
  looked_at_ += points.size();
  return found;
}

// What a facet leaves open in the plane is a chain on one line, known by its ends: those of the
// facet's own segments there. The cap has it backwards.
void Cutter::cut_facet(const ChainFacet& facet, PlaneId e, CutChunk& parts, Cap& cap) {
  const auto begin = facet.edges.begin(), end = facet.edges.end();
  const auto is_on = [&](const ChainEdge& s) { return side(s.low) == 0; };
  const auto is_above = [&](const ChainEdge& s) { return side(s.low) > 0; };
  if (std::none_of(begin, end, [&](const ChainEdge& s) { return is_on(s) || is_above(s) != is_above(*begin); }) &&
      std::all_of(begin, end, [&](const ChainEdge& s) { return side(s.high) == side(begin->low); })) {
    (is_above(*begin) ? parts.above : parts.below).push_back(facet);
    return;
  }
  std::array<ChainFacet, 2> part{ChainFacet{facet.side, {}}, ChainFacet{facet.side, {}}};
  std::array<std::vector<ChainEnd>, 2> open;
  const auto add = [&](int k, const ChainEdge& s, bool low_on, bool high_on) {
    part[k].edges.push_back(s);
    if (low_on) open[k].push_back({s.line, s.low, s.times});
    if (high_on) open[k].push_back({s.line, s.high, -s.times});
  };
  for (const ChainEdge& s : facet.edges) {
    const int low = side(s.low), high = side(s.high), where = low != 0 ? low : high;
    if (where == 0) continue;
    const int k = where > 0 ? 0 : 1;
    if (low * high >= 0) {
      add(k, s, low == 0, high == 0);
    } else {
      const PointId middle = space_.meeting(s.line, e);
      add(k, {s.line, s.low, middle, s.times}, false, true);
      add(1 - k, {s.line, middle, s.high, s.times}, true, false);
    }
  }
  for (const int k : {0, 1}) {
    if (part[k].edges.empty()) continue;
    if (!open[k].empty()) {
      const LineId line = space_.line(facet.side.plane, e);
      std::vector<ChainEnd>& all = k == 0 ? cap.above : cap.below;
      for (ChainEnd& end_there : open[k]) {
        end_there.line = line;
        all.push_back({line, end_there.point, -end_there.times});
      }
      const std::vector<ChainEdge> closing = edges_between(space_, std::move(open[k]));
      part[k].edges.insert(part[k].edges.end(), closing.begin(), closing.end());
    }
    (k == 0 ? parts.above : parts.below).push_back(std::move(part[k]));
  }
}

CutChunk Cutter::cut(Chunk chunk, PlaneId e) {
  CutChunk parts;
  Cap cap;
  for (const ChainFacet& facet : chunk)
    if (facet.side.plane != e) cut_facet(facet, e, parts, cap);
  const auto close = [&](std::vector<ChainEnd> ends, bool above) {
    std::vector<ChainEdge> edges = edges_between(space_, std::move(ends));
    if (!edges.empty()) (above ? parts.above : parts.below).push_back({{e, above}, std::move(edges)});
  };
  close(std::move(cap.above), true);
  close(std::move(cap.below), false);
  return parts;
}

ChunkBox box_of(const Arrangement& space, const Chunk& chunk) {
  const PointId first = chunk.front().edges.front().low;
  ChunkBox box{{first, first, first}, {first, first, first}};
  for (const PointId p : Cutter::points_of(chunk))
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (space.compare(p, box.low[axis], axis) < 0) box.low[axis] = p;
      if (space.compare(p, box.high[axis], axis) > 0) box.high[axis] = p;
    }
  return box;
}

bool overlap(const Arrangement& space, const ChunkBox& a, const ChunkBox& b) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (space.compare(a.high[axis], b.low[axis], axis) <= 0 || space.compare(b.high[axis], a.low[axis], axis) <= 0)
      return false;
  return true;
}

std::vector<Chunk> Cutter::components(Chunk chunk) {
  const std::vector<PointId> points = points_of(chunk);
  number_.resize(space_.point_count());
  for (std::uint32_t i = 0; i < points.size(); ++i) number_[points[i].value] = i;
  UnionFind joined(points.size());
  for (const ChainFacet& facet : chunk)
    for (const ChainEdge& e : facet.edges) joined.unite(number_[e.low.value], number_[e.high.value]);
  std::vector<std::uint32_t> component(points.size());
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    component[i] = joined.root(i) == i ? count++ : component[joined.root(i)];
  if (count <= 1) return {std::move(chunk)};
  std::vector<Chunk> parts(count);
  for (const ChainFacet& facet : chunk)
    for (const ChainEdge& e : facet.edges) {
      Chunk& part = parts[component[number_[e.low.value]]];
      if (part.empty() || part.back().side != facet.side) part.push_back({facet.side, {}});
      part.back().edges.push_back(e);
    }
  return united_where_boxes_overlap(std::move(parts));
}

// Sorted by their lowest x, chunks whose boxes overlap are near one another.
std::vector<Chunk> Cutter::united_where_boxes_overlap(std::vector<Chunk> chunks) {
  std::vector<std::pair<ChunkBox, std::uint32_t>> boxes;
  for (std::uint32_t i = 0; i < chunks.size(); ++i) boxes.emplace_back(box_of(space_, chunks[i]), i);
  std::ranges::stable_sort(
      boxes, [&](const auto& a, const auto& b) { return space_.compare(a.first.low[0], b.first.low[0], 0) < 0; });
  UnionFind groups(chunks.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t k = i + 1; k < boxes.size(); ++k) {
      if (space_.compare(boxes[i].first.high[0], boxes[k].first.low[0], 0) <= 0) break;
      if (overlap(space_, boxes[i].first, boxes[k].first)) groups.unite(boxes[i].second, boxes[k].second);
    }
  for (std::uint32_t i = 0; i < chunks.size(); ++i) {
    Chunk& whole = chunks[groups.root(i)];
    if (&whole != &chunks[i]) std::ranges::move(chunks[i], std::back_inserter(whole)), chunks[i].clear();
  }
  std::erase_if(chunks, [](const Chunk& chunk) { return chunk.empty(); });
  return chunks;
}

}  // namespace fathom::solids
