// SPDX-License-Identifier: GPL-3.0-or-later
// Solids of meshes: the pieces tile, the volume is right, refusals name their places, and what the
// pieces say is what the mesh says.
#include "fathom/solid.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "fathom/numbers.hpp"
#include "fathom/union.hpp"
#include "reference/files/pose.hpp"
#include "reference/solids/solid_values.hpp"
#include "tests/solids/meshes.hpp"
#include "tests/support/rounding_modes.hpp"

namespace fathom::solids {
namespace {

const std::vector<std::pair<int, int>> L{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

Mesh cube(int low, int high) { return box_mesh({low, low, low}, {high, high, high}); }

std::string fault_of(const Mesh& mesh) try {
  solid_of(mesh.body());
  return "";
} catch (const std::invalid_argument& error) {
  return error.what();
}

/// Whether a point lies strictly inside a piece.
bool is_inside(const Solid& solid, const Solid::Piece& piece, const Point& x) {
  for (const std::vector<std::uint32_t>& f : piece.facets) {
    const Point& p = solid.points[f[0]];
    if (dot(cross(solid.points[f[1]] - p, solid.points[f[2]] - p), x - p) >= 0) return false;
  }
  return true;
}

// The pieces around each of some points are as many as its winding number, which knows no pieces.
void expect_tiling(const Mesh& mesh, const Solid& solid, const std::string& name) {
  const kernels::Report report = validate(solid);
  EXPECT_TRUE(report.ok()) << name << ": " << report.faults.front();
  std::mt19937 random(7);
  const int sign = solid.turned ? -1 : 1;
  const auto share = [&] { return mpq_class(1 + random() % 996, 997); };
  for (int i = 0; i < 20; ++i) {
    const Point &p = mesh.points[random() % mesh.points.size()], &q = mesh.points[random() % mesh.points.size()];
    const Point x{p.x + share() * (q.x - p.x) + share() / 1000, p.y + share() * (q.y - p.y) + share() / 1001,
                  p.z + share() * (q.z - p.z) - share() / 1003};
    const auto around =
        std::ranges::count_if(solid.pieces, [&](const auto& piece) { return is_inside(solid, piece, x); });
    ASSERT_EQ(sign * winding_number(mesh, x), around) << name << ", law: winding number";
  }
}

struct Known {
  std::string name;
  Mesh mesh;
  mpq_class volume;
  std::size_t pieces;
};

std::vector<Known> known_solids() {
  const Mesh flap{{{2, 0, 0}, {3, 0, 0}, {3, 2, 0}}, {{0, 1, 2}, {2, 1, 0}}};
  Mesh with_t = cube(0, 2);  // a corner on an edge that one of its faces does not have
  with_t.points.push_back({1, 0, 0});
  with_t.faces[0] = {0, 2, 3, 1, 8};
  const Mesh small = cube(0, 1);
  return {
      {"cube", cube(0, 2), 8, 1},
      {"L", prism(L, 1), 3, 2},
      {"U", prism({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1), 5, 3},
      {"touches itself in an edge", prism({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}, 1), 2, 2},
      {"cavity", cube(0, 4) + turned(cube(1, 3)), 56, 6},
      {"a shell in the cavity of another", cube(0, 9) + turned(cube(1, 8)) + cube(3, 5), 729 - 343 + 8, 7},
      {"apart", small + moved(small, 1, {3, 0, 0}), 2, 2},
      {"common face", cube(0, 2) + moved(cube(0, 2), 1, {2, 0, 0}), 16, 1},
      {"part of a face in common", cube(0, 2) + moved(cube(0, 2), 1, {2, 1, 1}), 16, 2},
      {"common edge", small + moved(small, 1, {1, 1, 0}), 2, 2},
      {"common corner", small + moved(small, 1, {1, 1, 1}), 2, 2},
      {"overlap", cube(0, 2) + cube(1, 3), 15, 0},
      {"twice", cube(0, 2) + cube(0, 2), 8, 2},
      {"flap", cube(0, 2) + flap, 8, 1},
      {"corner on an edge", with_t, 8, 1},
      {"Schoenhardt", schoenhardt(), 0, 0},
      {"ring", ring_mesh(false), 16, 4},
      {"linked rings", ring_mesh(false) + moved(ring_mesh(true), 1, {2, 2, -2}), 32, 8},
      {"Menger 1", cells_mesh(menger_cells(1)), 20, 12},
  };
}

TEST(Solid, PiecesTileKnownMeshes) {
  for (const auto& [name, mesh, size, pieces] : known_solids()) {
    const Mesh third = moved(mesh, mpq_class(1, 3), {mpq_class(1, 7), 0, -5});
    for (const auto& [form, parts] : {std::pair(mesh, 1), {soup(mesh), 1}, {turned(mesh), 1}, {third, 27}}) {
      const Solid solid = solid_of(form.body());
      expect_tiling(form, solid, name);
      if (pieces != 0) EXPECT_EQ(solid.pieces.size(), pieces) << name;
      if (size != 0) EXPECT_EQ(volume(solid), size / parts) << name;
    }
  }
}

TEST(Solid, RandomCellsTile) {
  for (unsigned seed = 1; seed <= 15; ++seed) {
    std::mt19937 random(seed);
    const std::size_t count = 1 + seed % 20;
    Mesh mesh = cells_mesh(random_cells(random, count, 4));
    // A sheared lattice: no plane is along an axis.
    for (Point& p : mesh.points) p = {p.x + p.y / 3, p.y - p.z / 5, p.z + p.x / 7};
    const Solid solid = solid_of(mesh.body());
    expect_tiling(mesh, solid, "seed " + std::to_string(seed));
    EXPECT_EQ(volume(solid), mpq_class(static_cast<unsigned long>(count)) * mpq_class(104, 105)) << "seed " << seed;
  }
}

// Two meshes of one random lattice each, which cross: winding numbers of 2, and no symmetry.
TEST(Solid, OverlappingMeshesTile) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::mt19937 random(seed);
    const Mesh a = cells_mesh(random_cells(random, 6, 3));
    Mesh b = cells_mesh(random_cells(random, 6, 3));
    for (Point& p : b.points) p = {(3 * p.x - 4 * p.y) / 5 + 1, (4 * p.x + 3 * p.y) / 5, p.z + mpq_class(1, 4)};
    const Mesh both = a + b;
    const Solid solid = solid_of(both.body());
    expect_tiling(both, solid, "seed " + std::to_string(seed));
    EXPECT_LE(volume(solid), 12);
  }
}

TEST(Solid, SaysWhatPeopleMayNotExpect) {
  EXPECT_TRUE(solid_of(turned(prism(L, 1)).body()).turned);
  EXPECT_TRUE(solid_of((cube(0, 2) + cube(1, 3)).body()).overlaps);
  EXPECT_FALSE(solid_of((cube(0, 2) + moved(cube(0, 2), 1, {2, 0, 0})).body()).overlaps);
  Mesh bent = cube(0, 2);
  bent.points[7] = {2, 2, 3};
  const Solid solid = solid_of(bent.body());
  EXPECT_EQ(solid.bent_faces, 1U);
  EXPECT_EQ(notes(solid).at(0), "1 face of the mesh is not flat: cut from the first corner");
}

TEST(Solid, RefusesWithAPlace) {
  Mesh open = cube(0, 2);
  open.faces.pop_back();
  EXPECT_EQ(
      fault_of(open),
      "the mesh is not closed: 4 edges have more faces on one side than on the other, such as (0, 0, 0) -> (0, 2, 0). "
      "A solid has no hole in its surface");
  Mesh turned_face = cube(0, 2);
  std::ranges::reverse(turned_face.faces[1]);
  EXPECT_NE(fault_of(turned_face).find("two faces run in the same direction: one of them is turned over"),
            std::string::npos);
  Mesh face_twice = cube(0, 2);
  face_twice.faces.push_back(face_twice.faces[0]);
  EXPECT_NE(fault_of(face_twice).find("a face is given twice"), std::string::npos);
  const Mesh inverted = cube(0, 3) + moved(turned(cube(0, 1)), 1, {5, 0, 0});
  EXPECT_EQ(
      fault_of(inverted),
      "the mesh crosses itself, or a part of it is inside out: its winding number is -1 at (5.5, 0.5, 0.5), and has "
      "the other sign elsewhere");
  EXPECT_NE(fault_of(turned(inverted)).find("its winding number is 1 at (5.5, 0.5, 0.5)"), std::string::npos);
  EXPECT_NE(fault_of(cube(0, 1) + moved(turned(cube(0, 1)), 1, {5, 0, 0})).find("the other sign elsewhere"),
            std::string::npos)
      << "of volume 0";
  const Mesh bow_tie = prism({{0, 0}, {2, 2}, {2, 0}, {0, 4}}, 1);
  EXPECT_NE(fault_of(bow_tie).find("the mesh crosses itself"), std::string::npos);
  EXPECT_EQ(fault_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}}),
            "the mesh encloses no volume: its faces cancel");
  EXPECT_EQ(fault_of({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}),
            "the mesh encloses no volume: its faces have no area");
  EXPECT_THROW(solid_of(Body{GivenPoints(cube(0, 1).points)}), std::invalid_argument);
  EXPECT_NE(fault_of({cube(0, 1).points, {{0, 1, 8}}}).find("expected faces of points"), std::string::npos);
  EXPECT_THROW(solid_of(Body{}), std::invalid_argument);
  EXPECT_NE(fault_of({{}, {{0, 1, 2}}}).find("found faces alone"), std::string::npos);
}

TEST(Solid, PiecesComeBackFromTheirFile) {
  const Mesh mesh = moved(schoenhardt(), mpq_class(1, 3), {0, 0, mpq_class(1, 7)});
  const Solid solid = solid_of(mesh.body());
  EXPECT_EQ(parse_pieces(pieces_obj(solid), "pieces.obj").size(), pieces_of(solid).size());
  std::set<std::string> written, read;
  const auto add = [](const Pieces& pieces, std::set<std::string>& all) {
    for (const std::vector<Point>& piece : pieces)
      for (const Point& p : piece) all.insert(exact_text(p.x) + " " + exact_text(p.y) + " " + exact_text(p.z));
  };
  add(pieces_of(solid), written);
  add(parse_pieces(pieces_obj(solid), "pieces.obj", Decimals::exact), read);
  EXPECT_EQ(written, read);
}

TEST(Solid, IsTheSameInEveryRoundingMode) {
  const Mesh mesh = moved(schoenhardt() + cells_mesh(menger_cells(1)), mpq_class(1, 3), {0, 0, mpq_class(1, 7)});
  const std::string expected = pieces_obj(solid_of(mesh.body()));
  for (const int mode : testing::rounding_modes) {
    const testing::RoundingMode rounding(mode);
    EXPECT_EQ(pieces_obj(solid_of(mesh.body())), expected) << "mode " << mode;
  }
}

TEST(Solid, MovesWithItsMesh) {
  const Mesh mesh = schoenhardt() + moved(prism(L, 1), 1, {9, 0, 0});
  for (const int mirror : {1, -1}) {
    Body body = solid_body(mesh.body());
    const Pose pose{{{mirror, 1, 0, 3}, {0, 2, mpq_class(1, 3), 0}, {0, 0, 1, -1}}};
    files::place(body, {.matrix = pose});
    const kernels::Report report = validate(*body.solid);
    EXPECT_TRUE(report.ok()) << report.faults.front();
    EXPECT_EQ(volume(*body.solid), 2 * volume(solid_of(mesh.body())));
    EXPECT_EQ(*body.pieces, pieces_of(*body.solid));
  }
}

// A twin that knows no planes of the mesh: the cells that it is made of.
TEST(Solid, DepthIsThatOfTheCells) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    const std::set<Cell> of_a = random_cells(random, 5, 3), of_b = random_cells(random, 5, 3);
    const auto cells = [](const std::set<Cell>& all) {
      Pieces pieces;
      for (const auto& [x, y, z] : all) pieces.push_back(box_mesh({x, y, z}, {x + 1, y + 1, z + 1}).points);
      return pieces;
    };
    const auto depth = [](const Pieces& a, const Pieces& b) { return union_depth(a, b).squared(); };
    EXPECT_EQ(depth(pieces_of(solid_of(cells_mesh(of_a).body())), pieces_of(solid_of(cells_mesh(of_b).body()))),
              depth(cells(of_a), cells(of_b)))
        << "seed " << seed;
  }
}

}  // namespace
}  // namespace fathom::solids
