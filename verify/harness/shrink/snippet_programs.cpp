// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/shrink/snippet_programs.hpp"

#include <map>
#include <string_view>

namespace fathom::harness {
namespace {

/// In `text`, the words in the map's keys replaced by its values.
std::string filled(std::string text, const std::map<std::string, std::string>& values) {
  for (const auto& [key, value] : values)
    for (std::size_t at = 0; (at = text.find(key, at)) != std::string::npos; at += value.size()) text.replace(at, key.size(), value);
  return text;
}

/// The setting, if it is a plain number; a subject may say anything.
std::string setting(const SubjectInfo& info, const std::string& key, const std::string& usual) {
  const auto found = info.settings.find(key);
  if (found == info.settings.end() || found->second.empty()) return usual;
  const std::string& text = found->second;
  return text.find_first_not_of("0123456789.eE+-") == std::string::npos && text.find_first_of("0123456789") == 0 ? text : usual;
}

constexpr std::string_view libccd = R"(void support(const void* object, const ccd_vec3_t* along, ccd_vec3_t* farthest) {
  const Body& body = *static_cast<const Body*>(object);
  double most = -HUGE_VAL;
  for (const auto& v : body.points) {
    const double height = v[0] * along->v[0] + v[1] * along->v[1] + v[2] * along->v[2];
    if (height > most) {
      most = height;
      ccdVec3Set(farthest, v[0], v[1], v[2]);
    }
  }
}

void centre(const void* object, ccd_vec3_t* out) {
  const Body& body = *static_cast<const Body*>(object);
  ccdVec3Set(out, 0, 0, 0);
  for (const auto& v : body.points)
    for (int i = 0; i < 3; ++i) out->v[i] += v[i] / static_cast<double>(body.points.size());
}

void answer(const char* label, const Body& a, const Body& b) {
  ccd_t options;
  CCD_INIT(&options);
  options.support1 = options.support2 = support;
  options.center1 = options.center2 = centre;
  options.@tolerance = @value;
  options.max_iterations = @iterationsUL;
  ccd_real_t depth = 0;
  ccd_vec3_t direction = {}, position = {};
  const int code = @call(&a, &b, &options, &depth, &direction, &position);  // 0: overlap; B moves by depth * direction
  std::printf("%s: overlap %d depth %.17g direction %.17g %.17g %.17g\n", label, code == 0, depth, direction.v[0], direction.v[1],
              direction.v[2]);
}
)";

constexpr std::string_view fcl_convex = R"(fcl::Convexd convex(const Body& body) {
  const auto points = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const auto& v : body.points) points->emplace_back(v[0], v[1], v[2]);
  const auto faces = std::make_shared<std::vector<int>>();
  for (const auto& face : body.faces) {
    faces->push_back(static_cast<int>(face.size()));
    faces->insert(faces->end(), face.begin(), face.end());
  }
  return {points, static_cast<int>(body.faces.size()), faces, true};
}

)";

constexpr std::string_view fcl_distance = R"(void answer(const char* label, const Body& a, const Body& b) try {
  const fcl::Convexd convex_a = convex(a), convex_b = convex(b);
  const fcl::Transform3d world = fcl::Transform3d::Identity();
  fcl::DistanceRequestd request;
  request.enable_nearest_points = request.enable_signed_distance = true;
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.distance_tolerance = @value;
  fcl::DistanceResultd result;
  fcl::distance(&convex_a, world, &convex_b, world, request, result);
  std::printf("%s: overlap %d depth %.17g\n", label, !(result.min_distance > 0), -result.min_distance);
} catch (const std::exception& failure) {
  std::printf("%s: %s\n", label, failure.what());
}
)";

constexpr std::string_view fcl_collide = R"(void answer(const char* label, const Body& a, const Body& b) try {
  const fcl::Convexd convex_a = convex(a), convex_b = convex(b);
  const fcl::Transform3d world = fcl::Transform3d::Identity();
  fcl::CollisionRequestd request;
  request.enable_contact = true;
  request.gjk_solver_type = fcl::@solver;
  request.num_max_contacts = @contacts;
  request.gjk_tolerance = @value;
  fcl::CollisionResultd result;
  fcl::collide(&convex_a, world, &convex_b, world, request, result);
  std::printf("%s: overlap %d\n", label, result.isCollision());
  for (std::size_t i = 0; i < result.numContacts(); ++i) {
    const fcl::Contactd& contact = result.getContact(i);
    std::printf("%s: depth %.17g direction %.17g %.17g %.17g\n", label, contact.penetration_depth, contact.normal[0], contact.normal[1],
                contact.normal[2]);
  }
} catch (const std::exception& failure) {
  std::printf("%s: %s\n", label, failure.what());
}
)";

constexpr std::string_view bullet_placed = R"(struct Placed {
  Placed(const Body& body, btScalar margin) {
    double centre[3] = {};
    for (const auto& v : body.points)
      for (int i = 0; i < 3; ++i) centre[i] += v[i] / static_cast<double>(body.points.size());
    const btVector3 origin = btVector3(btScalar(centre[0]), btScalar(centre[1]), btScalar(centre[2]));
    at = btTransform(btMatrix3x3::getIdentity(), origin);
    for (const auto& v : body.points)
      shape.addPoint(btVector3(btScalar(v[0] - origin.x()), btScalar(v[1] - origin.y()), btScalar(v[2] - origin.z())), false);
    shape.setMargin(margin);
    shape.recalcLocalAabb();
  }
  btConvexHullShape shape;
  btTransform at;
};

)";

constexpr std::string_view bullet_epa = R"(void answer(const char* label, const Body& a, const Body& b) {
  const Placed one(a, 0), two(b, 0);
  btGjkEpaSolver2::sResults result;
  const bool overlap =
      btGjkEpaSolver2::Penetration(&one.shape, one.at, &two.shape, two.at, two.at.getOrigin() - one.at.getOrigin(), result);
  std::printf("%s: overlap %d status %d", label, overlap, static_cast<int>(result.status));
  if (overlap)
    std::printf(" depth %.17g direction %.17g %.17g %.17g", -double(result.distance), double(result.normal.x()), double(result.normal.y()),
                double(result.normal.z()));
  std::printf("\n");
}
)";

constexpr std::string_view bullet_pair = R"(void answer(const char* label, const Body& a, const Body& b) {
  const btScalar margin = btScalar(@value);
  const Placed one(a, margin), two(b, margin);
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth_solver;
  btGjkPairDetector detector(&one.shape, &two.shape, &simplex, &depth_solver);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = one.at;
  input.m_transformB = two.at;
  btPointCollector found;
  detector.getClosestPoints(input, found, nullptr);
  const double distance = found.m_distance + 2 * double(margin);  // both bodies grew by the margin
  std::printf("%s: overlap %d depth %.17g direction %.17g %.17g %.17g\n", label, found.m_hasResult && !(distance > 0), -distance,
              double(found.m_normalOnBInWorld.x()), double(found.m_normalOnBInWorld.y()), double(found.m_normalOnBInWorld.z()));
}
)";

constexpr std::string_view ode = R"(struct Geom {  // about the mean of its points; ODE keeps the pointers
  explicit Geom(const Body& body) {
    double centre[3] = {};
    for (const auto& v : body.points)
      for (int i = 0; i < 3; ++i) centre[i] += v[i] / static_cast<double>(body.points.size());
    for (const auto& v : body.points)
      for (int i = 0; i < 3; ++i) points.push_back(v[i] - centre[i]);
    for (const auto& face : body.faces) {
      polygons.push_back(static_cast<unsigned>(face.size()));
      polygons.insert(polygons.end(), face.begin(), face.end());
      add_plane(face);
    }
    id = dCreateConvex(nullptr, planes.data(), static_cast<unsigned>(body.faces.size()), points.data(),
                       static_cast<unsigned>(body.points.size()), polygons.data());
    dGeomSetPosition(id, centre[0], centre[1], centre[2]);
  }
  void add_plane(const std::vector<int>& face) {
    double normal[3] = {}, offset = 0;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const dReal *p = &points[3 * face[k]], *q = &points[3 * face[(k + 1) % face.size()]];
      for (int i = 0; i < 3; ++i) normal[i] += (p[(i + 1) % 3] - q[(i + 1) % 3]) * (p[(i + 2) % 3] + q[(i + 2) % 3]);
    }
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    for (int i = 0; i < 3; ++i) {
      planes.push_back(normal[i] / length);
      offset += planes.back() * points[3 * face[0] + i];
    }
    planes.push_back(offset);
  }
  std::vector<dReal> points, planes;
  std::vector<unsigned> polygons;
  dGeomID id;
};

void answer(const char* label, const Body& a, const Body& b) {
  const Geom one(a), two(b);
  dContactGeom contacts[@contacts];
  const int count = dCollide(one.id, two.id, @contacts, contacts, sizeof(dContactGeom));
  std::printf("%s: overlap %d\n", label, count > 0);
  for (int i = 0; i < count; ++i)
    std::printf("%s: depth %.17g direction %.17g %.17g %.17g\n", label, contacts[i].depth, contacts[i].normal[0], contacts[i].normal[1],
                contacts[i].normal[2]);
}
)";

Program libccd_program(const SubjectInfo& info) {
  const bool mpr = info.name.find("mpr") != std::string::npos;
  const std::string tolerance = mpr ? "mpr_tolerance" : "epa_tolerance";
  const std::map<std::string, std::string> values = {{"@tolerance", tolerance},
                                                     {"@value", setting(info, tolerance, "0.0001")},
                                                     {"@iterations", setting(info, "max_iterations", "18446744073709551615")},
                                                     {"@call", mpr ? "ccdMPRPenetration" : "ccdGJKPenetration"}};
  return {"g++ case.cpp -lccd -lm", "#include <ccd/ccd.h>\n\n#include <cmath>\n", filled(std::string(libccd), values), "", ""};
}

Program fcl_program(const SubjectInfo& info) {
  const bool distance = info.name.find("signed") != std::string::npos, indep = info.name.find("indep") != std::string::npos;
  const std::map<std::string, std::string> values = {{"@value", setting(info, distance ? "distance_tolerance" : "gjk_tolerance", "1e-6")},
                                                     {"@contacts", setting(info, "num_max_contacts", "1")},
                                                     {"@solver", indep ? "GST_INDEP" : "GST_LIBCCD"}};
  return {
      "g++ case.cpp $(pkg-config --cflags --libs fcl eigen3) -std=c++17",
      "#include <fcl/geometry/shape/convex.h>\n#include <fcl/narrowphase/collision.h>\n#include <fcl/narrowphase/distance.h>\n\n#include "
      "<exception>\n#include <memory>\n",
      std::string(fcl_convex) + filled(std::string(distance ? fcl_distance : fcl_collide), values), "", ""};
}

Program bullet_program(const SubjectInfo& info) {
  const bool pair = info.name.find("pair") != std::string::npos, wide = info.format.points == Precision::binary64;
  std::string includes = "#include <BulletCollision/CollisionShapes/btConvexHullShape.h>\n";
  for (const char* header :
       {"btGjkEpa2", "btGjkEpaPenetrationDepthSolver", "btGjkPairDetector", "btPointCollector", "btVoronoiSimplexSolver"})
    includes += "#include <BulletCollision/NarrowPhaseCollision/" + std::string(header) + ".h>\n";
  const std::map<std::string, std::string> values = {{"@value", setting(info, "margin", "0.04")}};
  return {std::string("g++ case.cpp $(pkg-config --cflags --libs bullet") + (wide ? "-float64)" : ")"), includes + "\n",
          std::string(bullet_placed) + filled(std::string(pair ? bullet_pair : bullet_epa), values), "", ""};
}

Program ode_program(const SubjectInfo& info) {
  const std::map<std::string, std::string> values = {{"@contacts", setting(info, "contacts", "32")}};
  return {"g++ case.cpp $(pkg-config --cflags --libs ode)", "#include <ode/ode.h>\n\n#include <cmath>\n", filled(std::string(ode), values),
          "  dInitODE2(0);\n", "  dCloseODE();\n"};
}

}  // namespace

std::optional<Program> program_for(const SubjectInfo& info) {
  if (info.library == "libccd") return libccd_program(info);
  if (info.library == "fcl") return fcl_program(info);
  if (info.library == "bullet") return bullet_program(info);
  if (info.library == "ode") return ode_program(info);
  return std::nullopt;
}

}  // namespace fathom::harness
