// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate checker as a library: what it accepts, and that each single fault is found where
// it is.
#include "verify/check/check.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/check/edits.hpp"

namespace fathom_check {
namespace {

TEST(Check, AcceptsEveryHandWrittenCertificate) {
  std::size_t count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(FATHOM_TEST_DATA) / "certificates")) {
    if (entry.path().extension() != ".cert" || entry.path().stem() == "two_in_one_file") continue;
    const Verdict verdict = verify(read(entry.path()));
    EXPECT_TRUE(verdict.accepted()) << verdict_line(verdict, entry.path().string());
    ++count;
  }
  EXPECT_GE(count, 8U);
}

TEST(Check, RefusesEveryHandWrittenForgery) {
  const auto reason = [](const char* name) {
    const Verdict verdict = verify(data(std::string("refused/") + name + ".cert"));
    EXPECT_EQ(verdict.outcome, Outcome::refused) << name;
    return verdict.reason;
  };
  EXPECT_EQ(reason("dented_cube"), "not convex across the edge 4 8");
  EXPECT_EQ(reason("split_facet"), "not convex across the edge 6 0");
  EXPECT_EQ(reason("zero_direction"), "a direction that is zero proves nothing");
  EXPECT_EQ(reason("open_box"), "no facet lies across the edge 4 6");
  EXPECT_EQ(reason("too_deep"), "the boundary of P is nearer in this direction than claimed");
  EXPECT_EQ(reason("inside_out"), "O does not lie below this facet");
}

TEST(Check, SaysWhatIsProved) {
  const auto line = [](const char* name) { return verdict_line(verify(data(name)), "file name"); };
  EXPECT_EQ(line("depth_cubes.cert"), "s VERIFIED penetrating depth_squared=1 optima=1 two%20cubes");
  EXPECT_EQ(line("point_tetrahedron.cert"),
            "s VERIFIED penetrating depth_squared=1/12 optima=4 a%20point%20in%20a%20tetrahedron");
  EXPECT_EQ(line("one_direction.cert"), "s VERIFIED penetrating depth_squared=1/12 one%20of%20four%20directions");
  EXPECT_EQ(line("bounds_cubes.cert"), "s VERIFIED penetrating depth_squared_in=[1/2,16/5] bounds%20of%20cubes");
  EXPECT_EQ(line("penetrating_cubes.cert"), "s VERIFIED penetrating depth_squared_in=[0,1] file%20name");
  EXPECT_EQ(line("touching_cubes.cert"), "s VERIFIED touching depth_squared=0 touching%20cubes");
  EXPECT_EQ(line("disjoint_cubes.cert"), "s VERIFIED disjoint depth_squared=0 disjoint%20cubes");
}

TEST(Check, VerdictStartsFromNo) {
  EXPECT_FALSE(Verdict().accepted());
  EXPECT_EQ(verify("").outcome, Outcome::malformed);
  EXPECT_EQ(verify("# nothing but a comment\n").outcome, Outcome::malformed);
}

TEST(Check, NamesAreEscapedInTheLine) {
  EXPECT_EQ(
      verdict_line(verify(""), "a\nb% c"),
      "s MALFORMED a%0Ab%25%20c:1: expected 'fathom-certificate' and a format: 1, 2 or 3, found the end of the input");
}

TEST(Check, OneTextHoldsOneCertificate) {
  const Verdict two = verify(data("two_in_one_file.cert"));
  EXPECT_EQ(two.outcome, Outcome::malformed);
  EXPECT_EQ(verify(data("depth_cubes.cert") + "# the end\n").outcome, Outcome::verified);
  EXPECT_EQ(verify(data("depth_cubes.cert") + "\n").outcome, Outcome::malformed);
}

TEST(Check, FaultsOfADepth) {
  expect_found(data("depth_cubes.cert"),
               {
                   {"claim depth 1\n", "claim depth 0\n", Outcome::refused, 21, "positive"},
                   {"claim depth 1\n", "claim depth -1\n", Outcome::refused, 21, "positive"},
                   {"claim depth 1\n", "claim depth 1/2\n", Outcome::refused, 23, "farther"},
                   {"claim depth 1\n", "claim depth 1000001/1000000\n", Outcome::refused, 23, "nearer"},
                   {"-1 0 0\n", "0 0 0\n", Outcome::refused, 23, "zero"},
                   {"-1 0 0\n", "-2 0 0\n", Outcome::refused, 23, "primitive"},
                   {"-1 0 0\n", "1 0 0\n", Outcome::refused, 23, "farther"},
                   {"1 all\n-1 0 0\n", "0 all\n", Outcome::malformed, 39, "counts"},
                   {"1 all\n-1 0 0\n", "2 all\n-1 0 0\n-1 0 0\n", Outcome::malformed, 41, "counts"},
                   {"0 7\n", "0 8\n", Outcome::refused, 25, "a has no point"},
                   {"0 7\n", "8 7\n", Outcome::refused, 25, "b has no point"},
                   {"0 7\n", "99999999999999999999 7\n", Outcome::refused, 25, "b has no point"},
                   {"4 0 4 6 2\n", "4 0 4 6 8\n", Outcome::refused, 34, "no vertex 8"},
                   {"4 0 4 6 2\n", "4 2 6 4 0\n", Outcome::refused, 34, "below"},
                   {"4 0 4 6 2\n", "2 0 4\n", Outcome::refused, 34, "three corners"},
                   {"4 0 4 6 2\n", "3 0 4 6\n", Outcome::refused, 34, "no facet lies across the edge 6 0"},
                   {"4 0 4 6 2\n", "4 0 4 6 3\n", Outcome::refused, 34, "nearer"},
                   {"4 0 4 6 2\n", "5 0 4 6 2\n", Outcome::malformed, 34, "corners"},
                   {"4 1 3 7 5\n", "4 1 3 7 4\n", Outcome::refused, 35, "one plane"},
                   {"4 1 3 7 5\n", "4 1 7 3 5\n", Outcome::refused, 35, "below"},
                   {"4 1 3 7 5\n", "4 5 5 1 3\n", Outcome::refused, 35, "one way"},
               });
}

TEST(Check, EmptyParts) {
  const std::string text = data("depth_cubes.cert");
  const Verdict verdict = verify(edited(edited(text, "1 all\n-1 0 0\n", "0 all\n"), "end 8 8 1", "end 8 8 0"));
  EXPECT_EQ(verdict.outcome, Outcome::refused) << verdict_line(verdict, "x");
  const std::string rest = "claim disjoint\ndirections 1 some\n0 0 1\nend ";
  EXPECT_EQ(verify("fathom-certificate 1\na 0\nb 1\n0 0 0\n" + rest + "0 1 1 0 0\n").outcome, Outcome::refused);
  EXPECT_EQ(verify("fathom-certificate 1\na 1\n0 0 0\nb 0\n" + rest + "1 0 1 0 0\n").outcome, Outcome::refused);
}

// h(n)^2 = q <n,n> alone is not enough: h(n) = -1 here.
TEST(Check, SignOfTheSupportFunction) {
  const std::string apart = data("disjoint_cubes.cert"), deep = data("depth_cubes.cert");
  const Verdict verdict = verify(apart.substr(0, apart.find("claim")) + deep.substr(deep.find("claim")));
  EXPECT_EQ(verdict_line(verdict, "x"),
            "s REFUSED disjoint%20cubes:23: O does not lie below the plane of this direction");
}

TEST(Check, OneDirectionUnlessADepth) {
  const std::string touching = data("touching_cubes.cert");
  const Verdict verdict =
      verify(edited(edited(touching, "1 some\n-1 0 0\n", "2 some\n-1 0 0\n-2 0 0\n"), "end 8 8 1", "end 8 8 2"));
  EXPECT_EQ(verdict.reason, "this claim takes exactly one direction");
}

TEST(Check, DenominatorsNeedNotAgree) {
  EXPECT_TRUE(verify(edited(data("point_tetrahedron.cert"), "1/2 1/2 1/2\n", "3/6 4/8 500/1000\n")).accepted());
}

TEST(Check, FaultsOfTheOtherClaims) {
  expect_found(data("touching_cubes.cert"),
               {
                   {"-1 0 0\n", "0 0 0\n", Outcome::refused, 23, "zero"},
                   {"-1 0 0\n", "-1 1 0\n", Outcome::refused, 23, "plane"},
                   {"1 some\n", "1 all\n", Outcome::refused, 22, "all"},
                   {"1 1/2\n3 1/2\n", "1 1/2\n3 1/3\n", Outcome::refused, 25, "sum to 1"},
                   {"1 1/2\n3 1/2\n", "1 3/2\n3 -1/2\n", Outcome::refused, 27, "positive"},
                   {"1 1/2\n3 1/2\n", "1 1\n3 0\n", Outcome::refused, 27, "positive"},
                   {"1 1/2\n3 1/2\n", "1 1/3\n3 2/3\n", Outcome::refused, 28, "different points"},
                   {"1 1/2\n3 1/2\n", "1 1/2\n8 1/2\n", Outcome::refused, 27, "no point"},
                   {"claim touching", "claim disjoint", Outcome::malformed, 25, "'end'"},
                   {"b 8\n2 0 0\n4 0 0\n2 2 0\n4 2 0\n2 0 2\n4 0 2\n2 2 2\n4 2 2\n",
                    "b 8\n3 0 0\n4 0 0\n3 2 0\n4 2 0\n3 0 2\n4 0 2\n3 2 2\n4 2 2\n", Outcome::refused, 23, "plane"},
               });
  expect_found(data("disjoint_cubes.cert"), {
                                                {"-1 0 0\n", "0 0 0\n", Outcome::refused, 23, "zero"},
                                                {"-1 0 0\n", "0 1 0\n", Outcome::refused, 23, "separate"},
                                                {"b 8\n3 0 0\n", "b 8\n2 0 0\n", Outcome::refused, 23, "separate"},
                                            });
  expect_found(data("bounds_cubes.cert"), {
                                              {"1/2 16/5", "16/5 1/2", Outcome::refused, 21, "above"},
                                              {"1/2 16/5", "-1/2 16/5", Outcome::refused, 21, "negative"},
                                              {"1/2 16/5", "0 0", Outcome::refused, 21, "not positive"},
                                              {"1/2 16/5", "1/2 3", Outcome::refused, 23, "farther"},
                                              {"1/2 16/5", "2 16/5", Outcome::refused, 34, "nearer"},
                                          });
}

TEST(Check, CompletenessOfOptima) {
  const std::string text = data("flat_segment.cert");
  expect_found(text,
               {
                   {"5 all\n0 -1 0\n0 0 -1\n", "5 all\n0 0 -1\n0 -1 0\n", Outcome::refused, 18, "above the one before"},
                   {"5 all\n0 -1 0\n0 0 -1\n", "5 all\n0 -1 0\n0 -1 0\n", Outcome::refused, 18, "above the one before"},
               });
  const std::string four = edited(edited(text, "5 all\n0 -1 0\n", "4 all\n"), "end 2 8 5", "end 2 8 4");
  const Verdict verdict = verify(four);
  EXPECT_EQ(verdict.outcome, Outcome::refused);
  EXPECT_NE(verdict.reason.find("not among all directions"), std::string::npos) << verdict.reason;
  EXPECT_TRUE(verify(edited(four, "4 all", "4 some")).accepted()) << "some need not be all";
}

// No topology is asked for: the argument does not need it.
TEST(Check, RepeatedAndRotatedFacetsDoNoHarm) {
  const std::string text = data("depth_cubes.cert");
  EXPECT_TRUE(verify(edited(text, "4 0 4 6 2\n", "4 4 6 2 0\n")).accepted());
  EXPECT_TRUE(verify(edited(edited(text, "facets 6\n", "facets 7\n4 4 6 2 0\n"), "1 8 6\n", "1 8 7\n")).accepted());
}

// Half of the surface: every facet is right, the solid is open.
TEST(Check, AnOpenSurfaceIsRefused) {
  const std::string text = data("depth_cubes.cert");
  EXPECT_EQ(verify(edited(edited(text, "facets 6\n4 0 4 6 2\n", "facets 5\n"), "1 8 6\n", "1 8 5\n")).outcome,
            Outcome::refused);
  EXPECT_EQ(verify(text.substr(0, text.find("facets")) + "facets 0\nend 8 8 1 8 0\n").outcome, Outcome::refused);
}

TEST(Check, Grammar) {
  const auto malformed_at = [](std::size_t line) {
    return [line](const Verdict& v) { return v.outcome == Outcome::malformed && v.line == line; };
  };
  const std::string text = data("disjoint_cubes.cert");
  const std::vector<std::pair<std::string, std::string>> edits = {
      {"0 0 0\n", "0 0 0 \n"},   {"0 0 0\n", " 0 0 0\n"},   {"0 0 0\n", "0  0 0\n"},  {"0 0 0\n", "0 0\n"},
      {"0 0 0\n", "0 0 0\r\n"},  {"0 0 0\n", "+0 0 0\n"},   {"0 0 0\n", "0 0 1/0\n"}, {"0 0 0\n", "0 0 1/\n"},
      {"0 0 0\n", "0 0 1/-2\n"}, {"0 0 0\n", "0 0 1.5\n"},  {"0 0 0\n", "0 0 1e5\n"}, {"0 0 0\n", "0 0 --1\n"},
      {"0 0 0\n", "0 0 -\n"},    {"0 0 0\n", "0 0 0x1\n"},  {"0 0 0\n", "\n0 0 0\n"}, {"0 0 0\n", "0\t0\t0\n"},
      {"0 0 0\n", "0 0 /2\n"},   {"0 0 0\n", "0 0 1/2/3\n"}};
  for (const auto& [from, to] : edits) EXPECT_TRUE(malformed_at(4)(verify(edited(text, from, to)))) << to;
  EXPECT_TRUE(verify(edited(text, "0 0 0\n", "-0 000 0/007\n")).accepted());
  EXPECT_TRUE(verify(edited(text, "0 0 0\n", "# any \xff bytes\n0 0 0\n")).accepted());
  for (const char* id : {"id\n", "id \n", "id a%\n", "id a%4\n", "id a%4g\n", "id \xc3\xa9\n", "id a\tb\n", "id a b\n",
                         "id optima=1 x\n"})
    EXPECT_TRUE(malformed_at(2)(verify(edited(text, "id disjoint%20cubes\n", id)))) << id;
  EXPECT_EQ(verify(edited(text, "id disjoint%20cubes\n", "id a%20b%c3%A9\n")).id, "a%20b%c3%A9");
  EXPECT_TRUE(malformed_at(1)(verify(edited(text, "certificate 1", "certificate 4"))));
  EXPECT_TRUE(malformed_at(3)(verify(edited(text, "certificate 1", "certificate 3"))));
  EXPECT_TRUE(malformed_at(21)(verify(edited(text, "certificate 1", "certificate 2"))));
  for (const char* word : {"any", "SOME", "", "some some"})
    EXPECT_TRUE(malformed_at(22)(verify(edited(text, "directions 1 some", std::string("directions 1 ") + word))))
        << word;
  EXPECT_TRUE(malformed_at(1)(verify("\xef\xbb\xbf" + text)));
}

// The line which is missing, or the one that is cut off.
TEST(Check, TheLineWhereTheInputEnds) {
  const std::string start = "fathom-certificate 1\n# a comment\na 1\n";
  EXPECT_EQ(verify(start).line, 4U);
  EXPECT_EQ(verify(start + "0 0 0").line, 4U);
  EXPECT_EQ(verify(start + "# another\n").line, 5U);
  EXPECT_EQ(verify("").line, 1U);
  EXPECT_EQ(verify("# a comment\n").line, 2U);
}

TEST(Check, EveryTruncationIsMalformed) {
  for (const char* name : {"depth_cubes.cert", "touching_cubes.cert", "disjoint_cubes.cert", "bounds_cubes.cert"}) {
    const std::string text = data(name);
    for (std::size_t length = 0; length < text.size(); ++length)
      EXPECT_EQ(verify(std::string_view(text).substr(0, length)).outcome, Outcome::malformed)
          << name << " cut to " << length;
  }
}

}  // namespace
}  // namespace fathom_check
