// SPDX-License-Identifier: GPL-3.0-or-later
// What records of shapes say; a forger who makes all sums right is refused. What is asked of every
// kind alike: prove_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/files/shape_names.hpp"
#include "tests/golden/forged.hpp"
#include "tests/golden/some_recipes.hpp"
#include "verify/check/check.hpp"
#include "verify/golden/records/prove.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {
namespace {

using testing::hex;
using testing::Json;
using testing::line_with;
using testing::read;
using testing::replaced;

Surd surd(const Json& exact) { return {read(exact["plus"]), read(exact["root"]) * exact["sign"].get<int>()}; }

TEST(ShapeRecord, SaysWhatOthersSayAboutTheCaseThatItIs) {
  for (const Recipe& recipe : testing::some_recipes(11, Level::P0)) {
    const std::vector<FormedCase> forms = cases_of(recipe);
    const std::vector<Record> records = records_of(recipe);
    ASSERT_EQ(forms.size(), records.size());
    for (std::size_t i = 0; i < forms.size(); ++i) {
      const Record& record = records[i];
      const CaseItem item = parse_case(record.line, "record");
      ASSERT_TRUE(item.ok()) << item.error().what();
      EXPECT_EQ(item.id, forms[i].id);
      const auto& pair = std::get<families::NamedPair>(forms[i].bodies);
      const Shape a = files::shape_of(item.value().a), b = files::shape_of(item.value().b);
      EXPECT_EQ(a, families::shape_of(pair.a)) << record.id;
      EXPECT_EQ(b, families::shape_of(pair.b)) << record.id;
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
  const std::vector<FormedCase> forms = cases_of(recipe);
  ASSERT_EQ(forms.size(), 3u);
  const auto pair_of = [](const FormedCase& made) { return std::get<families::NamedPair>(made.bodies); };
  for (const FormedCase& made : forms) {
    EXPECT_TRUE(in_format(made.bodies, made.form));
    EXPECT_EQ(pair_of(made).known.has_value(), made.form == Form::given);
    const mpq_class exact = pair_of(forms.front()).b.place.x, stored = pair_of(made).b.place.x;
    const mpq_class wide = exact_value(round_binary64(exact)), narrow = exact_value(double{round_binary32(exact)});
    EXPECT_EQ(stored, made.form == Form::given ? exact : made.form == Form::binary64 ? wide : narrow);
  }
  EXPECT_FALSE(in_format(forms[0].bodies, Form::binary64));
  EXPECT_FALSE(in_format(forms[1].bodies, Form::binary32));
}

TEST(ShapeRecord, NoRoundingThatOverflowsOrLeavesNoShape) {
  const auto ball = [](const mpq_class& radius, const mpq_class& x) {
    return families::posed(families::named("sphere", {{"radius", {radius}}}), {1, 0, 0, 0}, {x, 0, 0});
  };
  const mpq_class huge = exact_value(1e300), tiny = exact_value(1e-300);
  const auto with = [&](const mpq_class& radius, const mpq_class& x) {
    return families::NamedPair{ball(radius, x), ball(1, 0)};
  };
  EXPECT_TRUE(rounded(with(1, tiny), Form::binary32));
  EXPECT_FALSE(rounded(with(1, huge), Form::binary32));
  EXPECT_FALSE(rounded(with(tiny, 0), Form::binary32)) << "the radius becomes 0";
  EXPECT_TRUE(rounded(with(tiny, huge), Form::binary64));
  EXPECT_FALSE(rounded(with(1, huge * huge), Form::binary64));
}

// ---- forgers ----

/// The line that begins with this word.
std::string line_from(const std::string& text, const std::string& word) {
  const std::size_t at = text.find('\n' + word);
  EXPECT_NE(at, std::string::npos) << word;
  return text.substr(at + 1, text.find('\n', at + 1) - at);
}

TEST(ShapeForger, BoundsThatAreRaisedOrExchanged) {
  const Record record = testing::enclosed_record();
  const Json value = Json::parse(record.line)["expected"]["signed_depth"]["bounds"];
  const std::string low = value[0], high = value[1], claim = "claim signed_bounds " + low + ' ' + high + '\n';
  const auto refused = [&](const std::string& new_low, const std::string& new_high) {
    const std::string proof =
        replaced(record.certificate, claim, "claim signed_bounds " + new_low + ' ' + new_high + '\n');
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
  EXPECT_TRUE(refused(exact_text(mpq_class(read(high) + width)), exact_text(mpq_class(read(high) + 2 * width))))
      << "above the true value";
  EXPECT_TRUE(refused(exact_text(mpq_class(read(low) - 2 * width)), exact_text(mpq_class(read(low) - width))))
      << "below it";
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

TEST(ShapeForger, ACertificateThatSaysLess) {
  const Record record = records_of({Source::shape_catalogue, "sphere_centre_on_vertex"}).front();
  ASSERT_NE(record.line.find("optimal_cone"), std::string::npos);
  std::string less = record.certificate.substr(0, record.certificate.find("lineality")) + "end 1 8 1 1 1\n";
  const std::string counted = line_from(record.certificate, "end ");
  less = replaced(less, "end 1 8 1 1 1\n", counted.substr(0, std::string("end 1 8 1 1 1").size()) + '\n');
  ASSERT_TRUE(fathom_check::verify(less).accepted()) << fathom_check::verify(less).reason << less;
  EXPECT_EQ(faults_of(line_with(record.line, less), less), "the certificate does not claim to list all directions");
}

}  // namespace
}  // namespace fathom::golden
