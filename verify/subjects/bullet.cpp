// SPDX-License-Identifier: GPL-3.0-or-later
// fathom-subject-bullet and fathom-subject-bullet64, epa|pair|world: btGjkEpaSolver2 without
// margins; btGjkPairDetector, the path of two convex bodies in a world; and the manifold of a world
// of two bodies. The effect of Bullet's own margins is removed: the depth is reduced by what they
// add to A and B.
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "verify/subjects/subject.hpp"

namespace {

using subject::Body, subject::Settings, subject::Vector;

#ifdef BT_USE_DOUBLE_PRECISION
constexpr const char *precision = "binary64", *suffix = "64";
#else
constexpr const char *precision = "binary32", *suffix = "";
#endif

/// Rounds to Bullet's precision. The volatile is needed because g++ 12 omits the rounding of
/// vectors of two numbers that are widened again.
btScalar scalar(double x) {
  const volatile btScalar rounded = static_cast<btScalar>(x);
  return rounded;
}

btVector3 vector(const Vector& v) { return {scalar(v[0]), scalar(v[1]), scalar(v[2])}; }

Vector plain(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

/// How to make Bullet's shapes: hulls of vertices about their own centre, their mean, as Bullet's
/// users make them.
struct Making {
  btScalar margin = 0;
  /// boxes and cylinders as in a world: with the margin that Bullet gives them, inside their
  /// lengths
  bool inside = false;
  bool early = false;  ///< subtract the centre before it is rounded to binary32: then the placed hull is off by half an
                       ///< ulp of the centre
};

struct Placed {
  Placed(const Body& body, const Making& making) {
    if (body.shape.empty()) make_hull(body, making);
    else make_shape(body, making);
  }
  std::unique_ptr<btConvexShape> shape;
  btTransform at;
  double grown = 0;  ///< the part of the margin by which Bullet's body is larger than the given one

 private:
  void make_hull(const Body& body, const Making& making) {
    const Vector mean = subject::mean(body.vertices);
    at = btTransform(btMatrix3x3::getIdentity(), vector(mean));
    const Vector centre = making.early ? mean : plain(at.getOrigin());
    shape = hull(body.vertices, centre);
    grow(making.margin, 0);
  }

  static std::unique_ptr<btConvexShape> hull(const std::vector<Vector>& vertices, const Vector& centre) {
    auto made = std::make_unique<btConvexHullShape>();
    for (const Vector& v : vertices)
      made->addPoint(vector({v[0] - centre[0], v[1] - centre[1], v[2] - centre[2]}), false);
    made->recalcLocalAabb();
    return made;
  }

  /// GJK and EPA treat a shape as a core and a ball around it, whose radius is the margin: that of
  /// the case, or else the mode's. A sphere or capsule consists of its margin alone.
  void make_shape(const Body& body, const Making& making) {
    const btVector3 x = vector(body.rotation[0]), y = vector(body.rotation[1]), z = vector(body.rotation[2]);
    at = btTransform({x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2]}, vector(body.translation));
    const auto number = [&body](const char* name) { return subject::number(body, name); };
    const auto length = [&number] { return scalar(2 * number("half_length")); };
    if (subject::is(body, "sphere") || subject::is(body, "capsule")) {
      if (body.margin > 0)
        throw subject::Unsupported("a margin around a " + body.shape + ", which is nothing but margin in Bullet");
      if (subject::is(body, "sphere")) shape = std::make_unique<btSphereShape>(scalar(number("radius")));
      else shape = std::make_unique<btCapsuleShapeZ>(scalar(number("radius")), length());
      return;
    }
    if (subject::is(body, "box"))
      return make_around_core<btBoxShape>(subject::triple(body, "half"), making, body.margin);
    if (subject::is(body, "cylinder")) {
      const double radius = number("radius");
      return make_around_core<btCylinderShapeZ>({radius, radius, number("half_length")}, making, body.margin);
    }
    if (subject::is(body, "hull")) shape = hull(body.vertices, {});
    else shape = std::make_unique<btConeShapeZ>(scalar(number("radius")), length());
    grow(making.margin, body.margin);
  }

  /// For these shapes Bullet includes the margin in their lengths: the core would be smaller than
  /// the case's, and the edges round.
  template <class Inner>
  void make_around_core(const Vector& half, const Making& making, double given) {
    auto made = std::make_unique<Inner>(vector(half));
    Inner& inner = *made;
    shape = std::move(made);
    if (making.inside && !(given > 0)) return;
    grow(making.margin, given);
    inner.setImplicitShapeDimensions(vector(half));
  }

  void grow(btScalar usual, double given) {
    shape->setMargin(given > 0 ? scalar(given) : usual);
    grown = given > 0 ? 0 : usual;
  }
};

Making making(Settings& settings, double margin) {
  settings.note("centre", "mean of the vertices");
  Making making;
  making.margin = scalar(margin);
  if (sizeof(btScalar) < sizeof(double)) making.early = settings.count("centre_in_binary64", 0) != 0;
  return making;
}

/// Without the setting, the solver gets the initial guess of Bullet's own callers, from centre to
/// centre, as it has no default of its own.
subject::Solver epa(Settings& settings) {
  settings.note("margin", "0");
  const std::optional<Vector> guess = settings.vector("guess", "B-A");
  return [making = making(settings, 0), guess](const Body& a, const Body& b) {
    const Placed one(a, making), two(b, making);
    btGjkEpaSolver2::sResults result;
    subject::Reply reply;
    const btVector3 start = guess ? vector(*guess) : two.at.getOrigin() - one.at.getOrigin();
    reply.overlap = btGjkEpaSolver2::Penetration(one.shape.get(), one.at, two.shape.get(), two.at, start, result);
    if (result.status == btGjkEpaSolver2::sResults::GJK_Failed) throw std::runtime_error("btGjkEpaSolver2: GJK_Failed");
    if (result.status == btGjkEpaSolver2::sResults::EPA_Failed) throw std::runtime_error("btGjkEpaSolver2: EPA_Failed");
    if (!reply.overlap) return reply;
    reply.depth = result.distance;
    reply.direction = plain(one.at.getBasis() *
                            result.normal);  // the solver's normal is in the frame of A, its points are in the world
    reply.witness = {plain(result.witnesses[0]), plain(result.witnesses[1])};
    return reply;
  };
}

subject::Solver pair(Settings& settings) {
  constexpr double usual_margin = 0.04;  // CONVEX_DISTANCE_MARGIN, before it is rounded
  settings.note("simplex solver", "btVoronoiSimplexSolver");
  settings.note("penetration depth solver", "btGjkEpaPenetrationDepthSolver");
  Making bodies = making(settings, settings.number("margin", usual_margin));
  bodies.inside = settings.count("margin_inside", 0) != 0;
  return [making = bodies](const Body& a, const Body& b) {
    const Placed one(a, making), two(b, making);
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depth_solver;
    btGjkPairDetector detector(one.shape.get(), two.shape.get(), &simplex, &depth_solver);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = one.at;
    input.m_transformB = two.at;
    btPointCollector found;
    detector.getClosestPoints(input, found, nullptr);
    const double distance = found.m_distance + (one.grown + two.grown);
    subject::Reply reply{.overlap = found.m_hasResult && !(distance > 0)};
    if (!found.m_hasResult) return reply;
    (reply.overlap ? reply.depth : reply.distance) = distance;
    reply.direction = plain(found.m_normalOnBInWorld);
    const Vector& n = *reply.direction;
    Vector b_point = plain(found.m_pointInWorld), a_point;
    for (int i = 0; i < 3; ++i) {
      b_point[i] -= two.grown * n[i];
      a_point[i] = b_point[i] + distance * n[i];
    }
    reply.witness = {a_point, b_point};
    return reply;
  };
}

/// A world of two bodies, queried once as its manual says: all points of its manifold, each with a
/// distance and a point on both bodies.
class World {
 public:
  struct Point {
    double distance;
    Vector normal, on_a, on_b;  ///< the normal points to A
  };
  std::vector<Point> ask(Placed& a, Placed& b) {
    btCollisionObject one, two;
    one.setCollisionShape(a.shape.get());
    one.setWorldTransform(a.at);
    two.setCollisionShape(b.shape.get());
    two.setWorldTransform(b.at);
    world_.addCollisionObject(&one);
    world_.addCollisionObject(&two);
    world_.performDiscreteCollisionDetection();
    std::vector<Point> points;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
      const bool turned = manifold.getBody0() != &one;
      for (int k = 0; k < manifold.getNumContacts(); ++k) {
        const btManifoldPoint& point = manifold.getContactPoint(k);
        const btVector3 normal = turned ? -point.m_normalWorldOnB : point.m_normalWorldOnB;
        Vector on_a = plain(point.getPositionWorldOnA()), on_b = plain(point.getPositionWorldOnB());
        if (turned) std::swap(on_a, on_b);
        points.push_back({point.getDistance(), plain(normal), on_a, on_b});
      }
    }
    world_.removeCollisionObject(&one);
    world_.removeCollisionObject(&two);
    return points;
  }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase pairs_;
  btCollisionWorld world_{&dispatcher_, &pairs_, &configuration_};
};

subject::Solver world(Settings& settings) {
  constexpr double usual_margin = 0.04;
  Making bodies = making(settings, settings.number("margin", usual_margin));
  bodies.inside = true;
  const bool tells_positions = settings.count("positions", 0) != 0;
  if (tells_positions) settings.most_contacts(MANIFOLD_CACHE_SIZE);
  return [bodies, tells_positions](const Body& a, const Body& b) {
    Placed one(a, bodies), two(b, bodies);
    const std::vector<World::Point> points = World().ask(one, two);
    subject::Reply reply;
    if (points.empty()) return reply;
    const auto distance = [&](const World::Point& point) { return point.distance + (one.grown + two.grown); };
    const World::Point& deepest = *std::ranges::min_element(points, {}, distance);
    reply.overlap = !(distance(deepest) > 0);
    if (!reply.overlap) return reply;
    reply.depth = distance(deepest);
    reply.direction = deepest.normal;
    for (const World::Point& point : points) {
      if (!tells_positions) continue;
      Vector middle;
      for (int i = 0; i < 3; ++i)
        middle[i] = (point.on_a[i] + point.on_b[i] + (one.grown - two.grown) * point.normal[i]) / 2;
      reply.contacts.push_back({middle, distance(point)});
    }
    return reply;
  };
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = std::string("bullet") + suffix;
  const std::vector<std::string> shapes{"sphere", "capsule", "box", "cylinder", "cone", "hull", "margin"};
  const subject::Mode modes[] = {
      {.argument = "epa", .name = name + "-epa", .depth = "negative", .shapes = shapes, .make = epa},
      {.argument = "pair", .name = name + "-pair", .depth = "negative", .shapes = shapes, .make = pair},
      {.argument = "world",
       .name = name + "-world",
       .depth = "negative",
       .claims = "separating",
       .shapes = shapes,
       .make = world}};
  return subject::run({"bullet", SUBJECT_VERSION, precision, {std::begin(modes), std::end(modes)}}, argc, argv);
}
