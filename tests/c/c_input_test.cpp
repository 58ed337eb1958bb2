// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that is no input is answered by a code and a message, and what was to be made is NULL.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "fathom/numbers.hpp"
#include "fathom/union.hpp"
#include "tests/c/handles.hpp"
#include "tests/c/unions.hpp"
#include "verify/families/families.hpp"

namespace fathom {
namespace {

using namespace testing;  // handles

/// Makes a body of anything; the message is to hold `expected`, and what was to be made NULL.
template <class Make>
void expect_refused(Make make, const std::string& expected) {
  auto* body = reinterpret_cast<fathom_body*>(1);
  EXPECT_EQ(make(&body), FATHOM_BAD_INPUT) << expected;
  EXPECT_EQ(body, nullptr) << expected;
  EXPECT_NE(std::string(fathom_last_error()).find(expected), std::string::npos)
      << fathom_last_error() << " does not hold " << expected;
}

TEST(CBadInput, Points) {
  const double good[6] = {0, 0, 0, 1, 2, 3};
  const auto points = [](const double* xyz, std::size_t count) {
    return [=](fathom_body** body) { return fathom_body_from_points(xyz, count, body); };
  };
  expect_refused(points(nullptr, 1), "xyz: expected a pointer");
  expect_refused(points(good, 0), "from 1 to 2^31 points, found 0");
  for (const std::size_t count : {SIZE_MAX, SIZE_MAX / 24 + 1, (std::size_t{1} << 31) + 1})
    expect_refused(points(good, count), "2^31");
  for (const double x : {nan, infinity, -infinity}) {
    const double bad[6] = {0, 0, 0, 0, x, 0};
    expect_refused(points(bad, 2), "point 1: expected finite coordinates, found");
  }
  EXPECT_EQ(fathom_body_from_points(good, 2, nullptr), FATHOM_BAD_INPUT);
}

TEST(CBadInput, Numbers) {
  for (const char* const word : {"", "x", "1/0", "1e999999999", "inf", "nan", " 1", "0x", "1,5"}) {
    const char* const numbers[3] = {"0", "0", word};
    expect_refused([&](fathom_body** body) { return fathom_body_from_numbers(numbers, 1, body); },
                   "point 0: expected a number, found");
  }
  const char* const missing[3] = {"0", nullptr, "0"};
  expect_refused([&](fathom_body** body) { return fathom_body_from_numbers(missing, 1, body); }, "found NULL");
}

TEST(CBadInput, Texts) {
  const auto shape = [](const char* text, int decimals = FATHOM_EXACT_DECIMALS) {
    return [=](fathom_body** body) { return fathom_body_from_shape(text, decimals, body); };
  };
  expect_refused(shape(nullptr), "shape: expected a pointer");
  expect_refused(shape("sphere:r=1", 7), "decimals: expected");
  expect_refused(shape(""), "expected one of the shapes");
  expect_refused(shape("ball:r=1"), "expected one of the shapes");
  expect_refused(shape("sphere:r=nan"), "expected a number");
  expect_refused(shape("sphere:r=0"), "radius");
  expect_refused(shape("hull:vertices=1"), "no short form");
  expect_refused(
      [](fathom_body** body) { return fathom_body_from_mesh("no such file.off", FATHOM_EXACT_DECIMALS, body); },
      "no such file.off");
  const auto input = [](const char* word, int meshes = FATHOM_HULL, const char* joints = nullptr, std::size_t paths = 0,
                        int decimals = FATHOM_EXACT_DECIMALS) {
    return [=](fathom_body** body) { return fathom_body_read(word, meshes, joints, nullptr, paths, decimals, body); };
  };
  expect_refused(input(nullptr), "input: expected a pointer");
  expect_refused(input("no such file.off"), "no such file.off");
  expect_refused(input("sphere:r=1", 3), "meshes: expected FATHOM_HULL, FATHOM_PIECES or FATHOM_SOLID, found 3");
  expect_refused(input("sphere:r=1", FATHOM_PIECES), "expected a polytope, found a shape that is none");
  expect_refused(input("sphere:r=1", FATHOM_HULL, "elbow"), "joints: expected values such as");
  expect_refused(input("sphere:r=1", FATHOM_HULL, "elbow=1"), "elbow");
  expect_refused(input("sphere:r=1", FATHOM_HULL, nullptr, 1), "package_paths: expected a pointer");
  expect_refused(input("sphere:r=1", FATHOM_HULL, nullptr, 0, 7), "decimals: expected");
  expect_refused(input(FATHOM_TEST_DATA "/../../examples/data/arm.urdf#hand"), "a link of the robot");
  const auto json = [](const char* text) {
    return [=](fathom_body** body) {
      auto* other = reinterpret_cast<fathom_body*>(1);
      const int code = fathom_bodies_from_case(text, body, &other);
      EXPECT_EQ(other, nullptr);
      return code;
    };
  };
  expect_refused(json(""), "case:");
  expect_refused(json("{\"a\": 1}"), "case:1:");
  expect_refused(json("{\"a\": {\"vertices\": [[0, 0, 1e400]]}, \"b\": {\"vertices\": [[0, 0, 0]]}}"), "a.vertices");
  expect_refused(json(std::string(100'000, '[').c_str()), "case:");
}

TEST(CBadInput, Poses) {
  const BodyHandle a = body_of(cube_at(0)), ball = shape_of("sphere:r=1"), bar = shape_of("capsule:r=1,h=1");
  const double flat[12] = {}, bad[12] = {1, 0, 0, 0, 0, nan, 0, 0, 0, 0, 1, 0};
  const auto moved = [](const BodyHandle& body, const double* pose) {
    return [&body, pose](fathom_body** result) { return fathom_body_moved(body.get(), pose, result); };
  };
  const auto posed = [&](const char* pose) {
    return [&a, pose](fathom_body** r) { return fathom_body_posed(a.get(), pose, 0, r); };
  };
  expect_refused(moved(a, nullptr), "pose: expected a pointer");
  expect_refused(moved(nullptr, flat), "body: expected a pointer");
  expect_refused(moved(a, bad), "at index 5");
  expect_refused(moved(bar, flat), "singular");
  expect_refused(posed(nullptr), "pose: expected a pointer");
  expect_refused(posed("1 2 3"), "pose: expected three rows");
  expect_refused(posed("quat=0,0,0,0"), "quaternion");
  fathom_body* point = nullptr;
  EXPECT_EQ(fathom_body_moved(a.get(), flat, &point), FATHOM_OK);
  fathom_body_free(point);
}

TEST(CBadInput, NullAndForeignOptions) {
  const BodyHandle a = body_of(cube_at(0)), wall = shape_of("halfspace:normal=1:0:0,offset=0");
  fathom_answer* answer = nullptr;
  EXPECT_EQ(fathom_depth(nullptr, a.get(), nullptr, &answer), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_depth(a.get(), nullptr, nullptr, &answer), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_depth(a.get(), a.get(), nullptr, nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_depth(wall.get(), wall.get(), nullptr, &answer), FATHOM_BAD_INPUT);
  EXPECT_NE(std::string(fathom_last_error()).find("half-space"), std::string::npos) << fathom_last_error();
  fathom_options options;
  fathom_options_init(&options);
  options.size = 1;
  EXPECT_EQ(fathom_depth(a.get(), a.get(), &options, &answer), FATHOM_BAD_INPUT);
  fathom_options_init(&options);
  options.bits = 1001;
  EXPECT_EQ(fathom_depth(a.get(), wall.get(), &options, &answer), FATHOM_BAD_INPUT);
  EXPECT_EQ(answer, nullptr);
  EXPECT_EQ(fathom_answer_status(nullptr), -1);
  EXPECT_EQ(fathom_status_name(-1), nullptr);
  EXPECT_EQ(fathom_status_name(4), nullptr);
  EXPECT_EQ(fathom_answer_signed_depth(nullptr, nullptr, nullptr, nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_answer_optima(nullptr), 0U);
  const AnswerHandle good = answer_about(a, a);
  char* text = nullptr;
  EXPECT_EQ(fathom_answer_direction(good.get(), nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_answer_exact(good.get(), 7, &text), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_answer_exact(good.get(), FATHOM_DIRECTION, nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_answer_json(nullptr, nullptr, &text), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_answer_certificate(nullptr, nullptr, nullptr, &text), FATHOM_BAD_INPUT);
  EXPECT_EQ(text, nullptr);
  EXPECT_EQ(fathom_answer_signed_depth(good.get(), nullptr, nullptr, nullptr), FATHOM_OK);
  EXPECT_STREQ(fathom_last_error(), "");
  fathom_body_free(nullptr);
  fathom_answer_free(nullptr);
  fathom_text_free(nullptr);
  fathom_options_init(nullptr);
}

TEST(CBadInput, AbsurdCounts) {
  const BodyHandle a = body_of(cube_at(0));
  const double position[3] = {};
  for (const std::size_t count : {SIZE_MAX, SIZE_MAX / 24 + 1, (std::size_t{1} << 31) + 1}) {
    fathom_claim claim;
    fathom_claim_init(&claim);
    claim.contact_count = count;
    claim.contact_positions = position;
    fathom_judgement judgement;
    fathom_judgement_init(&judgement);
    EXPECT_EQ(fathom_judge(a.get(), a.get(), &claim, &judgement, nullptr), FATHOM_BAD_INPUT);
    EXPECT_NE(std::string(fathom_last_error()).find("at most 2^31 contacts of a claim, found"), std::string::npos)
        << fathom_last_error();
    int outcome = 7;
    EXPECT_EQ(fathom_check_certificate("x", count, nullptr, nullptr, &outcome, nullptr), FATHOM_BAD_INPUT);
    EXPECT_NE(std::string(fathom_last_error()).find("at most 2^31 bytes of a certificate, found"), std::string::npos)
        << fathom_last_error();
    EXPECT_EQ(outcome, 7);
  }
}

// Law: what is handed out is a proof. Every checker refuses to read numbers of more than 100,000
// digits.
TEST(CBadInput, ProofsThatNobodyWouldRead) {
  const char* const wide[12] = {"1e60000", "0", "0", "0", "1", "0", "0", "0", "1", "-1", "-1", "-1"};
  fathom_body* body = nullptr;
  ASSERT_EQ(fathom_body_from_numbers(wide, 4, &body), FATHOM_OK);
  const BodyHandle a(body), b = body_of({0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 1, 0});
  fathom_body* whole = nullptr;
  ASSERT_EQ(fathom_body_from_pieces(&body, 1, &whole), FATHOM_OK);
  const BodyHandle pieces(whole);
  for (const BodyHandle* const other : {&a, &pieces}) {
    const AnswerHandle answer = answer_about(*other, b);
    auto* text = reinterpret_cast<char*>(1);
    EXPECT_EQ(fathom_answer_certificate(answer.get(), "wide", nullptr, &text), FATHOM_ABSENT);
    EXPECT_EQ(text, nullptr);
    EXPECT_NE(std::string(fathom_last_error()).find("a number of more digits than the limit, 100000"),
              std::string::npos);
  }
}

TEST(CBadInput, LongMessagesAreCut) {
  expect_refused([](fathom_body** body) { return fathom_body_from_mesh(std::string(5000, 'x').c_str(), 0, body); },
                 "xxx");
  EXPECT_EQ(std::string(fathom_last_error()).size(), 1023U);
}

// Unions of convex pieces for C: what is refused, what is absent, and searches that are stopped.

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
void expect_call_refused(Call call, const std::string& expected) {
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
  expect_call_refused([&] { return fathom_body_from_pieces(nullptr, 1, &body); }, "pieces: expected a pointer");
  expect_call_refused(made_of({cube.get()}, 0), "from 1 to 2^31 pieces, found 0");
  expect_call_refused(made_of({cube.get()}, SIZE_MAX), "from 1 to 2^31 pieces");
  expect_call_refused(made_of({cube.get(), nullptr}, 2), "piece 1: expected a pointer, found NULL");
  expect_call_refused(made_of({cube.get(), ball.get()}, 2), "piece 1: expected a polytope, found another shape");
  expect_call_refused(made_of({both.get()}, 1), "piece 0: expected a convex body, found a union of pieces");
  fathom_body* const one = cube.get();
  expect_call_refused([&] { return fathom_body_from_pieces(&one, 1, nullptr); }, "the place for the result");
  expect_call_refused([&] { return fathom_body_from_piece_files("no such file.obj", 0, &body); }, "no such file.obj");
  expect_call_refused([&] { return fathom_body_from_piece_files(nullptr, 0, &body); }, "path: expected a pointer");
  expect_call_refused([&] { return fathom_body_from_piece_files(FATHOM_TEST_DATA "/key.obj", 7, &body); },
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
  expect_call_refused([&] { return fathom_depth(cube.get(), flat.get(), nullptr, &answer); }, "piece 1 of B is flat");
  expect_call_refused([&] { return fathom_depth(both.get(), ball.get(), nullptr, &answer); }, "is no union of pieces");
  fathom_claim claim;
  fathom_claim_init(&claim);
  fathom_judgement judgement;
  fathom_judgement_init(&judgement);
  expect_call_refused([&] { return fathom_judge(ball.get(), both.get(), &claim, &judgement, nullptr); },
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
