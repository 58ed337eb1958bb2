// SPDX-License-Identifier: GPL-3.0-or-later

#include "verify/harness/variants.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"
#include "tests/harness/fake_subject.hpp"
#include "tests/unions/pieces.hpp"
#include "verify/families/families.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/judge/truth.hpp"

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

TEST_P(OfEachPrecision, TheDerivativeIsThatOfTheCase) {
  std::size_t seen = 0;
  const auto squared = [](const Case& of) -> std::optional<mpq_class> {
    Reply reply;
    reply.derivative = 0;
    return judging::judged(judging::truth_of(of.a, of.b), reply, {}, {}, {}, of.motion).derivative.value().squared;
  };
  for (Case pair : pairs(GetParam())) {
    pair.motion = Motion{{{1, -2, 0.5}, {0, 4, -1}}, {{0, 0, 3}, {-2, 0, 1}}};
    const std::optional<mpq_class> right = squared(pair);
    for (const Variant& variant : variants(pair, GetParam(), all_names)) {
      if (!right || !variant.seen.motion) continue;
      EXPECT_EQ(squared(variant.seen), depth_squared_of(variant, *right)) << pair.id << ' ' << variant.name;
      EXPECT_EQ(rounded(*variant.seen.motion, GetParam()), variant.seen.motion) << "law: the subject sees it";
      ++seen;
    }
  }
  EXPECT_GT(seen, 400U);
}

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
                 const Tolerance& tolerance, const std::optional<ContactLimits>& manifold = ContactLimits{}) {
  const std::vector<std::string> names = {name};
  const std::vector<Variant> found = variants(pair, Precision::binary64, names);
  EXPECT_EQ(found.size(), 1u);
  return compare_variant(original(pair), of_variant(found.at(0).seen), found.at(0), tolerance, manifold);
}

Examine off_by(double factor, const Tolerance& tolerance) {
  return judged([=](const Case&, Reply& reply) { reply.depth = *reply.depth * factor; }, tolerance);
}

TEST(CompareVariant, ARightSubjectIsInvariant) {
  const Examine right = judged([](const Case&, Reply&) {});
  for (const Case& pair : pairs(Precision::binary64))
    for (const std::string& name : all_names) {
      const Outcome outcome = examine_variant(in_any_unit(right), name, Precision::binary64, {}, {}, {})(pair);
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
      const Outcome outcome = compare_variant(original, right(variant.seen), variant, {0, 0, 0}, {});
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

/// The corners of what two boxes along the axes share.
void add_contacts(const Case& pair, Reply& reply) {
  for (const Point& p : pair.a.points.exact()) {
    Point corner = p;
    for (const auto axis : axes) {
      const auto [low, high] = std::ranges::minmax_element(
          pair.b.points.exact(), [](const mpq_class& x, const mpq_class& y) { return x < y; }, axis);
      corner.*axis = std::clamp(p.*axis, mpq_class((*low).*axis), mpq_class((*high).*axis));
    }
    reply.contacts.push_back({{round_binary64(corner.x), round_binary64(corner.y), round_binary64(corner.z)}, {}});
  }
}

TEST(CompareVariant, ContactsReachEquallyFar) {
  const Examine all = judged(add_contacts);
  // The corner of the square where A's second point is has no contact.
  const Examine by_order = judged([](const Case& pair, Reply& reply) {
    add_contacts(pair, reply);
    std::erase_if(reply.contacts, [second = reply.contacts[1].position](const ContactPoint& contact) {
      return contact.position[1] == second[1] && contact.position[2] == second[2];
    });
  });
  const Case pair = cubes(mpq_class(1, 2));
  for (const std::string& name : all_names) {
    EXPECT_EQ(compared(all, all, pair, name, {}).verdict, Verdict::pass) << name;
    const Outcome outcome = compared(by_order, by_order, pair, name, {});
    EXPECT_EQ(outcome.verdict, name == "permute" ? Verdict::not_invariant : Verdict::pass) << name;
    if (passes(outcome.verdict)) continue;
    EXPECT_EQ(outcome.judgement->sentence,
              "the contacts of the case and of the variant \"permute\" reach differently far, by 0.707107");
  }
  EXPECT_EQ(compared(all, by_order, pair, "scale", {}).verdict, Verdict::not_invariant);
  EXPECT_EQ(compared(all, by_order, pair, "scale", {}, std::nullopt).verdict, Verdict::pass) << "no extent is promised";
  const std::size_t told = by_order(pair).reply->contacts.size();
  EXPECT_EQ(compared(by_order, by_order, pair, "permute", {}, ContactLimits{.most = told}).verdict, Verdict::pass)
      << "whoever tells as many as it can may have chosen";
  EXPECT_EQ(compared(by_order, by_order, pair, "permute", {}, ContactLimits{.most = told + 1}).verdict,
            Verdict::not_invariant);
}

// If A lies to the right the two contacts of an edge are moved inwards: so only exchanged bodies
// have others. They may differ by twice the tolerance.
TEST(CompareVariant, ContactsOfExchangedBodies) {
  const Tolerance tolerance{mpq_class(1, 8), 0, 0};  // 1/16 of a length
  const auto moved_by = [&](double way) {
    return judged(
        [way](const Case& pair, Reply& reply) {
          add_contacts(pair, reply);
          const auto is_left = [&](const Point& p, const Point& q) { return p.x < q.x; };
          const auto least = [&](const Body& body) { return std::ranges::min(body.points.exact(), is_left).x; };
          if (least(pair.a) < least(pair.b)) return;
          for (ContactPoint& contact : reply.contacts)
            if (contact.position[1] == 0) contact.position[1] = way;
        },
        tolerance);
  };
  const Case pair = cubes(mpq_class(1, 2));
  const auto verdict = [&](double way, const std::string& name) {
    return compared(moved_by(way), moved_by(way), pair, name, tolerance).verdict;
  };
  for (const std::string& name : all_names)
    EXPECT_EQ(verdict(0.25, name), name == "swap" ? Verdict::not_invariant : Verdict::pass) << name;
  EXPECT_EQ(verdict(0.125, "swap"), Verdict::pass);
  EXPECT_EQ(verdict(std::nextafter(0.125, 1), "swap"), Verdict::not_invariant);
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

TEST(CompareVariant, MeasuresDirectionsRatherThanComparingThem) {
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

// Which of the answers about pairs of pieces is the one about the unions, and what becomes of those
// that are none.

using unions::box;

/// A of two boxes, B of three; the first is 1/2 deep in the first of B, the second 1/4 in the
/// second.
Case unions_case() {
  const Pieces a{box({0, 0, 0}, {1, 1, 1}), box({0, 0, 4}, {1, 1, 5})};
  const Pieces b{box({mpq_class(1, 2), 0, 0}, {9, 1, 1}), box({mpq_class(3, 4), 0, 4}, {9, 1, 5}),
                 box({20, 0, 0}, {21, 1, 1})};
  return {"two", Body{.points = {}, .pieces = std::make_shared<const Pieces>(a)},
          Body{.points = {}, .pieces = std::make_shared<const Pieces>(b)}};
}

SubjectAnswer says(std::optional<double> depth) {
  return {{}, Reply{.overlap = true, .depth = depth, .direction = Triple{-1, 0, 0}}};
}
SubjectAnswer says_apart(std::optional<double> distance = {}) { return {{}, Reply{.distance = distance}}; }

/// Answers by the ids of pairs; all others are apart by 7.
struct Script {
  std::map<std::string, SubjectAnswer> answers;
  std::map<std::string, Verdict> faults;
  std::vector<std::string> asked;

  Outcome run(const SubjectInfo& info = {}, const Case& pair = unions_case()) {
    return examine_pairs(pair, 0, info, {}, [this](const Case& one, std::optional<SubjectAnswer>& answer) {
      asked.push_back(one.id);
      Outcome outcome = outcome_for(one);
      outcome.seconds = 2;
      if (const auto fault = faults.find(one.id); fault != faults.end()) {
        outcome.verdict = fault->second;
        outcome.detail = "as in the script";
      } else {
        const auto found = answers.find(one.id);
        answer = found == answers.end() ? says_apart(7) : found->second;
      }
      return outcome;
    });
  }
};

TEST(PiecePairs, TheDeepestReplyIsTheAnswer) {
  Script script{{{"two[0,0]", says(0.5)}, {"two[1,1]", says(0.25)}}, {}, {}};
  const Outcome outcome = script.run();
  EXPECT_EQ(script.asked,
            (std::vector<std::string>{"two[0,0]", "two[0,1]", "two[0,2]", "two[1,0]", "two[1,1]", "two[1,2]"}));
  EXPECT_EQ(outcome.id, "two");
  EXPECT_EQ(outcome.verdict, Verdict::pass);
  EXPECT_EQ(outcome.reply->depth, 0.5);
  EXPECT_EQ(outcome.seconds, 12);
  EXPECT_EQ(outcome.digest, digest_of(unions_case()));
  ASSERT_TRUE(outcome.pieces);
  EXPECT_EQ(outcome.pieces->pairs, 6U);
  EXPECT_EQ(outcome.pieces->answer_of[0], 0U);
  EXPECT_EQ(outcome.pieces->answer_of[1], 0U);
  EXPECT_EQ(outcome.pieces->query.verdict, Verdict::pass);

  script.answers["two[1,1]"] = says(0.75);
  const Outcome wrong = script.run();
  EXPECT_EQ(wrong.verdict, Verdict::too_deep);
  EXPECT_EQ(wrong.pieces->answer_of[0], 1U);
  EXPECT_EQ(wrong.pieces->query.verdict, Verdict::too_deep);
  EXPECT_EQ(wrong.pieces->query.depth_squared, mpq_class(1, 16)) << "the pair's";
  EXPECT_EQ(wrong.judgement->depth_squared, mpq_class(1, 4)) << "the unions'";
}

TEST(PiecePairs, TheSignIsThatOfTheConventions) {
  SubjectInfo info;
  info.conventions.depth = Conventions::Sign::negative;
  Script script{{{"two[0,0]", says(-0.5)}, {"two[1,1]", says(-0.25)}}, {}, {}};
  EXPECT_EQ(script.run(info).reply->depth, -0.5);
}

TEST(PiecePairs, WhatIsNotFiniteIsDeepest) {
  Script script{{{"two[0,0]", says(0.5)}, {"two[1,1]", says(std::numeric_limits<double>::quiet_NaN())}}, {}, {}};
  EXPECT_EQ(script.run().verdict, Verdict::nan);
}

TEST(PiecePairs, OverlapsWithoutDepths) {
  Script script{{{"two[0,0]", says({})}, {"two[1,1]", says(0.5)}}, {}, {}};
  EXPECT_EQ(script.run().reply->depth, 0.5);
  script.answers["two[1,1]"] = says({});
  const Outcome outcome = script.run();
  EXPECT_EQ(outcome.verdict, Verdict::pass) << "by its classification";
  EXPECT_EQ(outcome.pieces->answer_of[1], 0U);
}

TEST(PiecePairs, ApartByTheLeastDistance) {
  Case pair = unions_case();
  for_each_hull(pair.a, [](std::vector<Point>& points) {
    for (Point& p : points) p.x -= 3;
  });
  Script script{{{"two[0,0]", says_apart(2.5)}, {"two[1,1]", says_apart(2.75)}}, {}, {}};
  const Outcome outcome = script.run({}, pair);
  EXPECT_EQ(outcome.verdict, Verdict::pass) << outcome.judgement->sentence;
  EXPECT_EQ(outcome.reply->distance, 2.5);
  EXPECT_EQ(outcome.judgement->distance_squared, mpq_class(25, 4));
  script.answers["two[1,1]"] = says_apart();
  const Outcome bare = script.run({}, pair);
  EXPECT_FALSE(bare.reply->distance) << "that of one pair is not known";
  EXPECT_EQ(bare.verdict, Verdict::pass);
  SubjectInfo info;
  info.promises = {"distance"};
  EXPECT_EQ(script.run(info, pair).verdict, Verdict::inconsistent) << "a promise is one about each pair";
}

TEST(PiecePairs, NoAnswerToOneIsNone) {
  Script script{{{"two[0,0]", says(0.5)}}, {{"two[0,2]", Verdict::crash}}, {}};
  const Outcome crash = script.run();
  EXPECT_EQ(crash.verdict, Verdict::crash);
  EXPECT_EQ(crash.detail, "piece 0 of A, piece 2 of B: as in the script");
  EXPECT_EQ(script.asked.size(), 3U) << "and no other is asked";
  EXPECT_FALSE(crash.judgement || crash.reply || crash.pieces);

  Script failing{{{"two[1,0]", {{}, Failed{"no step"}}}}, {}, {}};
  const Outcome failed = failing.run();
  EXPECT_EQ(failed.verdict, Verdict::failed);
  EXPECT_EQ(failed.detail, "piece 1 of A, piece 0 of B: no step");

  Script declining{{{"two[0,1]", {{}, Unsupported{"too thin"}}}}, {}, {}};
  EXPECT_EQ(declining.run().verdict, Verdict::unsupported);
  EXPECT_EQ(declining.asked.size(), 6U);
  declining.faults["two[1,2]"] = Verdict::time_out;
  EXPECT_EQ(declining.run().verdict, Verdict::time_out) << "worse than to decline";
}

TEST(PiecePairs, TimesAddUpIfAllAreThere) {
  Script script;
  script.answers["two[0,0]"] = says(0.5);
  for (const std::string& id : {"two[0,0]", "two[0,1]", "two[0,2]", "two[1,0]", "two[1,1]", "two[1,2]"})
    script.answers.try_emplace(id, says_apart()).first->second.microseconds = 1.5;
  EXPECT_EQ(script.run().microseconds, 9.0);
  script.answers["two[1,2]"].microseconds.reset();
  EXPECT_FALSE(script.run().microseconds);
}

TEST(PiecePairs, Ids) {
  const Case pair = unions_case();
  EXPECT_TRUE(is_pair_of("two[1,2]", pair));
  for (const char* other : {"two", "two[2,0]", "two[0,3]", "two[01,2]", "two[1,2]x", "two[1,2", "two[ 1,2]", "two[,]",
                            "tow[1,2]", "two[-1,0]"})
    EXPECT_FALSE(is_pair_of(other, pair)) << other;
  EXPECT_FALSE(is_pair_of("p[0,0]", {"p", Body{box({0, 0, 0}, {1, 1, 1})}, Body{box({0, 0, 0}, {1, 1, 1})}}));
}

TEST(PiecePairs, AreSeenInTheSubjectsPrecision) {
  Case pair = unions_case();
  for_each_hull(pair.a, [](std::vector<Point>& points) { points.back().x += mpq_class(1, mpz_class(1) << 40); });
  const std::optional<Case> seen = as_seen(pair, Precision::binary32);
  ASSERT_TRUE(seen);
  EXPECT_EQ((*seen->a.pieces)[0], (*unions_case().a.pieces)[0]);
  EXPECT_NE(digest_of(pair), digest_of(*seen));
  EXPECT_EQ(as_seen(*seen, Precision::binary32)->a.pieces->size(), 2U) << "what was seen is seen again";
  for_each_hull(pair.a, [](std::vector<Point>& points) {
    for (Point& p : points) p.z = p.z / (mpz_class(1) << 60) + 1;
  });
  std::string why;
  EXPECT_FALSE(as_seen(pair, Precision::binary32, {}, &why));
  EXPECT_EQ(why, "piece 0 of A has no interior in binary32, the precision of the subject");
}

TEST(PiecePairs, OneBodyMayBePlain) {
  const Case pair{"plain", Body{box({0, 0, 0}, {1, 1, 1})}, unions_case().b};
  const std::optional<Case> seen = as_seen(pair, Precision::binary64);
  ASSERT_TRUE(seen && seen->a.pieces && seen->b.pieces);
  EXPECT_EQ(seen->a.pieces->size(), 1U);
  EXPECT_EQ(run_message("1", *seen, Precision::binary64, false).find("{\"pieces\":[{\"vertices\":"),
            run_message("1", *seen, Precision::binary64, false).rfind("\"pieces\"") - 1);
}

TEST(PiecePairs, RadiiAreDeclined) {
  SubjectInfo info;
  EXPECT_EQ(obstacle_to(unions_case(), info, 0), "");
  info.rounding["vertices"] = mpq_class(1, 8);
  EXPECT_NE(obstacle_to(unions_case(), info, 0), "");
  EXPECT_TRUE(is_asked_in_pairs(unions_case(), info));
  info.shapes = {"pieces"};
  EXPECT_FALSE(is_asked_in_pairs(unions_case(), info));
}

}  // namespace
}  // namespace fathom::harness
