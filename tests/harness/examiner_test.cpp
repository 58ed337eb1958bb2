// SPDX-License-Identifier: GPL-3.0-or-later
// Subjects written as lines of shell. What the liar of tests/cli/transcripts/certify.md does is not
// done again here.

#include "verify/harness/examiner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>

#include "tests/harness/fake_subject.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/journal.hpp"
#include "verify/harness/seen_case.hpp"

namespace fathom::harness {
namespace {

const std::string hello =
    R"({"type":"hello","protocol":"fathom/subject/1","name":"s","version":"1","precision":"binary64",)"
    R"("conventions":{"touching":"either","depth":"positive","moves":"a","unit":true}})";

/// Says hello, then for each run executes `body` with the run's id in $id.
SubjectCommand shell_subject(const std::string& body) {
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
  Examiner examiner(shell_subject(apart), notes.settings());
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
  Examiner examiner(shell_subject("case $x in *[[]7,*) kill -9 $$;; *[[]8,*) echo nonsense;; *) " + apart + ";; esac"),
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
  Examiner examiner(shell_subject("case $x in *[[]7,*) sleep 60;; *) " + apart + ";; esac"), notes.settings(0.2));
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
    Examiner examiner(shell_subject(apart + "; " + way), notes.settings());
    for (const char* id : {"a", "b", "c"}) EXPECT_EQ(examiner.examine(points(id, 1)).verdict, Verdict::pass) << way;
    examiner.finish();
    const std::vector<std::string> expected{"a: " + detail, "b: " + detail, "c: " + detail};
    EXPECT_EQ(notes.texts, expected) << way;
  }
}

TEST(Examiner, BlamesTheCaseThatFailsAgain) {
  Notes notes;  // dies after each answer, and whenever it has read case 7
  Examiner examiner(shell_subject("case $x in *[[]7,*) kill -11 $$;; *) " + apart + "; sleep 0.005; kill -9 $$;; esac"),
                    notes.settings());
  EXPECT_EQ(examiner.examine(points("a", 1)).verdict, Verdict::pass);
  const Outcome outcome = examiner.examine(points("b", 7));
  EXPECT_EQ(outcome.verdict, Verdict::crash);
  EXPECT_EQ(outcome.detail, "killed by signal 11 (Segmentation fault)");
  EXPECT_EQ(notes.texts, (std::vector<std::string>{"a: killed by signal 9 (Killed)"}));
}

/// What happens with a case once, and not again.
TEST(Examiner, AsksAFreshProcess) {
  const std::string mark = ::testing::TempDir() + "examiner_test_first";
  const std::string first = "[ ! -e '" + mark + "' ] && touch '" + mark + "' && ";
  for (const auto& [way, detail] : {std::pair<std::string, std::string>{"kill -9 $$", "-: killed by signal 9 (Killed)"},
                                    {"{ echo '{}'; continue; }", "-: wrote '{}'"},
                                    {"exit 0", "-: ended with exit code 0"}}) {
    ASSERT_EQ(std::system(("rm -f '" + mark + "'").c_str()), 0);
    Notes notes;
    Examiner examiner(shell_subject(first + way + "; " + apart), notes.settings());
    EXPECT_EQ(examiner.examine(points("a", 1)).verdict, Verdict::pass) << way;
    EXPECT_EQ(notes.texts, std::vector<std::string>{detail});
    EXPECT_EQ(examiner.starts(), 2U);
  }
  ASSERT_EQ(std::system(("rm -f '" + mark + "'").c_str()), 0);
}

TEST(Examiner, HearsHowItEnds) {
  const auto at_stop = [](const std::string& way) {
    SubjectCommand command = shell_subject(apart);
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
  Examiner examiner(shell_subject("printf '{\"half'; sleep 60"), notes.settings(0.2));
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
  const std::string once = ::testing::TempDir() + "examiner_test_once";
  const std::string says_hello_once = "[ -e '" + once + "' ] && exit 5; touch '" + once + "'; ";
  ASSERT_EQ(std::system(("rm -f '" + once + "'").c_str()), 0);
  Examiner examiner({says_hello_once + shell_subject("exit 4").shell}, notes.settings());
  EXPECT_THROW(examiner.examine(points("x", 1)), SubjectError) << "where the fresh process is due";
  ASSERT_EQ(std::system(("rm -f '" + once + "'").c_str()), 0);
}

TEST(Examiner, Stops) {
  Notes notes;
  bool stop = false;
  Settings settings = notes.settings();
  settings.stop = [&] { return stop; };
  Examiner examiner(shell_subject("sleep 60"), settings);
  stop = true;
  EXPECT_THROW(examiner.examine(points("x", 1)), Interrupted);
}

// Many threads, each case once; exceptions end the run where they should, and nowhere else.

struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A plan over the cases "0", "1", ... whose subject passes everything.
class Runs : public ::testing::TestWithParam<unsigned> {
 protected:
  static constexpr int count = 50;

  Runs() {
    plan_.jobs = GetParam();
    plan_.next = [this]() -> std::optional<Case> {
      if (next_ == count) return std::nullopt;
      const int i = next_++;
      return Case{std::to_string(i), {{{i, 0, 0}}}, {{{0, 0, 0}}}};
    };
    plan_.worker = [this]() -> Worker {
      ++workers_;
      return {[this](const Case& pair, long) { return examine(pair); }, [this] { ++finished_; }};
    };
    plan_.found = [this](const Case&, const Case& seen, const Outcome& outcome, bool known) {
      EXPECT_EQ(seen.id, outcome.id);
      ++found_[outcome.id + (outcome.variant.empty() ? "" : "~" + outcome.variant) + (known ? " known" : "")];
    };
    plan_.fault = [this](const Case& pair, const std::exception_ptr& error) {
      try {
        std::rethrow_exception(error);
      } catch (const Refused&) {
        ++faults_[pair.id];
      }
    };
    plan_.left_out = [this](const Case&, const std::string&) { ++left_out_; };
  }

  Outcome examine(const Case& pair) {
    std::this_thread::yield();
    if (refuse_ && std::stoi(pair.id) % 10 == 3) throw Refused("no");
    if (break_ && pair.id == "20") throw std::runtime_error("broken");
    Outcome outcome = outcome_for(pair);
    outcome.verdict = Verdict::pass;
    return outcome;
  }

  [[nodiscard]] bool each_once() const {
    return std::ranges::all_of(found_, [](const auto& entry) { return entry.second == 1; });
  }

  RunPlan plan_;
  int next_ = 0;
  std::atomic<unsigned> workers_ = 0, finished_ = 0;
  bool refuse_ = false, break_ = false;
  std::map<std::string, int> found_, faults_;
  int left_out_ = 0;
};

TEST_P(Runs, EachCaseOnce) {
  run(plan_);
  EXPECT_EQ(found_.size(), std::size_t{count});
  EXPECT_TRUE(each_once());
  EXPECT_EQ(workers_, GetParam());
  EXPECT_EQ(finished_, GetParam());
}

TEST_P(Runs, FaultsOfSingleCases) {
  refuse_ = true;
  run(plan_);
  EXPECT_EQ(found_.size(), std::size_t{count - 5});
  EXPECT_EQ(faults_.size(), 5U);
  EXPECT_TRUE(each_once());
}

TEST_P(Runs, OtherFaultsEndIt) {
  break_ = true;
  EXPECT_THROW(run(plan_), std::runtime_error);
  EXPECT_FALSE(found_.contains("20"));
  EXPECT_TRUE(each_once());
  if (GetParam() == 1) {
    EXPECT_EQ(next_, 21) << "no case is taken after it";
  }
}

TEST_P(Runs, SourcesAndExaminersMayFail) {
  plan_.worker = []() -> Worker { throw Refused("no subject"); };
  EXPECT_THROW(run(plan_), Refused);
  EXPECT_TRUE(found_.empty());
}

TEST_P(Runs, VariantsAndWhatIsKnown) {
  plan_.variants = {"swap", "permute"};
  Outcome before = outcome_for({"7", {{{7, 0, 0}}}, {{{0, 0, 0}}}});
  before.verdict = Verdict::pass;
  plan_.known = [&](const std::string& id, const std::string& variant, const std::string& digest) {
    return id == "7" && variant.empty() && digest == before.digest ? &before : nullptr;
  };
  run(plan_);
  EXPECT_EQ(found_.size(), std::size_t{2 * count});
  EXPECT_EQ(left_out_, count) << "single points have no other order";
  EXPECT_TRUE(each_once());
  EXPECT_TRUE(found_.contains("7 known"));
  EXPECT_TRUE(found_.contains("7~swap"));
}

INSTANTIATE_TEST_SUITE_P(Jobs, Runs, ::testing::Values(1U, 2U, 7U));

// The size that cases are brought to.                                          [verify/PROTOCOL.md]

Case segments(const mpq_class& length) { return {"s", Body{{{0, 0, 0}, {length, 0, 0}}}, Body{{{5, 0, 0}}}}; }

TEST(ExponentToFit, TheExtentIsLessThanTheSizeAndAtLeastHalfOfIt) {
  EXPECT_EQ(exponent_to_fit(segments(32), mpq_class(64)), 0);
  EXPECT_EQ(exponent_to_fit(segments(64), mpq_class(64)), -1) << "less than";
  const mpq_class below = 64 - mpq_class(1, 1'000'000'007);
  EXPECT_EQ(exponent_to_fit(segments(below), mpq_class(64)), 0);
  EXPECT_EQ(exponent_to_fit(segments(32 - mpq_class(1, 1'000'000'007)), mpq_class(64)), 1);
  for (const mpq_class& size : {mpq_class(64), mpq_class(1, 3), mpq_class(100'003, 7)})
    for (const mpq_class& length : {mpq_class(1), mpq_class(1, 3), scaled(mpq_class(5, 7), -1074), scaled(3, 1023)}) {
      const mpq_class there = scaled(length, exponent_to_fit(segments(length), size));
      EXPECT_TRUE(there < size && 2 * there >= size) << there << ' ' << size;
    }
  EXPECT_EQ(exponent_to_fit(segments(3), std::nullopt), 0);
  EXPECT_EQ(exponent_to_fit(segments(0), mpq_class(64)), 0) << "a point on a point";
}

TEST(InUnit, LengthsOfAnswersAreScaledAndDirectionsAreNot) {
  Reply reply;
  reply.depth = 3;
  reply.direction = Triple{0, 2, 0};
  reply.witness_b = Triple{1, -5, 0x1p-1074};
  reply.distance = 7;
  reply.contacts = {{{2, 4, 6}, 5.0}, {{1, 1, 1}, {}}};
  const Reply there = in_unit(reply, -1);
  EXPECT_EQ(there.depth, 1.5);
  EXPECT_EQ(there.direction, reply.direction);
  EXPECT_EQ(there.distance, 3.5);
  EXPECT_EQ(there.contacts, (std::vector<ContactPoint>{{{1, 2, 3}, 2.5}, {{0.5, 0.5, 0.5}, {}}}));
  EXPECT_EQ(*there.witness_b, (Triple{0.5, -2.5, 0})) << "rounded once, ties to even";
}

// Two cubes that overlap by 1 in a square: its corners are the contacts, but for one.
TEST(ContactFaults, ComeWithTheirProofsInTheUnitOfTheCase) {
  std::vector<Triple> cube, other;
  for (const double x : {0, 4})
    for (const double y : {0, 4})
      for (const double z : {0, 4}) cube.push_back({x, y, z}), other.push_back({x + 3, y, z});
  const Case seen{"c", Body{GivenPoints(cube)}, Body{GivenPoints(other)}};
  Reply reply;
  reply.overlap = true;
  reply.depth = 0.5;  // in a unit twice as long
  reply.direction = Triple{-1, 0, 0};
  reply.contacts = {{{2, 0, 0}, 0.5}, {{2, 2, 0}, 0.5}, {{2, 2, 2}, 0.5}};
  SubjectInfo info;
  const auto judged = [&] {
    Outcome outcome = outcome_for(seen, -1);
    judge_answer(outcome, seen, {"", reply}, info, {});
    return outcome;
  };
  EXPECT_EQ(judged().verdict, Verdict::pass) << "no extent is promised";
  info.conventions.manifold = ContactLimits();
  const Outcome outcome = judged();
  EXPECT_EQ(outcome.verdict, Verdict::misses_extent);
  EXPECT_EQ(outcome.judgement->findings, std::vector{Verdict::misses_extent});
  ASSERT_EQ(outcome.contact_faults.size(), 1U);
  EXPECT_EQ(outcome.contact_faults[0].sentence, "the contacts miss a corner of the patch by 2.828");
  EXPECT_EQ(outcome.contact_faults[0].missed[0].point, (Point{4, 0, 4}));
  const std::optional<Outcome> read = read_outcome(outcome_line(outcome));
  ASSERT_TRUE(read);
  EXPECT_EQ(outcome_line(*read), outcome_line(outcome));
  info.conventions.manifold->most = 3;
  EXPECT_TRUE(judged().contact_faults.empty());
  reply.contacts[1].position[1] = 3;
  EXPECT_EQ(judged().contact_faults.at(0).finding, Verdict::contact_outside);
  reply.direction = Triple{1, 0, 0};
  EXPECT_TRUE(judged().contact_faults.empty()) << "the sign is wrong, and is told alone";
}

// Cubes of side 4, one 3 along x; A goes on into B at 2, in a unit twice as long at 1.
TEST(Twists, AreAskedForAndJudgedInTheUnitOfTheCase) {
  std::vector<Triple> cube, other;
  for (const double x : {0, 4})
    for (const double y : {0, 4})
      for (const double z : {0, 4}) cube.push_back({x, y, z}), other.push_back({x + 3, y, z});
  const Case asked{"c", Body{GivenPoints(cube)}, Body{GivenPoints(other)}, Motion{{{2, 0, 0}, {}}, {}}};
  const auto subject = [&](const std::string& derivative) {
    std::string said = hello;
    said.insert(said.size() - 1, R"(,"capabilities":{"twist":true},"promises":["derivative"])");
    return SubjectCommand{
        "read x; echo '" + said +
        R"('; while read -r x; do id=${x#*id\":\"}; id=${id%%\"*}; case $x in *stop*) exit 0;; *'"twist":{"a":{"v":[1,0,0],"w":[0,0,0]},"b":{"v":[0,0,0],"w":[0,0,0]}}}') ;; *) exit 7;; esac; )" +
        R"(echo "{\"type\":\"reply\",\"id\":\"$id\",\"overlap\":true)" + derivative + R"(}"; done)"};
  };
  Settings settings;
  settings.fit = 4;  // so that all lengths are halves
  const auto outcome = [&](const std::string& derivative) {
    return Examiner(subject(derivative), settings).examine(asked);
  };
  const Outcome right = outcome(R"(,\"derivative\":1)"), wrong = outcome(R"(,\"derivative\":-1)"), none = outcome("");
  EXPECT_EQ(right.verdict, Verdict::pass) << right.detail;
  EXPECT_EQ(right.judgement->derivative.value().squared, 4);
  EXPECT_EQ(right.judgement->derivative->kinks, std::vector<std::string>{"extended"});
  EXPECT_EQ(wrong.verdict, Verdict::wrong_derivative);
  EXPECT_EQ(wrong.judgement.value().sentence,
            "the derivative is wrong by 4: -2 is claimed, 2 is right; it is the right rate with the other sign");
  EXPECT_EQ(none.verdict, Verdict::inconsistent) << "law: what is promised is there";
  EXPECT_FALSE(none.judgement->derivative);
  EXPECT_EQ(outcome(R"(,\"derivative\":nan)").verdict, Verdict::nan);
  for (const Outcome& each : {right, wrong}) {
    const std::optional<Outcome> read = read_outcome(outcome_line(each));
    ASSERT_TRUE(read);
    EXPECT_EQ(outcome_line(*read), outcome_line(each)) << "law: what was written is read as it was";
  }
  Case still = asked;
  still.motion.reset();
  EXPECT_NE(digest_of(asked), digest_of(still)) << "law: to go on with a report the motion must be the same";
}

TEST(Twists, OfUnionsAreThoseOfTheChosenPair) {
  const auto box = [](double low, double high) {
    std::vector<Triple> points;
    for (const double x : {low, high})
      for (const double y : {0, 4})
        for (const double z : {0, 4}) points.push_back({x, y, z});
    return GivenPoints(points).exact();
  };
  Body both;
  both.pieces = std::make_shared<const Pieces>(Pieces{box(0, 2), box(2, 4)});
  const Case pair{"u", both, Body{box(3, 9)}, Motion{{{2, 0, 0}, {}}, {}}};
  SubjectInfo info;
  info.promises = {"derivative"};
  const Outcome outcome = examine_pairs(pair, 0, info, {}, [](const Case& one, std::optional<SubjectAnswer>& answer) {
    EXPECT_TRUE(one.motion);
    Reply reply;
    reply.overlap = one.id == "u[1,0]";
    if (reply.overlap) reply.depth = 1;
    reply.derivative = reply.overlap ? 2 : 7;
    answer = SubjectAnswer{"", reply};
    return outcome_for(one);
  });
  EXPECT_EQ(outcome.verdict, Verdict::pass) << outcome.judgement.value().sentence;
  EXPECT_EQ(outcome.judgement->derivative.value().claimed, 2);
  EXPECT_EQ(outcome.judgement->derivative->squared, 4);
}

/// Two cubes 1 above a block, or 1 deep in it, as they turn: one comes nearer, one goes away.
TEST(Twists, OfUnionsWithSeveralSuchPairsAreTheLargest) {
  const auto box = [](double left, double right, double low, double high) {
    std::vector<Triple> points;
    for (const double x : {left, right})
      for (const double y : {-4, 4})
        for (const double z : {low, high}) points.push_back({x, y, z});
    return GivenPoints(points).exact();
  };
  const auto outcome = [&](double top, std::array<std::optional<double>, 2> rates, std::optional<double> length = 1) {
    Body both;
    both.pieces = std::make_shared<const Pieces>(Pieces{box(-4, -3, 0, 9), box(3, 4, 0, 9)});
    const Case pair{"u", both, Body{box(-9, 9, -9, top)}, Motion{{{}, {0, 1, 0}}, {}}};
    return examine_pairs(pair, 0, {}, {}, [&](const Case& one, std::optional<SubjectAnswer>& answer) {
      Reply reply;
      reply.overlap = top > 0;
      (top > 0 ? reply.depth : reply.distance) = length;
      reply.derivative = rates.at(one.id == "u[1,0]" ? 1 : 0);
      answer = SubjectAnswer{"", reply};
      return outcome_for(one);
    });
  };
  for (const double top : {-1.0, 1.0}) {
    const Outcome right = outcome(top, {-3, 4});
    EXPECT_EQ(right.verdict, Verdict::pass) << right.judgement.value().sentence;
    EXPECT_EQ(right.judgement->derivative.value().claimed, 4);
    EXPECT_EQ(right.judgement->derivative->squared, 16);
    EXPECT_EQ(outcome(top, {-3, 5}).verdict, Verdict::wrong_derivative);
    EXPECT_EQ(outcome(top, {-3, NAN}).verdict, Verdict::nan);
    EXPECT_FALSE(outcome(top, {-3, std::nullopt}).judgement->derivative);
    EXPECT_FALSE(outcome(top, {std::nullopt, 4}).judgement->derivative);
    EXPECT_FALSE(outcome(top, {-3, 4}, std::nullopt).judgement->derivative) << "which of them counts is not told";
  }
}

// Out of each piece A goes up or sideways by 1, out of both up alone: see proofs/patch.md. The
// replies are right about the pairs, and not enough for the unions.
TEST(Twists, OfUnionsMayBeMoreThanThoseOfAllPairs) {
  const auto box = [](double left, double right, double top) {
    std::vector<Triple> points;
    for (const double x : {left, right})
      for (const double y : {top - 10, top})
        for (const double z : {-9, 9}) points.push_back({x, y, z});
    return GivenPoints(points).exact();
  };
  std::vector<Point> a;
  for (const int x : {0, 4})
    for (const int y : {0, 4})
      for (const int z : {-8, 8}) a.push_back({x, y, z});
  Body both;
  both.pieces = std::make_shared<const Pieces>(Pieces{box(-9, 1, 1), box(3, 13, 1)});
  const Case pair{"u", Body{GivenPoints(a)}, both, Motion{{{0, -1, 0}, {}}, {}}};
  const auto outcome = [&](double rate) {
    return examine_pairs(pair, 0, {}, {}, [rate](const Case& one, std::optional<SubjectAnswer>& answer) {
      Reply reply;
      reply.overlap = true;
      reply.depth = 1;
      reply.derivative = rate;
      answer = SubjectAnswer{"", reply};
      return outcome_for(one);
    });
  };
  const Outcome of_pairs = outcome(0), of_unions = outcome(1);
  EXPECT_EQ(of_pairs.verdict, Verdict::wrong_derivative);
  EXPECT_EQ(of_pairs.judgement->derivative.value().squared, 1);
  EXPECT_EQ(of_pairs.judgement->findings.size(), 1U) << "the depth is right";
  EXPECT_EQ(of_pairs.pieces.value().query.derivative.value().squared, 0);
  EXPECT_EQ(of_pairs.pieces->query.verdict, Verdict::pass);
  EXPECT_EQ(of_unions.verdict, Verdict::pass) << of_unions.judgement->sentence;
  EXPECT_EQ(of_unions.pieces->query.verdict, Verdict::wrong_derivative);
}

TEST(JudgedBodies, AreGrownByTheRadiusOfTheirWord) {
  const Case seen{"c", Body{{{0, 0, 0}, {1, 0, 0}}}, files::body_of(files::named("sphere", {{"radius", {2}}}))};
  SubjectInfo info;
  EXPECT_FALSE(judged_bodies(seen, info, 0).a.shape);
  info.rounding = {{"vertices", mpq_class(1, 2)}};
  EXPECT_EQ(judged_bodies(seen, info, 3).a.shape->radius, mpq_class(1, 16)) << "a length of the subject's unit";
  EXPECT_EQ(judged_bodies(seen, info, 3).b.shape->radius, 2);
  info.rounding = {{"", mpq_class(1, 2)}};
  EXPECT_EQ(judged_bodies(seen, info, 0).b.shape->radius, mpq_class(5, 2));
}

}  // namespace
}  // namespace fathom::harness
