// SPDX-License-Identifier: GPL-3.0-or-later
// Unions of convex pieces for C: what the C++ interface gives.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cfenv>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#include "fathom/union.hpp"
#include "tests/c/unions.hpp"
#include "verify/families/families.hpp"

namespace fathom {
namespace {

using namespace testing;  // handles

std::string text_of(const Point& p) { return exact_text(p.x) + " " + exact_text(p.y) + " " + exact_text(p.z); }

// ---- meshes that are not their hulls ----

std::string dents(const fathom_body* a, const fathom_body* b, int expected) {
  fathom_answer* answer = nullptr;
  EXPECT_EQ(fathom_depth(a, b, nullptr, &answer), FATHOM_OK) << fathom_last_error();
  char* text = nullptr;
  EXPECT_EQ(fathom_answer_dents(answer, &text), expected);
  fathom_answer_free(answer);
  return taken(text);
}

TEST(Dents, AreToldOfMeshesAndOfPiecesThatAreMeshes) {
  const std::string tent = R"({"vertices":[[0,0,0],[4,0,0],[0,4,0],[0,0,4],[1,1,1]],"faces":)"
                           R"([[0,2,1],[0,1,3],[0,3,2],[1,2,4],[2,3,4],[3,1,4]]})",
                    lid = R"({"vertices":[[0,0,0],[4,0,0],[0,4,0],[0,0,4]],"faces":[[0,2,1],[0,1,3],[0,3,2]]})";
  fathom_body *a = nullptr, *b = nullptr, *pieces = nullptr;
  ASSERT_EQ(fathom_bodies_from_case((R"({"a":)" + tent + R"(,"b":)" + lid + "}").c_str(), &a, &b), FATHOM_OK);
  const BodyHandle dented(a), open(b), points = body_of({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  const std::string how = " not convex, its hull is 33 % larger, its deepest point 0.577 inside the hull";
  EXPECT_EQ(dents(a, b, FATHOM_OK), "A is" + how + "; B is open");
  EXPECT_EQ(dents(points.get(), points.get(), FATHOM_ABSENT), "");
  fathom_body* const both[] = {points.get(), a};
  ASSERT_EQ(fathom_body_from_pieces(both, 2, &pieces), FATHOM_OK);
  const BodyHandle united(pieces);
  EXPECT_EQ(dents(points.get(), pieces, FATHOM_OK), "piece 1 of B is" + how);
  EXPECT_EQ(fathom_answer_dents(nullptr, nullptr), FATHOM_BAD_INPUT);
}

// ---- answers ----

void expect_optima(const AnswerHandle& answer, const UnionDepth& expected, const std::string& name) {
  const bool listed = expected.status == Status::penetrating;
  ASSERT_EQ(fathom_answer_optima(answer.get()), listed ? expected.optima.size() : 0U) << name;
  for (std::size_t i = 0; listed && i < expected.optima.size(); ++i) {
    double direction[3], translation[3];
    int clearance = -1;
    ASSERT_EQ(fathom_answer_optimum(answer.get(), i, direction, translation), FATHOM_OK) << name;
    ASSERT_EQ(fathom_answer_clearance(answer.get(), i, &clearance), FATHOM_OK) << name;
    const Point& t = expected.optima[i].translation;
    EXPECT_EQ(std::vector<double>(translation, translation + 3),
              (std::vector<double>{round_binary64(t.x), round_binary64(t.y), round_binary64(t.z)}))
        << name;
    EXPECT_EQ(clearance, expected.optima[i].clearance ? 1 : 0) << name;
    const mpq_class square = t.x * t.x + t.y * t.y + t.z * t.z;
    const double along[3] = {round_binary64(Surd{0, mpq_class(sgn(t.x) * t.x * t.x / square)}),
                             round_binary64(Surd{0, mpq_class(sgn(t.y) * t.y * t.y / square)}),
                             round_binary64(Surd{0, mpq_class(sgn(t.z) * t.z * t.z / square)})};
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(direction[k], along[k]) << name;
  }
  if (listed) {
    EXPECT_EQ(exactly(answer, FATHOM_TRANSLATION), text_of(expected.optima.front().translation)) << name;
  }
}

void expect_numbers(const AnswerHandle& answer, const UnionDepth& expected, const std::string& name) {
  EXPECT_EQ(fathom_answer_status(answer.get()), static_cast<int>(expected.status)) << name;
  const Surd value{0, expected.apart ? mpq_class(-expected.apart->distance.squared) : expected.squared()};
  double nearest = 0, low = 0, high = 0;
  ASSERT_EQ(fathom_answer_signed_depth(answer.get(), &nearest, &low, &high), FATHOM_OK);
  EXPECT_EQ(nearest, round_binary64(value)) << name;
  EXPECT_EQ(low, round_binary64(value, Rounding::rd)) << name;
  EXPECT_EQ(high, round_binary64(value, Rounding::ru)) << name;
  double deepest = 0, hulls = 0;
  std::size_t pieces[2] = {9, 9};
  ASSERT_EQ(fathom_answer_deepest_pair(answer.get(), &deepest, pieces), FATHOM_OK);
  ASSERT_EQ(fathom_answer_hulls(answer.get(), &hulls), FATHOM_OK);
  EXPECT_EQ(deepest, root_binary64(expected.bounds->deepest_pair)) << name;
  EXPECT_TRUE(pieces[0] == expected.bounds->a && pieces[1] == expected.bounds->b) << name;
  EXPECT_EQ(hulls, root_binary64(expected.bounds->hulls)) << name;
}

void expect_apart(const AnswerHandle& answer, const UnionDepth& expected, const std::string& name) {
  double a[3], b[3];
  if (!expected.apart) {
    EXPECT_EQ(fathom_answer_witness(answer.get(), a, b), FATHOM_ABSENT) << name;
    return;
  }
  const Distance& distance = expected.apart->distance;
  EXPECT_EQ(exactly(answer, FATHOM_TRANSLATION), text_of(distance.translation)) << name;
  EXPECT_EQ(exactly(answer, FATHOM_WITNESS_A), text_of(distance.witness.a)) << name;
  EXPECT_EQ(exactly(answer, FATHOM_WITNESS_B), text_of(distance.witness.b)) << name;
  const Vector& n = distance.direction;
  EXPECT_EQ(exactly(answer, FATHOM_DIRECTION), n.x.get_str() + " " + n.y.get_str() + " " + n.z.get_str()) << name;
}

void expect_json(const std::string& json, const std::string& id, const UnionDepth& expected) {
  const auto has = [&](const std::string& part) { return json.find(part) != std::string::npos; };
  EXPECT_EQ(json.find("{\"schema\":\"fathom/union/1\""), 0U) << json;
  EXPECT_TRUE(has("\"id\":\"" + id + "\"") && has("\"status\":\"" + std::string(name(expected.status)) + "\"")) << json;
  EXPECT_TRUE(has("\"depth\":{\"squared\":\"" + exact_text(expected.squared()) + "\"")) << json;
  for (const UnionOptimum& optimum : expected.optima) {
    const Point& t = optimum.translation;
    EXPECT_TRUE(has("[\"" + exact_text(t.x) + "\",\"" + exact_text(t.y) + "\",\"" + exact_text(t.z) + "\"]")) << json;
  }
  EXPECT_EQ(json.find('\n'), std::string::npos);
}

TEST(CUnions, EqualTheCppInterface) {
  std::set<Status> statuses;
  for (const families::Family& family : families::families(families::Kind::unions)) {
    for (const unsigned seed : {1U, 2U}) {
      const Case made = family.make(seed, 3);
      const Pieces a = pieces_of(made.a), b = pieces_of(made.b);
      const AnswerHandle answer = answer_about(union_of(a), union_of(b));
      const UnionDepth expected = union_depth(a, b);
      expect_numbers(answer, expected, made.id);
      expect_optima(answer, expected, made.id);
      expect_apart(answer, expected, made.id);
      expect_json(json_of(answer, made.id.c_str()), made.id, expected);
      EXPECT_EQ(certificate_of(answer, "one"), certificate_text(a, b, expected, "one")) << made.id;
      statuses.insert(expected.status);
    }
  }
  EXPECT_GE(statuses.size(), 2U);
}

TEST(CUnions, AnExactFit) {
  const AnswerHandle answer = answer_about(bar(), block());
  EXPECT_EQ(exactly(answer, FATHOM_SIGNED_DEPTH), "1");
  EXPECT_EQ(exactly(answer, FATHOM_DIRECTION), "1 0 0");
  EXPECT_EQ(exactly(answer, FATHOM_DEEPEST_PAIR), "1");
  EXPECT_EQ(exactly(answer, FATHOM_HULLS), "2");
  int clearance = -1;
  ASSERT_EQ(fathom_answer_clearance(answer.get(), 0, &clearance), FATHOM_OK);
  EXPECT_EQ(clearance, 0);
  EXPECT_EQ(fathom_answer_clearance(answer.get(), 1, &clearance), FATHOM_BAD_INPUT);
  EXPECT_NE(std::string(fathom_last_error()).find("index: expected one below 1"), std::string::npos);
}

TEST(CUnions, ThatTouchHaveNoOneDirection) {
  const AnswerHandle answer = answer_about(block(), box_at(6, 0, 0, 1, 1, 1));
  EXPECT_EQ(fathom_answer_status(answer.get()), FATHOM_TOUCHING);
  EXPECT_EQ(exactly(answer, FATHOM_TRANSLATION), "0 0 0");
  double direction[3];
  EXPECT_EQ(fathom_answer_direction(answer.get(), direction), FATHOM_ABSENT);
  EXPECT_EQ(fathom_answer_optima(answer.get()), 0U);
}

TEST(CUnions, ListAsManyOptimaAsAreWanted) {
  fathom_options options;
  fathom_options_init(&options);
  options.optima = 2;
  std::vector<BodyHandle> piece;
  piece.push_back(body_of(cube_at(0)));
  const BodyHandle cube = union_of(piece);
  EXPECT_EQ(fathom_answer_optima(answer_about(cube, cube).get()), 6U);
  const AnswerHandle answer = answer_about(cube, cube, &options);
  EXPECT_EQ(fathom_answer_optima(answer.get()), 2U);
  EXPECT_EQ(fathom_answer_optimum(answer.get(), 2, nullptr, nullptr), FATHOM_BAD_INPUT);
  const std::string json = json_of(answer, "two"), proof = certificate_of(answer, "two");
  EXPECT_TRUE(json.find("[\"-1\",\"0\",\"0\"]") < json.find("[\"0\",\"-1\",\"0\"]") &&
              json.find("[\"1\",\"0\",\"0\"]") == std::string::npos)
      << json;
  int outcome = -1;
  char* line = nullptr;
  ASSERT_EQ(fathom_check_certificate(proof.data(), proof.size(), nullptr, nullptr, &outcome, &line), FATHOM_OK);
  EXPECT_NE(taken(line).find("optima=6"), std::string::npos) << "law: the proof is of all of them";
}

TEST(CUnions, ComeFromCasesAndFilesAndArePosed) {
  fathom_body *a = nullptr, *b = nullptr, *moved = nullptr;
  const char* const json =
      R"({"a": {"shape": "box", "half": [0.5, 1, 1], "pose": "xyz=1.25,0,0"},
          "b": {"pieces": [{"shape": "box", "half": [5, 5, 5], "pose": "xyz=-5,0,0"}, {"shape": "box", "half": [5, 5, 5], "pose": "xyz=6,0,0"}]}})";
  ASSERT_EQ(fathom_bodies_from_case(json, &a, &b), FATHOM_OK) << fathom_last_error();
  const BodyHandle plate(a), walls(b);
  EXPECT_EQ(exactly(answer_about(plate, walls), FATHOM_TRANSLATION), "-3/4 0 0");
  ASSERT_EQ(fathom_body_posed(walls.get(), "xyz=1/4,0,0", FATHOM_EXACT_DECIMALS, &moved), FATHOM_OK)
      << fathom_last_error();
  EXPECT_EQ(exactly(answer_about(plate, BodyHandle(moved)), FATHOM_TRANSLATION), "-1/2 0 0");
  EXPECT_EQ(exactly(answer_about(plate, walls), FATHOM_TRANSLATION), "-3/4 0 0") << "law: a body does not change";
  const auto read = [](const std::string& path) {
    fathom_body* body = nullptr;
    EXPECT_EQ(fathom_body_from_piece_files((FATHOM_TEST_DATA "/" + path).c_str(), FATHOM_BINARY64_DECIMALS, &body),
              FATHOM_OK)
        << fathom_last_error();
    return BodyHandle(body);
  };
  EXPECT_EQ(exactly(answer_about(read("key.obj"), read("comb.obj")), FATHOM_SIGNED_DEPTH), "sqrt(5/8)");
  EXPECT_EQ(fathom_answer_status(answer_about(read("decompositions/mug"), read("decompositions/spanner.obj")).get()),
            FATHOM_PENETRATING);
}

TEST(CUnions, CertificatesAreCompared) {
  const BodyHandle a = bar(), b = block();
  const std::string text = certificate_of(answer_about(a, b), "fit");
  const auto outcome = [&](const fathom_body* first, const fathom_body* second) {
    int result = -1;
    EXPECT_EQ(fathom_check_certificate(text.data(), text.size(), first, second, &result, nullptr), FATHOM_OK)
        << fathom_last_error();
    return result;
  };
  EXPECT_EQ(outcome(nullptr, nullptr), FATHOM_VERIFIED);
  EXPECT_EQ(outcome(a.get(), b.get()), FATHOM_VERIFIED);
  EXPECT_EQ(outcome(b.get(), a.get()), FATHOM_REFUSED);
  EXPECT_EQ(outcome(a.get(), a.get()), FATHOM_REFUSED);
}

TEST(CUnions, OneBodyInManyThreads) {
  const BodyHandle a = bar(), b = block();
  std::vector<std::string> found(4);
  std::vector<std::thread> threads;
  for (std::string& text : found) threads.emplace_back([&] { text = certificate_of(answer_about(a, b), "one"); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(std::set<std::string>(found.begin(), found.end()).size(), 1U);
}

#ifdef FE_UPWARD
TEST(CUnions, AnyRoundingMode) {
  const BodyHandle a = bar(), b = block();
  const std::string usual = json_of(answer_about(a, b), "one");
  std::fesetround(FE_UPWARD);
  const std::string upward = json_of(answer_about(a, b), "one");
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(upward, usual);
}
#endif

}  // namespace
}  // namespace fathom
