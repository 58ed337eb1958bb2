// SPDX-License-Identifier: GPL-3.0-or-later
// fathom-subject-ode collide: dCollide on convex geoms and ODE's own primitives, the deepest of the
// contacts that it returns.
#include <ode/ode.h>

#include <algorithm>
#include <cmath>

#include "verify/subjects/subject.hpp"

namespace {

using subject::Body, subject::Vector;

Vector plain(const dVector3& v) { return {v[0], v[1], v[2]}; }

/// Makes a primitive of ODE, whose lengths are full ones. Its shapes lie along z about their
/// centre. A plane has no position: its normal and offset determine it.
dGeomID primitive(const Body& body) {
  const auto number = [&body](const char* name) { return subject::number(body, name); };
  if (subject::is(body, "halfspace")) {
    const Vector normal = subject::turned(body, subject::triple(body, "normal"));
    double offset = number("offset");
    for (int i = 0; i < 3; ++i) offset += normal[i] * body.translation[i];
    return dCreatePlane(nullptr, normal[0], normal[1], normal[2], offset);
  }
  dGeomID id = nullptr;
  if (subject::is(body, "sphere")) id = dCreateSphere(nullptr, number("radius"));
  if (subject::is(body, "capsule")) id = dCreateCapsule(nullptr, number("radius"), 2 * number("half_length"));
  if (subject::is(body, "cylinder")) id = dCreateCylinder(nullptr, number("radius"), 2 * number("half_length"));
  if (subject::is(body, "box")) {
    const auto& [x, y, z] = subject::triple(body, "half");
    id = dCreateBox(nullptr, 2 * x, 2 * y, 2 * z);
  }
  const fathom_subject::Matrix& r = body.rotation;
  const dMatrix3 rotation = {r[0][0], r[0][1], r[0][2], 0, r[1][0], r[1][1], r[1][2], 0, r[2][0], r[2][1], r[2][2], 0};
  dGeomSetRotation(id, rotation);
  dGeomSetPosition(id, body.translation[0], body.translation[1], body.translation[2]);
  return id;
}

/// A primitive, or a convex geom about the mean of its vertices, which ODE uses as an inner point.
/// ODE keeps the pointers.
class Geom {
 public:
  explicit Geom(const Body& body) {
    if (body.shape.empty()) make_convex(subject::hull(body));
    else id_ = primitive(body);
  }
  Geom(const Geom&) = delete;
  Geom& operator=(const Geom&) = delete;
  ~Geom() { dGeomDestroy(id_); }
  dGeomID id() const { return id_; }

 private:
  void make_convex(const Body& body) {
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

  /// Adds the unit normal (Newell's, outward) and offset of a face.
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
  const bool tells_positions = settings.count("positions", 0) != 0;
  if (tells_positions) settings.most_contacts(contacts);
  settings.note("centre", "mean of the vertices");
  return [contacts, tells_positions](const Body& a, const Body& b) {
    if (subject::is(a, "halfspace") && subject::is(b, "halfspace"))
      throw subject::Unsupported("two half-spaces: ODE collides no planes");
    const Geom one(a), two(b);
    std::vector<dContactGeom> found(contacts);
    const int count = dCollide(one.id(), two.id(), static_cast<int>(contacts), found.data(), sizeof(dContactGeom));
    subject::Reply reply{.overlap = count > 0};
    if (!reply.overlap) return reply;
    const dContactGeom& deepest =
        *std::max_element(found.begin(), found.begin() + count,
                          [](const dContactGeom& c, const dContactGeom& d) { return c.depth < d.depth; });
    reply.depth = deepest.depth;
    reply.direction = plain(deepest.normal);
    for (int i = 0; i < count; ++i)
      if (tells_positions && plain(found[i].normal) == *reply.direction)
        reply.contacts.push_back({plain(found[i].pos), found[i].depth});
    return reply;
  };
}

}  // namespace

int main(int argc, char** argv) {
  dInitODE2(0);
  const subject::Mode mode{.argument = "collide",
                           .name = "ode-collide",
                           .faces = true,
                           .shapes = {"sphere", "capsule", "box", "cylinder", "halfspace"},
                           .make = collide};
  const int code = subject::run({"ode", SUBJECT_VERSION, "binary64", {mode}}, argc, argv);
  dCloseODE();
  return code;
}
