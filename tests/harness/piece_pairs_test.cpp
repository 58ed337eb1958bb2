// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the answers about pairs of pieces is the one about the unions, and what becomes of those
// that are none.
#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "tests/unions/pieces.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/seen_case.hpp"

namespace fathom::harness {
namespace {

using unions::box;

/// A of two boxes, B of three; the first is 1/2 deep in the first of B, the second 1/4 in the
/// second.
Case unions_case() {
  const Pieces a{box({0, 0, 0}, {1, 1, 1}), box({0, 0, 4}, {1, 1, 5})};
  const Pieces b{box({mpq_class(1, 2), 0, 0}, {9, 1, 1}), box({mpq_class(3, 4), 0, 4}, {9, 1, 5}),
                 box({20, 0, 0}, {21, 1, 1})};
  return {"two", Body{.points = {}, .pieces = std::make_shared<const Pieces>(a)},
          Body{.points = {}, .pieces = std::make_shared<const Pieces>(b)}};
}

SubjectAnswer says(std::optional<double> depth) {
  return {{}, Reply{.overlap = true, .depth = depth, .direction = Triple{-1, 0, 0}}};
}
SubjectAnswer says_apart(std::optional<double> distance = {}) { return {{}, Reply{.distance = distance}}; }

/// Answers by the ids of pairs; all others are apart by 7.
struct Script {
  std::map<std::string, SubjectAnswer> answers;
  std::map<std::string, Verdict> faults;
  std::vector<std::string> asked;

  Outcome run(const SubjectInfo& info = {}, const Case& pair = unions_case()) {
    return examine_pairs(pair, 0, info, {}, [this](const Case& one, std::optional<SubjectAnswer>& answer) {
      asked.push_back(one.id);
      Outcome outcome = outcome_for(one);
      outcome.seconds = 2;
      if (const auto fault = faults.find(one.id); fault != faults.end()) {
        outcome.verdict = fault->second;
        outcome.detail = "as in the script";
      } else {
        const auto found = answers.find(one.id);
        answer = found == answers.end() ? says_apart(7) : found->second;
      }
      return outcome;
    });
  }
};

TEST(PiecePairs, TheDeepestReplyIsTheAnswer) {
  Script script{{{"two[0,0]", says(0.5)}, {"two[1,1]", says(0.25)}}, {}, {}};
  const Outcome outcome = script.run();
  EXPECT_EQ(script.asked,
            (std::vector<std::string>{"two[0,0]", "two[0,1]", "two[0,2]", "two[1,0]", "two[1,1]", "two[1,2]"}));
  EXPECT_EQ(outcome.id, "two");
  EXPECT_EQ(outcome.verdict, Verdict::pass);
  EXPECT_EQ(outcome.reply->depth, 0.5);
  EXPECT_EQ(outcome.seconds, 12);
  EXPECT_EQ(outcome.digest, digest_of(unions_case()));
  ASSERT_TRUE(outcome.pieces);
  EXPECT_EQ(outcome.pieces->pairs, 6U);
  EXPECT_EQ(outcome.pieces->answer_of[0], 0U);
  EXPECT_EQ(outcome.pieces->answer_of[1], 0U);
  EXPECT_EQ(outcome.pieces->query.verdict, Verdict::pass);

  script.answers["two[1,1]"] = says(0.75);
  const Outcome wrong = script.run();
  EXPECT_EQ(wrong.verdict, Verdict::too_deep);
  EXPECT_EQ(wrong.pieces->answer_of[0], 1U);
  EXPECT_EQ(wrong.pieces->query.verdict, Verdict::too_deep);
  EXPECT_EQ(wrong.pieces->query.depth_squared, mpq_class(1, 16)) << "the pair's";
  EXPECT_EQ(wrong.judgement->depth_squared, mpq_class(1, 4)) << "the unions'";
}

TEST(PiecePairs, TheSignIsThatOfTheConventions) {
  SubjectInfo info;
  info.conventions.depth = Conventions::Sign::negative;
  Script script{{{"two[0,0]", says(-0.5)}, {"two[1,1]", says(-0.25)}}, {}, {}};
  EXPECT_EQ(script.run(info).reply->depth, -0.5);
}

TEST(PiecePairs, WhatIsNotFiniteIsDeepest) {
  Script script{{{"two[0,0]", says(0.5)}, {"two[1,1]", says(std::numeric_limits<double>::quiet_NaN())}}, {}, {}};
  EXPECT_EQ(script.run().verdict, Verdict::nan);
}

TEST(PiecePairs, OverlapsWithoutDepths) {
  Script script{{{"two[0,0]", says({})}, {"two[1,1]", says(0.5)}}, {}, {}};
  EXPECT_EQ(script.run().reply->depth, 0.5);
  script.answers["two[1,1]"] = says({});
  const Outcome outcome = script.run();
  EXPECT_EQ(outcome.verdict, Verdict::pass) << "by its classification";
  EXPECT_EQ(outcome.pieces->answer_of[1], 0U);
}

TEST(PiecePairs, ApartByTheLeastDistance) {
  Case pair = unions_case();
  for_each_hull(pair.a, [](std::vector<Point>& points) {
    for (Point& p : points) p.x -= 3;
  });
  Script script{{{"two[0,0]", says_apart(2.5)}, {"two[1,1]", says_apart(2.75)}}, {}, {}};
  const Outcome outcome = script.run({}, pair);
  EXPECT_EQ(outcome.verdict, Verdict::pass) << outcome.judgement->sentence;
  EXPECT_EQ(outcome.reply->distance, 2.5);
  EXPECT_EQ(outcome.judgement->distance_squared, mpq_class(25, 4));
  script.answers["two[1,1]"] = says_apart();
  const Outcome bare = script.run({}, pair);
  EXPECT_FALSE(bare.reply->distance) << "that of one pair is not known";
  EXPECT_EQ(bare.verdict, Verdict::pass);
  SubjectInfo info;
  info.promises = {"distance"};
  EXPECT_EQ(script.run(info, pair).verdict, Verdict::inconsistent) << "a promise is one about each pair";
}

TEST(PiecePairs, NoAnswerToOneIsNone) {
  Script script{{{"two[0,0]", says(0.5)}}, {{"two[0,2]", Verdict::crash}}, {}};
  const Outcome crash = script.run();
  EXPECT_EQ(crash.verdict, Verdict::crash);
  EXPECT_EQ(crash.detail, "piece 0 of A, piece 2 of B: as in the script");
  EXPECT_EQ(script.asked.size(), 3U) << "and no other is asked";
  EXPECT_FALSE(crash.judgement || crash.reply || crash.pieces);

  Script failing{{{"two[1,0]", {{}, Failed{"no step"}}}}, {}, {}};
  const Outcome failed = failing.run();
  EXPECT_EQ(failed.verdict, Verdict::failed);
  EXPECT_EQ(failed.detail, "piece 1 of A, piece 0 of B: no step");

  Script declining{{{"two[0,1]", {{}, Unsupported{"too thin"}}}}, {}, {}};
  EXPECT_EQ(declining.run().verdict, Verdict::unsupported);
  EXPECT_EQ(declining.asked.size(), 6U);
  declining.faults["two[1,2]"] = Verdict::time_out;
  EXPECT_EQ(declining.run().verdict, Verdict::time_out) << "worse than to decline";
}

TEST(PiecePairs, TimesAddUpIfAllAreThere) {
  Script script;
  script.answers["two[0,0]"] = says(0.5);
  for (const std::string& id : {"two[0,0]", "two[0,1]", "two[0,2]", "two[1,0]", "two[1,1]", "two[1,2]"})
    script.answers.try_emplace(id, says_apart()).first->second.microseconds = 1.5;
  EXPECT_EQ(script.run().microseconds, 9.0);
  script.answers["two[1,2]"].microseconds.reset();
  EXPECT_FALSE(script.run().microseconds);
}

TEST(PiecePairs, Ids) {
  const Case pair = unions_case();
  EXPECT_TRUE(is_pair_of("two[1,2]", pair));
  for (const char* other : {"two", "two[2,0]", "two[0,3]", "two[01,2]", "two[1,2]x", "two[1,2", "two[ 1,2]", "two[,]",
                            "tow[1,2]", "two[-1,0]"})
    EXPECT_FALSE(is_pair_of(other, pair)) << other;
  EXPECT_FALSE(is_pair_of("p[0,0]", {"p", Body{box({0, 0, 0}, {1, 1, 1})}, Body{box({0, 0, 0}, {1, 1, 1})}}));
}

TEST(PiecePairs, AreSeenInTheSubjectsPrecision) {
  Case pair = unions_case();
  for_each_hull(pair.a, [](std::vector<Point>& points) { points.back().x += mpq_class(1, mpz_class(1) << 40); });
  const std::optional<Case> seen = as_seen(pair, Precision::binary32);
  ASSERT_TRUE(seen);
  EXPECT_EQ((*seen->a.pieces)[0], (*unions_case().a.pieces)[0]);
  EXPECT_NE(digest_of(pair), digest_of(*seen));
  EXPECT_EQ(as_seen(*seen, Precision::binary32)->a.pieces->size(), 2U) << "what was seen is seen again";
  for_each_hull(pair.a, [](std::vector<Point>& points) {
    for (Point& p : points) p.z = p.z / (mpz_class(1) << 60) + 1;
  });
  std::string why;
  EXPECT_FALSE(as_seen(pair, Precision::binary32, {}, &why));
  EXPECT_EQ(why, "piece 0 of A has no interior in binary32, the precision of the subject");
}

TEST(PiecePairs, OneBodyMayBePlain) {
  const Case pair{"plain", Body{box({0, 0, 0}, {1, 1, 1})}, unions_case().b};
  const std::optional<Case> seen = as_seen(pair, Precision::binary64);
  ASSERT_TRUE(seen && seen->a.pieces && seen->b.pieces);
  EXPECT_EQ(seen->a.pieces->size(), 1U);
  EXPECT_EQ(run_message("1", *seen, Precision::binary64, false).find("{\"pieces\":[{\"vertices\":"),
            run_message("1", *seen, Precision::binary64, false).rfind("\"pieces\"") - 1);
}

TEST(PiecePairs, RadiiAreDeclined) {
  SubjectInfo info;
  EXPECT_EQ(obstacle_to(unions_case(), info, 0), "");
  info.rounding["vertices"] = mpq_class(1, 8);
  EXPECT_NE(obstacle_to(unions_case(), info, 0), "");
  EXPECT_TRUE(is_asked_in_pairs(unions_case(), info));
  info.shapes = {"pieces"};
  EXPECT_FALSE(is_asked_in_pairs(unions_case(), info));
}

}  // namespace
}  // namespace fathom::harness
