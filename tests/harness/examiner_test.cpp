// SPDX-License-Identifier: GPL-3.0-or-later
// Subjects written as lines of shell. What the liar of tests/cli/certify_liar_test.py does is not done again here.
#include "verify/harness/examiner.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace fathom::harness {
namespace {

const std::string hello = R"({"type":"hello","protocol":"fathom/subject/1","name":"s","version":"1","precision":"binary64",)"
                          R"("conventions":{"touching":"either","depth":"positive","moves":"a","unit":true}})";

/// Says hello, then for each run executes `body` with the run's id in $id.
Command subject(const std::string& body) {
  return {"read x; echo '" + hello + R"('; while read -r x; do id=${x#*id\":\"}; id=${id%%\"*}; case $x in *stop*) exit 0;; esac; )" +
          body + "; done"};
}
const std::string apart = R"(echo "{\"type\":\"reply\",\"id\":\"$id\",\"overlap\":false}")";

Case points(const std::string& id, int distance) { return {id, {{{0, 0, 0}}}, {{{distance, 0, 0}}}}; }

struct Notes {
  std::vector<std::string> texts;
  Settings settings(double time_out = 10) {
    Settings settings;
    settings.time_out = time_out;
    settings.note = [this](const std::string& text) { texts.push_back(text); };
    return settings;
  }
};

TEST(Examiner, AsksAndJudges) {
  Notes notes;
  Examiner examiner(subject(apart), notes.settings());
  EXPECT_EQ(examiner.info().name, "s");
  for (int i = 1; i < 5; ++i) {
    const Outcome outcome = examiner.examine(points(std::to_string(i), i));
    EXPECT_EQ(outcome.verdict, Verdict::pass);
    EXPECT_EQ(outcome.id, std::to_string(i));
    ASSERT_TRUE(outcome.judgement);
    EXPECT_EQ(outcome.judgement->status, Status::disjoint);
    EXPECT_GT(outcome.seconds, 0);
  }
  EXPECT_EQ(examiner.starts(), 1U);
  EXPECT_TRUE(notes.texts.empty());
}

TEST(Examiner, BlamesOnlyTheCaseAtHand) {
  Notes notes;
  Examiner examiner(subject("case $x in *[[]7,*) kill -9 $$;; *[[]8,*) echo nonsense;; *) " + apart + ";; esac"), notes.settings());
  const std::vector<std::pair<int, Verdict>> expected{{1, Verdict::pass},    {7, Verdict::crash}, {7, Verdict::crash}, {2, Verdict::pass},
                                                      {8, Verdict::garbage}, {3, Verdict::pass},  {4, Verdict::pass}};
  for (const auto& [distance, verdict] : expected) EXPECT_EQ(examiner.examine(points("x", distance)).verdict, verdict) << distance;
  EXPECT_EQ(examiner.starts(), 4U);
}

TEST(Examiner, GivesUpTime) {
  Notes notes;
  Examiner examiner(subject("case $x in *[[]7,*) sleep 60;; *) " + apart + ";; esac"), notes.settings(0.2));
  const Outcome outcome = examiner.examine(points("x", 7));
  EXPECT_EQ(outcome.verdict, Verdict::time_out);
  EXPECT_GE(outcome.seconds, 0.2);
  EXPECT_FALSE(outcome.judgement);
}

TEST(Examiner, AsksAgainWhereAnEarlierCaseIsToBlame) {
  Notes notes;
  Examiner examiner(subject(apart + "; exit 0"), notes.settings());
  for (int i = 1; i < 6; ++i) EXPECT_EQ(examiner.examine(points("x", i)).verdict, Verdict::pass);
  EXPECT_EQ(examiner.starts(), 5U);
  EXPECT_EQ(notes.texts.size(), 4U);
}

TEST(Examiner, NeverStarts) {
  Notes notes;
  Settings impatient = notes.settings(0.1);
  impatient.hello_time_out = 0.2;
  EXPECT_THROW(Examiner({"sleep 60"}, impatient), SubjectError);
  EXPECT_THROW(Examiner({"exit 1"}, notes.settings()), SubjectError);
  EXPECT_THROW(Examiner({"echo hello"}, notes.settings()), SubjectError);
}

TEST(Examiner, DoesNotStartAgain) {
  Notes notes;
  const std::string once = testing::TempDir() + "examiner_test_once";
  const std::string says_hello_once = "[ -e '" + once + "' ] && exit 5; touch '" + once + "'; ";
  ASSERT_EQ(std::system(("rm -f '" + once + "'").c_str()), 0);
  Examiner examiner({says_hello_once + subject("exit 4").shell}, notes.settings());
  EXPECT_EQ(examiner.examine(points("x", 1)).verdict, Verdict::crash);
  EXPECT_THROW(examiner.examine(points("x", 2)), SubjectError);
  ASSERT_EQ(std::system(("rm -f '" + once + "'").c_str()), 0);
}

TEST(Examiner, Stops) {
  Notes notes;
  bool stop = false;
  Settings settings = notes.settings();
  settings.stop = [&] { return stop; };
  Examiner examiner(subject("sleep 60"), settings);
  stop = true;
  EXPECT_THROW(examiner.examine(points("x", 1)), Interrupted);
}

}  // namespace
}  // namespace fathom::harness
