// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate checker as a library, format 2: what it accepts, and that each single fault is
// found where it is.

#include <gtest/gtest.h>

#include <string>

#include "tests/check/edits.hpp"
#include "verify/check/check.hpp"

namespace fathom_check {
namespace {

std::string second(const std::string& name) { return data("format_2/" + name + ".cert"); }

TEST(CheckFormat2, SaysWhatIsProved) {
  const auto line = [](const char* name) { return verdict_line(verify(second(name)), "x"); };
  EXPECT_EQ(line("cylinder_on_floor"), "s VERIFIED touching signed_depth_in=[0,0] can%20on%20the%20floor");
  EXPECT_EQ(line("sphere_capsule"), "s VERIFIED touching signed_depth=-sqrt(25)+5 sphere%20and%20capsule");
  EXPECT_EQ(line("crossing_capsules"), "s VERIFIED penetrating signed_depth=sqrt(0)+3/4 cone=1+0 crossing%20capsules");
  EXPECT_EQ(line("corner_on_corner"), "s VERIFIED penetrating signed_depth=sqrt(0)+1 cone=0+4 tip%20to%20tip");
  EXPECT_EQ(line("rounded_cubes"), "s VERIFIED penetrating signed_depth=sqrt(1)+3/10 optima=1 rounded%20cubes");
  EXPECT_EQ(line("balls"), "s VERIFIED penetrating signed_depth_in=[2,3] balls");
  EXPECT_EQ(line("cone_and_box"), "s VERIFIED disjoint signed_depth_in=[-1/2,-1/2] x");
}

TEST(CheckFormat2, StatusFlipsExactlyAtEquality) {
  const auto status = [](const std::string& name, const char* from, const char* to) {
    const Verdict verdict = verify(edited(second(name), from, to));
    return verdict.accepted() ? verdict.status : verdict.reason;
  };
  EXPECT_EQ(status("sphere_capsule", "radius_b 3", "radius_b 300000000000000000001/100000000000000000000"),
            "penetrating");
  EXPECT_EQ(status("sphere_capsule", "radius_b 3", "radius_b 299999999999999999999/100000000000000000000"), "disjoint");
  EXPECT_EQ(status("sphere_capsule", "radius_a 2\n", ""), "disjoint");
  EXPECT_EQ(status("crossing_capsules", "radius_a 1/2\n", ""), "penetrating");
  EXPECT_EQ(status("crossing_capsules", "radius_a 1/2\n", "radius_a -1/2\n"), "a radius is negative");
  EXPECT_EQ(status("cylinder_on_floor", "signed_bounds 0 0", "signed_bounds -1 0"), "undecided");
  EXPECT_EQ(status("cylinder_on_floor", "signed_bounds 0 0", "signed_bounds 0 1/9"), "undecided");
}

TEST(CheckFormat2, FaultsOfShapes) {
  expect_found(second("balls"),
               {
                   {"heights_a 1\n3\n", "heights_a 1\n2999999999/1000000000\n", Outcome::refused, 15, "too small"},
                   {"heights_a 1\n3\n", "heights_a 1\n-3\n", Outcome::refused, 15, "too small"},
                   {"heights_b 1\n3\n", "heights_b 1\n3000000001/1000000000\n", Outcome::refused, 13, "farther"},
                   {"2 -2 1\n", "0 0 0\n", Outcome::refused, 13, "zero"},
                   {"0 1 0 0\n", "0 1 0 1/1000000\n", Outcome::refused, 19, "unit ball"},
                   {"0 1 0 0\n", "1 1 0 0\n", Outcome::refused, 19, "no atom"},
                   {"0 1 0 0\n", "0 1 0\n", Outcome::malformed, 19, "inner point"},
                   {"0 1 0 0\n", "0 9/10 0 0\n", Outcome::verified, 0, ""},
                   {"radius_a 1\n", "", Outcome::refused, 39, "nearer"},
                   {"bounds 2 3", "bounds 2 1", Outcome::refused, 11, "above"},
                   {"bounds 2 3", "bounds 9/4 3", Outcome::refused, 40, "nearer"},
                   {"bounds 2 3", "bounds -2 3", Outcome::verified, 0, ""},
                   {"bounds 2 3", "bounds 2 299999/100000", Outcome::refused, 13, "farther"},
                   {"claim signed_bounds 2 3", "claim depth 4", Outcome::malformed, 11, "signed_bounds"},
                   {"ball 0 0 0 1", "disc 0 0 0 1", Outcome::malformed, 6, "atom"},
                   {"ball 0 0 0 1 0 0 0 1 0 0 0 1", "ball 0 0 0 1 0 0 0 1 0 0 0 0", Outcome::refused, 40, "nearer"},
                   {"heights_a 1\n3\n", "heights_a 2\n3\n3\n", Outcome::malformed, 49, "counts"},
               });
  const std::string two =
      edited(edited(second("balls"), "heights_a 1\n3\n", "heights_a 2\n3\n0\n"), "end 1 1 1 1 1 1", "end 1 1 1 1 1 2");
  EXPECT_EQ(verify(two).reason, "there is not one height for each term");
}

TEST(CheckFormat2, FaultsOfDistances) {
  expect_found(second("sphere_capsule"),
               {
                   {"apart 25", "apart 24", Outcome::refused, 13, "nearer"},
                   {"apart 25", "apart 26", Outcome::refused, 13, "farther"},
                   {"apart 25", "apart -25", Outcome::refused, 11, "positive"},
                   {"-1 0 0\n", "1 0 0\n", Outcome::refused, 13, "separate"},
                   {"0 1/2\n1 1/2", "0 1/3\n1 2/3", Outcome::refused, 16, "too far"},
                   {"0 1/2\n1 1/2", "0 1/2\n1 1/3", Outcome::refused, 16, "sum to 1"},
                   {"claim apart 25", "claim touching", Outcome::refused, 13, "plane"},
                   {"claim apart 25", "claim disjoint", Outcome::malformed, 11, "'claim apart Q'"},
                   {"claim apart 25", "claim signed_bounds 0 0", Outcome::verified, 0, ""},
                   {"claim apart 25", "claim signed_bounds 1/99 1", Outcome::refused, 16, "too far"},
                   {"claim apart 25", "claim signed_bounds -1 -1/99", Outcome::refused, 13, "farther"},
               });
  expect_found(second("cylinder_on_floor"),
               {
                   {"heights_a 1\n0\n", "heights_a 1\n-1/1000\n", Outcome::refused, 13, "too small"},
                   {"heights_a 1\n0\n", "heights_a 1\n1/1000\n", Outcome::refused, 11, "farther"},
                   {"0 1 0 0\n", "1 1 0 0\n", Outcome::refused, 11, "nearer"},
                   {"halfspace_b 0 0 1 0", "halfspace_b 0 0 0 0", Outcome::refused, 8, "normal"},
                   {"halfspace_b 0 0 1 0", "halfspace_b 0 0 -1 0", Outcome::refused, 11, "not that of"},
                   {"halfspace_b 0 0 1 0", "halfspace_b 0 1/9 1 0", Outcome::refused, 11, "not that of"},
                   {"halfspace_b 0 0 1 0", "halfspace_b 0 0 7/3 0/5", Outcome::verified, 0, ""},
                   {"halfspace_b 0 0 1 0", "halfspace_b 0 0 1 1/999", Outcome::refused, 11, "farther"},
                   {"0 0 1\nheights", "0 0 5\nheights", Outcome::verified, 0, ""},
                   {"1 some", "1 all", Outcome::refused, 10, "all"},
               });
}

TEST(CheckFormat2, HalfSpaces) {
  const auto line = [](const std::string& claim, const std::string& which = "some") {
    return verdict_line(verify("fathom-certificate 2\nhalfspace_a 0 0 -2/3 -2\nb 2\n0 0 5\n1 0 2\nradius_b 1\nclaim " +
                               claim + "\ndirections 1 " + which + "\n0 0 1\nend 2 1\n"),
                        "x");
  };
  EXPECT_EQ(line("depth 4"), "s VERIFIED penetrating signed_depth=sqrt(4)+1 x");
  EXPECT_EQ(line("depth 3"), "s REFUSED x:9: the boundary of P is farther in this direction than claimed");
  EXPECT_EQ(line("depth 4", "all").substr(0, 13), "s REFUSED x:8");
  EXPECT_EQ(line("signed_bounds 3 3"), "s VERIFIED penetrating signed_depth_in=[3,3] x");
  EXPECT_EQ(line("signed_bounds 31/10 4").substr(0, 13), "s REFUSED x:9");
  const std::string two =
      "fathom-certificate 2\nhalfspace_a 0 0 -1 0\nhalfspace_b 0 0 1 0\nclaim touching\ndirections 1 some\n0 0 1\nend "
      "1\n";
  EXPECT_EQ(verify(two).reason, "two half-spaces");
}

TEST(CheckFormat2, TheConeIsNeitherTooLargeNorTooSmall) {
  expect_found(second("corner_on_corner"),
               {
                   {"rays 4\n-1 -1 -1\n-1 1 -1\n1 -1 -1\n1 1 -1\n", "rays 4\n-1 -1 -1\n-1 1 -1\n1 1 -1\n1 -1 -1\n",
                    Outcome::refused, 25, "above"},
                   {"1 1 -1\nd", "2 2 -2\nd", Outcome::refused, 25, "primitive"},
                   {"1 1 -1\nd", "3 3 -2\nd", Outcome::refused, 25, "does not belong"},
                   {"differences 4\n1 0\n", "differences 4\n2 0\n", Outcome::refused, 24, "two sides"},
                   {"differences 4\n1 0\n", "differences 4\n0 0\n", Outcome::refused, 27, "exactly two"},
                   {"differences 4\n1 0\n", "differences 4\n1 1\n", Outcome::refused, 27, "no point"},
                   {"lineality 0\n", "lineality 0\nid x\n", Outcome::malformed, 21, "'rays'"},
               });
  const std::string text = second("corner_on_corner");
  const std::string more =
      edited(edited(text, "rays 4\n-1 -1 -1\n", "rays 5\n-1 -1 -1\n-1 0 -1\n"), "0 4 4\n", "0 5 4\n");
  EXPECT_EQ(verify(more).outcome, Outcome::refused);
  const std::string fewer = edited(edited(text, "rays 4\n-1 -1 -1\n", "rays 3\n"), "0 4 4\n", "0 3 4\n");
  EXPECT_EQ(verify(fewer).outcome, Outcome::refused);
  const std::string none = text.substr(0, text.find("lineality")) + "end 1 5 1 1 1\n";
  EXPECT_EQ(verdict_line(verify(none), "x"), "s VERIFIED penetrating signed_depth=sqrt(0)+1 tip%20to%20tip");

  expect_found(second("crossing_capsules"),
               {
                   {"lineality 1\n0 0 1\n", "lineality 1\n0 0 -7\n", Outcome::verified, 0, ""},
                   {"lineality 1\n0 0 1\n", "lineality 1\n0 1 1\n", Outcome::refused, 22, "does not belong"},
                   {"lineality 1\n0 0 1\n", "lineality 1\n0 0 0\n", Outcome::refused, 21, "independent"},
                   {"lineality 1\n0 0 1\nrays 0\n", "lineality 0\nrays 1\n0 0 1\n", Outcome::malformed, 29, "counts"},
                   {"0 0\n0 1\n1 1\n1 0\n", "0 0\n0 0\n1 1\n1 0\n", Outcome::refused, 24, "wider"},
               });
  const std::string half =
      edited(edited(second("crossing_capsules"), "lineality 1\n0 0 1\nrays 0\n", "lineality 0\nrays 1\n0 0 1\n"),
             "1 0 4\n", "0 1 4\n");
  EXPECT_EQ(verify(half).reason, "the cone may go on behind ray 0");
}

TEST(CheckFormat2, EveryTruncationIsMalformed) {
  for (const char* name : {"cylinder_on_floor", "sphere_capsule", "crossing_capsules", "cone_and_box", "balls"}) {
    const std::string text = second(name);
    for (std::size_t length = 0; length < text.size(); ++length)
      EXPECT_EQ(verify(std::string_view(text).substr(0, length)).outcome, Outcome::malformed)
          << name << " cut to " << length;
  }
}

TEST(CheckFormat2, RefusesBodiesThatAreNone) {
  const auto reason = [](const std::string& body, const std::string& counts) {
    return verify("fathom-certificate 2\n" + body +
                  "\nhalfspace_b 0 0 1 0\nclaim signed_bounds 0 0\ndirections 1 some\n0 0 1\nheights_a 0\n" +
                  "inner_a 0\nend " + counts + " 1 0 0\n")
        .reason;
  };
  EXPECT_EQ(reason("shape_a 0", "0"), "a shape without terms");
  EXPECT_EQ(reason("shape_a 1\nterm 0", "1 0"), "a term without atoms");
  EXPECT_EQ(reason("shape_a 1\nterm 1\npoint 0 0 0", "1 1"), "there is no inner point");
}

// The certificate checker as a library, format 3: what it accepts, and that each single fault is
// found where it is.

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
