// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of the plane for C: what the C++ interface gives, with z = 0; and what takes none.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "fathom/plane.hpp"
#include "tests/c/handles.hpp"

namespace fathom {
namespace {

using namespace testing;  // handles

BodyHandle polygon(const std::vector<double>& xy) {
  fathom_body* body = nullptr;
  EXPECT_EQ(fathom_body_from_plane_points(xy.data(), xy.size() / 2, &body), FATHOM_OK) << fathom_last_error();
  return BodyHandle(body);
}

BodyHandle in_plane_of(const BodyHandle& body) {
  fathom_body* plane = nullptr;
  EXPECT_EQ(fathom_body_in_plane(body.get(), &plane), FATHOM_OK) << fathom_last_error();
  return BodyHandle(plane);
}

const std::vector<double> square = {0, 0, 1, 0, 1, 1, 0, 1};
constexpr const char* mixed = "a body of the plane and one of space are given: both must be of one of them";

TEST(PlaneInC, AnswersHaveNoZ) {
  const AnswerHandle answer = answer_about(polygon(square), polygon({0.75, 0.25, 3, 0.25, 3, 0.5}));
  EXPECT_EQ(fathom_answer_status(answer.get()), FATHOM_PENETRATING);
  EXPECT_EQ(exactly(answer, FATHOM_SIGNED_DEPTH), "1/4");
  EXPECT_EQ(exactly(answer, FATHOM_DIRECTION), "-1 0 0");
  std::array<double, 3> translation{}, a{}, b{};
  EXPECT_EQ(fathom_answer_translation(answer.get(), translation.data()), FATHOM_OK);
  EXPECT_EQ(translation, (std::array<double, 3>{-0.25, 0, 0}));
  EXPECT_EQ(fathom_answer_witness(answer.get(), a.data(), b.data()), FATHOM_OK);
  EXPECT_EQ(a[2], 0);
  EXPECT_EQ(b[2], 0);
  char* json = nullptr;
  EXPECT_EQ(fathom_answer_json(answer.get(), "p", &json), FATHOM_OK);
  const std::string line = taken(json);
  EXPECT_NE(line.find("\"dimension\":2"), std::string::npos) << line;
}

TEST(PlaneInC, CertificatesAreChecked) {
  const BodyHandle a = polygon(square), b = polygon({0.75, 0.25, 3, 0.25, 3, 0.5}), cube = body_of(cube_at(0));
  char* made = nullptr;
  ASSERT_EQ(fathom_answer_certificate(answer_about(a, b).get(), "p", nullptr, &made), FATHOM_OK) << fathom_last_error();
  const std::string proof = taken(made);
  int outcome = -1;
  char* line = nullptr;
  ASSERT_EQ(fathom_check_certificate(proof.data(), proof.size(), a.get(), b.get(), &outcome, &line), FATHOM_OK);
  EXPECT_EQ(outcome, FATHOM_VERIFIED);
  EXPECT_NE(taken(line).find("dimension=2"), std::string::npos);
  EXPECT_EQ(fathom_check_certificate(proof.data(), proof.size(), b.get(), a.get(), &outcome, nullptr), FATHOM_OK);
  EXPECT_EQ(outcome, FATHOM_REFUSED);
  EXPECT_EQ(fathom_check_certificate(proof.data(), proof.size(), a.get(), cube.get(), &outcome, nullptr),
            FATHOM_BAD_INPUT);
}

TEST(PlaneInC, RoundBodiesAndCasesAreOfIt) {
  const BodyHandle disc = in_plane_of(shape_of("sphere:r=1,at=0:3:0"));
  EXPECT_EQ(exactly(answer_about(polygon(square), disc), FATHOM_SIGNED_DEPTH), "-1");
  EXPECT_EQ(exactly(answer_about(in_plane_of(shape_of("halfspace:normal=0:1:0,offset=0")), polygon(square)),
                    FATHOM_SIGNED_DEPTH),
            "0");
  fathom_body *a = nullptr, *b = nullptr;
  EXPECT_EQ(fathom_bodies_from_case(
                R"({"dimension": 2, "a": {"shape": "circle", "radius": 1}, "b": {"vertices": [[0, "1/2"], [0, 9]]}})",
                &a, &b),
            FATHOM_OK)
      << fathom_last_error();
  const BodyHandle of_a(a), of_b(b);
  EXPECT_EQ(exactly(answer_about(of_a, of_b), FATHOM_SIGNED_DEPTH), "1/2");
}

TEST(PlaneInC, UnionsAndTheirPieces) {
  const BodyHandle left = polygon({-9, -1, -1, -1, -1, 1, -9, 1}), right = polygon({0.5, -1, 9, -1, 9, 1, 0.5, 1});
  fathom_body* const both[] = {left.get(), right.get()};
  fathom_body *made = nullptr, *second = nullptr;
  ASSERT_EQ(fathom_body_from_pieces(both, 2, &made), FATHOM_OK) << fathom_last_error();
  const BodyHandle slot(made);
  EXPECT_EQ(exactly(answer_about(polygon(square), slot), FATHOM_SIGNED_DEPTH), "1/2");
  ASSERT_EQ(fathom_body_piece(slot.get(), 1, &second), FATHOM_OK);
  const BodyHandle piece(second);
  EXPECT_EQ(exactly(answer_about(polygon(square), piece), FATHOM_SIGNED_DEPTH), "1/2");
  const BodyHandle cube = body_of(cube_at(0));
  fathom_body* const one_of_each[] = {left.get(), cube.get()};
  EXPECT_EQ(fathom_body_from_pieces(one_of_each, 2, &made), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_last_error(), std::string("piece 1: expected pieces that are all of the plane, or all of space"));
}

TEST(PlaneInC, WhatIsRefused) {
  fathom_body* body = nullptr;
  EXPECT_EQ(fathom_body_from_plane_points(nullptr, 1, &body), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_last_error(), std::string("xy: expected a pointer, found NULL"));
  const double bad[] = {0, 0, 0, infinity};
  EXPECT_EQ(fathom_body_from_plane_points(bad, 2, &body), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_last_error(), std::string("point 1: expected finite coordinates, found inf"));
  EXPECT_EQ(fathom_body_from_plane_points(bad, 0, &body), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_body_in_plane(nullptr, &body), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_body_in_plane(body_of(cube_at(0)).get(), &body), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_last_error(), std::string("a point of a body of the plane has the z 0, found another"));
  EXPECT_EQ(fathom_body_moved(polygon(square).get(), std::array<double, 12>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1}.data(),
                              &body),
            FATHOM_BAD_INPUT);
  EXPECT_EQ(body, nullptr);

  const BodyHandle flat = polygon(square), cube = body_of(cube_at(0));
  fathom_answer* answer = nullptr;
  EXPECT_EQ(fathom_depth(flat.get(), cube.get(), nullptr, &answer), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_last_error(), std::string(mixed));
  int status = 0;
  EXPECT_EQ(fathom_overlap(cube.get(), flat.get(), nullptr, &status, nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_last_error(), std::string(mixed));
  fathom_prepared* prepared = nullptr;
  EXPECT_EQ(fathom_prepare(flat.get(), &prepared), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_last_error(), std::string("Prepared takes bodies of space, found a body of the plane"));
  fathom_claim claim;
  fathom_claim_init(&claim);
  fathom_judgement judgement;
  fathom_judgement_init(&judgement);
  EXPECT_EQ(fathom_judge(flat.get(), cube.get(), &claim, &judgement, nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_last_error(), std::string(mixed));
  const double leaving[6] = {0, 0, 0, 1, 0, 0};
  double rate = 0;
  const std::string sentence = "a twist of a body of the plane leaves it: of v only x and y, of w only z may be set";
  EXPECT_EQ(fathom_answer_derivative(answer_about(flat, flat).get(), leaving, nullptr, &rate, nullptr),
            FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_last_error(), sentence);
  claim.has_derivative = 1;
  claim.twist_a[3] = 1;
  EXPECT_EQ(fathom_judge(flat.get(), flat.get(), &claim, &judgement, nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_last_error(), sentence);
}

TEST(PlaneInC, PatchesAndRatesHaveNoZ) {
  const AnswerHandle answer = answer_about(polygon(square), polygon({0.75, 0.25, 3, 0.25, 3, 0.5, 0.75, 0.5}));
  size_t patches = 0, corners = 0;
  EXPECT_EQ(fathom_answer_patches(answer.get(), &patches), FATHOM_OK);
  EXPECT_EQ(patches, 1u);
  double direction[3], size = 0, a[3], b[3], rate = 0;
  EXPECT_EQ(fathom_answer_patch(answer.get(), 0, &corners, direction, &size, nullptr, nullptr), FATHOM_OK);
  EXPECT_EQ(corners, 2u);
  EXPECT_EQ(size, 0.25);
  EXPECT_EQ(direction[2], 0);
  EXPECT_EQ(fathom_answer_patch_corner(answer.get(), 0, 1, a, b), FATHOM_OK);
  EXPECT_TRUE(a[2] == 0 && b[2] == 0 && a[0] == 1 && b[0] == 0.75);
  const double turn[6] = {0, 0, 0, 0, 0, 1};
  EXPECT_EQ(fathom_answer_derivative(answer.get(), turn, nullptr, &rate, nullptr), FATHOM_OK) << fathom_last_error();
  EXPECT_EQ(rate, -0.25);  // at the height 1/4 of the patch the edge recedes least
  char* json = nullptr;
  EXPECT_EQ(fathom_answer_manifold_json(answer.get(), "p", turn, nullptr, &json), FATHOM_OK);
  EXPECT_NE(taken(json).find("\"direction\":[\"-1\",\"0\"]"), std::string::npos);
}

TEST(PlaneInC, ClaimsAreJudged) {
  const BodyHandle a = polygon(square), b = polygon({0.75, 0.25, 3, 0.25, 3, 0.5, 0.75, 0.5});
  fathom_claim claim;
  fathom_claim_init(&claim);
  claim.overlap = claim.has_depth = claim.has_direction = 1;
  claim.depth = 0.25;
  claim.direction[0] = -1;
  claim.direction[2] = 7;  // is not read
  fathom_judgement judgement;
  fathom_judgement_init(&judgement);
  ASSERT_EQ(fathom_judge(a.get(), b.get(), &claim, &judgement, nullptr), FATHOM_OK) << fathom_last_error();
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_PASS);
  EXPECT_EQ(judgement.signed_depth, 0.25);
  claim.depth = 0.5;
  ASSERT_EQ(fathom_judge(a.get(), b.get(), &claim, &judgement, nullptr), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_TOO_DEEP);
  // Two circles: by proved bounds.
  const BodyHandle disc = in_plane_of(shape_of("sphere:r=1,at=0:3:0"));
  claim.depth = 2;
  ASSERT_EQ(fathom_judge(disc.get(), disc.get(), &claim, &judgement, nullptr), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_PASS);
}

}  // namespace
}  // namespace fathom
