// SPDX-License-Identifier: GPL-3.0-or-later
// What of a mesh holds the contacts of its solid: as the hull's answer says, where the mesh is
// convex; as every triangle says that is asked at random points of a contact.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "fathom/answer.hpp"
#include "fathom/files.hpp"
#include "fathom/patch.hpp"
#include "fathom/solid.hpp"
#include "reference/files/pose.hpp"
#include "reference/patch/patch.hpp"
#include "tests/solids/meshes.hpp"

namespace fathom::patch {
namespace {

using Kind = MeshFeature::Kind;
using solids::box_mesh;
using solids::cells_mesh;
using solids::Mesh;
using solids::prism;
using solids::random_cells;
using solids::soup;
using Features = std::vector<MeshFeature>;

const std::vector<std::pair<int, int>> L_polygon{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

Features face(std::uint32_t number) { return {{Kind::face, {number}}}; }

Body posed(Body body, const std::string& pose) {
  std::string fault;
  files::place(body, files::parse_pose(pose, Decimals::exact, fault));
  EXPECT_EQ(fault, "");
  return body;
}

UnionDepth depth_of(const Body& a, const Body& b) { return std::get<UnionDepth>(exact_answer(a, b).found); }

std::set<std::uint32_t> as_set(const std::vector<std::uint32_t>& ids) { return {ids.begin(), ids.end()}; }

/// The corners of the one feature.
std::set<std::uint32_t> corners_of(const Mesh& mesh, const Features& features) {
  EXPECT_EQ(features.size(), 1U);
  const MeshFeature& only = features.at(0);
  return as_set(only.kind == Kind::face ? mesh.faces[only.ids[0]] : only.ids);
}

TEST(MeshFeatures, OfACubeAreTheFacesOfItsHull) {
  const Mesh cube = box_mesh({-1, -1, -1}, {1, 1, 1});
  std::set<ContactKind> kinds;
  for (const std::string pose :
       {"xyz=3/2,1/5,1/7 quat=1,2,3,5", "xyz=1/5,-7/5,1/7 quat=5,1,0,1", "xyz=5/4,1,1/9 quat=7,1,1,3",
        "xyz=0,1/7,8/5 quat=3,1,1,0", "xyz=1,1/8,1 quat=9,1,3,2", "xyz=6/5,6/5,0 quat=8,0,3,3"}) {
    const Body hull_b = posed(cube.body(), pose), solid_b = posed(solid_body(cube.body()), pose);
    for (const bool swapped : {false, true}) {
      const auto asked = [&](const Body& a, const Body& b) {
        return swapped ? exact_answer(b, a) : exact_answer(a, b);
      };
      const Answer of_hulls = asked(cube.body(), hull_b), of_solids = asked(solid_body(cube.body()), solid_b);
      const std::vector<Optimum>& optima = std::get<Depth>(of_hulls.found).optima();
      ASSERT_EQ(optima.size(), 1U) << pose;
      const PieceContact& met = std::get<UnionDepth>(of_solids.found).optima.at(0).contacts.at(0);
      EXPECT_EQ(corners_of(cube, met.mesh_a), as_set(optima[0].contact.a)) << pose;
      EXPECT_EQ(corners_of(cube, met.mesh_b), as_set(optima[0].contact.b)) << pose;
      kinds.insert(optima[0].contact.kind);
    }
  }
  EXPECT_TRUE(kinds.contains(ContactKind::edge_edge) && kinds.contains(ContactKind::facet_vertex) &&
              kinds.contains(ContactKind::vertex_facet))
      << "the poses are not what the test is about";
}

TEST(MeshFeatures, InTheNotchOfAnL) {
  const Mesh ell = prism(L_polygon, 1), small = box_mesh({mpq_class(5, 4), mpq_class(3, 4), mpq_class(1, 4)},
                                                         {mpq_class(7, 4), 2, mpq_class(3, 4)});
  for (const std::string pose : {"xyz=0,0,0", "xyz=1/3,7,-2 quat=1,2,3,4", "-1 0 0 5 0 1 0 0 0 0 1 0"}) {
    const Body a = posed(solid_body(small.body()), pose), b = posed(solid_body(ell.body()), pose);
    const UnionDepth depth = depth_of(a, b), swapped = depth_of(b, a);
    ASSERT_EQ(depth.optima.size(), 1U);
    EXPECT_EQ(depth.squared(), mpq_class(1, 16));
    for (const PieceContact& met : depth.optima[0].contacts) {
      EXPECT_EQ(met.mesh_a, face(2)) << pose;
      EXPECT_EQ(met.mesh_b, face(4)) << pose;
    }
    EXPECT_EQ(swapped.optima.at(0).contacts.at(0).mesh_a, face(4)) << pose;
    const ContactGeometry geometry = contact_geometry(a, b, exact_answer(a, b));
    ASSERT_EQ(geometry.patches.size(), depth.optima[0].contacts.size());
    for (const Patch& patch : geometry.patches) {
      EXPECT_EQ(patch.mesh_a, face(2)) << pose;
      EXPECT_EQ(patch.mesh_b, face(4)) << pose;
    }
    const UnionDepth beside_hull = depth_of(posed(small.body(), pose), b);
    EXPECT_TRUE(beside_hull.optima.at(0).contacts.at(0).mesh_a.empty()) << "law: a hull is no solid";
    EXPECT_EQ(beside_hull.optima.at(0).contacts.at(0).mesh_b, face(4)) << pose;
  }
}

TEST(MeshFeatures, OfWhatIsNearest) {
  const Body ell = solid_body(prism(L_polygon, 1).body());
  const UnionDepth corner = depth_of(ell, solid_body(box_mesh({3, 2, 2}, {4, 4, 4}).body()));
  EXPECT_EQ(corner.apart->mesh_a, (Features{{Kind::vertex, {8}}}));
  EXPECT_EQ(corner.apart->mesh_b, (Features{{Kind::vertex, {0}}}));
  const UnionDepth side = depth_of(ell, solid_body(box_mesh({3, mpq_class(1, 2), -1}, {4, 4, 4}).body()));
  EXPECT_EQ(side.apart->mesh_a, face(3));
  EXPECT_EQ(side.apart->mesh_b, face(5));
  const Body bars[2] = {solid_body(box_mesh({-2, -1, 0}, {-1, 3, 1}).body()), ell};
  const ContactGeometry nearest = contact_geometry(bars[0], bars[1], exact_answer(bars[0], bars[1]));
  ASSERT_EQ(nearest.patches.size(), bars[1].pieces->size())
      << "the pieces of the L share its side, and both are nearest";
  for (const Patch& patch : nearest.patches)
    EXPECT_EQ(patch.mesh_b, face(7)) << "law: also of pairs that are not first";
}

/// Whether x lies in so many triangles of a face, by signs of the fan, that they do not cancel.
bool holds_naively(const Mesh& mesh, const std::vector<std::uint32_t>& face, const Point& x) {
  int sum = 0;
  Point first;
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    const Point p = mesh.points[face[0]] - x, q = mesh.points[face[i]] - x, r = mesh.points[face[i + 1]] - x;
    const Point n = cross(q - p, r - p);
    if (first == Point{}) first = n;
    if (n == Point{} || dot(n, p) != 0) continue;
    const int turn = sgn(dot(n, first));
    if (dot(n, cross(p, q)) > 0 && dot(n, cross(q, r)) > 0 && dot(n, cross(r, p)) > 0) sum += turn;
  }
  return sum != 0;
}

/// By every vertex, edge and triangle; x lies on no seam of a fan.
Features at_naively(const Mesh& mesh, const Point& x) {
  Features found;
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i)
    if (mesh.points[i] == x) return {{Kind::vertex, {i}}};
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const std::vector<std::uint32_t>& face : mesh.faces)
    for (std::size_t i = 0; i < face.size(); ++i) edges.insert(std::minmax(face[i], face[(i + 1) % face.size()]));
  for (const auto& [low, high] : edges) {
    const Point p = mesh.points[low] - x, q = mesh.points[high] - x;
    if (cross(p, q) == Point{} && dot(p, q) < 0) found.push_back({Kind::edge, {low, high}});
  }
  for (std::uint32_t f = 0; found.empty() && f < mesh.faces.size(); ++f)
    if (holds_naively(mesh, mesh.faces[f], x)) return face(f);
  return found;
}

// Unit squares: contacts go across many of them, along edges and over corners.
TEST(MeshFeatures, OfCellsAreWhatEveryTriangleSays) {
  std::size_t contacts = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    const Mesh a = cells_mesh(random_cells(random, 8, 3));
    Mesh b = cells_mesh(random_cells(random, 8, 3));
    if (seed % 2 == 0)
      for (Point& p : b.points) p = {(3 * p.x - 4 * p.y) / 5 + 1, (4 * p.x + 3 * p.y) / 5, p.z + mpq_class(1, 4)};
    const Body solid_a = solid_body(a.body()), solid_b = solid_body(b.body());
    const Answer answer = exact_answer(solid_a, solid_b);
    const MeshSurface surface(a.points, *a.body().faces);
    for (const Patch& patch : contact_geometry(solid_a, solid_b, answer).patches) {
      std::vector<Point> corners;
      for (std::size_t k = 0; k < patch.corners.size(); ++k) corners.push_back(patch.a(k).core);
      const Features features = surface.features(corners);
      ASSERT_FALSE(features.empty()) << "seed " << seed << ", law: a contact lies on the surface";
      std::set<MeshFeature> met;
      for (int sample = 0; sample < 40; ++sample) {
        Point x;
        mpq_class sum;
        for (const Point& corner : corners) {
          const mpq_class weight = 1 + random() % 9973;
          x = x + weight * corner;
          sum += weight;
        }
        for (const MeshFeature& f : at_naively(a, mpq_class(1 / sum) * x)) met.insert(f);
      }
      for (const MeshFeature& f : met) EXPECT_TRUE(std::ranges::find(features, f) != features.end()) << "seed " << seed;
      EXPECT_FALSE(met.empty()) << "seed " << seed;
      ++contacts;
    }
  }
  EXPECT_GT(contacts, 20U);
}

TEST(MeshFeatures, AreThoseOfTheDimensionOfTheContact) {
  const Mesh ell = prism(L_polygon, 1);
  const MeshSurface surface(ell.points, *ell.body().faces);
  using Corners = std::vector<Point>;
  const mpq_class half(1, 2), third(1, 3);
  EXPECT_EQ(surface.features(Corners{{half, third, 1}}), face(1));
  EXPECT_EQ(surface.features(Corners{{mpq_class(3, 2), 1, third}}), face(4));
  EXPECT_EQ(surface.features(Corners{{mpq_class(3, 2), mpq_class(3, 2), 1}}), Features{}) << "in the notch";
  EXPECT_EQ(surface.features(Corners{{1, 1, third}}), (Features{{Kind::edge, {3, 9}}}));
  EXPECT_EQ(surface.features(Corners{{1, 1, 1}}), (Features{{Kind::vertex, {9}}}));
  EXPECT_EQ(surface.features(Corners{{0, 1, 1}, {2, 1, 1}}), (Features{{Kind::face, {1}}, {Kind::edge, {8, 9}}}))
      << "half of it is an edge";
  EXPECT_EQ(surface.features(Corners{{0, 1, third}, {0, 1, half}}), face(7));
  EXPECT_EQ(surface.features(Corners{{1, 0, 0}, {1, 0, 1}}), face(2));
  EXPECT_EQ(surface.features(Corners{{half, half, 1}, {mpq_class(3, 2), half, 1}, {half, mpq_class(3, 2), 1}}),
            face(1));
  EXPECT_EQ(surface.features(Corners{{1, 1, 1}, {2, 1, 1}, {2, 2, 1}}), Features{}) << "in the notch";
  const Mesh triangles = soup(ell);
  const MeshSurface of_soup(triangles.points, *triangles.body().faces);
  EXPECT_EQ(of_soup.features(Corners{{1, 1, 1}}).at(0).kind, Kind::vertex);
  EXPECT_EQ(of_soup.features(Corners{{0, third, third}}).size(), 1U);
}

TEST(MeshFeatures, OfFilesAreThereForEveryContact) {
  const Body spanner = solid_body(read_mesh(FATHOM_TEST_DATA "/decompositions/spanner.off", Decimals::exact));
  const Body cube = solid_body(read_mesh(FATHOM_TEST_DATA "/cube.off"));
  for (const std::string pose : {"xyz=0,0,0", "xyz=1,-1/3,1/5 quat=3,1,2,1", "xyz=4,1,0 quat=9,1,0,1", "xyz=40,0,0"}) {
    const UnionDepth depth = depth_of(spanner, posed(cube, pose));
    for (const UnionOptimum& optimum : depth.optima)
      for (const PieceContact& met : optimum.contacts) EXPECT_TRUE(!met.mesh_a.empty() && !met.mesh_b.empty()) << pose;
    if (!depth.apart) continue;
    EXPECT_TRUE(!depth.apart->mesh_a.empty() && !depth.apart->mesh_b.empty()) << pose;
  }
}

}  // namespace
}  // namespace fathom::patch
