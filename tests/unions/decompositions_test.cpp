// SPDX-License-Identifier: GPL-3.0-or-later
// Files as tools for convex decomposition write them: read, answered and proved.
//                                                                       [tests/data/decompositions]
#include <gtest/gtest.h>

#include <string>

#include "fathom/certificate.hpp"
#include "fathom/files.hpp"
#include "tests/unions/pieces.hpp"
#include "verify/check/check.hpp"
#include "verify/families/union_pairs.hpp"

namespace fathom::unions {
namespace {

const std::string folder = FATHOM_TEST_DATA "/decompositions/";

Pieces mug() { return read_pieces(folder + "mug.obj"); }
Pieces spanner() { return read_pieces(folder + "spanner.obj"); }

/// The answer, whose proof the checker accepts, and whose optima leave nothing that overlaps.
UnionDepth proved(const Pieces& a, const Pieces& b) {
  const UnionDepth depth = union_depth(a, b);
  const fathom_check::Verdict verdict = fathom_check::verify(certificate_text(a, b, depth));
  EXPECT_TRUE(verdict.accepted()) << verdict.line << ": " << verdict.reason;
  for (const UnionOptimum& optimum : depth.optima)
    EXPECT_EQ(union_depth(moved(a, optimum.translation), b).status, Status::touching);
  return depth;
}

TEST(Decompositions, AreReadPieceByPiece) {
  EXPECT_EQ(mug().size(), 16U);
  EXPECT_EQ(spanner().size(), 12U);
  EXPECT_EQ(read_pieces(folder + "mug"), mug()) << "law: a file a piece, or all in one";
  for (const Pieces& pieces : {mug(), spanner()})
    for (const std::vector<Point>& piece : pieces) {
      EXPECT_FALSE(families::is_flat(piece));
      EXPECT_LE(piece.size(), 24U);
    }
  EXPECT_EQ(mug()[0][0].x.get_d(), 4.646140) << "the nearest double of the text";
}

TEST(Decompositions, AMugAgainstItself) {
  // Aside: the handle of B is in the hollow of A.
  const UnionDepth same = proved(mug(), mug()), aside = proved(moved(mug(), {6, 0, 3}), mug());
  EXPECT_EQ(same.optima.size(), 2U) << "what takes A out takes B out, reversed";
  for (const UnionDepth* depth : {&same, &aside}) {
    EXPECT_EQ(depth->status, Status::penetrating);
    EXPECT_GT(depth->squared(), depth->bounds->deepest_pair);
  }
  EXPECT_LT(aside.squared(), aside.bounds->hulls);
}

TEST(Decompositions, ABoxInAMug) {
  const auto box_of = [](const mpq_class& half, const mpq_class& low) {
    return Pieces{box({-half, -half, low}, {half, half, low + 2})};
  };
  const UnionDepth with_room = proved(box_of(2, 2), mug()), too_wide = proved(box_of(mpq_class(5, 2), 2), mug()),
                   in_the_ground = proved(box_of(2, mpq_class(1, 2)), mug());
  EXPECT_EQ(with_room.status, Status::disjoint);
  EXPECT_EQ(too_wide.status, Status::penetrating);
  EXPECT_EQ(in_the_ground.status, Status::penetrating);
  EXPECT_LT(in_the_ground.squared(), mpq_class(1, 4)) << "up";
  EXPECT_LT(in_the_ground.squared(), in_the_ground.bounds->hulls);
}

TEST(Decompositions, ASpannerAboutTheRimOfAMug) {
  const UnionDepth depth = proved(moved(spanner(), {mpq_class(-3, 2), 0, mpq_class(17, 2)}), mug());
  EXPECT_EQ(depth.status, Status::penetrating);
  EXPECT_LE(depth.bounds->deepest_pair, depth.squared());
  EXPECT_LE(depth.squared(), depth.bounds->hulls);
}

}  // namespace
}  // namespace fathom::unions
