// SPDX-License-Identifier: GPL-3.0-or-later
// Records against the naive method, the exact one, and the definitions of rounding.
#include "verify/golden/records/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "fathom/depth.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "reference/depth/naive.hpp"
#include "tests/golden/some_recipes.hpp"
#include "verify/check/check.hpp"
#include "verify/golden/release/real_cases.hpp"

namespace fathom::golden {
namespace {

using Json = nlohmann::json;

Json texts(const Vector& v) { return {v.x.get_str(), v.y.get_str(), v.z.get_str()}; }
Json texts(const Point& p) { return {exact_text(p.x), exact_text(p.y), exact_text(p.z)}; }

Case points_of(const Record& record) {
  const CaseItem item = parse_case(record.line, "record");
  EXPECT_TRUE(item.ok()) << record.id << ": " << (item.ok() ? "" : item.error().what());
  EXPECT_EQ(item.id, record.id);
  return item.ok() ? item.value() : Case{};
}

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
      const Case points = points_of(record);
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

mpq_class read(const Json& text) { return *parse_number(text.get<std::string>(), Decimals::exact).value; }

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
    EXPECT_EQ(points_of(records[0]).a.points, base.a.points);
    for (const Record& record : records) {
      const Case found = points_of(record);
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
      EXPECT_NE(points_of(records[i - 1]).b.points, points_of(records[i]).b.points) << name;
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

}  // namespace
}  // namespace fathom::golden
