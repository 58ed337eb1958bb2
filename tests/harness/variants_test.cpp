// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/variants.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"
#include "tests/harness/fake_subject.hpp"
#include "verify/families/catalogue.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/judge/words.hpp"

namespace fathom::harness {
namespace {

using namespace fathom::testing;

const std::vector<std::string> all_names = {"swap", "translate", "permute", "scale", "repeat"};

std::vector<Case> pairs(Precision precision) {
  std::vector<Case> result;
  for (const families::CatalogueEntry& entry : families::catalogue())
    if (std::optional<Case> seen = as_seen(entry.pair, precision)) result.push_back(*seen);
  for (const families::Family& family : families::families())
    if (!std::string(family.name).starts_with("crossed"))
      if (std::optional<Case> seen = as_seen(family.make(3, 8), precision)) result.push_back(*seen);
  return result;
}

bool same_points(std::vector<Point> p, std::vector<Point> q) {
  const auto less = [](const Point& a, const Point& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
  std::ranges::sort(p, less);
  std::ranges::sort(q, less);
  return p == q;
}

class OfEachPrecision : public ::testing::TestWithParam<Precision> {};
INSTANTIATE_TEST_SUITE_P(Both, OfEachPrecision, ::testing::Values(Precision::binary32, Precision::binary64));

TEST_P(OfEachPrecision, TheLawHoldsWhenEachVariantIsSolvedAnew) {
  std::size_t seen = 0;
  for (const Case& pair : pairs(GetParam())) {
    const Depth depth = truth_about(pair.a.points, pair.b.points).depth;
    for (const Variant& variant : variants(pair, GetParam(), all_names)) {
      const Depth anew = truth_about(variant.seen.a.points, variant.seen.b.points).depth;
      EXPECT_EQ(anew.squared(), depth_squared_of(variant, depth.squared())) << pair.id << ' ' << variant.name;
      EXPECT_EQ(anew.status(), depth.status()) << pair.id << ' ' << variant.name;
      EXPECT_EQ(variant.seen.id, pair.id);
      for_each_coordinate(variant.seen,
                          [&](const mpq_class& value) { EXPECT_TRUE(representable(value, GetParam())) << pair.id; });
      ++seen;
    }
  }
  EXPECT_GT(seen, 300u);
}

TEST_P(OfEachPrecision, EachVariantIsWhatItsNameSays) {
  std::size_t longest = 0;
  for (const Case& pair : pairs(GetParam()))
    for (const Variant& variant : variants(pair, GetParam(), all_names)) {
      const Body &a = variant.seen.a, &b = variant.seen.b;
      if (variant.name == "swap") {
        EXPECT_EQ(a.points, pair.b.points);
        EXPECT_EQ(b.points, pair.a.points);
      } else if (variant.name == "permute") {
        EXPECT_TRUE(same_points(a.points, pair.a.points));
        EXPECT_TRUE(same_points(b.points, pair.b.points));
        EXPECT_FALSE(a.points == pair.a.points && b.points == pair.b.points);
      } else if (variant.name == "translate") {
        const Point step = a.points[0] - pair.a.points[0];
        EXPECT_FALSE(step == Point{});
        for (std::size_t i = 0; i < a.points.size(); ++i) EXPECT_EQ(a.points[i] - pair.a.points[i], step);
        for (std::size_t i = 0; i < b.points.size(); ++i) EXPECT_EQ(b.points[i] - pair.b.points[i], step);
        longest += abs(step.x) >= 1 ? 1 : 0;
      } else if (variant.name == "repeat") {
        EXPECT_EQ(digest_of(variant.seen), digest_of(pair));
        EXPECT_EQ(variant.exponent, 0);
      } else {
        EXPECT_NE(variant.exponent, 0);
        for (std::size_t i = 0; i < a.points.size(); ++i)
          EXPECT_EQ(a.points[i].y, scaled(pair.a.points[i].y, variant.exponent));
      }
    }
  EXPECT_GT(longest, 50u);
}

TEST(Variants, ComeInOneOrderAndAreTheSameEachTime) {
  const Case pair = family_case("random_ball", 20, 1);
  const std::vector<std::string> names = {"scale", "permute", "nonsense"};
  const std::vector<Variant> first = variants(pair, Precision::binary64, names),
                             again = variants(pair, Precision::binary64, names);
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[0].name, "permute");
  EXPECT_EQ(first[1].name, "scale");
  EXPECT_EQ(first[0].seen.a.points, again[0].seen.a.points);
}

TEST(Variants, WithoutAnExactFormAreLeftOutAndTold) {
  const mpq_class top = scaled((mpz_class(1) << 53) - 1, 971), bottom = scaled(1, -1074);
  const Case pair{"wide", {{{top, top, top}}}, {{{bottom, bottom, bottom}}}};
  std::vector<std::string> left_out;
  const std::vector<Variant> found = variants(pair, Precision::binary64, all_names, &left_out);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].name, "swap");
  EXPECT_EQ(found[1].name, "repeat");
  ASSERT_EQ(left_out.size(), 3u);
  EXPECT_NE(left_out[0].find("no translate other"), std::string::npos) << left_out[0];
  EXPECT_NE(left_out[2].find("scale"), std::string::npos) << left_out[2];
}

/// Unit cubes that overlap by `overlap` along x.
Case cubes(const mpq_class& overlap) { return {"cubes", box(0, 0, 0, 1, 1, 1), box(1 - overlap, 0, 0, 1, 1, 1)}; }

Outcome compared(const Examine& original, const Examine& of_variant, const Case& pair, const std::string& name,
                 const Tolerance& tolerance) {
  const std::vector<std::string> names = {name};
  const std::vector<Variant> found = variants(pair, Precision::binary64, names);
  EXPECT_EQ(found.size(), 1u);
  return compare_variant(original(pair), of_variant(found.at(0).seen), found.at(0), tolerance);
}

Examine off_by(double factor, const Tolerance& tolerance) {
  return judged([=](const Case&, Reply& reply) { reply.depth = *reply.depth * factor; }, tolerance);
}

TEST(CompareVariant, ARightSubjectIsInvariant) {
  const Examine right = judged([](const Case&, Reply&) {});
  for (const Case& pair : pairs(Precision::binary64))
    for (const std::string& name : all_names) {
      const Outcome outcome = examine_variant(in_any_unit(right), name, Precision::binary64, {})(pair);
      EXPECT_TRUE(passes(outcome.verdict)) << pair.id << ' ' << name << ": " << outcome.judgement->sentence;
      EXPECT_TRUE(outcome.variant == name || outcome.variant.empty());
    }
}

// Bodies so small that an ulp is a good part of them: the depth of a larger variant has more
// digits.
TEST(CompareVariant, CorrectRoundingIsInvariantWithoutATolerance) {
  const Examine right = judged([](const Case&, Reply&) {}, {0, 0, 0});
  std::size_t compared = 0, rounded_otherwise = 0;
  for (Case pair : pairs(Precision::binary64)) {
    for_each_coordinate(pair, [](mpq_class& value) { value = scaled(value, -1060); });
    const Case tiny = *as_seen(pair, Precision::binary64);
    const Outcome original = right(tiny);
    if (!original.reply->depth) continue;
    for (const Variant& variant : variants(tiny, Precision::binary64, all_names)) {
      const Outcome outcome = compare_variant(original, right(variant.seen), variant, {0, 0, 0});
      EXPECT_TRUE(passes(outcome.verdict)) << pair.id << ' ' << variant.name << ": " << outcome.judgement->sentence;
      ++compared;
      rounded_otherwise +=
          scaled(exact_value(*outcome.reply->depth), -variant.exponent) != exact_value(*original.reply->depth);
    }
  }
  EXPECT_GT(compared, 100u);
  EXPECT_GT(rounded_otherwise, 10u);
}

TEST(CompareVariant, ToleratesADifferenceOfTheToleranceAndNoMore) {
  const Tolerance tolerance{mpq_class(1, 8), 0, 0};
  const Case pair = cubes(mpq_class(1, 2));
  const Examine deep = off_by(1 + 1.0 / 16, tolerance), shallow = off_by(1 - 1.0 / 16, tolerance);
  const Examine shallower = off_by(1 - 1.0 / 16 - 1.0 / 1024, tolerance);
  for (const std::string& name : all_names) {
    EXPECT_EQ(compared(deep, shallow, pair, name, tolerance).verdict, Verdict::pass) << name;
    const Outcome outcome = compared(deep, shallower, pair, name, tolerance);
    EXPECT_EQ(outcome.verdict, Verdict::not_invariant) << name;
    EXPECT_EQ(outcome.judgement->verdict, Verdict::not_invariant);
    EXPECT_EQ(outcome.variant, name);
    // (1/8 + 1/1024) / 2
    EXPECT_NE(outcome.judgement->sentence.find("differ by 0.0629883: 0.53125 and 0.468262"), std::string::npos)
        << outcome.judgement->sentence;
  }
}

TEST(CompareVariant, AVariantThatFailsByItselfKeepsItsVerdict) {
  const Examine right = judged([](const Case&, Reply&) {}), wrong = off_by(2, {});
  const Outcome outcome = compared(right, wrong, cubes(mpq_class(1, 2)), "swap", {});
  EXPECT_TRUE(fails(outcome.verdict));
  EXPECT_NE(outcome.verdict, Verdict::not_invariant);
  EXPECT_EQ(outcome.variant, "swap");
}

TEST(CompareVariant, ARightVariantOfAWrongAnswerIsNotInvariant) {
  const Case pair = cubes(mpq_class(1, 2));
  const Examine right = judged([](const Case&, Reply&) {});
  const auto verdict = [&](const Examine& original) { return compared(original, right, pair, "scale", {}).verdict; };
  EXPECT_EQ(verdict(off_by(2, {})), Verdict::not_invariant);
  EXPECT_EQ(verdict(judged([](const Case&, Reply& reply) { reply.overlap = false; })), Verdict::not_invariant);
  EXPECT_EQ(verdict(judged([](const Case&, Reply& reply) { reply.depth = NAN; })), Verdict::not_invariant);
  EXPECT_EQ(verdict([](const Case& c) { return speechless(c, Verdict::crash); }), Verdict::not_invariant);
  EXPECT_EQ(verdict([](const Case& c) { return speechless(c, Verdict::unsupported); }), Verdict::pass);
}

// By the policy both of two translations may be right.
TEST(CompareVariant, LongerTranslationsMayDiffer) {
  Tolerance any;
  any.policy = *judging::policy_of("separating");
  const Case pair = cubes(mpq_class(1, 2));
  const Examine right = judged([](const Case&, Reply&) {}, any);
  const auto along_y = [](const Case&, Reply& reply) {
    reply.depth = 1;
    reply.direction = {0, 1, 0};
  };
  EXPECT_EQ(compared(judged(along_y, any), right, pair, "permute", any).verdict, Verdict::pass);
  EXPECT_EQ(compared(judged(along_y, {}), right, pair, "permute", {}).verdict, Verdict::not_invariant);
}

TEST(CompareVariant, DistancesInTheUnitsOfTheCase) {
  const Tolerance tolerance{mpq_class(1, 8), 0, 0};
  const Case pair = cubes(mpq_class(-1, 2));  // 1/2 apart
  const auto times = [&](double factor) {
    return judged(
        [factor](const Case& c, Reply& reply) {
          const Truth truth = truth_about(c.a.points, c.b.points);
          reply.distance = factor * root_binary64(truth.depth.distance()->squared);
        },
        tolerance);
  };
  for (const std::string& name : all_names) {
    EXPECT_EQ(compared(times(1 + 1.0 / 16), times(1 - 1.0 / 16), pair, name, tolerance).verdict, Verdict::pass) << name;
    const Outcome outcome = compared(times(1 + 1.0 / 16), times(1 - 1.0 / 16 - 1.0 / 1024), pair, name, tolerance);
    EXPECT_EQ(outcome.verdict, Verdict::not_invariant) << name;
    EXPECT_NE(outcome.judgement->sentence.find("the distances of the case and of the variant"), std::string::npos);
  }
}

TEST(CompareVariant, PricesDirectionsRatherThanComparingThem) {
  // The depth is 1/2 along x, and 1 along y or z.
  const Case pair = cubes(mpq_class(1, 2));
  const Examine right = judged([](const Case&, Reply&) {});
  const Examine along_y = judged([](const Case&, Reply& reply) { reply.direction = {0, 1, 0}; });
  const Outcome outcome = compared(along_y, right, pair, "permute", {});
  EXPECT_EQ(outcome.verdict, Verdict::not_invariant);
  EXPECT_NE(outcome.judgement->sentence.find("different depths: 1 and 0.5"), std::string::npos)
      << outcome.judgement->sentence;
  // A tie is not a difference.
  const Case tied{"tied", box(0, 0, 0, 1, 1, 1), box(mpq_class(1, 2), mpq_class(1, 2), 0, 1, 1, 1)};
  const auto along = [](const Triple& u) { return judged([u](const Case&, Reply& reply) { reply.direction = u; }); };
  EXPECT_EQ(compared(along({0, -1, 0}), along({-1, 0, 0}), tied, "permute", {}).verdict, Verdict::pass);
}

}  // namespace
}  // namespace fathom::harness
