// SPDX-License-Identifier: GPL-3.0-or-later
// What records of unions say; a forger who makes all sums right is refused. What is asked of every
// kind alike: prove_test.cpp.
#include <gtest/gtest.h>

#include "fathom/certificate.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "fathom/union.hpp"
#include "tests/golden/forged.hpp"
#include "tests/golden/some_recipes.hpp"
#include "verify/check/check.hpp"
#include "verify/families/catalogue.hpp"
#include "verify/families/union_pairs.hpp"
#include "verify/golden/records/prove.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {
namespace {

using testing::hex;
using testing::Json;
using testing::line_with;
using testing::read;
using testing::replaced;

Record record_named(const char* entry) { return records_of({Source::union_catalogue, entry}).front(); }

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
    for (const FormedCase& made : cases_of(recipe)) {
      const bool expected = recipe.source == Source::union_catalogue || recipe.name.starts_with("cut_");
      EXPECT_EQ(std::get<Unions>(made.bodies).known.has_value(), expected && made.form == Form::given) << made.id;
      EXPECT_EQ(made.id, id_of(recipe, made.form));
      EXPECT_TRUE(in_format(made.bodies, made.form)) << made.id;
    }
  }
}

TEST(UnionRecord, NoRoundingThatOverflowsOrFlattensAPiece) {
  const auto with = [](const mpq_class& low, const mpq_class& high) {
    const std::vector<Point> unit = families::box_from({0, 0, 0}, {1, 1, 1});
    return Unions{{unit}, {unit, families::box_from({low, 0, 0}, {high, 1, 1})}};
  };
  const mpq_class huge = exact_value(1e300), next = 1 + exact_value(0x1p-30), third(1, 3);
  EXPECT_FALSE(rounded(with(0, huge), Form::binary32));
  EXPECT_TRUE(rounded(with(0, huge), Form::binary64));
  EXPECT_FALSE(rounded(with(0, huge * huge), Form::binary64));
  EXPECT_FALSE(rounded(with(1, next), Form::binary32)) << "the piece becomes flat";
  EXPECT_TRUE(rounded(with(1, next), Form::binary64));
  const std::optional<RecordBodies> third_rounded = rounded(with(0, third), Form::binary64);
  ASSERT_TRUE(third_rounded);
  EXPECT_EQ(std::get<Unions>(*third_rounded).b.at(1),
            families::box_from({0, 0, 0}, {exact_value(round_binary64(third)), 1, 1}));
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
  EXPECT_NE(fault([](Json& forged) { forged["expected"]["depth"]["squared"] = "1"; }).find("expected.depth.squared"),
            std::string::npos);
  EXPECT_NE(fault([](Json& forged) { forged["expected"]["optima"].erase(1); }).find("expected.optima"),
            std::string::npos);
  EXPECT_NE(fault([](Json& forged) { forged["expected"]["optima"][0]["clearance"] = true; }).find("expected.optima"),
            std::string::npos);
  EXPECT_NE(fault([](Json& forged) { forged["source"]["known"]["optima"] = 2; }).find("source.known.optima"),
            std::string::npos);
  EXPECT_NE(fault([](Json& forged) { forged["b"]["pieces"].erase(0); }).find("b.pieces"), std::string::npos);
  EXPECT_NE(fault([](Json& forged) { forged["a"]["pieces"][0]["vertices"][0][0] = "0x1p-1"; }).find("a.pieces"),
            std::string::npos);
}

TEST(UnionForger, ACertificateThatIsNotAccepted) {
  const Record record = record_named("slot_exact_fit");
  const std::string raised = replaced(record.certificate, "claim depth 9/16", "claim depth 10/16"),
                    lowered = replaced(record.certificate, "claim depth 9/16", "claim depth 1/2");
  for (const std::string& proof : {raised, lowered})
    EXPECT_NE(faults_of(line_with(record.line, proof), proof).value_or("").find("not accepted"), std::string::npos);
}

/// The same points, one piece repeated: the body is the same set, the pieces are not.
TEST(UnionForger, APieceMore) {
  const Record record = record_named("cube_repeated");
  const auto unions = std::get<Unions>(base_bodies({Source::union_catalogue, "cube_repeated"}));
  Pieces more = unions.a;
  more.push_back(more.front());
  const std::string proof = certificate_text(more, unions.b, union_depth(more, unions.b), record.id);
  ASSERT_TRUE(fathom_check::verify(proof).accepted());
  EXPECT_EQ(faults_of(line_with(record.line, proof), proof), "the certificate is about other bodies");
}

TEST(UnionProve, WhatIsKnownIsNotDenied) {
  const Record record = record_named("slot_exact_fit");
  FormedCase made = cases_of({Source::union_catalogue, "slot_exact_fit"}).front();
  const auto proved = [&] { return std::get<UnionStatement>(proved_truth(made, {}, record.certificate)); };
  EXPECT_EQ(proved().squared, mpq_class(9, 16));
  const KnownUnion known = *std::get<Unions>(made.bodies).known;
  for (const KnownUnion& wrong :
       {KnownUnion{Status::touching, known.squared, known.optima},
        KnownUnion{known.status, known.squared + 1, known.optima}, KnownUnion{known.status, known.squared, 2}}) {
    std::get<Unions>(made.bodies).known = wrong;
    EXPECT_THROW(proved(), NotProved);
  }
}

}  // namespace
}  // namespace fathom::golden
