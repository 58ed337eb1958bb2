// SPDX-License-Identifier: GPL-3.0-or-later
// fathom-subject-fcl signed|collide|indep: FCL's distance and collide, on fcl::Convex<double> in
// world coordinates and FCL's own primitives.
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "verify/subjects/subject.hpp"

namespace {

using subject::Body, subject::Settings, subject::Vector;

Vector plain(const fcl::Vector3d& v) { return {v[0], v[1], v[2]}; }

std::unique_ptr<fcl::CollisionGeometryd> convex(const Body& body) {
  const auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const Vector& v : body.vertices) vertices->emplace_back(v[0], v[1], v[2]);
  const auto faces = std::make_shared<std::vector<int>>();
  for (const std::vector<int>& face : body.faces) {
    faces->push_back(static_cast<int>(face.size()));
    faces->insert(faces->end(), face.begin(), face.end());
  }
  return std::make_unique<fcl::Convexd>(vertices, static_cast<int>(body.faces.size()), faces, true);
}

/// Makes a primitive of FCL, whose lengths are full ones. Its shapes lie along z about their
/// centre; a cone's apex is above.
std::unique_ptr<fcl::CollisionGeometryd> primitive(const Body& body) {
  const auto number = [&body](const char* name) { return subject::number(body, name); };
  if (subject::is(body, "sphere")) return std::make_unique<fcl::Sphered>(number("radius"));
  if (subject::is(body, "box")) {
    const auto& [x, y, z] = subject::triple(body, "half");
    return std::make_unique<fcl::Boxd>(2 * x, 2 * y, 2 * z);
  }
  if (subject::is(body, "ellipsoid")) {
    const auto& [a, b, c] = subject::triple(body, "radii");
    return std::make_unique<fcl::Ellipsoidd>(a, b, c);
  }
  if (subject::is(body, "halfspace"))
    return std::make_unique<fcl::Halfspaced>(fcl::Vector3d(subject::triple(body, "normal").data()), number("offset"));
  const double radius = number("radius"), length = 2 * number("half_length");
  if (subject::is(body, "capsule")) return std::make_unique<fcl::Capsuled>(radius, length);
  if (subject::is(body, "cylinder")) return std::make_unique<fcl::Cylinderd>(radius, length);
  return std::make_unique<fcl::Coned>(radius, length);
}

fcl::Transform3d placing(const Body& body) {
  fcl::Transform3d at = fcl::Transform3d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) at.linear()(i, j) = body.rotation[i][j];
    at.translation()[i] = body.translation[i];
  }
  return at;
}

struct Placed {
  explicit Placed(const Body& body)
      : geometry(body.shape.empty() ? convex(subject::hull(body)) : primitive(body)), at(placing(body)) {}
  std::unique_ptr<fcl::CollisionGeometryd> geometry;
  fcl::Transform3d at;
};

subject::Solver signed_distance(Settings& settings) {
  fcl::DistanceRequestd request;
  request.enable_nearest_points = request.enable_signed_distance = true;
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.distance_tolerance = settings.number("distance_tolerance", request.distance_tolerance);
  settings.note("gjk_solver_type", "GST_LIBCCD");
  return [request](const Body& a, const Body& b) {
    const Placed one(a), two(b);
    fcl::DistanceResultd result;
    fcl::distance(one.geometry.get(), one.at, two.geometry.get(), two.at, request, result);
    subject::Reply reply{.overlap = !(result.min_distance > 0)};  // NaN is passed on
    (reply.overlap ? reply.depth : reply.distance) = result.min_distance;
    reply.witness = {plain(result.nearest_points[0]), plain(result.nearest_points[1])};
    return reply;
  };
}

bool is_halfspace(const Body& body) { return subject::is(body, "halfspace"); }

/// Returns whether FCL answers the pair by a closed formula, with either solver.
bool has_formula(const Body& a, const Body& b) {
  if (is_halfspace(a) || is_halfspace(b)) return true;
  if (a.shape.empty() || b.shape.empty()) return false;
  const auto& [first, second] = std::minmax(a.shape, b.shape);
  return (first == "box" && second == "box") || (second == "sphere" && first != "cone" && first != "ellipsoid");
}

subject::Solver collide(Settings& settings, fcl::GJKSolverType type, const char* type_name) {
  fcl::CollisionRequestd request;
  request.enable_contact = true;
  request.gjk_solver_type = type;
  request.num_max_contacts = settings.count("num_max_contacts", request.num_max_contacts);
  request.gjk_tolerance = settings.number("gjk_tolerance", request.gjk_tolerance);
  settings.note("gjk_solver_type", type_name);
  if (type == fcl::GST_INDEP)  // libccd's MPR has no such parameter
    if (const auto guess = settings.vector("guess", "1:0:0")) {
      request.enable_cached_gjk_guess = true;
      request.cached_gjk_guess = fcl::Vector3d(guess->data());
    }
  const bool tells_positions = settings.count("positions", 0) != 0;
  if (tells_positions) settings.most_contacts(std::min(request.num_max_contacts, std::size_t{4}));  // boxBox2
  return [request, tells_positions](const Body& a, const Body& b) {
    if (is_halfspace(a) && is_halfspace(b)) throw subject::Unsupported("two half-spaces: FCL gives no depth");
    const Placed one(a), two(b);
    fcl::CollisionResultd result;
    fcl::collide(one.geometry.get(), one.at, two.geometry.get(), two.at, request, result);
    subject::Reply reply{.overlap = result.isCollision()};
    std::vector<fcl::Contactd> contacts;
    result.getContacts(contacts);
    if (contacts.empty()) return reply;
    const auto size = [](const fcl::Contactd& contact) { return std::abs(contact.penetration_depth); };
    const fcl::Contactd& deepest = *std::ranges::max_element(contacts, {}, size);
    // GST_INDEP reports depths below 0, as the mode declares, except for these pairs.
    const bool turned = request.gjk_solver_type == fcl::GST_INDEP && has_formula(a, b);
    const double sign = turned ? -1 : 1;
    reply.depth = sign * deepest.penetration_depth;
    reply.direction = plain(deepest.normal);
    for (const fcl::Contactd& contact : contacts)
      if (tells_positions && contact.normal == deepest.normal)
        reply.contacts.push_back({plain(contact.pos), sign * contact.penetration_depth});
    return reply;
  };
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> bounded{"sphere", "capsule", "box", "cylinder", "cone", "ellipsoid"};
  std::vector<std::string> all = bounded;
  all.emplace_back("halfspace");  // for a half-space, distance calls a null pointer of FCL
  const subject::Mode modes[] = {
      {.argument = "signed",
       .name = "fcl-signed",
       .depth = "negative",
       .faces = true,
       .shapes = bounded,
       .make = signed_distance},
      {.argument = "collide",
       .name = "fcl-collide",
       .moves = "b",
       .faces = true,
       .shapes = all,
       .make = [](Settings& settings) { return collide(settings, fcl::GST_LIBCCD, "GST_LIBCCD"); }},
      {.argument = "indep",
       .name = "fcl-indep",
       .depth = "negative",
       .moves = "b",
       .faces = true,
       .shapes = all,
       .make = [](Settings& settings) { return collide(settings, fcl::GST_INDEP, "GST_INDEP"); }}};
  return subject::run({"fcl", SUBJECT_VERSION, "binary64", {std::begin(modes), std::end(modes)}}, argc, argv);
}
