// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that is no input is answered by a code and a message, and what was to be made is NULL.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "tests/c/handles.hpp"

namespace fathom {
namespace {

using namespace testing;  // handles

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

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

}  // namespace
}  // namespace fathom
