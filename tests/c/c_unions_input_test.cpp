// SPDX-License-Identifier: GPL-3.0-or-later
// Unions of convex pieces for C: what is refused, what is absent, and searches that are stopped.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "fathom/numbers.hpp"
#include "fathom/union.hpp"
#include "tests/c/unions.hpp"
#include "verify/families/families.hpp"

namespace fathom {
namespace {

using namespace testing;  // handles

// ---- work that is stopped ----

struct Patience {
  int asked = 0, most = 0;
};
int is_out(void* caller) {
  auto& patience = *static_cast<Patience*>(caller);
  return ++patience.asked > patience.most ? 1 : 0;
}

/// What is known of a search that was stopped: bounds, and nothing else.
void expect_bounds_alone(const AnswerHandle& answer, double depth) {
  EXPECT_EQ(fathom_answer_status(answer.get()), FATHOM_PENETRATING);
  double nearest = 0, low = 0, high = 0, xyz[3];
  ASSERT_EQ(fathom_answer_signed_depth(answer.get(), &nearest, &low, &high), FATHOM_OK);
  EXPECT_TRUE(low <= depth && depth <= high && (std::isnan(nearest) || nearest == depth))
      << low << ' ' << high << ", the depth is " << depth;
  EXPECT_EQ(exactly(answer, FATHOM_SIGNED_DEPTH).front(), '[');
  EXPECT_EQ(fathom_answer_translation(answer.get(), xyz), FATHOM_ABSENT);
  EXPECT_EQ(fathom_answer_direction(answer.get(), xyz), FATHOM_ABSENT);
  EXPECT_EQ(fathom_answer_optima(answer.get()), 0U);
  char* text = nullptr;
  EXPECT_EQ(fathom_answer_certificate(answer.get(), nullptr, nullptr, &text), FATHOM_ABSENT);
  EXPECT_NE(std::string(fathom_last_error()).find("stopped"), std::string::npos);
  EXPECT_NE(json_of(answer, nullptr).find("\"complete\":false"), std::string::npos);
}

TEST(CUnions, CanBeStoppedAtAnyTime) {
  const Case made = families::find_family("clusters")->make(1, 4);
  const BodyHandle a = union_of(pieces_of(made.a)), b = union_of(pieces_of(made.b));
  const double depth = root_binary64(union_depth(pieces_of(made.a), pieces_of(made.b)).squared());
  Patience patience;
  fathom_options options;
  fathom_options_init(&options);
  options.stop = is_out;
  options.caller = &patience;
  int nothing = 0, bounds = 0;
  bool done = false;
  for (int most = 0; !done; ++most) {
    patience = {0, most};
    fathom_answer* made_answer = nullptr;
    const int code = fathom_depth(a.get(), b.get(), &options, &made_answer);
    const AnswerHandle answer(made_answer);
    done = patience.asked <= most;
    if (code == FATHOM_INTERRUPTED) {
      EXPECT_TRUE(!answer && bounds == 0) << "law: before there are bounds there is no answer, and later there is";
      ++nothing;
    } else if (code == FATHOM_OK && !done && fathom_answer_optima(answer.get()) == 0) {
      expect_bounds_alone(answer, depth);
      ++bounds;
    } else {
      ASSERT_EQ(code, FATHOM_OK) << fathom_last_error();
      double nearest = 0;
      ASSERT_EQ(fathom_answer_signed_depth(answer.get(), &nearest, nullptr, nullptr), FATHOM_OK);
      EXPECT_EQ(nearest, depth);
    }
  }
  EXPECT_TRUE(nothing > 0 && bounds > 0) << nothing << ' ' << bounds;
}

// ---- what is none ----

template <class Call>
void expect_refused(Call call, const std::string& expected) {
  EXPECT_EQ(call(), FATHOM_BAD_INPUT) << expected;
  EXPECT_NE(std::string(fathom_last_error()).find(expected), std::string::npos)
      << fathom_last_error() << " does not hold " << expected;
}

TEST(CUnions, BadPieces) {
  const BodyHandle cube = body_of(cube_at(0)), ball = shape_of("sphere:r=1"), both = block();
  fathom_body* body = nullptr;
  const auto made_of = [&](std::vector<fathom_body*> pieces, std::size_t count) {
    return [&body, pieces, count] { return fathom_body_from_pieces(pieces.data(), count, &body); };
  };
  expect_refused([&] { return fathom_body_from_pieces(nullptr, 1, &body); }, "pieces: expected a pointer");
  expect_refused(made_of({cube.get()}, 0), "from 1 to 2^31 pieces, found 0");
  expect_refused(made_of({cube.get()}, SIZE_MAX), "from 1 to 2^31 pieces");
  expect_refused(made_of({cube.get(), nullptr}, 2), "piece 1: expected a pointer, found NULL");
  expect_refused(made_of({cube.get(), ball.get()}, 2), "piece 1: expected a polytope, found another shape");
  expect_refused(made_of({both.get()}, 1), "piece 0: expected a convex body, found a union of pieces");
  fathom_body* const one = cube.get();
  expect_refused([&] { return fathom_body_from_pieces(&one, 1, nullptr); }, "the place for the result");
  expect_refused([&] { return fathom_body_from_piece_files("no such file.obj", 0, &body); }, "no such file.obj");
  expect_refused([&] { return fathom_body_from_piece_files(nullptr, 0, &body); }, "path: expected a pointer");
  expect_refused([&] { return fathom_body_from_piece_files(FATHOM_TEST_DATA "/key.obj", 7, &body); },
                 "decimals: expected");
  EXPECT_EQ(body, nullptr);
}

TEST(CUnions, BadQuestions) {
  const BodyHandle cube = body_of(cube_at(0)), ball = shape_of("sphere:r=1"), both = block();
  std::vector<BodyHandle> pieces;
  pieces.push_back(body_of(cube_at(0)));
  pieces.push_back(box_at(0, 0, 0, 1, 0, 1));
  const BodyHandle flat = union_of(pieces);
  fathom_answer* answer = nullptr;
  expect_refused([&] { return fathom_depth(cube.get(), flat.get(), nullptr, &answer); }, "piece 1 of B is flat");
  expect_refused([&] { return fathom_depth(both.get(), ball.get(), nullptr, &answer); }, "is no union of pieces");
  fathom_claim claim;
  fathom_claim_init(&claim);
  fathom_judgement judgement;
  fathom_judgement_init(&judgement);
  expect_refused([&] { return fathom_judge(ball.get(), both.get(), &claim, &judgement, nullptr); },
                 "is no union of pieces");
  const AnswerHandle convex = answer_about(cube, cube), good = answer_about(bar(), both);
  double depth = 7;
  int clearance = -1;
  char* text = nullptr;
  EXPECT_EQ(fathom_answer_deepest_pair(convex.get(), &depth, nullptr), FATHOM_ABSENT);
  EXPECT_EQ(fathom_answer_hulls(convex.get(), &depth), FATHOM_ABSENT);
  EXPECT_EQ(fathom_answer_exact(convex.get(), FATHOM_HULLS, &text), FATHOM_ABSENT);
  EXPECT_EQ(depth, 7);
  EXPECT_EQ(fathom_answer_clearance(convex.get(), 0, &clearance), FATHOM_OK);
  EXPECT_EQ(clearance, 1);
  EXPECT_EQ(fathom_answer_clearance(nullptr, 0, &clearance), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_answer_clearance(good.get(), 0, nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_answer_hulls(good.get(), nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_answer_deepest_pair(nullptr, &depth, nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_answer_deepest_pair(good.get(), nullptr, nullptr), FATHOM_OK);
}

}  // namespace
}  // namespace fathom
