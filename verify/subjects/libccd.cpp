// SPDX-License-Identifier: GPL-3.0-or-later
// fathom-subject-libccd epa|mpr: ccdGJKPenetration and ccdMPRPenetration on vertex lists in world
// coordinates, and on shapes.
#include <ccd/ccd.h>

#include <cmath>
#include <map>
#include <stdexcept>

#include "verify/subjects/subject.hpp"

namespace {

using subject::Body, subject::Vector;

Vector plain(const ccd_vec3_t& v) { return {v.v[0], v.v[1], v.v[2]}; }

/// Returns a farthest point of a body along `u`. libccd has no shapes: these functions follow its
/// test suite and FCL.
using Support = Vector (*)(const Body& body, const Vector& u);

/// Returns the first of the farthest vertices.
Vector hull(const Body& body, const Vector& u) {
  const auto height = [&u](const Vector& v) { return v[0] * u[0] + v[1] * u[1] + v[2] * u[2]; };
  const Vector* best = &body.vertices.front();
  double most = height(*best);
  for (const Vector& v : body.vertices)
    if (const double h = height(v); h > most) {
      most = h;
      best = &v;
    }
  return *best;
}

/// Returns the farthest point of a ball about O; O for a direction of length 0.
Vector ball(double radius, const Vector& u) {
  const double length = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  if (length == 0) return {};
  return {u[0] * (radius / length), u[1] * (radius / length), u[2] * (radius / length)};
}

/// Returns the farthest point of a disc about O across z.
Vector disc(double radius, const Vector& u) { return ball(radius, {u[0], u[1], 0}); }

Vector sphere(const Body& body, const Vector& u) { return ball(subject::number(body, "radius"), u); }

Vector capsule(const Body& body, const Vector& u) {
  Vector v = ball(subject::number(body, "radius"), u);
  v[2] += std::copysign(subject::number(body, "half_length"), u[2]);
  return v;
}

Vector box(const Body& body, const Vector& u) {
  const Vector& half = subject::triple(body, "half");
  return {std::copysign(half[0], u[0]), std::copysign(half[1], u[1]), std::copysign(half[2], u[2])};
}

Vector cylinder(const Body& body, const Vector& u) {
  Vector v = disc(subject::number(body, "radius"), u);
  v[2] = std::copysign(subject::number(body, "half_length"), u[2]);
  return v;
}

/// Returns the apex, which is above, or a point of the rim.
Vector cone(const Body& body, const Vector& u) {
  const double radius = subject::number(body, "radius"), half_length = subject::number(body, "half_length");
  if (2 * half_length * u[2] > radius * std::hypot(u[0], u[1])) return {0, 0, half_length};
  Vector v = disc(radius, u);
  v[2] = -half_length;
  return v;
}

Vector ellipsoid(const Body& body, const Vector& u) {
  const Vector& r = subject::triple(body, "radii");
  Vector v = ball(1, {r[0] * u[0], r[1] * u[1], r[2] * u[2]});
  for (int i = 0; i < 3; ++i) v[i] *= r[i];
  return v;
}

const std::map<std::string, Support>& supports() {
  static const std::map<std::string, Support> all{{"sphere", sphere}, {"capsule", capsule},
                                                  {"box", box},       {"cylinder", cylinder},
                                                  {"cone", cone},     {"ellipsoid", ellipsoid}};
  return all;
}

struct Object {
  explicit Object(const Body& given) : body(given) {
    if (body.shape.empty()) {
      centre = subject::mean(body.vertices);
      return;
    }
    centre = body.translation;
    farthest = supports().at(body.shape);
  }
  const Body& body;
  Vector centre{};
  Support farthest = hull;
};

void support(const void* object, const ccd_vec3_t* along, ccd_vec3_t* farthest) {
  const Object& of = *static_cast<const Object*>(object);
  const bool placed = !of.body.shape.empty();
  Vector v = of.farthest(of.body, placed ? subject::turned_back(of.body, plain(*along)) : plain(*along));
  if (placed) {
    v = subject::turned(of.body, v);
    for (int i = 0; i < 3; ++i) v[i] += of.body.translation[i];
  }
  ccdVec3Set(farthest, v[0], v[1], v[2]);
}

void centre(const void* object, ccd_vec3_t* out) {
  const Vector& c = static_cast<const Object*>(object)->centre;
  ccdVec3Set(out, c[0], c[1], c[2]);
}

/// The direction from which GJK starts. It is global because libccd calls a function of the bodies
/// alone.
Vector first_direction{};

void first(const void*, const void*, ccd_vec3_t* out) {
  ccdVec3Set(out, first_direction[0], first_direction[1], first_direction[2]);
}

using Penetration = int (*)(const void*, const void*, const ccd_t*, ccd_real_t*, ccd_vec3_t*, ccd_vec3_t*);

ccd_t options_of(subject::Settings& settings, ccd_real_t ccd_t::*tolerance, const std::string& name) {
  ccd_t options;
  CCD_INIT(&options);
  options.support1 = options.support2 = support;
  options.center1 = options.center2 = centre;
  options.*tolerance = settings.number(name, options.*tolerance);
  options.max_iterations = settings.count("max_iterations", options.max_iterations);
  if (tolerance == &ccd_t::epa_tolerance)  // MPR starts from the centres instead
    if (const auto direction = settings.vector("first_direction", "1:0:0")) {
      first_direction = *direction;
      options.first_dir = first;
    }
  settings.note("centre", "mean of the vertices");
  return options;
}

/// Makes a solver. By libccd's header, its position is where a force should act, not a point of
/// both bodies; it is reported as a contact only on request.
subject::Solver solver(Penetration penetration, subject::Settings& settings, ccd_real_t ccd_t::*tolerance,
                       const std::string& name) {
  const ccd_t options = options_of(settings, tolerance, name);
  const bool tells_position = settings.count("positions", 0) != 0;
  return [penetration, options, tells_position](const Body& a, const Body& b) {
    const Object one(a), two(b);
    ccd_real_t depth = 0;
    ccd_vec3_t direction{}, position{};
    const int code = penetration(&one, &two, &options, &depth, &direction, &position);
    if (code == -2) throw std::runtime_error("libccd ran out of memory");
    subject::Reply reply{.overlap = code == 0};
    if (!reply.overlap) return reply;
    reply.depth = depth;
    reply.direction = plain(direction);
    if (tells_position) reply.contacts = {{plain(position), depth}};
    return reply;
  };
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> shapes;
  for (const auto& [name, support_of_name] : supports()) shapes.push_back(name);
  const subject::Mode epa{
      .argument = "epa", .name = "libccd-epa", .moves = "b", .shapes = shapes, .make = [](subject::Settings& settings) {
        return solver(ccdGJKPenetration, settings, &ccd_t::epa_tolerance, "epa_tolerance");
      }};
  const subject::Mode mpr{
      .argument = "mpr", .name = "libccd-mpr", .moves = "b", .shapes = shapes, .make = [](subject::Settings& settings) {
        return solver(ccdMPRPenetration, settings, &ccd_t::mpr_tolerance, "mpr_tolerance");
      }};
  return subject::run({"libccd", SUBJECT_VERSION, "binary64", {epa, mpr}}, argc, argv);
}
