// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of others against a solid: own ones tile it; what is left out, moved, doubled or grown is
// found with its volume; volumes are those of inclusion and exclusion, and points are where they
// should be by winding numbers.
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>

#include "fathom/numbers.hpp"
#include "fathom/solid.hpp"
#include "tests/solids/meshes.hpp"
#include "tests/support/rounding_modes.hpp"

namespace fathom::solids {
namespace {

/// A box of the test, by its corners.
struct Box {
  std::array<mpq_class, 3> low, high;
};

Box common(const Box& a, const Box& b) {
  Box both;
  for (int i = 0; i < 3; ++i) {
    both.low[i] = std::max(a.low[i], b.low[i]);
    both.high[i] = std::max(both.low[i], std::min(a.high[i], b.high[i]));
  }
  return both;
}

mpq_class size(const Box& b) { return (b.high[0] - b.low[0]) * (b.high[1] - b.low[1]) * (b.high[2] - b.low[2]); }

/// The volume of a union, by inclusion and exclusion.
mpq_class size(const std::vector<Box>& boxes) {
  mpq_class sum;
  for (unsigned chosen = 1; chosen < 1U << boxes.size(); ++chosen) {
    std::optional<Box> all;
    int sign = -1;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if ((chosen >> i & 1U) != 0) {
        all = all ? common(*all, boxes[i]) : boxes[i];
        sign = -sign;
      }
    sum += sign * size(*all);
  }
  return sum;
}

Mesh mesh_of(const Box& b) { return box_mesh({b.low[0], b.low[1], b.low[2]}, {b.high[0], b.high[1], b.high[2]}); }

Box random_box(std::mt19937& random) {
  Box box;
  for (int i = 0; i < 3; ++i) {
    box.low[i] = static_cast<int>(random() % 6);
    box.high[i] = box.low[i] + 1 + static_cast<int>(random() % 4) + mpq_class(1, 3);
  }
  return box;
}

/// Around the corners of a box.
Box box_of(const std::vector<Point>& corners) {
  Box box{{corners[0].x, corners[0].y, corners[0].z}, {corners[0].x, corners[0].y, corners[0].z}};
  for (const Point& p : corners) {
    const std::array<mpq_class, 3> at{p.x, p.y, p.z};
    for (int i = 0; i < 3; ++i) {
      box.low[i] = std::min(box.low[i], at[i]);
      box.high[i] = std::max(box.high[i], at[i]);
    }
  }
  return box;
}

bool holds(const std::vector<Point>& corners, const Point& x) {
  const Box box = box_of(corners);
  const std::array<mpq_class, 3> at{x.x, x.y, x.z};
  for (int i = 0; i < 3; ++i)
    if (at[i] <= box.low[i] || at[i] >= box.high[i]) return false;
  return true;
}

// What is covered, counted both ways.
void expect_balance(const Solid& solid, const PieceCoverage& found, const mpq_class& of_pieces,
                    const std::string& name) {
  EXPECT_EQ(of_pieces - found.overlap, volume(solid) - found.missing + found.outside)
      << name << ", law: the union of the pieces is the solid without what is missing, and what is outside";
}

TEST(Coverage, OwnPiecesTile) {
  const Mesh third =
      moved(schoenhardt() + moved(ring_mesh(false), 1, {9, 9, 9}), mpq_class(1, 3), {0, 0, mpq_class(1, 7)});
  for (const Mesh& mesh :
       {third, cells_mesh(menger_cells(2)), box_mesh({0, 0, 0}, {4, 4, 4}) + turned(box_mesh({1, 1, 1}, {3, 3, 3})),
        box_mesh({0, 0, 0}, {2, 2, 2}) + box_mesh({1, 1, 1}, {3, 3, 3})}) {
    const Solid solid = solid_of(mesh.body());
    const PieceCoverage found = coverage(solid, pieces_of(solid));
    EXPECT_TRUE(found.tiles());
    EXPECT_EQ(found.outside_of.size(), pieces_of(solid).size());
    EXPECT_FALSE(found.uncovered || found.stray || found.most_outside());
  }
}

TEST(Coverage, OneFaultAtATime) {
  const Mesh mesh = moved(ring_mesh(false), mpq_class(1, 3), {mpq_class(1, 7), 0, 0});
  const Solid solid = solid_of(mesh.body());
  const Pieces own = pieces_of(solid);
  const auto of_piece = [&](std::size_t i) { return size(box_of(own[i])); };
  Pieces short_of = own;
  std::rotate(short_of.begin(), short_of.begin() + 1, short_of.end());
  short_of.pop_back();
  const PieceCoverage less = coverage(solid, short_of);
  EXPECT_EQ(less.missing, of_piece(0)) << "left out";
  EXPECT_EQ(less.outside, 0) << "left out";
  ASSERT_TRUE(less.uncovered);
  EXPECT_TRUE(holds(own[0], *less.uncovered));
  Pieces doubled = own;
  doubled.push_back(own[2]);
  const PieceCoverage twice = coverage(solid, doubled);
  EXPECT_TRUE(twice.same_union());
  EXPECT_FALSE(twice.tiles());
  EXPECT_EQ(twice.overlap, of_piece(2)) << "doubled";
  Pieces with_move = own;
  for (Point& p : with_move[1]) p.z += 1000;
  const PieceCoverage away = coverage(solid, with_move);
  EXPECT_EQ(away.missing, of_piece(1)) << "moved";
  EXPECT_EQ(away.outside, of_piece(1)) << "moved";
  EXPECT_EQ(away.outside_of[1], of_piece(1)) << "moved";
  EXPECT_EQ(away.most_outside(), 1U);
  ASSERT_TRUE(away.stray);
  EXPECT_TRUE(holds(with_move[1], *away.stray));
  Pieces grown = own;
  for (Point& p : grown[3]) p.z = 2 * p.z;  // from 0 upwards
  const PieceCoverage more = coverage(solid, grown);
  EXPECT_EQ(more.missing, 0) << "grown";
  EXPECT_EQ(more.outside, of_piece(3)) << "grown";
  EXPECT_EQ(more.most_outside(), 3U);
  Pieces hull_alone{mesh.points};
  const PieceCoverage hull = coverage(solid, hull_alone);
  EXPECT_EQ(hull.outside, mpq_class(1, 3)) << "the hole of the ring";
  EXPECT_EQ(winding_number(mesh, *hull.stray), 0);
}

TEST(Coverage, BoxesByInclusionAndExclusion) {
  for (unsigned seed = 1; seed <= 25; ++seed) {
    std::mt19937 random(seed);
    const std::string name = "seed " + std::to_string(seed);
    std::vector<Box> of_solid(1 + seed % 4), given(1 + seed % 5);
    for (Box& b : of_solid) b = random_box(random);
    for (Box& b : given) b = random_box(random);
    Mesh mesh = mesh_of(of_solid[0]);
    for (std::size_t i = 1; i < of_solid.size(); ++i) mesh = mesh + mesh_of(of_solid[i]);
    Pieces pieces;
    mpq_class total;
    for (const Box& b : given) pieces.push_back(mesh_of(b).points), total += size(b);
    const Solid solid = solid_of(mesh.body());
    const PieceCoverage found = coverage(solid, pieces);
    std::vector<Box> all = of_solid;
    all.insert(all.end(), given.begin(), given.end());
    EXPECT_EQ(found.missing, size(all) - size(given)) << name;
    EXPECT_EQ(found.outside, size(all) - size(of_solid)) << name;
    EXPECT_EQ(found.overlap, total - size(given)) << name;
    for (std::size_t i = 0; i < given.size(); ++i) {
      std::vector<Box> with = of_solid;
      with.push_back(given[i]);
      EXPECT_EQ(found.outside_of[i], size(with) - size(of_solid)) << name;
    }
    expect_balance(solid, found, total, name);
    ASSERT_EQ(found.uncovered.has_value(), found.missing > 0) << name;
    ASSERT_EQ(found.stray.has_value(), found.outside > 0) << name;
    const auto in_a_piece = [&](const Point& x) {
      return std::ranges::any_of(pieces, [&](const auto& piece) { return holds(piece, x); });
    };
    if (found.uncovered) {
      EXPECT_TRUE(winding_number(mesh, *found.uncovered) > 0 && !in_a_piece(*found.uncovered)) << name;
    }
    if (found.stray) {
      EXPECT_TRUE(winding_number(mesh, *found.stray) == 0 && in_a_piece(*found.stray)) << name;
    }
  }
}

// Neither has planes along the axes, and both have cavities.
TEST(Coverage, SwappingSwapsMissingAndOutside) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::mt19937 random(seed);
    Mesh a = cells_mesh(random_cells(random, 7, 3)), b = cells_mesh(random_cells(random, 7, 3));
    for (Point& p : a.points) p = {p.x + p.y / 3, p.y - p.z / 5, p.z + p.x / 7};
    for (Point& p : b.points) p = {(3 * p.x - 4 * p.y) / 5 + 1, (4 * p.x + 3 * p.y) / 5, p.z + mpq_class(1, 4)};
    const Solid of_a = solid_of(a.body()), of_b = solid_of(b.body());
    const PieceCoverage ab = coverage(of_a, pieces_of(of_b)), ba = coverage(of_b, pieces_of(of_a));
    EXPECT_EQ(ab.missing, ba.outside) << "seed " << seed;
    EXPECT_EQ(ab.outside, ba.missing) << "seed " << seed;
    EXPECT_EQ(ab.overlap, 0) << "of a tiling";
    expect_balance(of_a, ab, volume(of_b), "seed " + std::to_string(seed));
    if (ab.uncovered) {
      EXPECT_TRUE(winding_number(a, *ab.uncovered) == 1 && winding_number(b, *ab.uncovered) == 0);
    }
    if (ab.stray) {
      EXPECT_TRUE(winding_number(a, *ab.stray) == 0 && winding_number(b, *ab.stray) == 1);
    }
  }
}

TEST(Coverage, RefusesFlatPieces) {
  const Solid solid = solid_of(box_mesh({0, 0, 0}, {1, 1, 1}).body());
  const auto fault = [&](const Pieces& pieces) -> std::string {
    try {
      coverage(solid, pieces);
      return "";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  const std::vector<Point> square{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  EXPECT_EQ(fault({box_mesh({0, 0, 0}, {1, 1, 1}).points, square}),
            "piece 1 is flat: pieces that cover a solid need interiors");
  EXPECT_EQ(fault({{}}), "piece 0 has no points");
  EXPECT_EQ(fault({}), "there are no pieces");
}

TEST(Coverage, IsTheSameInEveryRoundingMode) {
  const Mesh mesh = moved(schoenhardt(), mpq_class(1, 3), {0, 0, mpq_class(1, 7)});
  const Solid solid = solid_of(mesh.body());
  Pieces pieces = pieces_of(solid);
  for (Point& p : pieces[0]) p.x += mpq_class(1, 1000);
  const auto text = [&] {
    const PieceCoverage found = coverage(solid, pieces);
    std::string all;
    for (const auto* v : {&found.missing, &found.outside, &found.overlap}) all += exact_text(*v) + " ";
    for (const Point& p : {*found.uncovered, *found.stray}) all += exact_text(p.x) + exact_text(p.y) + exact_text(p.z);
    return all;
  };
  const std::string expected = text();
  for (const int mode : testing::rounding_modes) {
    const testing::RoundingMode rounding(mode);
    EXPECT_EQ(text(), expected) << "mode " << mode;
  }
}

}  // namespace
}  // namespace fathom::solids
