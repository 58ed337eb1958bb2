// SPDX-License-Identifier: GPL-3.0-or-later
// What records of bodies of the plane say, against answers about the cases that they are. What is
// asked of every kind alike: prove_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "fathom/answer.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "tests/golden/forged.hpp"
#include "tests/golden/some_recipes.hpp"
#include "verify/golden/records/prove.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {
namespace {

using testing::case_of;
using testing::hex;
using testing::Json;
using testing::line_with;
using testing::read;

Json two_texts(const Vector& v) { return {v.x.get_str(), v.y.get_str()}; }

/// The case has polygons where the record has shapes of radius 0: so the answer goes another way.
TEST(PlaneRecord, SaysWhatOthersSayAboutTheCaseThatItIs) {
  std::set<std::string> statuses, kinds;
  for (const Recipe& recipe : testing::some_recipes(3, Level::F0)) {
    for (const Record& record : records_of(recipe)) {
      const Case bodies = case_of(record);
      ASSERT_EQ(bodies.a.dimension, 2u) << record.id;
      const Json line = Json::parse(record.line), &expected = line["expected"];
      for (const Method method : {Method::automatic, Method::naive}) {
        Question question;
        question.options.method = method;
        const Answer answer = exact_answer(bodies.a, bodies.b, question);
        EXPECT_EQ(expected["status"], answer.status_name()) << record.id;
        EXPECT_EQ(hex(expected["signed_depth"]["f64"]["rn"]), answer.nearest_binary64()) << record.id;
        EXPECT_EQ(hex(expected["signed_depth"]["low"]), answer.low_binary64()) << record.id;
        const Surd value{
            read(expected["signed_depth"]["exact"]["plus"]),
            read(expected["signed_depth"]["exact"]["root"]) * expected["signed_depth"]["exact"]["sign"].get<int>()};
        EXPECT_EQ(compare(value, *answer.exact()), 0) << record.id;
        statuses.insert(expected["status"]);
        const Json& ways = expected["translations"];
        if (expected.contains("optimal_cone")) {
          EXPECT_FALSE(ways[0].contains("contact"));
          continue;
        }
        ASSERT_EQ(ways.size(), std::max<std::size_t>(1, answer.core()->optima().size())) << record.id;
        EXPECT_EQ(expected["direction"], two_texts(*answer.direction())) << record.id;
        for (std::size_t i = 0; i < ways.size(); ++i) {
          const bool overlap = !answer.core()->optima().empty();
          const Contact& contact = overlap ? answer.core()->optima()[i].contact : *answer.contact();
          EXPECT_EQ(ways[i]["normal"], two_texts(overlap ? answer.core()->optima()[i].direction : *answer.direction()));
          EXPECT_EQ(ways[i]["contact"], Json({{"kind", name(contact.kind)}, {"a", contact.a}, {"b", contact.b}}))
              << record.id;
          kinds.insert(ways[i]["contact"]["kind"]);
        }
      }
    }
  }
  EXPECT_EQ(statuses, (std::set<std::string>{"penetrating", "touching", "disjoint"}));
  EXPECT_GE(kinds.size(), 3u);
}

TEST(PlaneRecord, CertificatesOfTheSameBodiesInSpaceAreRefused) {
  const Record record = records_of({Source::plane_family, "plane_random", 7, 1}).front();
  Case bodies = case_of(record);
  bodies.a.dimension = bodies.b.dimension = 3;
  const std::string flat = certificate_text(bodies.a, bodies.b, exact_answer(bodies.a, bodies.b), record.id);
  EXPECT_EQ(faults_of(line_with(record.line, flat), flat), "the certificate is about other bodies");
}

TEST(PlaneRecord, TheSecondWaySeesAnotherDepth) {
  const Record record = records_of({Source::plane_family, "plane_rounded", 7, 2}).front();
  EXPECT_FALSE(disagreement_with(Method::exact, record.line));
  EXPECT_FALSE(disagreement_with(Method::naive, record.line));
  Json line = Json::parse(record.line);
  line["expected"]["signed_depth"]["exact"]["plus"] = "7";
  EXPECT_EQ(disagreement_with(Method::naive, line.dump()).value_or("").find("by the method naive: expected.signed"),
            0u);
}

TEST(PlaneRecord, NoRoundingThatOverflowsOrLeavesNoRadius) {
  auto plane = std::get<families::PlanePair>(base_bodies({Source::plane_family, "plane_rounded", 7, 1}));
  EXPECT_TRUE(rounded(plane, Form::binary32));
  plane.b.shape->radius = exact_value(0x1p-200);
  EXPECT_FALSE(in_format(plane, Form::binary32));
  EXPECT_TRUE(in_format(plane, Form::binary64));
  EXPECT_FALSE(rounded(plane, Form::binary32)) << "the radius becomes 0";
  plane.b.shape->radius = exact_value(0x1p200);
  EXPECT_FALSE(rounded(plane, Form::binary32)) << "it overflows";
  EXPECT_TRUE(rounded(plane, Form::binary64));
}

}  // namespace
}  // namespace fathom::golden
