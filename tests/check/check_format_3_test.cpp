// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate checker as a library, format 3: what it accepts, and that each single fault is
// found where it is.
#include <gtest/gtest.h>

#include <string>

#include "tests/check/edits.hpp"
#include "verify/check/check.hpp"

namespace fathom_check {
namespace {

std::string third(const std::string& name) { return data("format_3/" + name + ".cert"); }

const std::string seam = third("cube_in_two_pieces"), touching = third("pieces_touching"),
                  apart = third("pieces_apart");

/// The line of `text` that begins with `start`, the `which`-th one, from 1.
std::size_t line_of(const std::string& text, const std::string& start, int which = 1) {
  std::size_t line = 1;
  for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1, ++line)
    if (text.compare(begin, start.size(), start) == 0 && --which == 0) return line;
  ADD_FAILURE() << start;
  return 0;
}

TEST(CheckFormat3, SaysWhatIsProved) {
  const auto line = [](const std::string& text) { return verdict_line(verify(text), "x"); };
  EXPECT_EQ(line(seam), "s VERIFIED penetrating depth_squared=1 optima=1 pieces=2x1 a%20cube%20in%20two%20pieces");
  EXPECT_EQ(line(touching), "s VERIFIED touching depth_squared=0 pieces=2x2 pieces%20touching");
  EXPECT_EQ(line(edited(apart, "id pieces%20apart\n", "")), "s VERIFIED disjoint distance_squared=25 pieces=2x2 x");
  const Verdict verdict = verify(apart);
  EXPECT_EQ(verdict.format, 3);
  EXPECT_EQ(verdict.depth_squared + verdict.signed_depth, "") << "what is apart has no depth";
  EXPECT_EQ(verdict.distance_squared, "25");
  EXPECT_EQ(line(edited(seam, "claim depth 1\n", "claim depth 7/7\n")).substr(0, 38),
            "s VERIFIED penetrating depth_squared=1")
      << "lowest terms";
}

TEST(CheckFormat3, FaultsOfPieces) {
  const std::size_t first = line_of(seam, "a 8"), second = line_of(seam, "a 8", 2), of_b = line_of(seam, "b 8");
  const std::string flat = "a 8\n1 0 0\n2 0 0\n1 2 0\n2 2 0\n1 0 0\n2 0 0\n1 2 0\n2 2 0\n";
  expect_found(
      seam, {
                {"1 0 0\n2 0 0\n1 2 0\n2 2 0\n1 0 2\n2 0 2\n1 2 2\n2 2 2\n", flat.substr(4), Outcome::refused, second,
                 "one plane"},
                {"0 0 0\n1 0 0\n0 2 0\n1 2 0\n0 0 2\n1 0 2\n0 2 2\n1 2 2\n",
                 "0 0 0\n1 1 1\n2 2 2\n1 1 1\n3 3 3\n1 1 1\n5 5 5\n7 7 7\n", Outcome::refused, first, "one plane"},
                {"1 0 0\n3 0 0\n1 2 0\n3 2 0\n1 0 2\n3 0 2\n1 2 2\n3 2 2\n",
                 "3 3 3\n3 3 3\n3 3 3\n3 3 3\n3 3 3\n3 3 3\n3 3 3\n3 3 3\n", Outcome::refused, of_b, "one plane"},
                {"a 8\n1 0 0\n", "a 9\n1 0 0\n1 0 0\n", Outcome::malformed, 79, "counts"},
                {"a 8\n1 0 0\n", "a 7\n", Outcome::malformed, 77, "counts"},
                {"a 8\n1 0 0\n", "b 8\n1 0 0\n", Outcome::malformed, second, "'a'"},
                {"pieces_a 2\n", "pieces_a 1\n", Outcome::malformed, second, "'pieces_b'"},
                {"pieces_a 2\n", "pieces_a 3\n", Outcome::malformed, 23, "'a'"},
                {"pieces_b 1\n", "radius_a 1\npieces_b 1\n", Outcome::malformed, 23, "'pieces_b'"},
                {"pieces_b 1\n", "b 8\n", Outcome::malformed, 23, "'pieces_b'"},
                {"a 8\n1 0 0\n", "a 8\n1 0\n", Outcome::malformed, second + 1, "a point"},
                {"a 8\n1 0 0\n", "a 8\n1 0 0/0\n", Outcome::malformed, second + 1, "zero"},
            });
}

TEST(CheckFormat3, BodiesWithoutPieces) {
  const auto reason = [](const std::string& a, const std::string& b, const std::string& counts) {
    return verdict_line(
        verify("fathom-certificate 3\n" + a + b +
               "claim touching\nseparations 0\nnearest 0 0\nweights_a 0\nweights_b 0\nend " + counts + " 0 0 0\n"),
        "x");
  };
  const std::string simplex = " 4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  EXPECT_EQ(reason("pieces_a 0\n", "pieces_b 1\nb" + simplex, "0 1 4"), "s REFUSED x:2: a body without pieces");
  EXPECT_EQ(reason("pieces_a 1\na" + simplex, "pieces_b 0\n", "1 4 0"), "s REFUSED x:8: a body without pieces");
  EXPECT_EQ(reason("pieces_a 1\na 0\n", "pieces_b 1\nb" + simplex, "1 0 1 4"),
            "s REFUSED x:3: the points of this piece lie in one plane");
  EXPECT_EQ(reason("pieces_a 1\na" + simplex, "pieces_b 1\nb" + simplex, "1 4 1 4"),
            "s REFUSED x:15: there is not one separation for each pair of pieces");
}

// Points that are repeated, or on a line at first, do not make a piece flat.
TEST(CheckFormat3, PiecesWithManyPoints) {
  const std::string more =
      edited(edited(touching, "a 8\n0 0 0\n", "a 11\n0 0 0\n0 0 0\n1/3 0 0\n1/2 1 0\n"), "end 2 8", "end 2 11");
  EXPECT_TRUE(verify(more).accepted()) << verify(more).reason;
}

TEST(CheckFormat3, FaultsOfOptima) {
  const std::size_t t = line_of(seam, "optimum"), claim = line_of(seam, "claim"), u = t + 2;
  expect_found(seam,
               {
                   {"claim depth 1\n", "claim depth 0\n", Outcome::refused, claim, "positive"},
                   {"claim depth 1\n", "claim depth -1\n", Outcome::refused, claim, "positive"},
                   {"claim depth 1\n", "claim depth 2\n", Outcome::refused, t, "not the depth"},
                   {"claim depth 1\n", "claim depth 1/2\n", Outcome::refused, t, "not the depth"},
                   {"optimum -1 0 0\n", "optimum 1 0 0\n", Outcome::refused, u, "does not separate"},
                   {"optimum -1 0 0\n", "optimum -1 0 1/1000\n", Outcome::refused, t, "not the depth"},
                   {"optimum -1 0 0\n", "optimum -3/5 0 4/5\n", Outcome::refused, u + 1, "does not separate"},
                   {"optimum -1 0 0\n", "optimum -1 0\n", Outcome::malformed, t, "'optimum'"},
                   {"optimum -1 0 0\n", "optimum -1 0 0 0\n", Outcome::malformed, t, "'optimum'"},
                   {"optimum -1 0 0\n", "optima -1 0 0\n", Outcome::malformed, t, "'optimum'"},
                   {"optimum -1 0 0\n", "-1 0 0\n", Outcome::malformed, t, "'optimum'"},
                   {"optima 1\n", "optima 0\n", Outcome::malformed, t, "'polytopes'"},
                   {"optima 1\n", "optima 2\n", Outcome::malformed, line_of(seam, "polytopes"), "'optimum'"},
                   {"separations 2\n-1 0 0\n", "separations 2\n0 0 0\n", Outcome::refused, u, "zero"},
                   {"separations 2\n-1 0 0\n", "separations 2\n1 0 0\n", Outcome::refused, u, "does not separate"},
                   {"separations 2\n-1 0 0\n-1 0 0\n", "separations 2\n-1 0 0\n-1 0 1\n", Outcome::refused, u + 1,
                    "does not separate"},
                   {"separations 2\n-1 0 0\n-1 0 0\n", "separations 2\n-9 1 0\n-7 0 0\n", Outcome::verified, 0, ""},
                   {"separations 2\n-1 0 0\n", "separations 2\n-1/1 0 0\n", Outcome::malformed, u, "three integers"},
                   {"separations 2\n-1 0 0\n", "separations 1\n", Outcome::malformed, 77, "counts"},
                   {"separations 2\n-1 0 0\n", "separations 3\n-1 0 0\n-1 0 0\n", Outcome::malformed, 79, "counts"},
                   {"separations 2\n", "separations 2 some\n", Outcome::malformed, t + 1, "'separations'"},
               });
  const auto reason = [](const std::string& text) { return verify(text).reason; };
  const std::string fewer =
      edited(edited(seam, "separations 2\n-1 0 0\n", "separations 1\n"), "1 8 1 2 2 8", "1 8 1 1 2 8");
  const std::string more =
      edited(edited(seam, "separations 2\n", "separations 3\n-1 0 0\n"), "1 8 1 2 2 8", "1 8 1 3 2 8");
  EXPECT_EQ(reason(fewer), "there is not one separation for each pair of pieces");
  EXPECT_EQ(reason(more), "there is not one separation for each pair of pieces");
  const std::string twice = "optimum -1 0 0\nseparations 2\n-1 0 0\n-1 0 0\n";
  const std::string two =
      edited(edited(edited(seam, twice, twice + twice), "optima 1", "optima 2"), "1 8 1 2 2 8", "1 8 2 2 2 2 8");
  EXPECT_EQ(reason(two), "an optimum must be above the one before it");
  const std::string none = edited(edited(edited(seam, twice, ""), "optima 1", "optima 0"), "1 8 1 2 2 8", "1 8 0 2 8");
  EXPECT_EQ(verdict_line(verify(none), "x"), "s REFUSED a%20cube%20in%20two%20pieces:34: there is no optimum");
}

TEST(CheckFormat3, FaultsOfPolytopes) {
  const std::size_t p = line_of(seam, "polytope 0 0"), second = line_of(seam, "polytope 1 0");
  expect_found(seam, {
                         {"polytope 0 0\n", "polytope 2 0\n", Outcome::refused, p, "a has no piece"},
                         {"polytope 0 0\n", "polytope 0 1\n", Outcome::refused, p, "b has no piece"},
                         {"polytope 0 0\n", "polytope 4294967296 0\n", Outcome::refused, p, "a has no piece"},
                         {"polytope 0 0\n", "polytope 0\n", Outcome::malformed, p, "'polytope'"},
                         {"polytope 0 0\n", "polytope 0 -1\n", Outcome::malformed, p, "indices"},
                         {"polytope 0 0\n", "polytopes 0 0\n", Outcome::malformed, p, "'polytope'"},
                         {"polytopes 2\n", "polytopes 1\n", Outcome::malformed, second, "'tree'"},
                         {"polytopes 2\n", "polytopes 3\n", Outcome::malformed, 74, "'polytope'"},
                         {"0 7\n1 6\n", "8 7\n1 6\n", Outcome::refused, p + 2, "b has no point"},
                         {"0 7\n1 6\n", "0 8\n1 6\n", Outcome::refused, p + 2, "a has no point"},
                         {"0 7\n1 6\n", "0 7\n0 7\n", Outcome::refused, p + 12, "one plane"},
                         {"4 0 4 6 2\n", "4 0 4 6 8\n", Outcome::refused, p + 11, "no vertex 8"},
                         {"4 0 4 6 2\n", "4 2 6 4 0\n", Outcome::refused, p + 11, "below"},
                         {"4 0 4 6 2\n", "2 0 4\n", Outcome::refused, p + 11, "three corners"},
                         {"4 0 4 6 2\n", "3 0 4 6\n", Outcome::refused, p + 11, "no facet lies across the edge 6 0"},
                         {"4 1 3 7 5\n", "4 1 3 7 4\n", Outcome::refused, p + 12, "one plane"},
                         {"4 1 3 7 5\n", "4 5 5 1 3\n", Outcome::refused, p + 12, "one way"},
                         {"4 0 4 6 2\n", "5 0 4 6 2\n", Outcome::malformed, p + 11, "corners"},
                         // Moved by its mean the polytope holds O, wherever it is: the first one
                         // has O on its boundary.
                         {"4 0 4 6 2\n", "4 4 6 2 0\n", Outcome::verified, 0, ""},
                     });
  EXPECT_EQ(verify(edited(seam, "4 0 4 6 2\n4 1", "4 0 4 6 3\n4 1")).outcome, Outcome::refused);
  const std::string open = edited(edited(seam, "facets 6\n4 0 4 6 2\n", "facets 5\n"), "8 6 8 6 3", "8 5 8 6 3");
  EXPECT_EQ(verify(open).reason.substr(0, 27), "no facet lies across the ed") << verify(open).reason;
}

/// The first polytope becomes this one.
std::string with_polytope(const std::string& vertices, const std::string& facets, const std::string& counts) {
  const std::size_t begin = seam.find("vertices 8\n"), end = seam.find("polytope 1 0\n");
  return edited(seam.substr(0, begin) + vertices + facets + seam.substr(end), "2 8 6 8 6 3", "2 " + counts + " 8 6 3");
}

TEST(CheckFormat3, PolytopesThatAreNone) {
  const auto reason = [](const std::string& vertices, const std::string& facets, const std::string& counts) {
    return verify(with_polytope(vertices, facets, counts)).reason;
  };
  EXPECT_EQ(reason("vertices 0\n", "facets 0\n", "0 0"), "there is no facet");
  EXPECT_EQ(reason("vertices 0\n", "facets 1\n3 0 1 2\n", "0 1"), "there is no vertex 0");
  EXPECT_EQ(reason("vertices 1\n0 7\n", "facets 1\n3 0 0 0\n", "1 1"), "O does not lie below this facet");
  // A tetrahedron at one corner of the box, from outside and from inside.
  const std::string tetrahedron = "vertices 4\n0 7\n1 7\n2 7\n4 7\n";
  EXPECT_EQ(reason(tetrahedron, "facets 4\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n", "4 4"),
            "a facet that is not done is not among the children");
  EXPECT_EQ(reason(tetrahedron, "facets 4\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n", "4 4"),
            "O does not lie below this facet");
  // Many vertices that no facet has draw the mean out of the polytope.
  std::string many = "vertices 104\n0 7\n1 7\n2 7\n4 7\n";
  for (int k = 0; k < 100; ++k) many += "7 0\n";
  EXPECT_EQ(reason(many, "facets 4\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n", "104 4"), "O does not lie below this facet");
}

TEST(CheckFormat3, FaultsOfTouchingUnions) {
  const std::size_t u = line_of(touching, "separations") + 1, nearest = line_of(touching, "nearest");
  expect_found(touching,
               {
                   {"separations 4\n-1 0 0\n-1 0 0\n-1 0 0\n", "separations 4\n-1 0 0\n-1 0 0\n0 0 0\n",
                    Outcome::refused, u + 2, "zero"},
                   {"separations 4\n-1 0 0\n-1 0 0\n-1 0 0\n", "separations 4\n-1 0 0\n-1 0 0\n-1 1 0\n",
                    Outcome::refused, u + 2, "does not separate"},
                   {"separations 4\n-1 0 0\n", "separations 4\n0 1 0\n", Outcome::refused, u, "does not separate"},
                   {"separations 4\n-1 0 0\n", "separations 4\n-1 -1 0\n", Outcome::refused, u, "does not separate"},
                   {"separations 4\n-1 0 0\n", "separations 4\n-9 -4 0\n", Outcome::verified, 0, ""},
                   {"nearest 1 0\n", "nearest 2 0\n", Outcome::refused, nearest, "a has no piece"},
                   {"nearest 1 0\n", "nearest 1 2\n", Outcome::refused, nearest, "b has no piece"},
                   {"nearest 1 0\n", "nearest 0 0\n", Outcome::refused, nearest + 4, "different points"},
                   {"nearest 1 0\n", "nearest 1 1\n", Outcome::refused, nearest + 4, "different points"},
                   {"nearest 1 0\n", "nearest 1\n", Outcome::malformed, nearest, "'nearest'"},
                   {"nearest 1 0\n", "nearby 1 0\n", Outcome::malformed, nearest, "'nearest'"},
                   {"1 1/2\n3 1/2\n", "1 1/2\n3 1/3\n", Outcome::refused, nearest + 1, "sum to 1"},
                   {"1 1/2\n3 1/2\n", "1 3/2\n3 -1/2\n", Outcome::refused, nearest + 3, "positive"},
                   {"1 1/2\n3 1/2\n", "1 1/2\n8 1/2\n", Outcome::refused, nearest + 3, "no point"},
                   {"1 1/2\n3 1/2\n", "1 1/3\n3 2/3\n", Outcome::refused, nearest + 4, "different points"},
                   {"claim touching\n", "claim apart 1\n", Outcome::refused, u + 2, "does not separate"},
                   {"claim touching\n", "claim apart 0\n", Outcome::refused, u - 2, "positive"},
                   {"claim touching\n", "claim depth 1\n", Outcome::malformed, u - 1, "'optima'"},
               });
  // Only the piece that is named has the points: the weights' indices are its own.
  const std::string other =
      edited(touching, "nearest 1 0\nweights_a 2\n1 1/2\n3 1/2\n", "nearest 1 0\nweights_a 2\n9 1/2\n11 1/2\n");
  EXPECT_EQ(verify(other).reason, "there is no point of this number");
}

TEST(CheckFormat3, FaultsOfUnionsThatAreApart) {
  const std::size_t u = line_of(apart, "separations") + 1, nearest = line_of(apart, "nearest");
  expect_found(apart,
               {
                   {"apart 25\n", "apart 24\n", Outcome::refused, nearest + 3, "too far"},
                   {"apart 25\n", "apart 251/10\n", Outcome::refused, u + 2, "nearer"},
                   {"apart 25\n", "apart -25\n", Outcome::refused, u - 2, "positive"},
                   {"apart 25\n", "apart 0\n", Outcome::refused, u - 2, "positive"},
                   {"apart 25\n", "apart\n", Outcome::malformed, u - 2, "'claim apart Q'"},
                   {"apart 25\n", "disjoint\n", Outcome::malformed, u - 2, "'claim apart Q'"},
                   {"apart 25\n", "signed_bounds 1 2\n", Outcome::malformed, u - 2, "'claim apart Q'"},
                   {"claim apart 25\n", "claim touching\n", Outcome::refused, nearest + 3, "different points"},
                   {"separations 4\n-3 -4 0\n", "separations 4\n3 4 0\n", Outcome::refused, u, "does not separate"},
                   {"separations 4\n-3 -4 0\n", "separations 4\n0 0 0\n", Outcome::refused, u, "zero"},
                   {"separations 4\n-3 -4 0\n", "separations 4\n0 -1 0\n", Outcome::refused, u, "nearer"},
                   {"separations 4\n-3 -4 0\n-1 0 0\n-3 -4 0\n-1 0 0\n",
                    "separations 4\n-3 -4 0\n-3 -4 0\n-1 0 0\n-1 0 0\n", Outcome::refused, u + 2, "nearer"},
                   {"nearest 1 0\n", "nearest 0 0\n", Outcome::refused, nearest + 3, "too far"},
                   {"weights_b 1\n0 1\n", "weights_b 1\n4 1\n", Outcome::refused, nearest + 3, "too far"},
                   {"weights_b 1\n0 1\n", "weights_b 1\n0 2\n", Outcome::refused, nearest + 3, "sum to 1"},
               });
  const std::string fewer =
      edited(edited(apart, "separations 4\n-3 -4 0\n", "separations 3\n"), "8 8 4 1 1", "8 8 3 1 1");
  EXPECT_EQ(verify(fewer).reason, "there is not one separation for each pair of pieces");
}

TEST(CheckFormat3, Grammar) {
  EXPECT_EQ(verify(edited(seam, "certificate 3", "certificate 2")).line, 4U) << "pieces are of format 3 alone";
  EXPECT_EQ(verify(edited(seam, "certificate 3", "certificate 03")).line, 2U);
  EXPECT_EQ(verify(edited(seam, "tree 3\n", "# a comment\ntree 3\n")).outcome, Outcome::verified);
  EXPECT_EQ(verify(edited(seam, "tree 3\n", "\ntree 3\n")).line, 74U);
  EXPECT_EQ(verify(edited(seam, "end 2", "end 02")).outcome, Outcome::verified);
  for (const char* end :
       {"end 2 8 8 1 8 1 2 2 8 6 8 6\n", "end 2 8 8 1 8 1 2 2 8 6 8 6 3 0\n", "end 2 8 8 1 8 1 2 2 8 6 8 6 4\n",
        "end 2 8 8 1 8 1 2 3 8 6 8 6 3\n", "END 2 8 8 1 8 1 2 2 8 6 8 6 3\n"})
    EXPECT_EQ(verify(edited(seam, "end 2 8 8 1 8 1 2 2 8 6 8 6 3\n", end)).line, 78U) << end;
}

TEST(CheckFormat3, EveryTruncationIsMalformed) {
  for (const std::string& text : {seam, touching, apart})
    for (std::size_t length = 0; length < text.size(); ++length)
      EXPECT_EQ(verify(std::string_view(text).substr(0, length)).outcome, Outcome::malformed) << "cut to " << length;
}

}  // namespace
}  // namespace fathom_check
