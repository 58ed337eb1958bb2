// SPDX-License-Identifier: GPL-3.0-or-later
// fathom-subject-fcl signed|collide|indep: FCL's distance and collide on two fcl::Convex<double> in world coordinates.
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <memory>

#include "verify/subjects/subject.hpp"

namespace {

using subject::Body, subject::Settings, subject::Vector;

Vector plain(const fcl::Vector3d& v) { return {v[0], v[1], v[2]}; }

fcl::Convexd convex(const Body& body) {
  const auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const Vector& v : body.vertices) vertices->emplace_back(v[0], v[1], v[2]);
  const auto faces = std::make_shared<std::vector<int>>();
  for (const std::vector<int>& face : body.faces) {
    faces->push_back(static_cast<int>(face.size()));
    faces->insert(faces->end(), face.begin(), face.end());
  }
  return {vertices, static_cast<int>(body.faces.size()), faces, true};
}

subject::Solver signed_distance(Settings& settings) {
  fcl::DistanceRequestd request;
  request.enable_nearest_points = request.enable_signed_distance = true;
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.distance_tolerance = settings.number("distance_tolerance", request.distance_tolerance);
  settings.note("gjk_solver_type", "GST_LIBCCD");
  return [request](const Body& a, const Body& b) {
    const fcl::Convexd convex_a = convex(subject::hull(a)), convex_b = convex(subject::hull(b));
    const fcl::Transform3d world = fcl::Transform3d::Identity();
    fcl::DistanceResultd result;
    fcl::distance(&convex_a, world, &convex_b, world, request, result);
    subject::Reply reply{.overlap = !(result.min_distance > 0)};  // NaN is passed on
    if (!reply.overlap) return reply;
    reply.depth = result.min_distance;
    reply.witness = {plain(result.nearest_points[0]), plain(result.nearest_points[1])};
    return reply;
  };
}

subject::Solver collide(Settings& settings, fcl::GJKSolverType type, const char* type_name) {
  fcl::CollisionRequestd request;
  request.enable_contact = true;
  request.gjk_solver_type = type;
  request.num_max_contacts = settings.count("num_max_contacts", request.num_max_contacts);
  request.gjk_tolerance = settings.number("gjk_tolerance", request.gjk_tolerance);
  settings.note("gjk_solver_type", type_name);
  return [request](const Body& a, const Body& b) {
    const fcl::Convexd convex_a = convex(subject::hull(a)), convex_b = convex(subject::hull(b));
    const fcl::Transform3d world = fcl::Transform3d::Identity();
    fcl::CollisionResultd result;
    fcl::collide(&convex_a, world, &convex_b, world, request, result);
    subject::Reply reply{.overlap = result.isCollision()};
    std::vector<fcl::Contactd> contacts;
    result.getContacts(contacts);
    if (contacts.empty()) return reply;
    const auto size = [](const fcl::Contactd& contact) { return std::abs(contact.penetration_depth); };
    const fcl::Contactd& deepest = *std::ranges::max_element(contacts, {}, size);
    reply.depth = deepest.penetration_depth;
    reply.direction = plain(deepest.normal);
    return reply;
  };
}

}  // namespace

int main(int argc, char** argv) {
  const subject::Mode modes[] = {
      {.argument = "signed", .name = "fcl-signed", .depth = "negative", .faces = true, .make = signed_distance},
      {.argument = "collide",
       .name = "fcl-collide",
       .moves = "b",
       .faces = true,
       .make = [](Settings& settings) { return collide(settings, fcl::GST_LIBCCD, "GST_LIBCCD"); }},
      {.argument = "indep", .name = "fcl-indep", .depth = "negative", .moves = "b", .faces = true, .make = [](Settings& settings) {
         return collide(settings, fcl::GST_INDEP, "GST_INDEP");
       }}};
  return subject::run({"fcl", SUBJECT_VERSION, "binary64", {std::begin(modes), std::end(modes)}}, argc, argv);
}
