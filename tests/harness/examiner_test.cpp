// SPDX-License-Identifier: GPL-3.0-or-later
// Subjects written as lines of shell. What the liar of tests/cli/certify_liar_test.py does is not
// done again here.
#include "verify/harness/examiner.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace fathom::harness {
namespace {

const std::string hello =
    R"({"type":"hello","protocol":"fathom/subject/1","name":"s","version":"1","precision":"binary64",)"
    R"("conventions":{"touching":"either","depth":"positive","moves":"a","unit":true}})";

/// Says hello, then for each run executes `body` with the run's id in $id.
SubjectCommand subject(const std::string& body) {
  return {"read x; echo '" + hello +
          R"('; while read -r x; do id=${x#*id\":\"}; id=${id%%\"*}; case $x in *stop*) exit 0;; esac; )" + body +
          "; done"};
}
const std::string apart = R"(echo "{\"type\":\"reply\",\"id\":\"$id\",\"overlap\":false}")";

Case points(const std::string& id, int distance) { return {id, {{{0, 0, 0}}}, {{{distance, 0, 0}}}}; }

/// What was no case's fault: "a: killed by signal 9 (Killed)" after case a.
struct Notes {
  std::vector<std::string> texts;
  Settings settings(double time_out = 10) {
    Settings settings;
    settings.time_out = time_out;
    settings.unattributed = [this](const Unattributed& thing) {
      texts.push_back(thing.after.value_or("-") + ": " + thing.detail);
    };
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
  examiner.finish();
  EXPECT_EQ(examiner.starts(), 1U);
  EXPECT_TRUE(notes.texts.empty()) << notes.texts.front();
  EXPECT_EQ(examiner.examine(points("more", 1)).verdict, Verdict::pass) << "in a fresh process";
}

TEST(Examiner, BlamesOnlyTheCaseAtHand) {
  Notes notes;
  Examiner examiner(subject("case $x in *[[]7,*) kill -9 $$;; *[[]8,*) echo nonsense;; *) " + apart + ";; esac"),
                    notes.settings());
  const std::vector<std::pair<int, Verdict>> expected{{1, Verdict::pass}, {7, Verdict::crash},   {7, Verdict::crash},
                                                      {2, Verdict::pass}, {8, Verdict::garbage}, {3, Verdict::pass},
                                                      {4, Verdict::pass}};
  for (const auto& [distance, verdict] : expected)
    EXPECT_EQ(examiner.examine(points("x", distance)).verdict, verdict) << distance;
  EXPECT_EQ(examiner.starts(), 7U) << "each failing case is put to a fresh process again";
  EXPECT_TRUE(notes.texts.empty()) << notes.texts.front();
}

TEST(Examiner, GivesUpTime) {
  Notes notes;
  Examiner examiner(subject("case $x in *[[]7,*) sleep 60;; *) " + apart + ";; esac"), notes.settings(0.2));
  const Outcome outcome = examiner.examine(points("x", 7));
  EXPECT_EQ(outcome.verdict, Verdict::time_out);
  EXPECT_GE(outcome.seconds, 0.2);
  EXPECT_FALSE(outcome.judgement);
}

TEST(Examiner, BlamesNoCaseForWhatComesAfterAGoodAnswer) {
  const std::vector<std::pair<std::string, std::string>> ways{
      {"exit 0", "ended with exit code 0"},
      {"kill -9 $$", "killed by signal 9 (Killed)"},
      {"sleep 0.005; exit 3", "ended with exit code 3"},
      {"echo done", "wrote 'done'"},
      {"sleep 0.005; printf done; exit 0", "wrote 'done'"},
      {"exec 1>&-; sleep 60", "closed its output and lived on"},
  };
  for (const auto& [way, detail] : ways) {
    Notes notes;
    Examiner examiner(subject(apart + "; " + way), notes.settings());
    for (const char* id : {"a", "b", "c"}) EXPECT_EQ(examiner.examine(points(id, 1)).verdict, Verdict::pass) << way;
    examiner.finish();
    const std::vector<std::string> expected{"a: " + detail, "b: " + detail, "c: " + detail};
    EXPECT_EQ(notes.texts, expected) << way;
  }
}

TEST(Examiner, BlamesTheCaseThatFailsAgain) {
  Notes notes;  // dies after each answer, and whenever it has read case 7
  Examiner examiner(subject("case $x in *[[]7,*) kill -11 $$;; *) " + apart + "; sleep 0.005; kill -9 $$;; esac"),
                    notes.settings());
  EXPECT_EQ(examiner.examine(points("a", 1)).verdict, Verdict::pass);
  const Outcome outcome = examiner.examine(points("b", 7));
  EXPECT_EQ(outcome.verdict, Verdict::crash);
  EXPECT_EQ(outcome.detail, "killed by signal 11 (Segmentation fault)");
  EXPECT_EQ(notes.texts, (std::vector<std::string>{"a: killed by signal 9 (Killed)"}));
}

/// What happens with a case once, and not again.
TEST(Examiner, AsksAFreshProcess) {
  const std::string mark = testing::TempDir() + "examiner_test_first";
  const std::string first = "[ ! -e '" + mark + "' ] && touch '" + mark + "' && ";
  for (const auto& [way, detail] : {std::pair<std::string, std::string>{"kill -9 $$", "-: killed by signal 9 (Killed)"},
                                    {"{ echo '{}'; continue; }", "-: wrote '{}'"},
                                    {"exit 0", "-: ended with exit code 0"}}) {
    ASSERT_EQ(std::system(("rm -f '" + mark + "'").c_str()), 0);
    Notes notes;
    Examiner examiner(subject(first + way + "; " + apart), notes.settings());
    EXPECT_EQ(examiner.examine(points("a", 1)).verdict, Verdict::pass) << way;
    EXPECT_EQ(notes.texts, std::vector<std::string>{detail});
    EXPECT_EQ(examiner.starts(), 2U);
  }
  ASSERT_EQ(std::system(("rm -f '" + mark + "'").c_str()), 0);
}

TEST(Examiner, HearsHowItEnds) {
  const auto at_stop = [](const std::string& way) {
    SubjectCommand command = subject(apart);
    command.shell.replace(command.shell.find("exit 0"), 6, way);
    return command;
  };
  for (const auto& [way, detail] :
       {std::pair<std::string, std::string>{"exit 3", "a: after stop: ended with exit code 3"},
        {"kill -11 $$", "a: after stop: killed by signal 11 (Segmentation fault)"},
        {"echo bye; exit 0", "a: wrote 'bye'"}}) {
    Notes notes;
    Examiner examiner(at_stop(way), notes.settings());
    examiner.examine(points("a", 1));
    examiner.finish();
    EXPECT_EQ(notes.texts, std::vector<std::string>{detail});
  }
}

TEST(Examiner, GivesUpWhatNeverReads) {
  Notes notes;
  Examiner examiner({"read x; echo '" + hello + "'; exit 5"}, notes.settings());
  EXPECT_THROW(examiner.examine(points("a", 1)), SubjectError);
  EXPECT_EQ(notes.texts, std::vector<std::string>(3, "-: ended with exit code 5"));
}

TEST(Examiner, TellsOfALineWithoutEnd) {
  Notes notes;
  Examiner examiner(subject("printf '{\"half'; sleep 60"), notes.settings(0.2));
  EXPECT_EQ(examiner.examine(points("a", 1)).detail, "no answer within 0.2 s; 6 bytes came, no end of line: '{\"half'");
  Settings impatient = notes.settings(0.1);
  impatient.hello_time_out = 0.2;
  try {
    Examiner silent({"printf hello; sleep 60"}, impatient);
    FAIL();
  } catch (const SubjectError& error) {
    EXPECT_STREQ(error.what(), "the subject said no hello within 0.2 s; 5 bytes came, no end of line: 'hello'");
  }
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
  EXPECT_THROW(examiner.examine(points("x", 1)), SubjectError) << "where the fresh process is due";
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
