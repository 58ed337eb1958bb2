// SPDX-License-Identifier: GPL-3.0-or-later
// fathom-subject-ode collide: dCollide on two convex geoms, the deepest of the contacts that it returns.
#include <ode/ode.h>

#include <algorithm>
#include <cmath>

#include "verify/subjects/subject.hpp"

namespace {

using subject::Body, subject::Vector;

/// A convex geom about the mean of its vertices, which ODE takes for an inner point. ODE keeps the pointers.
class Geom {
 public:
  explicit Geom(const Body& body) {
    const Vector centre = subject::mean(body.vertices);
    for (const Vector& v : body.vertices)
      for (int i = 0; i < 3; ++i) points_.push_back(v[i] - centre[i]);
    for (const std::vector<int>& face : body.faces) {
      polygons_.push_back(static_cast<unsigned>(face.size()));
      polygons_.insert(polygons_.end(), face.begin(), face.end());
      add_plane(face);
    }
    id_ = dCreateConvex(nullptr, planes_.data(), static_cast<unsigned>(body.faces.size()), points_.data(),
                        static_cast<unsigned>(body.vertices.size()), polygons_.data());
    dGeomSetPosition(id_, centre[0], centre[1], centre[2]);
  }
  Geom(const Geom&) = delete;
  Geom& operator=(const Geom&) = delete;
  ~Geom() { dGeomDestroy(id_); }
  dGeomID id() const { return id_; }

 private:
  /// Unit normal (Newell's, outward) and offset.
  void add_plane(const std::vector<int>& face) {
    Vector normal{};
    for (std::size_t k = 0; k < face.size(); ++k) {
      const dReal *p = &points_[3 * face[k]], *q = &points_[3 * face[(k + 1) % face.size()]];
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, l = (i + 2) % 3;
        normal[i] += (p[j] - q[j]) * (p[l] + q[l]);
      }
    }
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    const dReal* p = &points_[3 * face[0]];
    double offset = 0;
    for (int i = 0; i < 3; ++i) {
      planes_.push_back(normal[i] / length);
      offset += planes_.back() * p[i];
    }
    planes_.push_back(offset);
  }

  std::vector<dReal> points_, planes_;
  std::vector<unsigned> polygons_;
  dGeomID id_;
};

subject::Solver collide(subject::Settings& settings) {
  constexpr unsigned long usual = 32, most = 0xffff;
  const unsigned long contacts = std::clamp(settings.count("contacts", usual), 1ul, most);
  settings.note("centre", "mean of the vertices");
  return [contacts](const Body& a, const Body& b) {
    const Geom one(subject::hull(a)), two(subject::hull(b));
    std::vector<dContactGeom> found(contacts);
    const int count = dCollide(one.id(), two.id(), static_cast<int>(contacts), found.data(), sizeof(dContactGeom));
    subject::Reply reply{.overlap = count > 0};
    if (!reply.overlap) return reply;
    const dContactGeom& deepest = *std::max_element(found.begin(), found.begin() + count,
                                                    [](const dContactGeom& c, const dContactGeom& d) { return c.depth < d.depth; });
    reply.depth = deepest.depth;
    reply.direction = {deepest.normal[0], deepest.normal[1], deepest.normal[2]};
    return reply;
  };
}

}  // namespace

int main(int argc, char** argv) {
  dInitODE2(0);
  const int code = subject::run(
      {"ode", SUBJECT_VERSION, "binary64", {{.argument = "collide", .name = "ode-collide", .faces = true, .make = collide}}}, argc, argv);
  dCloseODE();
  return code;
}
