// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/scene.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "reference/shapes/core.hpp"

namespace fathom::picture {
namespace {

bool is_zero(const Point& p) { return p.x == 0 && p.y == 0 && p.z == 0; }

std::vector<Point> chosen(const std::vector<Point>& points, const std::vector<std::uint32_t>& ids) {
  std::vector<Point> result;
  for (const std::uint32_t id : ids) result.push_back(points[id]);
  return result;
}

/// The directions of the faces that are edges: a look along one of them would show nothing.
std::vector<Point> edges_of(const std::vector<Point>& touch_a, const std::vector<Point>& touch_b) {
  std::vector<Point> result;
  for (const std::vector<Point>* face : {&touch_a, &touch_b})
    if (face->size() == 2) result.push_back(face->front() - face->back());
  return result;
}

/// A way in proportion to the bodies: at most three times as long as they are far apart in any coordinate.
std::optional<Point> in_proportion(const Pair& pair, const std::optional<Point>& way, bool& cut) {
  const auto size = [](const Point& p) { return std::max({mpq_class(abs(p.x)), mpq_class(abs(p.y)), mpq_class(abs(p.z))}); };
  mpq_class extent = 0;
  for (const GivenPoints* body : {&pair.a, &pair.b})
    for (const Point& p : *body) extent = std::max(extent, size(p - pair.b.front()));
  const mpq_class longest = 3 * (extent == 0 ? mpq_class(1) : extent);
  cut = way && size(*way) > longest;
  return cut ? (longest / size(*way)) * (*way) : way;
}

/// The vector alpha n + beta n/|n|, to within a few roundings.
Point along(const AlongNormal& v) { return v.alpha * rational(v.normal) + v.beta * exact_point(unit_vector(rational(v.normal))); }

Point place_of(const RoundedPoint& p) { return p.core + along({p.normal, 0, p.distance}); }

/// A number of any size, to within a few roundings.
mpq_class rounded(const Surd& value) {
  constexpr unsigned bits = 128;
  const mpf_class root = sqrt(mpf_class(mpq_class(abs(value.root)), bits));
  return mpq_class(value.rational + sgn(value.root) * mpq_class(root));
}

/// n/|n| times the value, where no translation is known: of curved bodies, whose value is enclosed, or known by chance.
Point way_by_value(const SignedDepth& depth) {
  const Bounds* bounds = depth.bounds();
  return along({depth.direction(), 0, bounds ? mpq_class((bounds->low + bounds->high) / 2) : rounded(*depth.exact())});
}

/// The points of a core that is a polytope; none of others.
std::vector<Point> core_points(const Shape& shape) {
  return shapes::polytope_points(shapes::simplified(shape), most_expanded_points).value_or(std::vector<Point>{});
}

/// The face of a rounded body: that of its core, moved outward by the radius.
std::vector<Point> rounded_face(const Shape& shape, const std::vector<std::uint32_t>& ids, const Vector& outward) {
  std::vector<Point> result;
  const Point by = along({outward, 0, shapes::simplified(shape).radius});
  for (const Point& p : chosen(core_points(shape), ids)) result.push_back(p + by);
  return result;
}

/// The direction of the answer: that of the half-space, if there is one, which is to be seen from its edge.
Point normal_of(const Shape& a, const Shape& b, const SignedDepth& depth) {
  if (const auto* half = std::get_if<HalfSpace>(&a.core)) return -half->normal;
  if (const auto* half = std::get_if<HalfSpace>(&b.core)) return half->normal;
  return rational(depth.direction());
}

/// Where the way begins if no witness is known.
Point start_of(const Shape& a, const Shape& b, const Point& normal, const Point& way) {
  if (!std::holds_alternative<HalfSpace>(a.core)) return farthest(a, -normal);
  return farthest(b, normal) - way;
}

}  // namespace

bool PairScene::approximate() const { return std::holds_alternative<Curved>(a) || std::holds_alternative<Curved>(b); }
bool PairScene::moves() const { return !is_zero(way); }
bool PairScene::has_edges() const {
  return std::ranges::any_of(std::array{&a, &b}, [](const Drawn* body) {
    const auto* curved = std::get_if<Curved>(body);
    return curved ? !curved->rims.empty() : !std::holds_alternative<HalfSpace>(*body);
  });
}
bool PairScene::of_unions() const { return std::holds_alternative<Compound>(a) || std::holds_alternative<Compound>(b); }

PairScene scene_of(const Pair& pair, const std::optional<Point>& claimed) {
  const Depth& depth = pair.depth;
  const Distance* distance = depth.distance();
  const Contact* contact = depth.contact();
  const Witness witness = distance ? distance->witness : *depth.witness();
  std::vector<Point> touch_a{witness.a}, touch_b{witness.b};
  if (contact) touch_a = chosen(pair.a, contact->a), touch_b = chosen(pair.b, contact->b);
  bool cut = false;
  const std::optional<Point> shown = in_proportion(pair, claimed, cut);
  const std::optional<Point> second = shown && !is_zero(*shown) ? shown : std::nullopt;
  const View view((distance ? -1 : 1) * rational(depth.direction()), second, edges_of(touch_a, touch_b));
  return {depth.status(),
          view,
          wires_of(pair.a, view),
          wires_of(pair.b, view),
          witness.a,
          distance ? distance->translation : depth.translation(),
          shown,
          cut,
          {std::move(touch_a)},
          {std::move(touch_b)}};
}

PairScene scene_of(const Shape& a, const Shape& b, const SignedDepth& depth) {
  const Point normal = normal_of(a, b, depth);
  const std::vector<AlongNormal> ways = depth.translations();
  const Point way = ways.empty() ? way_by_value(depth) : along(ways.front());
  const std::optional<RoundedWitness> witness = depth.witness();
  const Point start = witness ? place_of(witness->a) : start_of(a, b, normal, way);
  std::vector<Point> touch_a{start}, touch_b{witness ? place_of(witness->b) : start + way};
  if (const Contact* contact = depth.contact()) {
    const Vector n = depth.direction();
    touch_a = rounded_face(a, contact->a, -n);
    touch_b = rounded_face(b, contact->b, n);
  }
  const View view((depth.status() == Status::disjoint ? -1 : 1) * normal, std::nullopt, edges_of(touch_a, touch_b));
  PairScene scene{depth.status(), view,  drawn_shape(a, view), drawn_shape(b, view), start, way,
                  std::nullopt,   false, {std::move(touch_a)}, {std::move(touch_b)}};
  scene.enclosed = depth.bounds() != nullptr;
  return scene;
}

}  // namespace fathom::picture
