// SPDX-License-Identifier: GPL-3.0-or-later
// Patches and derivatives in C are those of the C++ interface, and of the program's JSON.
#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "fathom/answer.hpp"
#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#include "fathom/patch.hpp"
#include "reference/rounded/coordinates.hpp"
#include "tests/c/unions.hpp"
#include "verify/families/families.hpp"

namespace fathom {
namespace {

using namespace testing;  // handles

using Three = std::array<double, 3>;
constexpr std::array<double, 6> twist_of_a{1, -0.5, 3, 0, 0.25, -2}, twist_of_b{0.5, 2, -1, 1, 0, 2.5};

Twist twist_of(const std::array<double, 6>& x) { return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}}; }

/// A refusal's code, and why.
std::string refused(int code) { return std::to_string(code) + " " + fathom_last_error(); }
std::string absent(const std::string& why) { return std::to_string(FATHOM_ABSENT) + " " + why; }
std::string bad(const std::string& why) { return std::to_string(FATHOM_BAD_INPUT) + " " + why; }

std::string manifold_line(const AnswerHandle& answer, const double* twist_a, const double* twist_b) {
  char* text = nullptr;
  EXPECT_EQ(fathom_answer_manifold_json(answer.get(), "x", twist_a, twist_b, &text), FATHOM_OK) << fathom_last_error();
  return taken(text);
}

void expect_same_patch(const AnswerHandle& answer, std::size_t i, const Patch& expected) {
  std::size_t corners = 0, optimum = 7, pieces[2] = {7, 7};
  double size = -1;
  Three direction{}, a{}, b{};
  ASSERT_EQ(fathom_answer_patch(answer.get(), i, &corners, direction.data(), &size, &optimum, pieces), FATHOM_OK);
  ASSERT_EQ(corners, expected.corners.size());
  EXPECT_EQ(direction, rounded::nearest_unit(expected.direction));
  EXPECT_EQ(size, root_binary64(expected.squared()));
  EXPECT_EQ(optimum, expected.way);
  EXPECT_TRUE(pieces[0] == expected.pieces.first && pieces[1] == expected.pieces.second);
  for (std::size_t k = 0; k < corners; ++k) {
    ASSERT_EQ(fathom_answer_patch_corner(answer.get(), i, k, a.data(), b.data()), FATHOM_OK);
    EXPECT_EQ(a, rounded::nearest_binary64(expected.a(k)));
    EXPECT_EQ(b, rounded::nearest_binary64(expected.b(k)));
  }
  EXPECT_EQ(fathom_answer_patch_corner(answer.get(), i, corners, a.data(), b.data()), FATHOM_BAD_INPUT);
}

void expect_same(const AnswerHandle& answer, const ContactGeometry& expected) {
  std::size_t count = 0;
  ASSERT_EQ(fathom_answer_patches(answer.get(), &count), FATHOM_OK) << fathom_last_error();
  ASSERT_EQ(count, expected.patches.size());
  for (std::size_t i = 0; i < count; ++i) expect_same_patch(answer, i, expected.patches[i]);
  int smooth = -1;
  EXPECT_EQ(fathom_answer_smooth(answer.get(), &smooth), expected.of_unions ? FATHOM_ABSENT : FATHOM_OK);
  EXPECT_EQ(smooth, expected.of_unions ? -1 : expected.smooth() ? 1 : 0);
  Three v{7, 7, 7}, w{7, 7, 7};
  EXPECT_EQ(fathom_answer_gradient(answer.get(), v.data(), w.data()), expected.smooth() ? FATHOM_OK : FATHOM_ABSENT);
  if (expected.smooth()) {
    EXPECT_EQ(v, rounded::nearest_binary64(expected.gradient()->by_translation()));
    EXPECT_EQ(w, rounded::nearest_binary64(expected.gradient()->by_rotation()));
  } else {
    EXPECT_EQ(v[0] + w[2], 14);
  }
  double rate = 7;
  char* text = nullptr;
  const int code = fathom_answer_derivative(answer.get(), twist_of_a.data(), twist_of_b.data(), &rate, &text);
  const auto derivative = directional_derivative(expected, twist_of(twist_of_a), twist_of(twist_of_b));
  if (const auto* const reason = std::get_if<LeftOut>(&derivative)) {
    EXPECT_EQ(refused(code), absent("left out: " + std::string(name(*reason))));
    EXPECT_TRUE(rate == 7 && text == nullptr);
    return;
  }
  const DirectionalDerivative& d = std::get<DirectionalDerivative>(derivative);
  ASSERT_EQ(code, FATHOM_OK) << fathom_last_error();
  EXPECT_EQ(rate, round_binary64(d.value()) + 0.0);
  const std::string exact = taken(text);
  EXPECT_EQ(exact.front() == '-', d.sign() < 0) << exact;
}

TEST(CManifold, EqualsTheCppInterface) {
  std::size_t smooth = 0;
  for (const families::Family& family : families::families()) {
    SCOPED_TRACE(family.name);
    const Case made = family.make(1, 6);
    const ContactGeometry expected = contact_geometry(made.a, made.b, exact_answer(made.a, made.b));
    expect_same(answer_about(exact_body_of(made.a.points.exact()), exact_body_of(made.b.points.exact())), expected);
    smooth += expected.smooth() ? 1 : 0;
  }
  EXPECT_GT(smooth, 20U);
}

TEST(CManifold, OfUnions) {
  const AnswerHandle answer = answer_about(bar(), block());
  std::size_t count = 0, optimum = 7, pieces[2] = {7, 7};
  ASSERT_EQ(fathom_answer_patches(answer.get(), &count), FATHOM_OK);
  EXPECT_EQ(count, 2U);
  ASSERT_EQ(fathom_answer_patch(answer.get(), 1, nullptr, nullptr, nullptr, &optimum, pieces), FATHOM_OK);
  EXPECT_TRUE(optimum == 0 && pieces[0] == 0 && pieces[1] == 1);
  int smooth = -1;
  EXPECT_EQ(refused(fathom_answer_smooth(answer.get(), &smooth)),
            absent("of unions it is not told whether the depth is smooth"));
  double rate = 7;
  const double along[6] = {1, 0, 0, 0, 0, 0}, turning[6] = {0, 0, 0, 0, 0, 1};
  EXPECT_EQ(fathom_answer_derivative(answer.get(), along, nullptr, &rate, nullptr), FATHOM_OK);
  EXPECT_EQ(rate, -1);
  EXPECT_EQ(refused(fathom_answer_derivative(answer.get(), turning, nullptr, &rate, nullptr)),
            absent("left out: exact-fit"));
  EXPECT_NE(manifold_line(answer, turning, nullptr).find("\"derivative\":{\"left_out\":\"exact-fit\"}"),
            std::string::npos);
}

TEST(CManifold, IsTheJsonOfTheProgram) {
  const AnswerHandle answer = answer_about(shape_of("box:half=1:1:1"), shape_of("box:half=1:1:1,at=1:0.5:0.25"));
  const std::string still = manifold_line(answer, nullptr, nullptr);
  const double turning[6] = {0, 0, 0, 0, 0, -1};
  const std::string moving = manifold_line(answer, turning, nullptr), other = manifold_line(answer, nullptr, turning);
  EXPECT_EQ(json_of(answer, "x").find("manifold"), std::string::npos);
  EXPECT_NE(still.find("\"manifold\":{\"patches\":[{\"rank\":2,"), std::string::npos) << still;
  EXPECT_EQ(still.find("derivative"), std::string::npos);
  EXPECT_NE(moving.find("\"derivative\":{\"rate\":{"), std::string::npos) << moving;
  EXPECT_NE(moving, other);
  double rate = 7;
  char* exact = nullptr;
  EXPECT_EQ(fathom_answer_derivative(answer.get(), turning, nullptr, &rate, &exact), FATHOM_OK);
  EXPECT_EQ(taken(exact), "1");
  EXPECT_EQ(rate, 1);
  EXPECT_EQ(refused(fathom_answer_gradient(answer.get(), nullptr, nullptr)),
            absent("the signed depth is not smooth: extended"));
}

TEST(CManifold, WhatIsRefused) {
  const AnswerHandle answer = answer_about(shape_of("sphere:r=1"), shape_of("box:half=1:1:1,at=1.5:0:0"));
  std::size_t count = 7;
  int smooth = 7;
  double rate = 7, v[3] = {7, 7, 7};
  char* text = nullptr;
  const double lost[6] = {0, 0, 0, 0, nan, 0};
  EXPECT_EQ(refused(fathom_answer_derivative(answer.get(), lost, nullptr, &rate, &text)),
            bad("twist_a: expected finite numbers, found nan at index 4"));
  EXPECT_EQ(refused(fathom_answer_manifold_json(answer.get(), nullptr, nullptr, lost, &text)),
            bad("twist_b: expected finite numbers, found nan at index 4"));
  EXPECT_EQ(refused(fathom_answer_patch(answer.get(), 1, &count, nullptr, nullptr, nullptr, nullptr)),
            bad("patch: expected one below 1, the number of patches, found 1"));
  EXPECT_EQ(refused(fathom_answer_patch_corner(answer.get(), 0, 1, v, nullptr)),
            bad("corner: expected one below 1, the number of corners, found 1"));
  for (const int code : {fathom_answer_patches(nullptr, &count), fathom_answer_patches(answer.get(), nullptr),
                         fathom_answer_patch(nullptr, 0, &count, v, v, nullptr, nullptr),
                         fathom_answer_patch_corner(nullptr, 0, 0, v, v), fathom_answer_smooth(nullptr, &smooth),
                         fathom_answer_smooth(answer.get(), nullptr), fathom_answer_gradient(nullptr, v, v),
                         fathom_answer_derivative(nullptr, nullptr, nullptr, &rate, &text),
                         fathom_answer_manifold_json(nullptr, nullptr, nullptr, nullptr, &text),
                         fathom_answer_manifold_json(answer.get(), nullptr, nullptr, nullptr, nullptr)})
    EXPECT_EQ(code, FATHOM_BAD_INPUT);
  const AnswerHandle curved = answer_about(shape_of("cone:r=1,h=1"), shape_of("box:half=1:1:1"));
  EXPECT_EQ(refused(fathom_answer_patches(curved.get(), &count)), absent("left out: curved"));
  EXPECT_EQ(refused(fathom_answer_smooth(curved.get(), &smooth)), absent("left out: curved"));
  EXPECT_EQ(refused(fathom_answer_gradient(curved.get(), v, v)), absent("left out: curved"));
  EXPECT_EQ(refused(fathom_answer_derivative(curved.get(), nullptr, nullptr, &rate, &text)),
            absent("left out: curved"));
  EXPECT_NE(manifold_line(curved, nullptr, nullptr).find("\"left_out\":\"curved\""), std::string::npos);
  EXPECT_TRUE(count == 7 && smooth == 7 && rate == 7 && v[0] == 7 && text == nullptr);
}

TEST(CManifold, ProvedIfAskedFor) {
  fathom_options options;
  fathom_options_init(&options);
  EXPECT_EQ(options.patches, 0);
  options.patches = 1;
  const auto proof = [&](const AnswerHandle& answer, const fathom_options* how) {
    char* text = nullptr;
    EXPECT_EQ(fathom_answer_certificate(answer.get(), "one", how, &text), FATHOM_OK) << fathom_last_error();
    return taken(text);
  };
  for (const families::Family& family : families::families()) {
    const Case made = family.make(1, 6);
    const Answer expected = exact_answer(made.a, made.b);
    const AnswerHandle answer =
        answer_about(exact_body_of(made.a.points.exact()), exact_body_of(made.b.points.exact()));
    const std::string text = proof(answer, &options);
    EXPECT_EQ(text, certificate_text(made.a, made.b, expected, contact_geometry(made.a, made.b, expected), {}, "one"));
    int outcome = -1;
    EXPECT_EQ(fathom_check_certificate(text.data(), text.size(), nullptr, nullptr, &outcome, nullptr), FATHOM_OK);
    EXPECT_EQ(outcome, FATHOM_VERIFIED) << family.name;
    EXPECT_EQ(proof(answer, nullptr), certificate_text(made.a, made.b, expected, "one"));
  }
  const AnswerHandle unions = answer_about(bar(), block()),
                     curved = answer_about(shape_of("cone:r=1,h=1"), shape_of("box:half=1:1:1"));
  for (const AnswerHandle* const answer : {&unions, &curved})
    EXPECT_EQ(proof(*answer, &options), proof(*answer, nullptr));
}

TEST(CManifold, OfASearchThatWasStopped) {
  const BodyHandle a = bar(), b = block();
  std::size_t told = 0, left_out = 0;
  for (int calls = 1; told == 0 && calls < 1000; ++calls) {
    int more = calls;
    fathom_options options;
    fathom_options_init(&options);
    options.stop = [](void* caller) { return --*static_cast<int*>(caller) < 0 ? 1 : 0; };
    options.caller = &more;
    fathom_answer* made = nullptr;
    if (fathom_depth(a.get(), b.get(), &options, &made) != FATHOM_OK) continue;
    const AnswerHandle answer(made);
    std::size_t count = 0;
    const int code = fathom_answer_patches(answer.get(), &count);
    if (code == FATHOM_OK) {
      ++told;
      continue;
    }
    ++left_out;
    EXPECT_EQ(refused(code), absent("left out: incomplete"));
    EXPECT_NE(manifold_line(answer, nullptr, nullptr).find("\"left_out\":\"incomplete\""), std::string::npos);
  }
  EXPECT_GT(told, 0U);
  EXPECT_GT(left_out, 0U);
}

#ifdef FE_UPWARD
TEST(CManifold, AnyRoundingMode) {
  const AnswerHandle answer = answer_about(shape_of("sphere:r=1"), shape_of("box:half=1:1:1,at=1.1:0.3:0.7"));
  const std::string usual = manifold_line(answer, twist_of_a.data(), nullptr);
  std::fesetround(FE_UPWARD);
  const AnswerHandle again = answer_about(shape_of("sphere:r=1"), shape_of("box:half=1:1:1,at=1.1:0.3:0.7"));
  const std::string upward = manifold_line(again, twist_of_a.data(), nullptr);
  Three v{}, w{}, upward_v{}, upward_w{};
  const int code = fathom_answer_gradient(again.get(), upward_v.data(), upward_w.data());
  std::fesetround(FE_TONEAREST);
  ASSERT_EQ(code, FATHOM_OK);
  ASSERT_EQ(fathom_answer_gradient(answer.get(), v.data(), w.data()), FATHOM_OK) << fathom_last_error();
  EXPECT_EQ(upward, usual);
  EXPECT_TRUE(upward_v == v && upward_w == w);
}
#endif

TEST(CManifold, OneAnswerInManyThreads) {
  const AnswerHandle answer = answer_about(shape_of("box:half=1:1:1"), shape_of("box:half=1:2:1,at=1:2:2"));
  std::vector<std::string> found(4);
  {
    std::vector<std::jthread> threads;
    for (std::string& text : found)
      threads.emplace_back([&] { text = manifold_line(answer, twist_of_a.data(), nullptr); });
  }
  for (const std::string& text : found) EXPECT_EQ(text, found.front());
  EXPECT_NE(found.front().find("\"optimal_cone\""), std::string::npos) << found.front();
}

}  // namespace
}  // namespace fathom
