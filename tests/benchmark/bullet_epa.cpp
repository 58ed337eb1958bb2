// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/bullet_epa.hpp"

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>

namespace fathom::benchmarks {
namespace {

/// A hull about its centre, as Bullet's users make them, and where the centre is.
void fill(btConvexHullShape& shape, btTransform& place, const Body& body) {
  btVector3 centre(0, 0, 0);
  const auto at = [](const Point& p) { return btVector3(float(p.x.get_d()), float(p.y.get_d()), float(p.z.get_d())); };
  for (const Point& p : body.points) centre += at(p);
  centre /= btScalar(body.points.size());
  for (const Point& p : body.points) shape.addPoint(at(p) - centre, false);
  shape.setMargin(0);
  shape.recalcLocalAabb();
  place.setIdentity();
  place.setOrigin(centre);
}

}  // namespace

struct BulletPair::Hulls {
  btConvexHullShape a, b;
  btTransform place_a, place_b;
};

BulletPair::BulletPair(const Case& input) : hulls_(std::make_unique<Hulls>()) {
  fill(hulls_->a, hulls_->place_a, input.a);
  fill(hulls_->b, hulls_->place_b, input.b);
}

BulletPair::~BulletPair() = default;
BulletPair::BulletPair(BulletPair&&) noexcept = default;

double BulletPair::depth() const {
  const Hulls& h = *hulls_;
  btGjkEpaSolver2::sResults results;
  const btVector3 guess = h.place_b.getOrigin() - h.place_a.getOrigin();
  const bool found = btGjkEpaSolver2::Penetration(&h.a, h.place_a, &h.b, h.place_b, guess, results);
  return found ? -double(results.distance) : -1;
}

}  // namespace fathom::benchmarks
