// SPDX-License-Identifier: GPL-3.0-or-later
// fathom-subject-bullet and fathom-subject-bullet64, epa|pair: btGjkEpaSolver2 without margins, and btGjkPairDetector, the path of two
// convex hulls in a world. Its margins are undone: A and B grow by them, so 2 * margin is taken off the depth.
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <stdexcept>

#include "verify/subjects/subject.hpp"

namespace {

using subject::Body, subject::Settings, subject::Vector;

#ifdef BT_USE_DOUBLE_PRECISION
constexpr const char *precision = "binary64", *suffix = "64";
#else
constexpr const char *precision = "binary32", *suffix = "";
#endif

btVector3 vector(const Vector& v) { return {static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2])}; }

Vector plain(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

/// How hulls are made: about their own centre, the mean of the vertices, as Bullet's users make them.
struct Making {
  btScalar margin = 0;
  bool early = false;  ///< subtract the centre before it is rounded to binary32: then the placed hull is off by half an ulp of the centre
};

struct Placed {
  Placed(const Body& body, const Making& making) {
    const Vector mean = subject::mean(body.vertices);
    at = btTransform(btMatrix3x3::getIdentity(), vector(mean));
    const Vector centre = making.early ? mean : plain(at.getOrigin());
    for (const Vector& v : body.vertices) shape.addPoint(vector({v[0] - centre[0], v[1] - centre[1], v[2] - centre[2]}), false);
    shape.setMargin(making.margin);
    shape.recalcLocalAabb();
  }
  btConvexHullShape shape;
  btTransform at;
};

Making making(Settings& settings, double margin) {
  settings.note("centre", "mean of the vertices");
  Making making;
  making.margin = static_cast<btScalar>(margin);
  if (sizeof(btScalar) < sizeof(double)) making.early = settings.count("centre_in_binary64", 0) != 0;
  return making;
}

subject::Solver epa(Settings& settings) {
  settings.note("margin", "0");
  settings.note("guess", "from the centre of A to the centre of B");
  return [making = making(settings, 0)](const Body& a, const Body& b) {
    const Placed one(a, making), two(b, making);
    btGjkEpaSolver2::sResults result;
    subject::Reply reply;
    reply.overlap = btGjkEpaSolver2::Penetration(&one.shape, one.at, &two.shape, two.at, two.at.getOrigin() - one.at.getOrigin(), result);
    if (result.status == btGjkEpaSolver2::sResults::GJK_Failed) throw std::runtime_error("btGjkEpaSolver2: GJK_Failed");
    if (result.status == btGjkEpaSolver2::sResults::EPA_Failed) throw std::runtime_error("btGjkEpaSolver2: EPA_Failed");
    if (!reply.overlap) return reply;
    reply.depth = result.distance;
    reply.direction = plain(result.normal);
    reply.witness = {plain(result.witnesses[0]), plain(result.witnesses[1])};
    return reply;
  };
}

subject::Solver pair(Settings& settings) {
  constexpr double usual_margin = 0.04;  // CONVEX_DISTANCE_MARGIN, before it is rounded
  settings.note("simplex solver", "btVoronoiSimplexSolver");
  settings.note("penetration depth solver", "btGjkEpaPenetrationDepthSolver");
  return [making = making(settings, settings.number("margin", usual_margin))](const Body& a, const Body& b) {
    const Placed one(a, making), two(b, making);
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depth_solver;
    btGjkPairDetector detector(&one.shape, &two.shape, &simplex, &depth_solver);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = one.at;
    input.m_transformB = two.at;
    btPointCollector found;
    detector.getClosestPoints(input, found, nullptr);
    const double margin = making.margin, distance = found.m_distance + 2 * margin;
    subject::Reply reply{.overlap = found.m_hasResult && !(distance > 0)};
    if (!reply.overlap) return reply;
    reply.depth = distance;
    reply.direction = plain(found.m_normalOnBInWorld);
    const Vector& n = *reply.direction;
    Vector b_point = plain(found.m_pointInWorld), a_point;
    for (int i = 0; i < 3; ++i) {
      b_point[i] -= margin * n[i];
      a_point[i] = b_point[i] + distance * n[i];
    }
    reply.witness = {a_point, b_point};
    return reply;
  };
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = std::string("bullet") + suffix;
  const subject::Mode modes[] = {{.argument = "epa", .name = name + "-epa", .depth = "negative", .make = epa},
                                 {.argument = "pair", .name = name + "-pair", .depth = "negative", .make = pair}};
  return subject::run({"bullet", SUBJECT_VERSION, precision, {std::begin(modes), std::end(modes)}}, argc, argv);
}
