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

}  // namespace
}  // namespace fathom_check
