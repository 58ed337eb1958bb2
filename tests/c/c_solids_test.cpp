// SPDX-License-Identifier: GPL-3.0-or-later
// Closed meshes and their solids for C: what the C++ interface gives.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "fathom/solid.hpp"
#include "tests/c/unions.hpp"

namespace fathom {
namespace {

using namespace testing;  // handles

const std::string spanner = FATHOM_TEST_DATA "/decompositions/spanner.off";

BodyHandle mesh_of(const Body& mesh) {
  fathom_body* body = nullptr;
  const std::vector<std::uint32_t>& corners = mesh.faces->corners;
  const std::vector<unsigned> indices(corners.begin(), corners.end());
  EXPECT_EQ(fathom_body_with_triangles(exact_body_of(mesh.points).get(), indices.data(), indices.size() / 3, &body),
            FATHOM_OK)
      << fathom_last_error();
  return BodyHandle(body);
}

BodyHandle solid_of_mesh(const BodyHandle& mesh) {
  fathom_body* body = nullptr;
  EXPECT_EQ(fathom_body_solid(mesh.get(), &body), FATHOM_OK) << fathom_last_error();
  return BodyHandle(body);
}

BodyHandle posed(const BodyHandle& body, const char* pose) {
  fathom_body* moved = nullptr;
  EXPECT_EQ(fathom_body_posed(body.get(), pose, FATHOM_EXACT_DECIMALS, &moved), FATHOM_OK) << fathom_last_error();
  return BodyHandle(moved);
}

std::string exact_volume(const BodyHandle& solid) {
  char* exact = nullptr;
  EXPECT_EQ(fathom_body_volume(solid.get(), nullptr, &exact), FATHOM_OK) << fathom_last_error();
  return taken(exact);
}

/// The points of a piece as text, by both ways to read them.
std::vector<std::string> corners_of(const BodyHandle& body, std::size_t piece) {
  fathom_body* made = nullptr;
  EXPECT_EQ(fathom_body_piece(body.get(), piece, &made), FATHOM_OK) << fathom_last_error();
  const BodyHandle handle(made);
  std::size_t count = 0;
  EXPECT_EQ(fathom_body_points(made, &count), FATHOM_OK);
  std::vector<std::string> corners;
  for (std::size_t i = 0; i < count; ++i) {
    double at[3];
    char* exact = nullptr;
    EXPECT_EQ(fathom_body_point(made, i, at, &exact), FATHOM_OK);
    corners.push_back(taken(exact) + " " + hex_text(at[0]) + " " + hex_text(at[1]) + " " + hex_text(at[2]));
  }
  return corners;
}

TEST(CSolids, EqualTheCppInterface) {
  for (const Decimals decimals : {Decimals::binary64, Decimals::exact}) {
    const Body mesh = read_mesh(spanner, decimals), expected = solid_body(mesh);
    const BodyHandle solid = solid_of_mesh(mesh_of(mesh));
    std::size_t count = 0;
    ASSERT_EQ(fathom_body_pieces(solid.get(), &count), FATHOM_OK);
    ASSERT_EQ(count, expected.pieces->size());
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<std::string> corners;
      for (const Point& p : (*expected.pieces)[i]) {
        std::string& text = corners.emplace_back();
        for (const mpq_class* x : {&p.x, &p.y, &p.z}) text += exact_text(*x) + " ";
        text +=
            hex_text(round_binary64(p.x)) + " " + hex_text(round_binary64(p.y)) + " " + hex_text(round_binary64(p.z));
      }
      EXPECT_EQ(corners_of(solid, i), corners) << "piece " << i;
    }
    EXPECT_EQ(exact_volume(solid), exact_text(volume(*expected.solid)));
    double rounded = 0;
    ASSERT_EQ(fathom_body_volume(solid.get(), &rounded, nullptr), FATHOM_OK);
    EXPECT_EQ(rounded, round_binary64(volume(*expected.solid)));
    const BodyHandle cube = shape_of("box:half=1:1:1");
    EXPECT_EQ(exactly(answer_about(solid, cube), FATHOM_TRANSLATION),
              exactly(answer_about(union_of(*expected.pieces), cube), FATHOM_TRANSLATION));
  }
}

TEST(CSolids, OfFilesAndOfCases) {
  fathom_body *mesh = nullptr, *a = nullptr, *b = nullptr;
  ASSERT_EQ(fathom_body_from_mesh(spanner.c_str(), FATHOM_EXACT_DECIMALS, &mesh), FATHOM_OK);
  EXPECT_EQ(exact_volume(solid_of_mesh(BodyHandle(mesh))),
            exact_text(volume(solid_of(read_mesh(spanner, Decimals::exact)))));
  ASSERT_EQ(fathom_bodies_from_case(R"({"a":{"solid":{"vertices":[[0,0,0],[3,0,0],[0,3,0],[0,0,3]],"faces":)"
                                    R"([[0,2,1],[0,1,3],[0,3,2],[1,2,3]]}},"b":{"shape":"box","half":[1,1,1]}})",
                                    &a, &b),
            FATHOM_OK)
      << fathom_last_error();
  const BodyHandle tetrahedron(a), box(b);
  EXPECT_EQ(exact_volume(tetrahedron), "9/2");
}

TEST(CSolids, MoveWithTheirMesh) {
  const BodyHandle solid = solid_of_mesh(mesh_of(read_mesh(spanner, Decimals::exact)));
  const mpq_class before(exact_volume(solid));
  for (const auto& [pose, times] :
       {std::pair("xyz=1/3,2,-7 quat=1,2,3,4", 1), {"2 0 0 0 0 2 0 0 0 0 2 1", 8}, {"-1 0 0 0 1 1 0 0 0 0 3 1/7", 3}})
    EXPECT_EQ(exact_volume(posed(solid, pose)), exact_text(times * before)) << pose;
  EXPECT_EQ(fathom_body_volume(posed(solid, "1 0 0 0 0 1 0 0 0 0 0 0").get(), nullptr, nullptr), FATHOM_ABSENT);
}

TEST(CSolids, RefuseWhatBoundsNone) {
  const Body mesh = read_mesh(spanner, Decimals::exact);
  const std::vector<unsigned> corners(mesh.faces->corners.begin(), mesh.faces->corners.end());
  const BodyHandle points = exact_body_of(mesh.points), capsule = shape_of("capsule:r=1,h=1");
  fathom_body* open = nullptr;
  ASSERT_EQ(fathom_body_with_triangles(points.get(), corners.data(), corners.size() / 3 - 1, &open), FATHOM_OK);
  const BodyHandle kept(open);
  const auto refused = [](int code, int expected, const std::string& why) {
    EXPECT_EQ(code, expected) << why;
    EXPECT_NE(std::string(fathom_last_error()).find(why), std::string::npos) << fathom_last_error();
  };
  fathom_body* made = points.get();
  refused(fathom_body_solid(open, &made), FATHOM_BAD_INPUT,
          "the mesh is not closed: 3 edges have more faces on one side than on the other, such as ");
  EXPECT_EQ(made, nullptr);
  refused(fathom_body_solid(points.get(), &made), FATHOM_BAD_INPUT, "expected a mesh with faces, found points alone");
  refused(fathom_body_solid(capsule.get(), &made), FATHOM_BAD_INPUT, "expected a mesh, found a shape");
  refused(fathom_body_solid(nullptr, &made), FATHOM_BAD_INPUT, "expected a pointer, found NULL");
  refused(fathom_body_solid(open, nullptr), FATHOM_BAD_INPUT, "the place for the result");
  const unsigned beyond[3] = {0, 1, 84};
  refused(fathom_body_with_triangles(points.get(), beyond, 1, &made), FATHOM_BAD_INPUT,
          "triangle 0: expected one below 84, the number of points, found 84");
  refused(fathom_body_with_triangles(points.get(), nullptr, 1, &made), FATHOM_BAD_INPUT, "corners: expected a pointer");
  refused(fathom_body_with_triangles(points.get(), beyond, std::size_t{1} << 40, &made), FATHOM_BAD_INPUT,
          "expected from 1 to 2^31 triangles");
  refused(fathom_body_with_triangles(capsule.get(), beyond, 1, &made), FATHOM_ABSENT, "not the hull of points");
  refused(fathom_body_with_triangles(points.get(), beyond, 0, &made), FATHOM_BAD_INPUT,
          "expected from 1 to 2^31 triangles");
}

TEST(CSolids, OtherBodiesHaveNoSuchParts) {
  const BodyHandle cube = body_of(cube_at(0)), walls = block();
  std::size_t count = 0;
  fathom_body* piece = nullptr;
  EXPECT_EQ(fathom_body_pieces(walls.get(), &count), FATHOM_OK);
  EXPECT_EQ(count, 3U);
  EXPECT_EQ(fathom_body_piece(walls.get(), 3, &piece), FATHOM_BAD_INPUT);
  EXPECT_STREQ(fathom_last_error(), "index: expected one below 3, the number of pieces, found 3");
  EXPECT_EQ(fathom_body_volume(walls.get(), nullptr, nullptr), FATHOM_ABSENT);
  EXPECT_EQ(fathom_body_points(walls.get(), &count), FATHOM_ABSENT);
  EXPECT_EQ(fathom_body_pieces(cube.get(), &count), FATHOM_ABSENT);
  EXPECT_EQ(fathom_body_piece(cube.get(), 0, &piece), FATHOM_ABSENT);
  EXPECT_EQ(fathom_body_point(cube.get(), 8, nullptr, nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_body_points(cube.get(), nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_body_pieces(walls.get(), nullptr), FATHOM_BAD_INPUT);
}

}  // namespace
}  // namespace fathom
