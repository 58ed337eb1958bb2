// SPDX-License-Identifier: GPL-3.0-or-later
// Records against the naive method, the exact one, and the definitions of rounding.

#include "verify/golden/records/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "fathom/certificate.hpp"
#include "fathom/depth.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "fathom/signed_depth.hpp"
#include "fathom/union.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/files/shape_names.hpp"
#include "tests/golden/forged.hpp"
#include "tests/golden/some_recipes.hpp"
#include "verify/check/check.hpp"
#include "verify/families/families.hpp"
#include "verify/families/union_pairs.hpp"
#include "verify/golden/records/prove.hpp"
#include "verify/golden/records/recipe.hpp"

namespace fathom::golden {
namespace {

using testing::case_of;
using testing::hex;
using testing::Json;
using testing::line_with;
using testing::read;
using testing::replaced;

Json texts(const Vector& v) { return {v.x.get_str(), v.y.get_str(), v.z.get_str()}; }
Json texts(const Point& p) { return {exact_text(p.x), exact_text(p.y), exact_text(p.z)}; }

void expect_answer(const Json& expected, const Depth& depth, const std::string& id) {
  EXPECT_EQ(expected["status"], name(depth.status())) << id;
  EXPECT_EQ(expected["depth"]["squared"], exact_text(depth.squared())) << id;
  EXPECT_EQ(expected["flat"].size(), std::size_t{depth.flat_a} + std::size_t{depth.flat_b}) << id;
  ASSERT_EQ(expected["optima"].size(), depth.optima().size()) << id;
  for (std::size_t i = 0; i < depth.optima().size(); ++i) {
    const Json& listed = expected["optima"][i];
    const Optimum& optimum = depth.optima()[i];
    EXPECT_EQ(listed["direction"], texts(optimum.direction)) << id;
    EXPECT_EQ(listed["translation"], texts(optimum.translation())) << id;
    EXPECT_EQ(listed["contact"],
              Json({{"kind", name(optimum.contact.kind)}, {"a", optimum.contact.a}, {"b", optimum.contact.b}}))
        << id;
  }
  if (!depth.distance()) return;
  EXPECT_EQ(expected["distance"]["squared"], exact_text(depth.distance()->squared)) << id;
  EXPECT_EQ(expected["direction"], texts(depth.distance()->direction)) << id;
}

TEST(Record, AgreesWithTheNaiveAndTheExactMethod) {
  std::set<std::string> statuses;
  for (const Recipe& recipe : testing::some_recipes(4)) {
    for (const Record& record : records_of(recipe)) {
      const Json expected = Json::parse(record.line)["expected"];
      const Case points = case_of(record);
      statuses.insert(expected["status"]);
      for (const Method method : {Method::naive, Method::exact}) {
        expect_answer(expected, penetration_depth(points.a.points, points.b.points, {.method = method}), record.id);
      }
      if (expected["status"] != "penetrating") continue;
      const auto gap = depth::second_nearest_squared_naive(points.a.points, points.b.points);
      EXPECT_EQ(expected["gap"].is_null() ? "" : expected["gap"]["squared"].get<std::string>(),
                gap ? exact_text(*gap) : "")
          << record.id;
    }
  }
  EXPECT_EQ(statuses.size(), 3u);
}

/// By definition: x is the rounding of sign * sqrt(squared) in that mode, in the format whose next
/// numbers are `below` and `above` x.
void expect_root(const std::string& where, const mpq_class& squared, int sign, double x, Rounding mode, double below,
                 double above) {
  const auto signed_square = [](double v) { return mpq_class(exact_value(v) * abs(exact_value(v))); };
  const mpq_class exact = sign * squared;
  const auto middle = [](double u, double v) {
    const mpq_class m = (exact_value(u) + exact_value(v)) / 2;
    return mpq_class(m * abs(m));
  };
  switch (mode) {
    case Rounding::rd: EXPECT_TRUE(signed_square(x) <= exact && exact < signed_square(above)) << where; break;
    case Rounding::ru: EXPECT_TRUE(signed_square(x) >= exact && exact > signed_square(below)) << where; break;
    case Rounding::rn: EXPECT_TRUE(middle(below, x) <= exact && exact <= middle(x, above)) << where; break;
  }
}

void expect_vector(const std::string& id, const Json& rounded, const std::array<mpq_class, 3>& squares,
                   const std::array<int, 3>& signs) {
  constexpr std::array modes{Rounding::rn, Rounding::rd, Rounding::ru};
  constexpr std::array names{"rn", "rd", "ru"};
  for (std::size_t mode = 0; mode < modes.size(); ++mode) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string where = id + " " + names[mode] + " component " + std::to_string(i);
      const double x = std::stod(rounded["f64"][names[mode]][i].get<std::string>());
      if (std::isfinite(x))
        expect_root(where, squares[i], signs[i], x, modes[mode], std::nextafter(x, -HUGE_VAL),
                    std::nextafter(x, HUGE_VAL));
      const double wide = std::stod(rounded["f32"][names[mode]][i].get<std::string>());
      const auto narrow = static_cast<float>(wide);
      ASSERT_EQ(double{narrow}, wide) << where << ": no binary32";
      if (std::isfinite(narrow) && std::abs(narrow) < 1e38f)
        expect_root(where, squares[i], signs[i], narrow, modes[mode], std::nextafter(narrow, -HUGE_VALF),
                    std::nextafter(narrow, HUGE_VALF));
    }
  }
}

TEST(Record, DirectionsAndTranslationsAreCorrectlyRounded) {
  for (const Recipe& recipe : testing::some_recipes(7)) {
    for (const Record& record : records_of(recipe)) {
      const Json expected = Json::parse(record.line)["expected"];
      for (const Json& optimum : expected["optima"]) {
        std::array<mpq_class, 3> n, t, squares;
        std::array<int, 3> signs{}, senses{};
        mpq_class norm;
        for (std::size_t i = 0; i < 3; ++i) {
          n[i] = read(optimum["direction"][i]);
          t[i] = read(optimum["translation"][i]);
          norm += n[i] * n[i];
        }
        for (std::size_t i = 0; i < 3; ++i) {
          signs[i] = sgn(n[i]);
          senses[i] = sgn(t[i]);
          squares[i] = n[i] * n[i] / norm;
          t[i] *= t[i];
        }
        expect_vector(record.id + " unit", optimum["unit"], squares, signs);
        expect_vector(record.id + " translation", optimum["rounded"], t, senses);
      }
    }
  }
}

TEST(Record, RoundedOnesHoldTheRoundedPoints) {
  std::set<std::size_t> counts;
  for (const char* name :
       {"random_ball", "boxes_posed", "boxes_aligned", "huge_coordinates", "near_ties", "crossed_fans"}) {
    const Recipe recipe{Source::family, name, 8, 3};
    const auto base = std::get<HullPair>(base_bodies(recipe));
    const std::vector<Record> records = records_of(recipe);
    counts.insert(records.size());
    EXPECT_EQ(records[0].id, id_of(recipe));
    EXPECT_EQ(case_of(records[0]).a.points, base.a.points);
    for (const Record& record : records) {
      const Case found = case_of(record);
      const HullPair points{found.a, found.b};
      const Form form = record.id.ends_with(".b64")   ? Form::binary64
                        : record.id.ends_with(".b32") ? Form::binary32
                                                      : Form::given;
      EXPECT_TRUE(in_format(points, form)) << record.id;
      EXPECT_EQ(record.in_binary64, in_format(points, Form::binary64)) << record.id;
      EXPECT_EQ(record.in_binary32, in_format(points, Form::binary32)) << record.id;
      for (std::size_t i = 0; i < points.a.points.size(); ++i) {
        const mpq_class &exact = base.a.points[i].x, &stored = points.a.points[i].x;
        const mpq_class in_double = exact_value(round_binary64(exact, Rounding::rn));
        const mpq_class in_single =
            form == Form::binary32 ? exact_value(double{round_binary32(exact, Rounding::rn)}) : exact;
        EXPECT_EQ(stored, form == Form::given ? exact : form == Form::binary64 ? in_double : in_single) << record.id;
      }
    }
    // No two records hold the same points.
    for (std::size_t i = 1; i < records.size(); ++i)
      EXPECT_NE(case_of(records[i - 1]).b.points, case_of(records[i]).b.points) << name;
  }
  EXPECT_GE(counts.size(), 3u) << "one, two and three records of a base case";
}

TEST(Record, APointIsInAFormatIfRoundingLeavesIt) {
  const auto fits = [](const mpq_class& x, Form form) {
    return in_format(HullPair{{{{x, 0, 0}}}, {{{0, 0, x}}}}, form);
  };
  std::vector<mpq_class> values{0, mpq_class(1, 3), exact_value(0x1p-1074), exact_value(0x1p-149),
                                exact_value(0x1.fffffep127)};
  for (const double power : {0x1p-1074, 0x1p-1022, 0x1p-149, 0x1p-126, 1.0, 0x1p53, 0x1p127, 0x1p1023}) {
    for (const long m :
         {1L, -3L, (1L << 24) - 1, (1L << 24) + 1, (1L << 25) - 2, (1L << 53) - 1, -(1L << 53) - 1, (1L << 54) - 2}) {
      values.emplace_back(exact_value(power) * m);
      values.emplace_back(exact_value(power) / m);
    }
  }
  for (const mpq_class& x : values) {
    const double wide = round_binary64(x, Rounding::rn);
    const float narrow = round_binary32(x, Rounding::rn);
    EXPECT_EQ(fits(x, Form::binary64), std::isfinite(wide) && exact_value(wide) == x) << x;
    EXPECT_EQ(fits(x, Form::binary32), std::isfinite(narrow) && exact_value(narrow) == x) << x;
    EXPECT_TRUE(fits(x, Form::given));
  }
}

TEST(Record, NoRoundingThatOverflowsOrShrinksABodyToAPoint) {
  const mpq_class zero = 0, third(1, 3);
  const mpq_class huge = exact_value(1e300), tiny = exact_value(1e-300);
  const auto with = [&](const mpq_class& x) {
    return HullPair{{{{x, zero, zero}, {zero, x, third}}}, {{{third, zero, zero}}}};
  };
  EXPECT_TRUE(rounded(with(huge), Form::binary64));
  EXPECT_FALSE(rounded(with(huge), Form::binary32));
  EXPECT_FALSE(rounded(with(huge * huge), Form::binary64));
  EXPECT_TRUE(rounded(with(tiny), Form::binary32)) << "a third of the body is left";
  const HullPair shrinking{{{{tiny, zero, zero}, {zero, tiny, zero}}}, {{{third, zero, zero}}}};
  EXPECT_TRUE(rounded(shrinking, Form::binary64));
  EXPECT_FALSE(rounded(shrinking, Form::binary32));
}

TEST(Record, TheRealCasesHaveTheAnswersThatTwoOtherProgramsFound) {
  std::string_view text = real_cases_text();
  std::size_t count = 0;
  for (; !text.empty(); ++count) {
    const std::size_t end = text.find('\n');
    const Json real = Json::parse(text.substr(0, end));
    const std::string name = real["id"].get<std::string>().substr(6);
    const Json expected = Json::parse(records_of({Source::real, name})[0].line)["expected"];
    EXPECT_EQ(expected["status"], real["expected"]["status"]) << name;
    EXPECT_EQ(expected["depth"]["squared"], real["expected"]["depth_squared"]) << name;
    text.remove_prefix(end + 1);
  }
  EXPECT_EQ(count, 63u);
}

TEST(Record, StopsWhenAsked) {
  const Recipe recipe{Source::family, "random_ball", 8, 1};
  struct StopAfter final : Monitor {
    explicit StopAfter(int left) : left(left) {}
    void report(std::string_view, double) override {}
    bool stopped() override { return --left < 0; }
    int left;
  };
  for (const int left : {0, 2}) {
    StopAfter stop(left);
    EXPECT_THROW(records_of(recipe, &stop), Interrupted);
  }
}

TEST(Record, CertificatesAreAcceptedAndBearTheId) {
  for (const Record& record : records_of({Source::family, "boxes_posed", 8, 2})) {
    const fathom_check::Verdict verdict = fathom_check::verify(record.certificate);
    EXPECT_TRUE(verdict.accepted());
    EXPECT_EQ(verdict.id, record.id);
  }
}

// What records of shapes say; a forger who makes all sums right is refused. What is asked of every
// kind alike: prove_test.cpp.

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

// What records of unions say; a forger who makes all sums right is refused. What is asked of every
// kind alike: prove_test.cpp.

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
