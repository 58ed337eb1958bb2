// SPDX-License-Identifier: GPL-3.0-or-later
// The library for C gives what the C++ interface gives.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#include "tests/c/handles.hpp"
#include "tests/support/stated_cases.hpp"
#include "verify/families/families.hpp"

namespace fathom {
namespace {

using namespace testing;  // handles

using Numbers = std::vector<double>;

Numbers direction_of(const AnswerHandle& answer) {
  Numbers xyz(3, nan);
  EXPECT_EQ(fathom_answer_direction(answer.get(), xyz.data()), FATHOM_OK) << fathom_last_error();
  return xyz;
}

Numbers translation_of(const AnswerHandle& answer) {
  Numbers xyz(3, nan);
  EXPECT_EQ(fathom_answer_translation(answer.get(), xyz.data()), FATHOM_OK) << fathom_last_error();
  return xyz;
}

struct Rounded {
  double nearest = 0, low = 0, high = 0;
};
Rounded depth_of(const AnswerHandle& answer) {
  Rounded value;
  EXPECT_EQ(fathom_answer_signed_depth(answer.get(), &value.nearest, &value.low, &value.high), FATHOM_OK)
      << fathom_last_error();
  return value;
}

// ---- answers ----

TEST(CDepth, PenetratingCubes) {
  const AnswerHandle answer = answer_about(body_of(cube_at(0)), body_of(cube_at(0.75)));
  EXPECT_EQ(fathom_answer_status(answer.get()), FATHOM_PENETRATING);
  const Rounded depth = depth_of(answer);
  EXPECT_TRUE(depth.nearest == 0.25 && depth.low == 0.25 && depth.high == 0.25);
  EXPECT_EQ(direction_of(answer), (Numbers{-1, 0, 0}));
  EXPECT_EQ(translation_of(answer), (Numbers{-0.25, 0, 0}));
  Numbers a(3), b(3);
  ASSERT_EQ(fathom_answer_witness(answer.get(), a.data(), b.data()), FATHOM_OK);
  EXPECT_TRUE(a[0] == 1 && b[0] == 0.75);
  EXPECT_EQ(exactly(answer, FATHOM_WITNESS_A).substr(0, 2), "1 ");
  EXPECT_EQ(exactly(answer, FATHOM_WITNESS_B).substr(0, 4), "3/4 ");
  EXPECT_EQ(exactly(answer, FATHOM_SIGNED_DEPTH), "1/4");
  EXPECT_EQ(exactly(answer, FATHOM_DIRECTION), "-1 0 0");
  EXPECT_EQ(exactly(answer, FATHOM_TRANSLATION), "-1/4 0 0");
  ASSERT_EQ(fathom_answer_optima(answer.get()), 1U);
  Numbers direction(3), translation(3);
  ASSERT_EQ(fathom_answer_optimum(answer.get(), 0, direction.data(), translation.data()), FATHOM_OK);
  EXPECT_EQ(direction, direction_of(answer));
  EXPECT_EQ(translation, translation_of(answer));
}

TEST(CDepth, TouchingAndDisjointCubes) {
  const AnswerHandle touching = answer_about(body_of(cube_at(0)), body_of(cube_at(1)));
  EXPECT_EQ(fathom_answer_status(touching.get()), FATHOM_TOUCHING);
  EXPECT_EQ(exactly(touching, FATHOM_SIGNED_DEPTH), "0");
  EXPECT_EQ(translation_of(touching), (Numbers{0, 0, 0}));
  const AnswerHandle apart = answer_about(body_of(cube_at(0)), body_of(cube_at(3)));
  EXPECT_EQ(fathom_answer_status(apart.get()), FATHOM_DISJOINT);
  EXPECT_EQ(depth_of(apart).nearest, -2);
  EXPECT_EQ(translation_of(apart), (Numbers{2, 0, 0}));
  EXPECT_EQ(exactly(apart, FATHOM_WITNESS_A).substr(0, 2), "1 ");
  EXPECT_EQ(fathom_answer_optima(apart.get()), 0U);
}

TEST(CDepth, EqualsTheCppInterface) {
  for (const families::Family& family : families::families()) {
    const Case made = family.make(1, 6);
    const AnswerHandle answer =
        answer_about(exact_body_of(made.a.points.exact()), exact_body_of(made.b.points.exact()));
    const Depth expected = penetration_depth(made.a, made.b);
    EXPECT_EQ(fathom_answer_status(answer.get()), static_cast<int>(expected.status())) << family.name;
    const Surd value{0, signed_square(expected)};
    const Rounded depth = depth_of(answer);
    EXPECT_EQ(depth.nearest, round_binary64(value)) << family.name;
    EXPECT_EQ(depth.low, round_binary64(value, Rounding::rd)) << family.name;
    EXPECT_EQ(depth.high, round_binary64(value, Rounding::ru)) << family.name;
    EXPECT_EQ(fathom_answer_optima(answer.get()), expected.optima().size()) << family.name;
    const Vector& n = expected.direction();
    EXPECT_EQ(exactly(answer, FATHOM_DIRECTION), n.x.get_str() + " " + n.y.get_str() + " " + n.z.get_str())
        << family.name;
    char* certificate = nullptr;
    ASSERT_EQ(fathom_answer_certificate(answer.get(), "one", nullptr, &certificate), FATHOM_OK) << fathom_last_error();
    EXPECT_EQ(taken(certificate), certificate_text(made.a, made.b, expected, "one")) << family.name;
  }
}

TEST(CDepth, RealCasesHaveTheStatedAnswers) {
  using Json = nlohmann::json;
  std::size_t cases = 0;
  for (const auto& [pair, line, stated] : stated_cases()) {
    SCOPED_TRACE(pair.id);
    fathom_body *first = nullptr, *second = nullptr;
    ASSERT_EQ(fathom_bodies_from_case(line.c_str(), &first, &second), FATHOM_OK) << fathom_last_error();
    const AnswerHandle answer = answer_about(BodyHandle(first), BodyHandle(second));
    char* text = nullptr;
    ASSERT_EQ(fathom_answer_json(answer.get(), pair.id.c_str(), &text), FATHOM_OK) << fathom_last_error();
    const Json json = Json::parse(taken(text));
    EXPECT_EQ(json["status"], stated["status"]);
    EXPECT_EQ(json["depth"]["squared"], stated["depth_squared"]);
    Json translations = Json::array();
    for (const Json& optimum : json["optima"]) translations.push_back(optimum["translation"]);
    std::sort(translations.begin(), translations.end());
    if (!translations.empty()) {
      EXPECT_EQ(translations, stated["translations"]);
    }
    if (stated.contains("signed_depth")) {
      const Rounded depth = depth_of(answer);
      EXPECT_EQ((Json{{"low", depth.low}, {"high", depth.high}}),
                (Json{{"low", stated["signed_depth"]["low"]}, {"high", stated["signed_depth"]["high"]}}));
      if (json.contains("signed_depth")) {
        EXPECT_EQ(json["signed_depth"], stated["signed_depth"]);
      }
    }
    ++cases;
  }
  EXPECT_EQ(cases, 63U + 141U);
}

TEST(CDepth, RoundBodiesAreExact) {
  const AnswerHandle answer = answer_about(shape_of("sphere:r=1"), shape_of("sphere:r=2,at=1:1:0"));
  EXPECT_EQ(exactly(answer, FATHOM_SIGNED_DEPTH), "-sqrt(2)+3");
  EXPECT_EQ(exactly(answer, FATHOM_TRANSLATION), "-sqrt(9/2)+1 -sqrt(9/2)+1 0");
  const Rounded depth = depth_of(answer);
  EXPECT_EQ(depth.nearest, round_binary64(Surd{3, -2}));
  EXPECT_EQ(depth.high, std::nextafter(depth.low, infinity));
  EXPECT_EQ(fathom_answer_optima(answer.get()), 1U);
}

TEST(CDepth, CurvedBodiesAreEnclosed) {
  const BodyHandle cone = shape_of("cone:r=1,h=1"),
                   tilted = shape_of("cylinder:r=1,h=1,at=0.3:0.2:0.9,quaternion=3:1:2:1");
  const AnswerHandle answer = answer_about(cone, tilted);
  const Rounded depth = depth_of(answer);
  EXPECT_LT(depth.low, depth.high);
  EXPECT_EQ(exactly(answer, FATHOM_SIGNED_DEPTH).front(), '[');
  double xyz[3] = {7, 7, 7};
  EXPECT_EQ(fathom_answer_translation(answer.get(), xyz), FATHOM_ABSENT);
  EXPECT_NE(std::string(fathom_last_error()), "");
  EXPECT_EQ(xyz[0], 7);
  EXPECT_EQ(fathom_answer_optima(answer.get()), 0U);
  fathom_options options;
  fathom_options_init(&options);
  options.bits = 100;
  const AnswerHandle closer = answer_about(cone, tilted, &options);
  EXPECT_FALSE(std::isnan(depth_of(closer).nearest));
}

TEST(CDepth, Json) {
  const AnswerHandle answer = answer_about(body_of(cube_at(0)), shape_of("sphere:r=1"));
  char* json = nullptr;
  ASSERT_EQ(fathom_answer_json(answer.get(), "a \"name\"", &json), FATHOM_OK);
  const std::string text = taken(json);
  EXPECT_EQ(text.find("{\"schema\":\"fathom/result/2\""), 0U) << text;
  EXPECT_NE(text.find("\"id\":\"a \\\"name\\\"\""), std::string::npos) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(CDepth, ListedOptima) {
  fathom_options options;
  fathom_options_init(&options);
  options.optima = 2;
  const AnswerHandle answer = answer_about(body_of(cube_at(0)), body_of(cube_at(0)), &options);
  EXPECT_EQ(fathom_answer_optima(answer.get()), 2U);
  double xyz[3];
  EXPECT_EQ(fathom_answer_optimum(answer.get(), 2, xyz, nullptr), FATHOM_BAD_INPUT);
}

// ---- without the depth ----

std::string overlap_of(const BodyHandle& a, const BodyHandle& b) {
  int status = -1, again = -1;
  char* proof = nullptr;
  EXPECT_EQ(fathom_overlap(a.get(), b.get(), nullptr, &status, &proof), FATHOM_OK) << fathom_last_error();
  EXPECT_EQ(fathom_overlap(a.get(), b.get(), nullptr, &again, nullptr), FATHOM_OK);
  EXPECT_EQ(again, status);
  return std::string(fathom_status_name(status)) + "\n" + taken(proof);
}

TEST(COverlap, SaysWhereBodiesAreAndWhy) {
  const BodyHandle cube = body_of(cube_at(0));
  EXPECT_EQ(overlap_of(cube, body_of(cube_at(1))), "touching\ncommon 1 0 0\nnormal -1 0 0\n");
  EXPECT_EQ(overlap_of(cube, body_of(cube_at(3))), "disjoint\nnormal -1 0 0\n");
  EXPECT_EQ(overlap_of(cube, body_of(cube_at(0.5))).find("penetrating\ncommon "), 0U);
  EXPECT_NE(overlap_of(cube, body_of(cube_at(0.5))).find("\naround "), std::string::npos);
  int status = -1;
  char* proof = nullptr;
  const BodyHandle ball = shape_of("sphere:r=1");
  EXPECT_EQ(fathom_overlap(cube.get(), ball.get(), nullptr, &status, nullptr), FATHOM_OK);
  EXPECT_EQ(status, FATHOM_PENETRATING);
  EXPECT_EQ(fathom_overlap(cube.get(), ball.get(), nullptr, &status, &proof), FATHOM_BAD_INPUT);
  EXPECT_EQ(proof, nullptr);
  EXPECT_EQ(fathom_overlap(cube.get(), nullptr, nullptr, &status, nullptr), FATHOM_BAD_INPUT);
}

TEST(CCloser, ExcludesTheDistanceItself) {
  const BodyHandle cube = body_of(cube_at(0)), other = body_of(cube_at(3));
  const auto closer = [&](double distance, const std::string& why) {
    int result = -1, again = -1;
    char* proof = nullptr;
    EXPECT_EQ(fathom_closer_than(cube.get(), other.get(), distance, nullptr, &result, &proof), FATHOM_OK);
    EXPECT_EQ(fathom_closer_than(cube.get(), other.get(), distance, nullptr, &again, nullptr), FATHOM_OK);
    EXPECT_EQ(again, result);
    EXPECT_EQ(taken(proof), why);
    return result;
  };
  EXPECT_EQ(closer(2, "normal -1 0 0\n"), 0);
  EXPECT_EQ(closer(std::nextafter(2, 3), "points 1 0 0 3 0 0\n"), 1);
  int result = -1;
  for (const double distance : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_EQ(fathom_closer_than(cube.get(), other.get(), distance, nullptr, &result, nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(result, -1);
}

struct EndPrepared {
  void operator()(fathom_prepared* prepared) const { fathom_prepared_free(prepared); }
};
using PreparedHandle = std::unique_ptr<fathom_prepared, EndPrepared>;

PreparedHandle prepared_of(const BodyHandle& body) {
  fathom_prepared* prepared = nullptr;
  EXPECT_EQ(fathom_prepare(body.get(), &prepared), FATHOM_OK) << fathom_last_error();
  return PreparedHandle(prepared);
}

// As if fathom_body_moved had moved them.
TEST(CPrepared, EveryPose) {
  const BodyHandle still = body_of({0, 0, 0, 1, 0.125, 0, 0.25, 1, 0, 0, 0.25, 1, 1, 0, 0.75, 0.75, 1, 1.5});
  const BodyHandle other = body_of({0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1, 0.25, 0.25, 0.25, 0.75, 0.75, 0.125});
  const PreparedHandle a = prepared_of(still), b = prepared_of(other);
  fathom_warm_start start = {};
  double pose[12] = {0.75, 0.5, 0, 0.875, -0.5, 0.75, 0.125, 0, 0, 0.125, 1, 0};
  for (int step = 0; step < 8; ++step) {
    pose[3] += 0.125;
    fathom_body* moved = nullptr;
    fathom_answer* made = nullptr;
    ASSERT_EQ(fathom_body_moved(other.get(), pose, &moved), FATHOM_OK);
    const BodyHandle there(moved);
    ASSERT_EQ(fathom_prepared_depth(a.get(), nullptr, b.get(), pose, step % 3 == 0 ? nullptr : &start, nullptr, &made),
              FATHOM_OK)
        << fathom_last_error();
    const AnswerHandle answer(made), plain = answer_about(still, there);
    for (const int quantity : {FATHOM_SIGNED_DEPTH, FATHOM_DIRECTION, FATHOM_TRANSLATION, FATHOM_WITNESS_A})
      EXPECT_EQ(exactly(answer, quantity), exactly(plain, quantity));
    char *proof = nullptr, *plain_proof = nullptr;
    EXPECT_EQ(fathom_answer_certificate(answer.get(), "", nullptr, &proof), FATHOM_OK);
    EXPECT_EQ(fathom_answer_certificate(plain.get(), "", nullptr, &plain_proof), FATHOM_OK);
    EXPECT_EQ(taken(proof), taken(plain_proof));
    int status = -1, closer = -1, plain_closer = -2;
    EXPECT_EQ(fathom_prepared_overlap(a.get(), nullptr, b.get(), pose, nullptr, &status), FATHOM_OK);
    EXPECT_EQ(status, fathom_answer_status(plain.get()));
    EXPECT_EQ(fathom_prepared_closer_than(a.get(), nullptr, b.get(), pose, 0.25, nullptr, &closer), FATHOM_OK);
    EXPECT_EQ(fathom_closer_than(still.get(), there.get(), 0.25, nullptr, &plain_closer, nullptr), FATHOM_OK);
    EXPECT_EQ(closer, plain_closer);
  }
  EXPECT_GT(start.count, 0U);
}

TEST(CPrepared, BadInput) {
  const PreparedHandle cube = prepared_of(body_of(cube_at(0)));
  fathom_prepared* none = cube.get();
  EXPECT_EQ(fathom_prepare(shape_of("sphere:r=1").get(), &none), FATHOM_BAD_INPUT);
  EXPECT_EQ(none, nullptr);
  EXPECT_EQ(fathom_prepare(nullptr, &none), FATHOM_BAD_INPUT);
  fathom_answer* answer = nullptr;
  const auto refused = [&](const double* pose, fathom_warm_start start) {
    EXPECT_EQ(fathom_prepared_depth(cube.get(), pose, cube.get(), nullptr, &start, nullptr, &answer), FATHOM_BAD_INPUT);
    return std::string(fathom_last_error());
  };
  const double lost[12] = {1, 0, 0, nan, 0, 1, 0, 0, 0, 0, 1, 0};
  EXPECT_EQ(refused(lost, {}), "pose_a: expected finite numbers, found nan at index 3");
  EXPECT_EQ(refused(nullptr, {9, {}, {}}), "start: expected at most 8 differences, found 9");
  EXPECT_EQ(refused(nullptr, {1, {8}, {0}}), "a warm start names the points 8 and 0, but the bodies have 8 and 8");
  int status = 7, closer = 7;
  EXPECT_EQ(fathom_prepared_overlap(cube.get(), lost, cube.get(), nullptr, nullptr, &status), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_prepared_closer_than(cube.get(), nullptr, cube.get(), nullptr, infinity, nullptr, &closer),
            FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_prepared_closer_than(nullptr, nullptr, cube.get(), nullptr, 1, nullptr, &closer), FATHOM_BAD_INPUT);
  EXPECT_EQ(status + closer, 14);
  fathom_prepared_free(nullptr);
}

TEST(CDepth, CanBeStopped) {
  fathom_options options;
  fathom_options_init(&options);
  options.stop = [](void* caller) { return ++*static_cast<int*>(caller); };
  int asked = 0;
  options.caller = &asked;
  const BodyHandle a = shape_of("cone:r=1,h=1"), b = shape_of("cylinder:r=1,h=1,at=0.3:0.2:0.9,quaternion=3:1:2:1");
  fathom_answer* answer = nullptr;
  EXPECT_EQ(fathom_depth(a.get(), b.get(), &options, &answer), FATHOM_INTERRUPTED);
  EXPECT_EQ(answer, nullptr);
  EXPECT_GT(asked, 0);
}

TEST(CDepth, OneBodyInManyThreads) {
  const BodyHandle a = shape_of("capsule:r=0.1,h=1"), b = body_of(cube_at(0.1));
  std::vector<std::string> found(4);
  std::vector<std::thread> threads;
  for (std::string& text : found)
    threads.emplace_back([&] { text = exactly(answer_about(a, b), FATHOM_SIGNED_DEPTH); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(std::set<std::string>(found.begin(), found.end()).size(), 1U);
  EXPECT_FALSE(found.front().empty());
}

#ifdef FE_UPWARD
TEST(CDepth, AnyRoundingMode) {
  const AnswerHandle in_default_mode = answer_about(body_of(cube_at(0.1)), body_of(cube_at(0.7)));
  const std::string usual = exactly(in_default_mode, FATHOM_WITNESS_B);
  const double expected = depth_of(in_default_mode).nearest;
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const std::vector<double> a = cube_at(0.1), b = cube_at(0.7);
    std::fesetround(mode);
    const AnswerHandle answer = answer_about(body_of(a), body_of(b));
    const std::string text = exactly(answer, FATHOM_WITNESS_B);
    const double depth = depth_of(answer).nearest;
    const int after = std::fegetround();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(text, usual);
    EXPECT_EQ(depth, expected);
    EXPECT_EQ(after, mode);
  }
}
#endif

// ---- certificates ----

TEST(CCheck, Outcomes) {
  const BodyHandle a = body_of(cube_at(0)), b = body_of(cube_at(0.75)), ball = shape_of("sphere:r=1");
  char* certificate = nullptr;
  ASSERT_EQ(fathom_answer_certificate(answer_about(a, b).get(), nullptr, nullptr, &certificate), FATHOM_OK);
  const std::string text = taken(certificate);
  const auto outcome = [](const std::string& checked, const fathom_body* first, const fathom_body* second,
                          const std::string& begin) {
    int result = -1;
    char* line = nullptr;
    EXPECT_EQ(fathom_check_certificate(checked.data(), checked.size(), first, second, &result, &line), FATHOM_OK)
        << fathom_last_error();
    EXPECT_EQ(taken(line).find(begin), 0U);
    return result;
  };
  EXPECT_EQ(outcome(text, nullptr, nullptr, "s VERIFIED penetrating depth_squared=1/16"), FATHOM_VERIFIED);
  EXPECT_EQ(outcome(text, a.get(), b.get(), "s VERIFIED "), FATHOM_VERIFIED);
  EXPECT_EQ(outcome(text, b.get(), a.get(), "s REFUSED "), FATHOM_REFUSED);
  EXPECT_EQ(outcome("", nullptr, nullptr, "s MALFORMED "), FATHOM_MALFORMED);
  EXPECT_EQ(outcome(text + text, a.get(), b.get(), "s MALFORMED "), FATHOM_MALFORMED);
  EXPECT_EQ(outcome(text.substr(0, text.size() / 2), nullptr, nullptr, "s MALFORMED "), FATHOM_MALFORMED);
  EXPECT_EQ(outcome(std::string(100, '\0'), nullptr, nullptr, "s MALFORMED "), FATHOM_MALFORMED);
  std::string forged = text;
  forged.replace(forged.find("1/16"), 4, "1/17");
  EXPECT_EQ(outcome(forged, nullptr, nullptr, "s REFUSED "), FATHOM_REFUSED);
  int result = 9;
  EXPECT_EQ(fathom_check_certificate(text.data(), text.size(), a.get(), nullptr, &result, nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_check_certificate(text.data(), text.size(), a.get(), ball.get(), &result, nullptr),
            FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_check_certificate(nullptr, 5, nullptr, nullptr, &result, nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_check_certificate(text.data(), text.size(), nullptr, nullptr, nullptr, nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(result, 9);
}

}  // namespace
}  // namespace fathom
