// SPDX-License-Identifier: GPL-3.0-or-later
// fathom-subject-libccd epa|mpr: ccdGJKPenetration and ccdMPRPenetration on vertex lists in world coordinates.
#include <ccd/ccd.h>

#include <stdexcept>

#include "verify/subjects/subject.hpp"

namespace {

using subject::Body, subject::Vector;

struct Hull {
  const std::vector<Vector>& vertices;
  Vector centre;
};

Vector plain(const ccd_vec3_t& v) { return {v.v[0], v.v[1], v.v[2]}; }

/// The first of the farthest vertices along `along`.
void support(const void* object, const ccd_vec3_t* along, ccd_vec3_t* farthest) {
  const std::vector<Vector>& vertices = static_cast<const Hull*>(object)->vertices;
  const Vector u = plain(*along);
  const auto height = [&u](const Vector& v) { return v[0] * u[0] + v[1] * u[1] + v[2] * u[2]; };
  const Vector* best = &vertices.front();
  double most = height(*best);
  for (const Vector& v : vertices)
    if (const double h = height(v); h > most) {
      most = h;
      best = &v;
    }
  ccdVec3Set(farthest, (*best)[0], (*best)[1], (*best)[2]);
}

void centre(const void* object, ccd_vec3_t* out) {
  const Vector& c = static_cast<const Hull*>(object)->centre;
  ccdVec3Set(out, c[0], c[1], c[2]);
}

using Penetration = int (*)(const void*, const void*, const ccd_t*, ccd_real_t*, ccd_vec3_t*, ccd_vec3_t*);

subject::Solver solver(Penetration penetration, const ccd_t& options) {
  return [penetration, options](const Body& a, const Body& b) {
    const Hull hull_a{a.vertices, subject::mean(a.vertices)}, hull_b{b.vertices, subject::mean(b.vertices)};
    ccd_real_t depth = 0;
    ccd_vec3_t direction{}, position{};
    const int code = penetration(&hull_a, &hull_b, &options, &depth, &direction, &position);
    if (code == -2) throw std::runtime_error("libccd ran out of memory");
    subject::Reply reply{.overlap = code == 0};
    if (!reply.overlap) return reply;
    reply.depth = depth;
    reply.direction = plain(direction);
    return reply;
  };
}

ccd_t options_of(subject::Settings& settings, ccd_real_t ccd_t::*tolerance, const std::string& name) {
  ccd_t options;
  CCD_INIT(&options);
  options.support1 = options.support2 = support;
  options.center1 = options.center2 = centre;
  options.*tolerance = settings.number(name, options.*tolerance);
  options.max_iterations = settings.count("max_iterations", options.max_iterations);
  settings.note("centre", "mean of the vertices");
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  const subject::Mode epa{.argument = "epa", .name = "libccd-epa", .moves = "b", .make = [](subject::Settings& settings) {
                            return solver(ccdGJKPenetration, options_of(settings, &ccd_t::epa_tolerance, "epa_tolerance"));
                          }};
  const subject::Mode mpr{.argument = "mpr", .name = "libccd-mpr", .moves = "b", .make = [](subject::Settings& settings) {
                            return solver(ccdMPRPenetration, options_of(settings, &ccd_t::mpr_tolerance, "mpr_tolerance"));
                          }};
  return subject::run({"libccd", SUBJECT_VERSION, "binary64", {epa, mpr}}, argc, argv);
}
