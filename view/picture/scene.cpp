// SPDX-License-Identifier: GPL-3.0-or-later
// Makes scenes of hulls of points, of shapes and of unions: first the common part, then the parts
// of each, then the functions.
#include "view/picture/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "fathom/depth.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/shapes/core.hpp"

namespace fathom::picture {
namespace {

using Points = std::vector<Point>;

bool is_zero(const Point& p) { return p.x == 0 && p.y == 0 && p.z == 0; }

Points chosen(const Points& points, const std::vector<std::uint32_t>& ids) {
  Points result;
  for (const std::uint32_t id : ids) result.push_back(points[id]);
  return result;
}

/// Returns the directions of the faces that are edges: viewed along one of them, the edge would be
/// a point.
Points edges_of(const std::vector<Points>& touch_a, const std::vector<Points>& touch_b) {
  Points result;
  for (const std::vector<Points>* faces : {&touch_a, &touch_b})
    for (const Points& face : *faces)
      if (face.size() == 2) result.push_back(face.front() - face.back());
  return result;
}

/// The view of the plane.
View from_above() { return View({1, 0, 0}, Point{0, 1, 0}); }

/// Returns the greatest magnitude of a coordinate.
mpq_class size_of(const Point& p) { return std::max({mpq_class(abs(p.x)), mpq_class(abs(p.y)), mpq_class(abs(p.z))}); }

/// Increases `extent` to the largest coordinate difference of a point from the origin.
void widen(mpq_class& extent, const auto& points, const Point& origin) {
  for (const Point& p : points) extent = std::max(extent, size_of(p - origin));
}

/// Returns the way, shortened if it is out of proportion to the bodies: to at most three times
/// their extent in any coordinate.
Point in_proportion(const Point& way, const mpq_class& extent) {
  const mpq_class longest = 3 * (extent == 0 ? mpq_class(1) : extent), size = size_of(way);
  return size > longest ? (longest / size) * way : way;
}

/// Returns the vector alpha n + beta n/|n|, to within a few roundings.
Point along(const AlongNormal& v) {
  return v.alpha * rational(v.normal) + v.beta * exact_point(unit_vector(rational(v.normal)));
}

/// Shows a claimed way beside the others.
void add_claim(PairScene& scene, const std::optional<Point>& claimed, const mpq_class& extent) {
  if (!claimed) return;
  scene.claimed = in_proportion(*claimed, extent);
  scene.cut = *scene.claimed != *claimed;
}

/// Returns the longest side of the bodies' boxes in the picture, without that of a half-space.
mpq_class drawn_extent(const PairScene& scene) {
  mpq_class extent = 0;
  for (const Drawn* body : {&scene.a, &scene.b})
    if (const std::optional<Bounds2> box = box_of(*body, scene.view))
      extent = std::max({extent, box->width(), box->height()});
  return extent;
}

Point place_of(const RoundedPoint& p) { return p.core + along({p.normal, 0, p.distance}); }

/// Returns a number of any size, to within a few roundings.
mpq_class rounded(const Surd& value) {
  constexpr unsigned bits = 128;
  const mpf_class root = sqrt(mpf_class(mpq_class(abs(value.root)), bits));
  return mpq_class(value.rational + sgn(value.root) * mpq_class(root));
}

/// Returns n/|n| times the value, for curved bodies, of which no translation is known: the middle
/// of the bounds, or the exact value if it is known.
Point way_by_value(const SignedDepth& depth) {
  const Bounds* bounds = depth.bounds();
  return along({depth.direction(), 0, bounds ? mpq_class((bounds->low + bounds->high) / 2) : rounded(*depth.exact())});
}

/// Returns the points of a core that is a polytope; none for other cores.
Points core_points(const Shape& shape) {
  return shapes::polytope_points(shapes::simplified(shape), most_expanded_points).value_or(Points{});
}

/// Returns the face of a rounded body: that of its core, moved outward by the radius.
Points rounded_face(const Shape& shape, const std::vector<std::uint32_t>& ids, const Vector& outward) {
  Points result;
  const Point by = along({outward, 0, shapes::simplified(shape).radius});
  for (const Point& p : chosen(core_points(shape), ids)) result.push_back(p + by);
  return result;
}

/// Returns the direction of the answer; with a half-space, its normal, so that it is seen from its
/// edge.
Point normal_of(const Shape& a, const Shape& b, const SignedDepth& depth) {
  if (const auto* half = std::get_if<HalfSpace>(&a.core)) return -half->normal;
  if (const auto* half = std::get_if<HalfSpace>(&b.core)) return half->normal;
  return rational(depth.direction());
}

/// Returns the start of the way if no witness is known.
Point start_of(const Shape& a, const Shape& b, const Point& normal, const Point& way) {
  if (!std::holds_alternative<HalfSpace>(a.core)) return farthest(a, -normal);
  return farthest(b, normal) - way;
}

/// Returns the normal, among the planes between pieces in contact, that is the least parallel to
/// the way; nullopt if all are parallel to it.
std::optional<Point> second_of(const std::vector<PieceContact>& contacts, const Point& along) {
  const Vec3<double> way = unit_vector(along);
  std::optional<Point> best;
  double least = 1 - 1e-6;  // a cosine
  for (const PieceContact& contact : contacts) {
    const Point normal = rational(contact.direction);
    const double cosine = std::abs(dot(unit_vector(normal), way));
    if (cosine < least) least = cosine, best = normal;
  }
  return best;
}

Points moved(const Points& points, const Point& by) {
  Points result;
  for (const Point& p : points) result.push_back(p + by);
  return result;
}

/// Returns a point of A, in its present position, that touches B after A has moved.
Point meeting_point(const Points& a, const Points& b, const Point& by) {
  return penetration_depth(moved(a, by), b).witness()->a - by;
}

/// Which pieces of each body are in contact.
struct Touching {
  std::vector<bool> a, b;

  Touching(const Pieces& of_a, const Pieces& of_b) : a(of_a.size()), b(of_b.size()) {}
  void add(std::uint32_t i, std::uint32_t j) { a[i] = b[j] = true; }
};

/// Sets the way of A and the features in contact after it.
Touching add_optimum(const Pieces& a, const Pieces& b, const UnionOptimum& optimum, PairScene& scene) {
  Touching touching(a, b);
  scene.way = optimum.translation;
  for (const PieceContact& contact : optimum.contacts) {
    touching.add(contact.a, contact.b);
    scene.touch_a.push_back(chosen(a[contact.a], contact.contact.a));
    scene.touch_b.push_back(chosen(b[contact.b], contact.contact.b));
  }
  const PieceContact& first = optimum.contacts.front();
  scene.anchor = meeting_point(a[first.a], b[first.b], scene.way);
  return touching;
}

Touching add_distance(const Pieces& a, const Pieces& b, const UnionDistance& apart, PairScene& scene) {
  Touching touching(a, b);
  touching.add(apart.a, apart.b);
  scene.way = apart.distance.translation;
  scene.anchor = apart.distance.witness.a;
  scene.touch_a.push_back(chosen(a[apart.a], apart.distance.contact.a));
  scene.touch_b.push_back(chosen(b[apart.b], apart.distance.contact.b));
  return touching;
}

}  // namespace

bool PairScene::approximate() const { return std::holds_alternative<Curved>(a) || std::holds_alternative<Curved>(b); }
bool PairScene::moves() const { return !is_zero(way); }
bool PairScene::has_edges() const {
  return !plane && std::ranges::any_of(std::array{&a, &b}, [](const Drawn* body) {
    const auto* curved = std::get_if<Curved>(body);
    return curved ? !curved->rims.empty() : !std::holds_alternative<HalfSpace>(*body);
  });
}
std::string_view PairScene::dot_text() const {
  if (status == Status::touching) return "where they touch";
  return status == Status::disjoint ? "where they are nearest, closer than can be drawn"
                                    : "where they would touch after a way too short to be drawn";
}
bool PairScene::of_unions() const { return std::holds_alternative<Compound>(a) || std::holds_alternative<Compound>(b); }

PairScene scene_of(const Pair& pair, const std::optional<Point>& claimed) {
  const Depth& depth = pair.depth;
  const Distance* distance = depth.distance();
  const Contact* contact = depth.contact();
  const Witness witness = depth.contact_points();
  Points touch_a{witness.a}, touch_b{witness.b};
  if (contact) touch_a = chosen(pair.a, contact->a), touch_b = chosen(pair.b, contact->b);
  mpq_class extent = 0;
  for (const GivenPoints* body : {&pair.a, &pair.b}) widen(extent, *body, pair.b.front());
  const std::optional<Point> second = claimed && !is_zero(*claimed) ? claimed : std::nullopt;
  const View view =
      pair.plane ? from_above()
                 : View((distance ? -1 : 1) * rational(depth.direction()), second, edges_of({touch_a}, {touch_b}));
  PairScene scene{depth.status(),         view,      wires_of(pair.a, view),
                  wires_of(pair.b, view), witness.a, distance ? distance->translation : depth.translation(),
                  std::nullopt,           false,     {std::move(touch_a)},
                  {std::move(touch_b)}};
  add_claim(scene, claimed, extent);
  return scene;
}

PairScene scene_of(const Shape& a, const Shape& b, const SignedDepth& depth, const std::optional<Point>& claimed,
                   bool plane) {
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
  const View view = plane
                        ? from_above()
                        : View((depth.status() == Status::disjoint ? -1 : 1) * normal,
                               claimed && !is_zero(*claimed) ? claimed : std::nullopt, edges_of({touch_a}, {touch_b}));
  PairScene scene{depth.status(), view,  drawn_shape(a, view), drawn_shape(b, view), start, way,
                  std::nullopt,   false, {std::move(touch_a)}, {std::move(touch_b)}};
  scene.enclosed = depth.bounds() != nullptr;
  add_claim(scene, claimed, drawn_extent(scene));
  return scene;
}

// The part of scene.hpp about unions.

PairScene scene_of(const Pieces& a, const Pieces& b, const UnionDepth& depth, std::size_t optimum,
                   const std::optional<Point>& claimed, bool plane) {
  if (!depth.complete) throw std::invalid_argument("a search that was stopped has no picture");
  PairScene scene{depth.status, View({1, 0, 0}, std::nullopt), Wires{}, Wires{}, {}, {}, std::nullopt, false, {}, {}};
  const Touching touching =
      depth.apart ? add_distance(a, b, *depth.apart, scene) : add_optimum(a, b, depth.optima.at(optimum), scene);
  const std::vector<PieceContact> contacts = depth.apart ? std::vector<PieceContact>{} : depth.optima[optimum].contacts;
  const Point along = is_zero(scene.way) ? rational(contacts.front().direction) : scene.way;
  if (claimed) {
    mpq_class extent = 0;
    for (const Pieces* body : {&a, &b})
      for (const Points& piece : *body) widen(extent, piece, b.front().front());
    add_claim(scene, claimed, extent);
  }
  scene.view = plane ? from_above()
                     : View(along, claimed && !is_zero(*claimed) ? claimed : second_of(contacts, along),
                            edges_of(scene.touch_a, scene.touch_b));
  Compound of_a = compound_of(a, scene.view), of_b = compound_of(b, scene.view);
  of_a.in_contact = touching.a;
  of_b.in_contact = touching.b;
  scene.a = std::move(of_a);
  scene.b = std::move(of_b);
  return scene;
}

PairScene scene_of(const fathom::Body& a, const fathom::Body& b, const Answer& answer,
                   const std::optional<Point>& claimed) {
  const bool plane = answer.dimension() == 2;
  const auto of_kind = [&] {
    if (const auto* const depth = std::get_if<Depth>(&answer.found))
      return scene_of({a.points, b.points, *depth, plane}, claimed);
    if (const auto* const depth = std::get_if<SignedDepth>(&answer.found))
      return scene_of(files::shape_of(a), files::shape_of(b), *depth, claimed, plane);
    return scene_of(pieces_of(a), pieces_of(b), std::get<UnionDepth>(answer.found), 0, claimed, plane);
  };
  PairScene scene = of_kind();
  scene.plane = plane;
  return scene;
}

}  // namespace fathom::picture
