// SPDX-License-Identifier: GPL-3.0-or-later
// Records of shapes: what is made is proved and found again in another way; a forger who makes all sums right is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/files/shape_names.hpp"
#include "tests/golden/forged.hpp"
#include "tests/golden/some_recipes.hpp"
#include "verify/check/check.hpp"
#include "verify/golden/records/prove.hpp"
#include "verify/golden/records/recompute.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {
namespace {

using testing::hex;
using testing::Json;
using testing::line_with;
using testing::read;
using testing::replaced;

Surd surd(const Json& exact) { return {read(exact["plus"]), read(exact["root"]) * exact["sign"].get<int>()}; }

TEST(ShapeRecord, WhatIsMadeIsProvedAndGivenAgain) {
  std::set<std::string> statuses;
  std::size_t exact = 0, enclosed = 0;
  for (const Recipe& recipe : testing::some_recipes(7, Level::P0)) {
    for (const Record& record : records_of(recipe)) {
      EXPECT_EQ(faults_of(record.line, record.certificate).value_or(""), "") << record.id;
      for (const Method method : {Method::exact, Method::naive})
        EXPECT_EQ(disagreement_with(method, record.line).value_or(""), "") << record.id;
      const Json expected = Json::parse(record.line)["expected"];
      statuses.insert(expected["status"].get<std::string>());
      (expected["signed_depth"].contains("exact") ? exact : enclosed) += 1;
      EXPECT_TRUE(record.csv_row.empty());
    }
  }
  EXPECT_GE(statuses.size(), 3u);
  EXPECT_GT(exact, 50u);
  EXPECT_GT(enclosed, 30u);
}

TEST(ShapeRecord, SaysWhatOthersSayAboutTheCaseThatItIs) {
  for (const Recipe& recipe : testing::some_recipes(11, Level::P0)) {
    const std::vector<FormedShapes> forms = shape_cases_of(recipe);
    const std::vector<Record> records = records_of(recipe);
    ASSERT_EQ(forms.size(), records.size());
    for (std::size_t i = 0; i < forms.size(); ++i) {
      const Record& record = records[i];
      const CaseItem item = parse_case(record.line, "record");
      ASSERT_TRUE(item.ok()) << item.error().what();
      EXPECT_EQ(item.id, forms[i].shapes.id);
      const Shape a = files::shape_of(item.value().a), b = files::shape_of(item.value().b);
      EXPECT_EQ(a, families::shape_of(forms[i].shapes.pair.a)) << record.id;
      EXPECT_EQ(b, families::shape_of(forms[i].shapes.pair.b)) << record.id;
      const SignedDepth answer = signed_depth(a, b);
      const Json expected = Json::parse(record.line)["expected"], value = expected["signed_depth"];
      EXPECT_EQ(expected["flat"].size(), std::size_t{is_flat(a)} + std::size_t{is_flat(b)});
      if (const Surd* const exact = answer.exact()) {
        EXPECT_EQ(compare(surd(value["exact"]), *exact), 0) << record.id;
        EXPECT_EQ(expected["status"], name(*answer.status()));
        EXPECT_EQ(hex(value["f64"]["rn"]), round_binary64(*exact));
        EXPECT_EQ(hex(value["f32"]["ru"]), double{round_binary32(*exact, Rounding::ru)});
        EXPECT_EQ(hex(value["low"]), answer.low_binary64());
        EXPECT_EQ(hex(value["high"]), answer.high_binary64());
        ASSERT_EQ(expected["translations"].size(), answer.translations().size());
      } else {
        const mpq_class low = read(value["bounds"][0]), high = read(value["bounds"][1]);
        EXPECT_LT(low, high);
        EXPECT_LE(low, answer.bounds()->high) << record.id;
        EXPECT_GE(high, answer.bounds()->low) << record.id;
        EXPECT_LE(exact_value(hex(value["low"])), low);
        EXPECT_GE(exact_value(hex(value["high"])), high);
        EXPECT_TRUE(expected["translations"].empty());
      }
    }
  }
}

/// The bounds hold, and are near, for what is known by construction.
TEST(ShapeRecord, HoldsWhatIsKnown) {
  std::size_t known = 0;
  for (const Recipe& recipe : testing::some_recipes(5, Level::P0)) {
    const Json record = Json::parse(records_of(recipe).front().line);
    if (!record["source"].contains("signed_depth")) continue;
    const Surd answer = surd(record["source"]["signed_depth"]);
    const Json& value = record["expected"]["signed_depth"];
    if (value.contains("exact")) {
      EXPECT_EQ(compare(surd(value["exact"]), answer), 0) << record["id"];
    } else {
      EXPECT_GE(compare(answer, read(value["bounds"][0])), 0) << record["id"];
      EXPECT_LE(compare(answer, read(value["bounds"][1])), 0) << record["id"];
    }
    ++known;
  }
  EXPECT_GT(known, 30u);
}

TEST(ShapeRecord, TranslationsAreCorrectlyRounded) {
  // A sphere and the corner of a box: alpha n + beta n/|n| with an irrational |n|.
  std::size_t irrational = 0;
  for (const Recipe& recipe : testing::some_recipes(9, Level::P0)) {
    for (const Record& record : records_of(recipe)) {
      const Json expected = Json::parse(record.line)["expected"];
      for (const Json& along : expected["translations"]) {
        mpq_class norm;
        for (const Json& n : along["normal"]) norm += read(n) * read(n);
        const mpq_class alpha = read(along["alpha"]), beta = read(along["beta"]);
        for (std::size_t i = 0; i < 3; ++i) {
          const mpq_class n = read(along["normal"][i]), root = beta * n;
          const Surd component{alpha * n, root * abs(root) / norm};
          const double down = hex(along["rounded"]["f64"]["rd"][i]), up = hex(along["rounded"]["f64"]["ru"][i]);
          EXPECT_GE(compare(component, exact_value(down)), 0) << record.id;
          EXPECT_LE(compare(component, exact_value(up)), 0) << record.id;
          EXPECT_LE(up, std::nextafter(down, HUGE_VAL)) << record.id;
          irrational += down < up;
        }
      }
    }
  }
  EXPECT_GT(irrational, 50u);
}

TEST(ShapeRecord, RoundedOnesHoldTheRoundedNumbers) {
  const Recipe recipe{Source::shape_family, "inverse_side_face", 8, 3};
  const std::vector<FormedShapes> forms = shape_cases_of(recipe);
  ASSERT_EQ(forms.size(), 3u);
  for (const FormedShapes& made : forms) {
    EXPECT_TRUE(in_format(made.shapes.pair, made.form));
    EXPECT_EQ(made.shapes.pair.known.has_value(), made.form == Form::given);
    const mpq_class exact = forms.front().shapes.pair.b.place.x, stored = made.shapes.pair.b.place.x;
    const mpq_class wide = exact_value(round_binary64(exact)), narrow = exact_value(double{round_binary32(exact)});
    EXPECT_EQ(stored, made.form == Form::given ? exact : made.form == Form::binary64 ? wide : narrow);
  }
  EXPECT_FALSE(in_format(forms[0].shapes.pair, Form::binary64));
  EXPECT_FALSE(in_format(forms[1].shapes.pair, Form::binary32));
  EXPECT_THROW(shape_cases_of({Source::shape_family, "no_such_thing", 8, 1}), std::invalid_argument);
  EXPECT_THROW(shape_cases_of({Source::shape_catalogue, "no_such_thing"}), std::invalid_argument);
}

TEST(ShapeRecord, NoRoundingThatOverflowsOrLeavesNoShape) {
  const auto ball = [](const mpq_class& radius, const mpq_class& x) {
    return families::posed(families::named("sphere", {{"radius", {radius}}}), {1, 0, 0, 0}, {x, 0, 0});
  };
  const mpq_class huge = exact_value(1e300), tiny = exact_value(1e-300);
  const auto with = [&](const mpq_class& radius, const mpq_class& x) { return families::NamedPair{ball(radius, x), ball(1, 0)}; };
  EXPECT_TRUE(rounded_shapes(with(1, tiny), Form::binary32));
  EXPECT_FALSE(rounded_shapes(with(1, huge), Form::binary32));
  EXPECT_FALSE(rounded_shapes(with(tiny, 0), Form::binary32)) << "the radius becomes 0";
  EXPECT_TRUE(rounded_shapes(with(tiny, huge), Form::binary64));
  EXPECT_FALSE(rounded_shapes(with(1, huge * huge), Form::binary64));
}

// ---- forgers ----

/// The line that begins with this word.
std::string line_from(const std::string& text, const std::string& word) {
  const std::size_t at = text.find('\n' + word);
  EXPECT_NE(at, std::string::npos) << word;
  return text.substr(at + 1, text.find('\n', at + 1) - at);
}

Record enclosed_record() {
  for (const Recipe& recipe : testing::some_recipes(1, Level::P0)) {
    if (recipe.name != "cylinder_capsule") continue;
    for (Record& record : records_of(recipe))
      if (record.line.find("\"bounds\"") != std::string::npos && record.line.find("\"penetrating\"") != std::string::npos) return record;
  }
  ADD_FAILURE() << "no pair that is enclosed";
  return {};
}

TEST(ShapeForger, BoundsThatAreRaisedOrExchanged) {
  const Record record = enclosed_record();
  const Json value = Json::parse(record.line)["expected"]["signed_depth"]["bounds"];
  const std::string low = value[0], high = value[1], claim = "claim signed_bounds " + low + ' ' + high + '\n';
  const auto refused = [&](const std::string& new_low, const std::string& new_high) {
    const std::string proof = replaced(record.certificate, claim, "claim signed_bounds " + new_low + ' ' + new_high + '\n');
    Json line = Json::parse(line_with(record.line, proof));
    Json& stated = line["expected"]["signed_depth"];
    stated["bounds"] = {new_low, new_high};
    stated["low"] = hex_text(round_binary64(read(new_low), Rounding::rd));
    stated["high"] = hex_text(round_binary64(read(new_high), Rounding::ru));
    return faults_of(line.dump(), proof).has_value();
  };
  EXPECT_FALSE(refused(low, high)) << "the forger changes nothing else";
  const mpq_class width = read(high) - read(low), slack = width / 8;
  EXPECT_FALSE(refused(exact_text(mpq_class(read(low) - slack)), high)) << "wider bounds are true";
  EXPECT_TRUE(refused(high, low));
  EXPECT_TRUE(refused(exact_text(mpq_class(read(high) + width)), exact_text(mpq_class(read(high) + 2 * width)))) << "above the true value";
  EXPECT_TRUE(refused(exact_text(mpq_class(read(low) - 2 * width)), exact_text(mpq_class(read(low) - width)))) << "below it";
  EXPECT_TRUE(refused(high, high));
  EXPECT_TRUE(refused(low, low));
}

TEST(ShapeForger, ARadiusThatIsDropped) {
  const Record record = records_of({Source::shape_family, "capsule_box", 8, 1}).front();
  ASSERT_FALSE(faults_of(record.line, record.certificate));
  const std::string bare = replaced(record.certificate, line_from(record.certificate, "radius_"), "");
  ASSERT_TRUE(fathom_check::verify(bare).accepted()) << "it is true of other bodies";
  EXPECT_EQ(faults_of(line_with(record.line, bare), bare), "the certificate is about other bodies");
}

TEST(ShapeForger, TheCertificateOfAnother) {
  const std::vector<Record> records = records_of({Source::shape_family, "cylinders", 8, 2});
  ASSERT_GE(records.size(), 2u);
  testing::expect_refused_of(records[0], records[1]);
}

TEST(ShapeForger, ACertificateThatSaysLess) {
  const Record record = records_of({Source::shape_catalogue, "sphere_centre_on_vertex"}).front();
  ASSERT_NE(record.line.find("optimal_cone"), std::string::npos);
  std::string less = record.certificate.substr(0, record.certificate.find("lineality")) + "end 1 8 1 1 1\n";
  const std::string counted = line_from(record.certificate, "end ");
  less = replaced(less, "end 1 8 1 1 1\n", counted.substr(0, std::string("end 1 8 1 1 1").size()) + '\n');
  ASSERT_TRUE(fathom_check::verify(less).accepted()) << fathom_check::verify(less).reason << less;
  EXPECT_EQ(faults_of(line_with(record.line, less), less), "the certificate does not claim to list all directions");
}

TEST(ShapeForger, AnotherFormAndHostileSizes) {
  testing::expect_form_refused(records_of({Source::shape_catalogue, "spheres_touching"}).front());
  testing::expect_size_refused(records_of({Source::shape_family, "capsule_hull", 8, 1}).front(), "capsule_hull");
}

TEST(ShapeRecompute, NoticesOtherValues) {
  const Record exact = records_of({Source::shape_family, "capsules", 8, 1}).front(), enclosed = enclosed_record();
  Json wrong = Json::parse(exact.line);
  wrong["expected"]["signed_depth"]["exact"]["plus"] = "100";
  EXPECT_EQ(disagreement_with(Method::naive, wrong.dump()),
            "by the method naive: expected.signed_depth: the bodies, turned and exchanged, have another one");
  wrong = Json::parse(exact.line);
  wrong["expected"]["direction"] = {"1", "0", "0"};
  EXPECT_NE(disagreement_with(Method::exact, wrong.dump()).value_or("").find("expected.direction"), std::string::npos);
  wrong = Json::parse(enclosed.line);
  Json& bounds = wrong["expected"]["signed_depth"]["bounds"];
  for (Json& bound : bounds) bound = exact_text(mpq_class(read(bound) + mpq_class(1, 1000)));
  EXPECT_NE(disagreement_with(Method::exact, wrong.dump()).value_or("").find("have another one"), std::string::npos);
  bounds = Json::array();
  EXPECT_NE(disagreement_with(Method::exact, wrong.dump()).value_or("").find("expected a record"), std::string::npos);
}

}  // namespace
}  // namespace fathom::golden
