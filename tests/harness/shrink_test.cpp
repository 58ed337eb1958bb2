// SPDX-License-Identifier: GPL-3.0-or-later

#include "verify/harness/shrink/shrink.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "fathom/answer.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "fathom/plane.hpp"
#include "reference/answer/plane.hpp"
#include "reference/files/cases.hpp"
#include "tests/harness/fake_subject.hpp"
#include "tests/harness/snippet_cases.hpp"
#include "verify/check/check.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/variants.hpp"
#include "verify/judge/truth.hpp"

namespace fathom::harness {
namespace {

using namespace fathom::testing;

std::size_t above(const Body& body) {
  return static_cast<std::size_t>(std::ranges::count_if(body.points, [](const Point& p) { return p.z > 0; }));
}

/// Twice the depth, whenever A has more than five points above z = 0.
const Examine doubled = judged([](const Case& pair, Reply& reply) {
  if (reply.overlap && above(pair.a) > 5) reply.depth = 2 * *reply.depth;
});

bool accepted(const std::string& certificate) { return fathom_check::verify(certificate).accepted(); }

TEST(Shrink, LeavesWhatTheFailureNeedsAndNothingElse) {
  const Case pair = family_case("random_ball", 30, 2);
  const Verdict verdict = doubled(pair).verdict;
  ASSERT_TRUE(fails(verdict));
  const Shrunk shrunk = shrink(pair, verdict, doubled);
  EXPECT_TRUE(shrunk.reproduced);
  EXPECT_EQ(shrunk.outcome.verdict, verdict);
  EXPECT_EQ(shrunk.pair.a.points.size(), 6u);
  EXPECT_EQ(above(shrunk.pair.a), 6u);
  EXPECT_EQ(shrunk.pair.b.points.size(), 4u);
  for_each_coordinate(shrunk.pair, [](const mpq_class& value) {
    EXPECT_EQ(value.get_den(), 1);
    EXPECT_LE(abs(value), 4);
  });
  EXPECT_TRUE(accepted(shrunk.certificate));
  EXPECT_LT(shrunk.tried, 2000u);
}

TEST(Shrink, NoPointOfTheResultCanBeDropped) {
  const Case pair = family_case("random_sphere", 25, 5);
  const Verdict verdict = doubled(pair).verdict;
  ASSERT_TRUE(fails(verdict));
  ShrinkSettings settings;
  settings.keep_solid = false;
  const Case smallest = shrink(pair, verdict, doubled, {}, {}, settings).pair;
  for (Body Case::*body : {&Case::a, &Case::b})
    for (std::size_t i = 0; (smallest.*body).points.size() > 1 && i < (smallest.*body).points.size(); ++i) {
      Case less = smallest;
      std::vector<Point>& points = (less.*body).points.edit();
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
      EXPECT_NE(doubled(less).verdict, verdict) << i;
    }
}

TEST(Shrink, EachStepIsSmallerCertifiedAndOfThePrecision) {
  const Case pair = family_case("random_ball", 30, 2, Precision::binary32);
  const Verdict verdict = doubled(pair).verdict;
  ASSERT_TRUE(fails(verdict));
  std::vector<Shrunk> steps;
  ShrinkSettings settings;
  settings.precision = Precision::binary32;
  const Shrunk last = shrink(
      pair, verdict, doubled, [&](const Shrunk& step) { steps.push_back(step); }, {}, settings);
  ASSERT_GT(steps.size(), 5u);
  EXPECT_EQ(last.kept + 1, steps.size());
  EXPECT_EQ(steps.front().pair.a.points, pair.a.points);
  EXPECT_EQ(steps.back().pair.a.points, last.pair.a.points);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(doubled(steps[i].pair).verdict, verdict);
    EXPECT_TRUE(accepted(steps[i].certificate));
    EXPECT_TRUE(i == 0 || size_of(steps[i].pair) < size_of(steps[i - 1].pair)) << i;
    for_each_coordinate(steps[i].pair,
                        [](const mpq_class& value) { EXPECT_TRUE(representable(value, Precision::binary32)); });
  }
}

TEST(Shrink, IsTheSameEachTime) {
  const Case pair = family_case("random_ball", 24, 2);
  const Verdict verdict = doubled(pair).verdict;
  ASSERT_TRUE(fails(verdict));
  const Shrunk first = shrink(pair, verdict, doubled), again = shrink(pair, verdict, doubled);
  EXPECT_EQ(files::case_json(first.pair), files::case_json(again.pair));
  EXPECT_EQ(first.tried, again.tried);
}

TEST(Shrink, StopsWhenItIsToldTo) {
  const Case pair = family_case("random_ball", 30, 2);
  const Verdict verdict = doubled(pair).verdict;
  ASSERT_TRUE(fails(verdict));
  std::size_t examined = 0;
  const Examine counted = [&](const Case& c) {
    ++examined;
    return doubled(c);
  };
  const Shrunk stopped = shrink(pair, verdict, counted, {}, [&] { return examined >= 7; });
  EXPECT_EQ(examined, 7u);
  EXPECT_EQ(stopped.tried, 7u);
  EXPECT_EQ(doubled(stopped.pair).verdict, verdict);
  examined = 0;
  ShrinkSettings settings;
  settings.tries = 20;
  EXPECT_EQ(shrink(pair, verdict, counted, {}, {}, settings).tried, 20u);
  EXPECT_EQ(examined, 20u);
}

TEST(Shrink, SaysWhenTheVerdictDoesNotComeAgain) {
  const Case pair = family_case("random_ball", 12, 1);
  std::size_t better = 0;
  const Shrunk shrunk = shrink(pair, Verdict::crash, doubled, [&](const Shrunk&) { ++better; });
  EXPECT_FALSE(shrunk.reproduced);
  EXPECT_EQ(shrunk.tried, 1u);
  EXPECT_EQ(shrunk.kept, 0u);
  EXPECT_EQ(better, 0u);
  EXPECT_EQ(shrunk.pair.a.points, pair.a.points);
}

TEST(Shrink, OfACrashNeedsNoJudgement) {
  // Ends on any pair where both bodies have three points or more.
  const Examine crashing = [](const Case& pair) {
    const bool ends = pair.a.points.size() > 2 && pair.b.points.size() > 2;
    return speechless(pair, ends ? Verdict::crash : Verdict::pass);
  };
  const Case pair = family_case("random_lattice", 20, 1);
  const Shrunk solid = shrink(pair, Verdict::crash, crashing);
  EXPECT_EQ(solid.pair.a.points.size(), 4u);
  EXPECT_EQ(solid.pair.b.points.size(), 4u);
  const Depth depth = truth_about(solid.pair.a.points, solid.pair.b.points).depth;
  EXPECT_FALSE(depth.flat_a || depth.flat_b);
  ShrinkSettings settings;
  settings.keep_solid = false;
  const Shrunk shrunk = shrink(pair, Verdict::crash, crashing, {}, {}, settings);
  EXPECT_EQ(shrunk.pair.a.points.size(), 3u);
  EXPECT_EQ(shrunk.pair.b.points.size(), 3u);
  for_each_coordinate(shrunk.pair, [](const mpq_class& value) { EXPECT_EQ(value, 0); });
  EXPECT_TRUE(accepted(shrunk.certificate));
}

TEST(Shrink, WaitsForFewTimeOuts) {
  std::size_t examined = 0;
  const Examine hanging = [&](const Case& pair) {
    ++examined;
    return speechless(pair, pair.a.points.size() > 90 ? Verdict::time_out : Verdict::pass);
  };
  shrink(family_case("random_ball", 200, 1), Verdict::time_out, hanging);
  EXPECT_LE(examined, 100u);
}

TEST(Shrink, KeepsOneUlpThatMatters) {
  // Wrong whenever some coordinate of A is not a multiple of 2^-40.
  const Examine picky = judged([](const Case& pair, Reply& reply) {
    const auto is_fine = [](const Point& p) { return p.x != 0 && lowest_bit(p.x) < -40; };
    const bool fine = std::ranges::any_of(pair.a.points, is_fine);
    if (reply.overlap && fine) reply.depth = *reply.depth / 2;
  });
  Case pair = family_case("random_ball", 30, 2);
  pair.a.points.edit()[3].x += scaled(1, -50);
  const Verdict verdict = picky(pair).verdict;
  ASSERT_TRUE(fails(verdict));
  const Case smallest = shrink(pair, verdict, picky).pair;
  std::size_t dear = 0;
  for_each_coordinate(smallest, [&](const mpq_class& value) { dear += cost(value) > 20 ? 1 : 0; });
  EXPECT_EQ(dear, 1u) << files::case_json(smallest);
}

TEST(Shrink, OfAnAnswerThatAVariantChanges) {
  // Wrong by half the tolerance, one way or the other, by which of the bodies has more points.
  const Tolerance tolerance{mpq_class(1, 100), 0, 0};
  const Examine lopsided = judged(
      [](const Case& pair, Reply& reply) {
        if (reply.overlap) reply.depth = *reply.depth * (pair.a.points.size() > pair.b.points.size() ? 1.008 : 0.992);
      },
      tolerance);
  const Examine swapped = examine_variant(in_any_unit(lopsided), "swap", Precision::binary64, tolerance, {}, {});
  Case pair = family_case("random_ball", 12, 3);
  pair.b.points.edit().pop_back();
  ASSERT_EQ(swapped(pair).verdict, Verdict::not_invariant);
  const Shrunk shrunk = shrink(pair, Verdict::not_invariant, swapped);
  EXPECT_EQ(shrunk.outcome.variant, "swap");
  EXPECT_EQ(shrunk.outcome.verdict, Verdict::not_invariant);
  EXPECT_EQ(shrunk.pair.a.points.size() + shrunk.pair.b.points.size(), 9u);
}

TEST(Shrink, RefusesAnOutcomeThatContradictsTheProof) {
  const Examine lying = [](const Case& pair) {
    Outcome outcome = doubled(pair);
    outcome.judgement->depth_squared *= 4;
    return outcome;
  };
  const Case pair = family_case("random_ball", 30, 2);
  EXPECT_THROW(shrink(pair, doubled(pair).verdict, lying), std::logic_error);
  EXPECT_THROW(shrink({"none", {}, pair.b}, Verdict::crash, doubled), std::invalid_argument);
}

// ---- bodies of the plane ----

/// Twice the depth wherever the rule holds, judged in the plane.
Examine doubled_in_plane(std::function<bool(const Body&)> rule) {
  return [rule = std::move(rule)](const Case& pair) {
    const Answer answer = exact_answer(pair.a, pair.b);
    Outcome outcome;
    outcome.id = pair.id;
    Reply& reply = outcome.reply.emplace();
    reply.overlap = answer.status() == Status::penetrating;
    if (reply.overlap) reply.depth = (rule(pair.a) ? 2 : 1) * *answer.nearest_binary64();
    outcome.judgement = judging::judged(judging::truth_of(pair.a, pair.b), reply, {}, Precision::binary64, {});
    outcome.verdict = outcome.judgement->verdict;
    return outcome;
  };
}

TEST(Shrink, PolygonsStayInThePlane) {
  const Case pair = family_case("plane_random", 12, 1);
  const Examine examine = doubled_in_plane([](const Body& a) { return a.points.size() > 4; });
  const Verdict verdict = examine(pair).verdict;
  ASSERT_TRUE(fails(verdict));
  const Shrunk shrunk = shrink(pair, verdict, examine);
  EXPECT_TRUE(shrunk.reproduced);
  EXPECT_EQ(shrunk.pair.a.points.size(), 5u);
  EXPECT_EQ(shrunk.pair.b.points.size(), 3u);
  for (const Body* body : {&shrunk.pair.a, &shrunk.pair.b}) {
    EXPECT_EQ(body->dimension, 2u);
    EXPECT_FALSE(answer::is_flat_body(*body));
    for (const Point& p : body->points) EXPECT_EQ(p.z, 0);
  }
  for_each_coordinate(shrunk.pair, [](const mpq_class& value) { EXPECT_EQ(value.get_den(), 1); });
  EXPECT_TRUE(accepted(shrunk.certificate));
  EXPECT_TRUE(fathom_check::verify(shrunk.certificate).plane);
  const std::string snippet_text = snippet({}, shrunk.pair, shrunk.outcome);
  EXPECT_NE(snippet_text.find("truth.dimension = 2;"), std::string::npos) << snippet_text;
}

TEST(Shrink, RadiiInThePlaneGetSimpler) {
  Body capsule;
  capsule.shape = with_margin(hull(std::vector<Point>{{0, 0, 0}, {3, 1, 0}}), mpq_class(77, 64));
  const Case pair{"capsule",
                  in_plane(capsule),
                  in_plane(Body{{{0, 0, 0}, {4, 0, 0}, {mpq_class(9, 2), 1, 0}, {0, mpq_class(5, 4), 0}}}),
                  {}};
  const Examine examine = doubled_in_plane([](const Body& a) { return a.shape && a.shape->radius > 0; });
  const Verdict verdict = examine(pair).verdict;
  ASSERT_TRUE(fails(verdict));
  std::size_t steps = 0;
  std::optional<Size> before;
  const Shrunk shrunk = shrink(pair, verdict, examine, [&](const Shrunk& step) {
    EXPECT_TRUE(accepted(step.certificate));
    EXPECT_TRUE(!before || size_of(step.pair) < *before);
    before = size_of(step.pair);
    ++steps;
  });
  EXPECT_GT(steps, 3u);
  ASSERT_TRUE(shrunk.pair.a.shape);
  EXPECT_EQ(core_of(shrunk.pair.a).size(), 1u);
  EXPECT_EQ(shrunk.pair.a.shape->radius, 1);
  EXPECT_NE(snippet({}, shrunk.pair, shrunk.outcome).find("fathom::ShapeTruth truth"), std::string::npos);
}

TEST(Size, PrefersFewPointsThenSmallIntegers) {
  EXPECT_EQ(cost(0), 0u);
  EXPECT_LT(cost(1), cost(2));
  EXPECT_EQ(cost(-3), cost(3));
  EXPECT_LT(cost(1000), cost(mpq_class(1, 2)));
  EXPECT_LT(cost(mpq_class(3, 4)), cost(mpq_class(1023, 1024)));
  EXPECT_LT(cost(mpq_class(3, 4)), cost(scaled(3, -300)));
  EXPECT_LT(size_of({"", {{{9, 9, 9}}}, {{{9, 9, 9}}}}), size_of({"", {{{}, {}}}, {{{}}}}));
}

TEST(Simplify, RoundsAndOffersOnlyCheaperNumbers) {
  EXPECT_EQ(nearest_integer(mpq_class(5, 2)), 3);
  EXPECT_EQ(nearest_integer(mpq_class(-5, 2)), -2);
  EXPECT_EQ(nearest_integer(mpq_class(-8, 3)), -3);
  EXPECT_EQ(to_multiple(mpq_class(11, 16), -2), mpq_class(3, 4));
  EXPECT_EQ(to_bits(mpq_class(11, 16), 2), mpq_class(3, 4));
  EXPECT_EQ(to_bits(1000, 1), 1024);
  EXPECT_TRUE(simpler(0).empty());
  for (const mpq_class& value : {mpq_class(-1), mpq_class(77), mpq_class(-1001, 1024), scaled(12345, 400)})
    for (const mpq_class& other : simpler(value)) {
      EXPECT_NE(other, value);
      EXPECT_TRUE(cost(other) < cost(value) || (cost(other) == cost(value) && value < 0 && other >= 0))
          << other << " for " << value;
    }
}

class Files : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "fathom-shrink-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  static std::string text_of(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  std::filesystem::path folder;
};

TEST_F(Files, HoldTheCaseItsProofAndASnippet) {
  const Case pair = family_case("random_ball", 30, 2);
  const Verdict verdict = doubled(pair).verdict;
  ASSERT_TRUE(fails(verdict));
  SubjectInfo info;
  info.name = "fake";
  const std::filesystem::path place = folder / "deep" / "er";
  std::vector<std::string> paths;
  const Shrunk shrunk = shrink(pair, verdict, doubled, [&](const Shrunk& step) {
    paths = write_shrunk(place.string(), step, info);
    EXPECT_TRUE(accepted(text_of(paths.at(1))));
  });
  ASSERT_EQ(paths.size(), 3u);
  EXPECT_EQ(paths[0], (place / (std::string(name(verdict)) + ".case.json")).string());
  const CaseItem item = parse_case(text_of(paths[0]), paths[0]);
  ASSERT_TRUE(item.ok());
  EXPECT_EQ(item.value().a.points, shrunk.pair.a.points);
  EXPECT_EQ(item.value().b.points, shrunk.pair.b.points);
  EXPECT_EQ(text_of(paths[1]), shrunk.certificate);
  EXPECT_NE(text_of(paths[2]).find("fathom::judge"), std::string::npos);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(place), {}), 3);
}

TEST_F(Files, HoldATestOfTheDerivativeAlongTheMotion) {
  Shrunk shrunk;
  shrunk.pair = family_case("random_ball", 4, 1);
  shrunk.outcome = claimed(shrunk.pair, 1);
  shrunk.outcome.verdict = Verdict::wrong_derivative;
  shrunk.pair.motion = Motion{{{1, 0, 0}, {0, 0, mpq_class(1, 3)}}, {}};
  shrunk.outcome.reply->derivative = 0.5;
  SubjectInfo of_library;
  of_library.library = "libccd";
  const std::string text = text_of(write_shrunk(folder.string(), shrunk, of_library).at(2));
  EXPECT_NE(text.find("reply.derivative = 0x1p-1;"), std::string::npos) << text;
  EXPECT_NE(text.find("mpq_class(\"1/3\")"), std::string::npos) << text;
  EXPECT_NE(text.find(", {}, motion)"), std::string::npos) << text;
}

TEST_F(Files, ThatCannotBeWrittenAreNamed) {
  std::ofstream(folder / "file") << "taken";
  Shrunk shrunk;
  shrunk.pair = family_case("random_ball", 4, 1);
  EXPECT_THROW(write_shrunk((folder / "file").string(), shrunk, {}), InputError);
}

TEST(CaseLine, ReadsBackExactly) {
  for (const char* family : {"random_ball", "wild_coordinates", "boxes_posed"}) {
    const Case pair = families::find_family(family)->make(1, 8);
    const CaseItem item = parse_case(files::case_json(pair, "a \"comment\"\n"), "line");
    ASSERT_TRUE(item.ok()) << family;
    EXPECT_EQ(item.value().a.points, pair.a.points);
    EXPECT_EQ(item.value().b.points, pair.b.points);
    EXPECT_EQ(item.id, pair.id);
  }
}

// What stands in a snippet. That they compile, and show the wrong number again:
// snippet_heavy_test.cpp.

using namespace fathom::testing;

bool holds(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

TEST(Snippet, HoldsThePointsTheTruthAndTheClaim) {
  const Case pair = real_case("real::fcl-545-unit");
  const Outcome outcome = claimed(pair, 1.0392);
  for (const SubjectInfo& info : subjects()) {
    const std::string text = snippet(info, pair, outcome);
    EXPECT_TRUE(holds(text.substr(0, 300), "// real::fcl-545-unit: " + info.name)) << text;
    EXPECT_TRUE(holds(text, "// truth:   penetrating, depth^2 = ")) << text;
    EXPECT_TRUE(holds(text, "// claim:   overlap, depth 1.0392, direction (0, 0, 1)\n")) << text;
    EXPECT_TRUE(holds(text, "// verdict: " + std::string(name(outcome.verdict)) + ": ")) << text;
    for (const Body* body : {&pair.a, &pair.b})
      for (const Point& p : body->points) EXPECT_TRUE(holds(text, hex_text(round_binary64(p.x, Rounding::rn)))) << text;
    EXPECT_FALSE(holds(text, "@")) << text;
    EXPECT_EQ(holds(text, "std::vector<std::vector<int>> faces"), info.wants_faces);
  }
}

TEST(Snippet, TakesTheSettingsOfTheHello) {
  const Case pair = real_case("real::fcl-545-unit");
  const Outcome outcome = claimed(pair, 1);
  SubjectInfo info = subject("libccd", "libccd-epa");
  EXPECT_TRUE(holds(snippet(info, pair, outcome), "options.epa_tolerance = 0.0001;"));
  info.settings = {{"epa_tolerance", "1e-12"}, {"max_iterations", "500"}};
  const std::string text = snippet(info, pair, outcome);
  EXPECT_TRUE(holds(text, "options.epa_tolerance = 1e-12;"));
  EXPECT_TRUE(holds(text, "options.max_iterations = 500UL;"));
  EXPECT_TRUE(holds(text, "epa_tolerance = 1e-12, max_iterations = 500)"));
  EXPECT_TRUE(holds(snippet(subject("libccd", "libccd-mpr"), pair, outcome), "ccdMPRPenetration(&a"));
}

TEST(Snippet, IsNoPlaceForCodeOfTheSubject) {
  const Case real = real_case("real::fcl-545-unit");
  const Case pair{"id\n#include \"evil\"\\", real.a, real.b};
  SubjectInfo info = subject("libccd", "libccd\nint evil;");
  info.settings = {{"epa_tolerance", "0; evil()"}, {"key\nevil", "value\\"}};
  Outcome outcome = claimed(pair, 1);
  outcome.judgement->sentence = "two\nevil lines\\";
  const std::string text = snippet(info, pair, outcome);
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = text.find('\n', begin);
    const std::string line = text.substr(begin, end - begin);
    EXPECT_TRUE(!holds(line, "evil") || line.starts_with("//")) << line;
    EXPECT_FALSE(line.starts_with("//") && line.ends_with("\\")) << line;
    begin = end + 1;
  }
}

TEST(Snippet, OfACrashKnowsTheTruthAllTheSame) {
  const Case pair = real_case("real::fcl-545-unit");
  Outcome outcome;
  outcome.verdict = Verdict::crash;
  outcome.detail = "killed by signal 11";
  const std::string text = snippet(subject("", "home-made"), pair, outcome);
  EXPECT_TRUE(holds(text, "depth = 0.6\n")) << text;
  EXPECT_TRUE(holds(text, "// claim:   none\n")) << text;
  EXPECT_TRUE(holds(text, "// verdict: crash: killed by signal 11\n")) << text;
  EXPECT_TRUE(holds(text, "No answer was recorded")) << text;
}

TEST(Snippet, OfAVariantCallsTwice) {
  const Case pair = real_case("real::fcl-545-unit");
  Outcome outcome = claimed(pair, 1);
  outcome.variant = "swap";
  outcome.verdict = Verdict::not_invariant;
  const std::string text = snippet(subject("ode", "ode-collide", true), pair, outcome);
  EXPECT_TRUE(holds(text, "answer(\"A and B\", a, b);")) << text;
  EXPECT_TRUE(holds(text, "answer(\"the variant swap\", other_a, other_b);")) << text;
}

TEST(Snippet, WritesNumbersThatAreNoNumbers) {
  const Case pair = real_case("real::fcl-545-unit");
  Outcome outcome = claimed(pair, std::numeric_limits<double>::quiet_NaN());
  outcome.reply->direction = Triple{-std::numeric_limits<double>::infinity(), 0, 0};
  const std::string text = snippet(subject("", "home-made"), pair, outcome);
  EXPECT_TRUE(holds(text, "reply.depth = NAN;")) << text;
  EXPECT_TRUE(holds(text, "{{-HUGE_VAL, 0x0p+0, 0x0p+0}}")) << text;
}

}  // namespace
}  // namespace fathom::harness
