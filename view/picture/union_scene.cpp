// SPDX-License-Identifier: GPL-3.0-or-later
// The part of scene.hpp about unions.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fathom/depth.hpp"
#include "view/picture/scene.hpp"

namespace fathom::picture {
namespace {

using Points = std::vector<Point>;

Points chosen(const Points& points, const std::vector<std::uint32_t>& ids) {
  Points result;
  for (const std::uint32_t id : ids) result.push_back(points[id]);
  return result;
}

bool is_zero(const Point& p) { return p.x == 0 && p.y == 0 && p.z == 0; }

/// Of the planes between pieces in contact the normal that is the least parallel to the way; nullopt if there is none beside it.
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

/// A way that is at most three times as long as the bodies are far apart in any coordinate.
Point in_proportion(const Pieces& a, const Pieces& b, const Point& way) {
  const auto size = [](const Point& p) { return std::max({mpq_class(abs(p.x)), mpq_class(abs(p.y)), mpq_class(abs(p.z))}); };
  mpq_class extent = 0;
  for (const Pieces* body : {&a, &b})
    for (const Points& piece : *body)
      for (const Point& p : piece) extent = std::max(extent, size(p - b.front().front()));
  const mpq_class longest = 3 * extent;
  return size(way) > longest ? (longest / size(way)) * way : way;
}

/// The edges in contact: a look along one of them would show nothing.
Points edges_of(const PairScene& scene) {
  Points result;
  for (const auto* faces : {&scene.touch_a, &scene.touch_b})
    for (const Points& face : *faces)
      if (face.size() == 2) result.push_back(face.front() - face.back());
  return result;
}

Points moved(const Points& points, const Point& by) {
  Points result;
  for (const Point& p : points) result.push_back(p + by);
  return result;
}

/// A point of A, where it is now, that touches B once A has moved.
Point meeting_point(const Points& a, const Points& b, const Point& by) { return penetration_depth(moved(a, by), b).witness()->a - by; }

/// What is in contact, by pieces.
struct Touching {
  std::vector<bool> a, b;

  Touching(const Pieces& of_a, const Pieces& of_b) : a(of_a.size()), b(of_b.size()) {}
  void add(std::uint32_t i, std::uint32_t j) { a[i] = b[j] = true; }
};

/// Where A ends, and what is in contact there.
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

PairScene scene_of(const Pieces& a, const Pieces& b, const UnionDepth& depth, std::size_t optimum, const std::optional<Point>& claimed) {
  if (!depth.complete) throw std::invalid_argument("a search that was stopped has no picture");
  PairScene scene{depth.status, View({1, 0, 0}, std::nullopt), Wires{}, Wires{}, {}, {}, std::nullopt, false, {}, {}};
  const Touching touching = depth.apart ? add_distance(a, b, *depth.apart, scene) : add_optimum(a, b, depth.optima.at(optimum), scene);
  const std::vector<PieceContact> contacts = depth.apart ? std::vector<PieceContact>{} : depth.optima[optimum].contacts;
  const Point along = is_zero(scene.way) ? rational(contacts.front().direction) : scene.way;
  if (claimed) {
    scene.claimed = in_proportion(a, b, *claimed);
    scene.cut = *scene.claimed != *claimed;
  }
  scene.view = View(along, claimed && !is_zero(*claimed) ? claimed : second_of(contacts, along), edges_of(scene));
  Compound of_a = compound_of(a, scene.view), of_b = compound_of(b, scene.view);
  of_a.in_contact = touching.a;
  of_b.in_contact = touching.b;
  scene.a = std::move(of_a);
  scene.b = std::move(of_b);
  return scene;
}

}  // namespace fathom::picture
