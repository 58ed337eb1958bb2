// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/two_ways.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/harness/fake_subject.hpp"
#include "verify/check/reader.hpp"
#include "verify/families/families.hpp"
#include "verify/harness/journal.hpp"
#include "verify/harness/protocol.hpp"

namespace fathom::harness {
namespace {

using fathom::testing::family_case;

/// The exact method, except for what `change` does to its answer.
Solver planted(std::function<void(const Case&, Depth&)> change) {
  const Solver right = solver_by(Method::exact);
  return {"planted", [=](const Case& pair, Monitor* monitor) {
            Depth depth = right.depth(pair, monitor);
            change(pair, depth);
            return depth;
          }};
}

/// The name of a folder that is there while this object lives.
struct Folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / ("two_ways_test." + std::to_string(::getpid()));
  ~Folder() { std::filesystem::remove_all(path); }
};

TEST(TwoWays, AgreeOnEveryFamilyAndTheCatalogue) {
  std::vector<Case> cases;
  for (const families::Family& family : families::families()) cases.push_back(family.make(5, 12));
  for (const families::CatalogueEntry& entry : families::catalogue()) cases.push_back(entry.pair);
  for (const Case& pair : cases)
    for (const Method method : {Method::exact, Method::naive})
      EXPECT_EQ(difference(pair, solver_with_proof(), solver_by(method)).value_or(""), "") << pair.id;
}

TEST(TwoWays, SayWhatDiffersAndWhoThrew) {
  const Case pair = family_case("random_ball", 8, 4);
  const Solver flat = planted([](const Case&, Depth& depth) { depth.flat_b = true; });
  EXPECT_EQ(difference(pair, solver_by(Method::automatic), flat), "automatic and planted differ: flat_b: no and yes");
  const Solver mute = planted([](const Case&, Depth&) { throw std::logic_error("broken law: x"); });
  EXPECT_EQ(difference(pair, solver_by(Method::automatic), mute), "planted gave no answer: broken law: x");
  EXPECT_EQ(difference(pair, mute, flat), "planted gave no answer: broken law: x");
  const Solver stopped = planted([](const Case&, Depth&) { throw Interrupted(); });
  EXPECT_THROW(difference(pair, flat, stopped), Interrupted);
}

TEST(TwoWays, AProofOfAnotherAnswerIsNone) {
  const Case pair = family_case("random_ball", 8, 4);
  Depth right = penetration_depth(pair.a.points, pair.b.points);
  EXPECT_NE(accepted_certificate(pair, right), "");
  Depth flat = right;
  auto& inner = std::get<Penetration>(flat.outcome).inner;
  ASSERT_TRUE(inner);
  inner->facets.pop_back();
  EXPECT_THROW(accepted_certificate(pair, flat), std::logic_error);
}

TEST(TwoWays, AProofThatNoCheckerWouldReadIsNone) {
  Case pair = family_case("random_ball", 8, 4);
  mpz_ui_pow_ui(pair.a.points.edit().front().x.get_num_mpz_t(), 10, 200000);
  pair.a.points.edit().front().x.canonicalize();
  EXPECT_THROW(accepted_certificate(pair, nullptr), fathom_check::Unreadable);
}

TEST(TwoWays, TheDistanceIsProvedToo) {
  const Case pair = family_case("random_disjoint", 8, 4);
  Depth right = penetration_depth(pair.a.points, pair.b.points);
  EXPECT_NE(accepted_certificate(pair, right).find("\nclaim apart " + right.distance()->squared.get_str() + "\n"),
            std::string::npos);
  std::get<Distance>(right.outcome).squared *= 4;
  EXPECT_THROW(accepted_certificate(pair, right), std::logic_error);
}

TEST(KeepDifference, MakesItSmallAndWritesIt) {
  const Folder folder;
  const Solver wrong = planted([](const Case& shown, Depth& depth) {
    if (auto* penetration = std::get_if<Penetration>(&depth.outcome); penetration && shown.b.points.size() > 4)
      penetration->optima.front().support += 1;
  });
  const Solver fast = solver_by(Method::automatic);
  const Case pair = family_case("random_sphere", 20, 1);
  const std::string sentence = difference(pair, fast, wrong).value();
  const KeptDifference kept = keep_difference(folder.path, pair, sentence, fast, wrong);
  EXPECT_EQ(kept.pair.b.points.size(), 5u);
  EXPECT_EQ(kept.pair.a.points.size(), 4u);
  EXPECT_EQ(difference(kept.pair, fast, wrong), kept.sentence);
  std::ifstream in(kept.path);
  CaseStream cases(in, kept.path);
  const Case read = cases.next().value().value();
  EXPECT_EQ(read.id, pair.id);
  EXPECT_EQ(read.a.points, kept.pair.a.points);
  EXPECT_EQ(read.b.points, kept.pair.b.points);
}

/// A difference that rounding takes away is kept as it is, and so is one whose search is stopped.
TEST(KeepDifference, KeepsWhatCannotBeMadeSmaller) {
  const Folder folder;
  const Case third{"third", {{{0, 0, 0}, {mpq_class(1, 3), 0, 0}}}, {{{0, 1, 0}, {0, 2, 0}}}};
  const Solver wrong =
      planted([](const Case& shown, Depth& depth) { depth.flat_a = shown.a.points[1].x != mpq_class(1, 3); });
  const KeptDifference kept = keep_difference(folder.path, third, "they differ", solver_by(Method::automatic), wrong);
  EXPECT_EQ(kept.pair.a.points, third.a.points);
  EXPECT_EQ(kept.sentence, "they differ");
  const Case ball = family_case("random_ball", 20, 4);
  const Solver always = planted([](const Case&, Depth& depth) { depth.flat_a = !depth.flat_a; });
  const KeptDifference stopped =
      keep_difference(folder.path, ball, "x", solver_by(Method::automatic), always, [] { return true; });
  EXPECT_EQ(stopped.pair.a.points.size(), ball.a.points.size());
}

TEST(JudgeAnswer, FindsTruthAndJudgementAgain) {
  const Case pair = family_case("boxes_posed", 8, 1);
  const Truth truth = truth_about(pair.a.points, pair.b.points);
  ASSERT_EQ(truth.depth.status(), Status::penetrating);
  Reply reply = fathom::testing::right_reply(truth.depth);
  reply.direction = Triple{
      0.6, 0, 0.8};  // its exit distance is found by the certificate's polytope in one way, by a ray in the other
  const SubjectAnswer answer{"1", reply};
  const auto judged = [&](std::vector<Solver> second) {
    Outcome outcome = outcome_for(pair);
    judge_answer(outcome, pair, answer, {}, {{}, std::move(second), {}});
    return outcome;
  };
  const Outcome once = judged({}), twice = judged({solver_by(Method::exact), solver_by(Method::naive)});
  ASSERT_TRUE(twice.judgement->exit_distance_squared);
  EXPECT_EQ(difference(*once.judgement, *twice.judgement), std::nullopt);
  const Solver deeper =
      planted([](const Case&, Depth& depth) { std::get<Penetration>(depth.outcome).optima.front().support *= 2; });
  try {
    judged({solver_by(Method::exact), deeper});
    FAIL() << "no disagreement";
  } catch (const Disagreement& found) {
    EXPECT_EQ(found.pair.id, pair.id);
    EXPECT_EQ(found.second.name, "planted");
    EXPECT_TRUE(std::string_view(found.what()).starts_with("automatic and planted differ: squared: ")) << found.what();
  }
}

TEST(JudgementDifference, NamesTheField) {
  const Case pair = family_case("boxes_posed", 8, 1);
  const Truth truth = truth_about(pair.a.points, pair.b.points);
  const Judgement right = judge(truth, fathom::testing::right_reply(truth.depth));
  EXPECT_EQ(difference(right, right), std::nullopt);
  const auto expect_named = [&](const std::string& field, const std::function<void(Judgement&)>& change) {
    Judgement wrong = right;
    change(wrong);
    for (const auto& sentence : {difference(right, wrong), difference(wrong, right)})
      EXPECT_TRUE(sentence && sentence->starts_with("judgement." + field + ": "))
          << field << " / " << sentence.value_or("none");
  };
  expect_named("verdict", [](Judgement& j) { j.verdict = Verdict::too_deep; });
  expect_named("findings", [](Judgement& j) { j.findings.push_back(Verdict::nan); });
  expect_named("accuracy", [](Judgement& j) { j.accuracy.reset(); });
  expect_named("depth_squared", [](Judgement& j) { j.depth_squared += 1; });
  expect_named("error", [](Judgement& j) { j.error = 0.5; });
  expect_named("exit_distance_squared", [](Judgement& j) { j.exit_distance_squared.reset(); });
  expect_named("sentence", [](Judgement& j) { j.sentence += "x"; });
}

}  // namespace
}  // namespace fathom::harness
