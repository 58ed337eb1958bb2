// SPDX-License-Identifier: CC0-1.0
// g++ reproduce.cpp $(pkg-config --cflags --libs bullet) -o reproduce && ./reproduce
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <btBulletCollisionCommon.h>

#include <cstdio>

btConvexHullShape cube(btScalar margin) {
  btConvexHullShape shape;
  for (int i = 0; i < 8; ++i) shape.addPoint({i & 1 ? 0.5f : -0.5f, i & 2 ? 0.5f : -0.5f, i & 4 ? 0.5f : -0.5f}, false);
  shape.setMargin(margin);
  shape.recalcLocalAabb();
  return shape;
}

void show(const char* what, btScalar distance, const btVector3& normal) {
  std::printf("  %-31s depth %.4f along (%.4f %.4f %.4f)\n", what, -distance, normal.x() + 0, normal.y() + 0,
              normal.z() + 0);
}

struct Deepest : btCollisionWorld::ContactResultCallback {
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    if (point.getDistance() < distance) distance = point.getDistance(), normal = point.m_normalWorldOnB;
    return 0;
  }
  btScalar distance = 0;
  btVector3 normal{0, 0, 0};
};

/// What a world says of two shapes, the second moved.
Deepest in_world(btCollisionShape& first, btCollisionShape& second, const btTransform& at) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btCollisionWorld world(&dispatcher, &broadphase, &configuration);
  btCollisionObject a, b;
  a.setCollisionShape(&first);
  b.setCollisionShape(&second);
  b.setWorldTransform(at);
  world.addCollisionObject(&a);
  world.addCollisionObject(&b);
  Deepest deepest;
  world.contactPairTest(&a, &b, deepest);
  world.removeCollisionObject(&a);
  world.removeCollisionObject(&b);
  return deepest;
}

int main() {
  std::puts("Bullet: two unit cubes, the second moved");
  for (const float shift : {0.5f, 0.75f, 0.9f}) {
    std::printf("shift (%g 0 0): right is %g deep, B along (1 0 0)\n", shift, 1 - shift);
    const btTransform origin = btTransform::getIdentity(), there(btMatrix3x3::getIdentity(), {shift, 0, 0});
    btConvexHullShape a = cube(0), b = cube(0);
    btBoxShape one({0.5f, 0.5f, 0.5f}), two = one;
    btGjkEpaSolver2::sResults found;
    btGjkEpaSolver2::Penetration(&a, origin, &b, there, {shift, 0, 0}, found);
    show("btGjkEpaSolver2, hulls:", found.distance, found.normal);
    btGjkEpaSolver2::Penetration(&a, origin, &b, there, {0, 1, 0}, found);
    show("the same, another guess:", found.distance, found.normal);
    Deepest deepest = in_world(a, b, there);
    show("contactPairTest, hulls:", deepest.distance, deepest.normal);
    deepest = in_world(one, two, there);
    show("contactPairTest, boxes:", deepest.distance, deepest.normal);
    btConvexHullShape round = cube(0.04f), other = cube(0.04f);
    deepest = in_world(round, other, there);
    show("hulls with margin 0.04, undone:", deepest.distance + 0.08f, deepest.normal);
  }
}
