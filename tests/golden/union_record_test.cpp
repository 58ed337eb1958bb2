// SPDX-License-Identifier: GPL-3.0-or-later
// Records of unions: what is made is proved and found again in another way; a forger who makes all sums right is refused.
#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "fathom/certificate.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "fathom/union.hpp"
#include "tests/golden/forged.hpp"
#include "tests/golden/some_recipes.hpp"
#include "verify/check/check.hpp"
#include "verify/families/union_bodies.hpp"
#include "verify/families/union_catalogue.hpp"
#include "verify/golden/records/accepted.hpp"
#include "verify/golden/records/prove.hpp"
#include "verify/golden/records/recompute.hpp"
#include "verify/golden/records/record.hpp"
#include "verify/golden/unions/union_prove.hpp"

namespace fathom::golden {
namespace {

using testing::hex;
using testing::Json;
using testing::line_with;
using testing::read;
using testing::replaced;

Record record_named(const char* entry) { return records_of({Source::union_catalogue, entry}).front(); }

TEST(UnionRecord, WhatIsMadeIsProvedAndGivenAgain) {
  std::set<std::string> statuses, forms;
  for (const Recipe& recipe : testing::some_recipes(3, Level::U0)) {
    for (const Record& record : records_of(recipe)) {
      EXPECT_EQ(faults_of(record.line, record.certificate).value_or(""), "") << record.id;
      for (const Method method : {Method::exact, Method::naive})
        EXPECT_EQ(disagreement_with(method, record.line).value_or(""), "") << record.id;
      const Json line = Json::parse(record.line);
      statuses.insert(line["expected"]["status"].get<std::string>());
      forms.insert(line["source"]["form"].get<std::string>());
      EXPECT_TRUE(record.csv_row.empty());
    }
  }
  EXPECT_EQ(statuses.size(), 3u);
  EXPECT_EQ(forms.size(), 3u);
}

TEST(UnionRecord, SaysWhatOthersSayAboutTheCaseThatItIs) {
  for (const Recipe& recipe : testing::some_recipes(5, Level::U0)) {
    for (const Record& record : records_of(recipe)) {
      const CaseItem item = parse_case(record.line, "record");
      ASSERT_TRUE(item.ok()) << item.error().what();
      EXPECT_EQ(item.id, record.id);
      const UnionDepth answer = union_depth(*item.value().a.pieces, *item.value().b.pieces);
      const Json expected = Json::parse(record.line)["expected"];
      EXPECT_EQ(expected["status"], name(answer.status)) << record.id;
      EXPECT_EQ(read(expected["depth"]["squared"]), answer.squared());
      EXPECT_EQ(hex(expected["depth"]["f64"]["rn"]), root_binary64(answer.squared()));
      if (answer.status == Status::penetrating) {
        ASSERT_EQ(expected["optima"].size(), answer.optima.size()) << record.id;
        for (std::size_t i = 0; i < answer.optima.size(); ++i) {
          const Point& t = answer.optima[i].translation;
          const Json &found = expected["optima"][i]["translation"], &rounded = expected["optima"][i]["rounded"];
          EXPECT_EQ((Point{read(found[0]), read(found[1]), read(found[2])}), t) << record.id;
          EXPECT_EQ(hex(rounded["f64"]["ru"][0]), round_binary64(t.x, Rounding::ru));
          EXPECT_EQ(hex(rounded["f32"]["rd"][2]), double{round_binary32(t.z, Rounding::rd)});
        }
      } else {
        EXPECT_TRUE(expected["optima"].empty());
      }
      ASSERT_EQ(expected.contains("distance"), answer.apart.has_value());
      if (answer.apart) {
        EXPECT_EQ(read(expected["distance"]["squared"]), answer.apart->distance.squared) << record.id;
      }
    }
  }
}

/// The catalogue states its answers, which nobody computed.
TEST(UnionRecord, HoldsWhatIsKnown) {
  for (const families::UnionCatalogueEntry& entry : families::union_catalogue()) {
    const Json line = Json::parse(record_named(entry.pair.id.c_str()).line), &expected = line["expected"];
    EXPECT_EQ(expected["status"], name(entry.status)) << entry.pair.id;
    const bool apart = entry.status == Status::disjoint;
    EXPECT_EQ(read((apart ? expected["distance"] : expected["depth"])["squared"]), entry.squared) << entry.pair.id;
    EXPECT_EQ(expected["optima"].size(), entry.status == Status::penetrating ? entry.optima : 0) << entry.pair.id;
  }
}

TEST(UnionRecord, KnownAreTheCatalogueAndBodiesThatWereCut) {
  for (const Recipe& recipe : testing::some_recipes(1, Level::U0)) {
    for (const FormedUnions& made : union_cases_of(recipe)) {
      const bool expected = recipe.source == Source::union_catalogue || recipe.name.starts_with("cut_");
      EXPECT_EQ(made.known.has_value(), expected && made.form == Form::given) << made.unions.id;
      EXPECT_EQ(made.unions.id, id_of(recipe, made.form));
      EXPECT_TRUE(unions_in_format(made.unions, made.form)) << made.unions.id;
    }
  }
  EXPECT_THROW(union_cases_of({Source::union_family, "no_such_thing", 8, 1}), std::invalid_argument);
  EXPECT_THROW(union_cases_of({Source::union_catalogue, "no_such_thing"}), std::invalid_argument);
}

TEST(UnionRecord, NoRoundingThatOverflowsOrFlattensAPiece) {
  const auto with = [](const mpq_class& low, const mpq_class& high) {
    const auto body = [](Pieces pieces) { return Body{.points = {}, .pieces = std::make_shared<const Pieces>(std::move(pieces))}; };
    const std::vector<Point> unit = families::box_from({0, 0, 0}, {1, 1, 1});
    return Case{"boxes", body({unit}), body({unit, families::box_from({low, 0, 0}, {high, 1, 1})})};
  };
  const mpq_class huge = exact_value(1e300), next = 1 + exact_value(0x1p-30), third(1, 3);
  EXPECT_FALSE(rounded_unions(with(0, huge), Form::binary32));
  EXPECT_TRUE(rounded_unions(with(0, huge), Form::binary64));
  EXPECT_FALSE(rounded_unions(with(0, huge * huge), Form::binary64));
  EXPECT_FALSE(rounded_unions(with(1, next), Form::binary32)) << "the piece becomes flat";
  EXPECT_TRUE(rounded_unions(with(1, next), Form::binary64));
  const std::optional<Case> rounded = rounded_unions(with(0, third), Form::binary64);
  ASSERT_TRUE(rounded);
  EXPECT_EQ(rounded->b.pieces->at(1), families::box_from({0, 0, 0}, {exact_value(round_binary64(third)), 1, 1}));
}

// ---- forgers ----

TEST(UnionForger, AnotherDepthFewerOptimaOtherPieces) {
  const Record record = record_named("cavity_too_small");
  const Json line = Json::parse(record.line);
  ASSERT_EQ(line["expected"]["optima"].size(), 3u);
  const auto fault = [&](const auto& change) {
    Json forged = line;
    change(forged);
    return faults_of(forged.dump(), record.certificate).value_or("");
  };
  EXPECT_EQ(fault([](Json&) {}), "");
  EXPECT_NE(fault([](Json& forged) { forged["expected"]["depth"]["squared"] = "1"; }).find("expected.depth.squared"), std::string::npos);
  EXPECT_NE(fault([](Json& forged) { forged["expected"]["optima"].erase(1); }).find("expected.optima"), std::string::npos);
  EXPECT_NE(fault([](Json& forged) { forged["expected"]["optima"][0]["clearance"] = true; }).find("expected.optima"), std::string::npos);
  EXPECT_NE(fault([](Json& forged) { forged["source"]["known"]["optima"] = 2; }).find("source.known.optima"), std::string::npos);
  EXPECT_NE(fault([](Json& forged) { forged["b"]["pieces"].erase(0); }).find("b.pieces"), std::string::npos);
  EXPECT_NE(fault([](Json& forged) { forged["a"]["pieces"][0]["vertices"][0][0] = "0x1p-1"; }).find("a.pieces"), std::string::npos);
}

TEST(UnionForger, ACertificateThatIsNotAccepted) {
  const Record record = record_named("slot_exact_fit");
  const std::string raised = replaced(record.certificate, "claim depth 9/16", "claim depth 10/16"),
                    lowered = replaced(record.certificate, "claim depth 9/16", "claim depth 1/2");
  for (const std::string& proof : {raised, lowered})
    EXPECT_NE(faults_of(line_with(record.line, proof), proof).value_or("").find("not accepted"), std::string::npos);
}

TEST(UnionForger, TheCertificateOfAnother) { testing::expect_refused_of(record_named("slot_exact_fit"), record_named("slot_wider")); }

/// The same points, one piece repeated: the body is the same set, the pieces are not.
TEST(UnionForger, APieceMore) {
  const Record record = record_named("cube_repeated");
  const Case unions = union_cases_of({Source::union_catalogue, "cube_repeated"}).front().unions;
  Pieces more = *unions.a.pieces;
  more.push_back(more.front());
  const std::string proof = certificate_text(more, *unions.b.pieces, union_depth(more, *unions.b.pieces), record.id);
  ASSERT_TRUE(fathom_check::verify(proof).accepted());
  EXPECT_EQ(faults_of(line_with(record.line, proof), proof), "the certificate is about other bodies");
}

TEST(UnionForger, AnotherFormAndHostileSizes) {
  testing::expect_form_refused(record_named("slot_filled"));
  testing::expect_size_refused(records_of({Source::union_family, "clusters", 4, 1}).front(), "clusters");
}

TEST(UnionProve, WhatIsKnownIsNotDenied) {
  const Record record = record_named("slot_exact_fit");
  FormedUnions bodies = union_cases_of({Source::union_catalogue, "slot_exact_fit"}).front();
  EXPECT_EQ(proved_truth(bodies, record.certificate).squared, mpq_class(9, 16));
  const KnownUnion known = *bodies.known;
  for (const KnownUnion& wrong : {KnownUnion{Status::touching, known.squared, known.optima},
                                  KnownUnion{known.status, known.squared + 1, known.optima}, KnownUnion{known.status, known.squared, 2}}) {
    bodies.known = wrong;
    EXPECT_THROW(static_cast<void>(proved_truth(bodies, record.certificate)), NotProved);
  }
}

TEST(UnionRecompute, NoticesOtherValues) {
  const auto by_exact = [](const Json& line) { return disagreement_with(Method::exact, line.dump()).value_or(""); };
  const Json deep = Json::parse(record_named("cavity_too_small").line);
  Json wrong = deep;
  EXPECT_EQ(by_exact(wrong), "");
  wrong["expected"]["depth"]["squared"] = "1";
  EXPECT_NE(by_exact(wrong).find("expected.depth.squared"), std::string::npos);
  wrong = deep;
  wrong["expected"]["optima"].erase(2);
  EXPECT_NE(by_exact(wrong).find("expected.optima"), std::string::npos);

  const Json apart = Json::parse(record_named("gap_of_a_body").line);
  EXPECT_EQ(by_exact(apart), "");
  ASSERT_EQ(apart["expected"]["distance"]["pieces"], (Json{0, 0}));
  wrong = apart;
  wrong["expected"]["distance"]["squared"] = "2";
  EXPECT_NE(by_exact(wrong).find("expected.distance.squared"), std::string::npos);
  wrong = apart;
  wrong["expected"]["distance"]["pieces"] = {0, 7};
  EXPECT_NE(by_exact(wrong).find("there are no such pieces"), std::string::npos);
  const Json chain = Json::parse(record_named("rings_linked").line);
  const std::uint32_t a = chain["expected"]["distance"]["pieces"][0];
  wrong = chain;
  wrong["expected"]["distance"]["pieces"][0] = (a + 2) % 4;
  EXPECT_NE(by_exact(wrong).find("not the nearest"), std::string::npos) << by_exact(wrong);
  wrong["expected"]["distance"].erase("pieces");
  EXPECT_NE(by_exact(wrong).find("expected a record"), std::string::npos);
}

}  // namespace
}  // namespace fathom::golden
