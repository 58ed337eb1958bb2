// SPDX-License-Identifier: GPL-3.0-or-later
// Which shapes a subject is given, how it is given them, and that it is judged on what it was
// given.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "fathom/numbers.hpp"
#include "reference/files/cases.hpp"
#include "verify/check/check.hpp"
#include "verify/families/families.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/journal.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/two_ways.hpp"
#include "verify/harness/variants.hpp"

namespace fathom::harness {
namespace {

using families::named;
using families::NamedBody;
using families::posed;

const mpq_class tenth(1, 10);
const std::vector<std::string> all_variants = {"swap", "translate", "permute", "scale"};

Body body(const char* shape, files::NumbersByName numbers) { return files::body_of(named(shape, numbers)); }
Body ball(const mpq_class& radius) { return body("sphere", {{"radius", {radius}}}); }
Body block(const mpq_class& half) { return body("box", {{"half", {half, half, half}}}); }

std::set<std::string> every_word() {
  std::set<std::string> words = {margin_word};
  for (const files::ShapeName& shape : files::shape_names()) words.emplace(shape.name);
  return words;
}

std::string why_not(const Case& pair, const std::set<std::string>& shapes, Precision precision = Precision::binary64) {
  std::string why;
  EXPECT_FALSE(as_seen(pair, precision, shapes, &why));
  return why;
}

TEST(ShapesSeen, ByThoseWhoDeclareThem) {
  const Case pair{"id", ball(1), block(1)};
  const Case both = *as_seen(pair, Precision::binary64, {"sphere", "box"});
  EXPECT_TRUE(both.a.shape && both.a.words && both.b.words);
  EXPECT_FALSE(both.b.shape) << "a box is a polytope, whoever takes it";
  const Case points = *as_seen(pair, Precision::binary64, {"sphere"});
  EXPECT_TRUE(points.a.words);
  EXPECT_FALSE(points.b.words);
  EXPECT_EQ(points.b.points.size(), 8U);
  EXPECT_EQ(why_not(pair, {"box"}), R"(the subject does not declare "sphere" among its shapes)");
  EXPECT_EQ(why_not(pair, {}), R"(the subject does not declare "sphere" among its shapes)");
}

TEST(ShapesSeen, MarginsAndSums) {
  const Case rounded{"id", body("rounded_box", {{"half", {1, 1, 1}}, {"margin", {tenth}}}), block(1)};
  EXPECT_EQ(why_not(rounded, {"box"}), R"(the subject does not declare "margin" among its shapes)");
  EXPECT_EQ(as_seen(rounded, Precision::binary64, {"box", "margin"})->a.words->shape, "box") << "with a margin";
  const Case flat{"id", body("sphere", {{"radius", {1}}, {"margin", {0}}}), block(1)};
  EXPECT_TRUE(as_seen(flat, Precision::binary64, {"sphere"})) << "a margin of 0 is none";
  const NamedBody terms[] = {named("sphere", {{"radius", {1}}}),
                             named("cylinder", {{"radius", {1}}, {"half_length", {2}}})};
  const Case sum{"id", files::body_of(files::named_sum({terms[0], terms[1]})), block(1)};
  EXPECT_EQ(why_not(sum, {"sphere", "cylinder"}), R"(the subject does not declare "sum" among its shapes)");
  EXPECT_EQ(why_not(sum, {"sphere", "sum"}), R"(the subject does not declare "cylinder" among its shapes)");
  EXPECT_TRUE(as_seen(sum, Precision::binary64, {"sphere", "cylinder", "sum"}));
  const Case planes{"id", body("halfspace", {{"normal", {0, 0, 1}}, {"offset", {0}}}),
                    body("halfspace", {{"normal", {0, 1, 0}}, {"offset", {0}}})};
  EXPECT_EQ(why_not(planes, {"halfspace"}), "both bodies are half-spaces, which have no depth");
}

TEST(ShapesSeen, EveryNumberIsRounded) {
  NamedBody given = named("capsule", {{"radius", {tenth}}, {"half_length", {tenth * 3}}, {"margin", {tenth * 7}}});
  given = posed(given, {1, tenth, 0, 0}, {tenth, 0, tenth * 2});
  const Body seen = as_seen({"id", files::body_of(given), block(1)}, Precision::binary32, every_word())->a;
  const NamedBody& words = *seen.words;
  EXPECT_EQ(words.fields.numbers.at("radius").front(), exact_value(0.1F));
  EXPECT_EQ(words.fields.numbers.at("half_length").front(), exact_value(0.3F));
  EXPECT_EQ(words.fields.numbers.at("margin").front(), exact_value(0.7F));
  EXPECT_EQ(words.turn, (Quaternion{1, exact_value(0.1F), 0, 0})) << "of any length: an exact rotation";
  EXPECT_EQ(words.place, (Point{exact_value(0.1F), 0, exact_value(0.2F)}));
  EXPECT_EQ(*seen.shape, files::shape_of(words)) << "and the shape is the one of these words";
  NamedBody matrix = named("ellipsoid", {{"radii", {1, tenth, 2}}});
  matrix.matrix = Pose{{{1, 0, 0, tenth}, {0, tenth, 0, 0}, {0, 0, 1, 0}}};
  const Body placed = as_seen({"id", files::body_of(matrix), block(1)}, Precision::binary32, every_word())->a;
  EXPECT_EQ((*placed.words->matrix)[1][1], exact_value(0.1F));
  EXPECT_EQ((*placed.words->matrix)[0][3], exact_value(0.1F));
  EXPECT_EQ(*placed.shape, files::shape_of(*placed.words));
}

TEST(ShapesSeen, RoundingThatLeavesNoShape) {
  const mpq_class tiny("1/1" + std::string(60, '0')), huge("1" + std::string(60, '0'));
  const auto why = [&](const Body& bad, Precision precision = Precision::binary32) {
    return why_not({"id", bad, block(1)}, every_word(), precision);
  };
  EXPECT_EQ(why(ball(tiny)), "rounding to binary32 leaves no shape: the radius of a sphere is not positive: 0");
  EXPECT_EQ(why(ball(huge)), "a number of a shape overflows binary32, the precision of the subject");
  EXPECT_TRUE(as_seen({"id", ball(tiny), block(1)}, Precision::binary64, every_word()));
  EXPECT_TRUE(why(files::body_of(posed(named("sphere", {{"radius", {1}}}), {tiny, 0, 0, 0}, {1, 0, 0})))
                  .starts_with("rounding to binary32 leaves "));
  EXPECT_TRUE(
      why(body("halfspace", {{"normal", {0, 0, tiny}}, {"offset", {0}}})).starts_with("rounding to binary32 leaves "));
  EXPECT_EQ(why(block(huge)), "a number of a shape overflows binary32, the precision of the subject");
  EXPECT_EQ(why_not({"id", block(huge), block(1)}, {}, Precision::binary32),
            "a coordinate overflows binary32, the precision of the subject");
}

TEST(ShapesSeen, AsWordsOnTheWire) {
  NamedBody given = posed(named("capsule", {{"radius", {mpq_class(1, 2)}}, {"half_length", {1}}, {"margin", {tenth}}}),
                          {1, 1, 0, 0}, {0, 0, tenth});
  const Case pair{"id", files::body_of(given), block(1)};
  const auto message = [&](Precision precision, const std::set<std::string>& shapes) {
    return run_message("7", *as_seen(pair, precision, shapes), precision, true);
  };
  EXPECT_EQ(message(Precision::binary64, every_word()),
            R"({"type":"run","id":"7","a":{"shape":"capsule","radius":0.5,"half_length":1,"axis":"z","margin":0.1,)"
            R"("pose":{"quaternion":[1,1,0,0],"translation":[0,0,0.1]}},)"
            R"("b":{"shape":"box","half":[1,1,1],"pose":{"quaternion":[1,0,0,0],"translation":[0,0,0]}}})");
  EXPECT_NE(message(Precision::binary32, every_word()).find(R"("margin":0.10000000149011612,)"), std::string::npos);
  EXPECT_NE(message(Precision::binary64, {"capsule", "margin"}).find(R"("b":{"vertices":[[)"), std::string::npos);
  EXPECT_NE(message(Precision::binary64, {"capsule", "margin"}).find(R"("faces":[[)"), std::string::npos);
}

TEST(ShapesSeen, AgainAsTheyAreAndWithADigestOfTheirOwn) {
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    std::set<std::string> digests;
    for (const families::Family& family : families::families(families::Kind::shapes)) {
      const Case pair = family.make(3, family.usual_size);
      const std::optional<Case> seen = as_seen(pair, precision, every_word());
      ASSERT_TRUE(seen) << family.name;
      const Case again = *as_seen(*seen, precision, every_word());
      EXPECT_EQ(run_message("1", again, precision, false), run_message("1", *seen, precision, false));
      EXPECT_EQ(digest_of(again), digest_of(*seen));
      digests.insert(digest_of(*seen));
    }
    EXPECT_EQ(digests.size(), families::families(families::Kind::shapes).size());
  }
}

TEST(ShapesSeen, HelloNamesThem) {
  const auto hello = [](const std::string& shapes) {
    return R"({"type":"hello","protocol":"fathom/subject/1","name":"x","version":"1","precision":"binary64","conventions":)"
           R"({"touching":"either","depth":"positive","moves":"a","unit":true},"capabilities":{"shapes":)" +
           shapes + "}}";
  };
  const SubjectInfo info = read_hello(hello(R"(["sphere","cone","margin","halfspace"])"));
  EXPECT_EQ(info.shapes, (std::set<std::string>{"cone", "halfspace", "margin", "sphere"}));
  EXPECT_EQ(hello_text(read_hello(hello_text(info))), hello_text(info));
  EXPECT_EQ(read_hello(hello_text(info)).shapes, info.shapes);
  EXPECT_TRUE(read_hello(hello("[]")).shapes.empty());
  for (const char* wrong :
       {R"(["cube"])", R"(["rounded_box"])", R"([3])", R"("sphere")", R"({"sphere":true})", R"([""])"}) {
    try {
      read_hello(hello(wrong));
      ADD_FAILURE() << wrong;
    } catch (const ProtocolError& error) {
      EXPECT_NE(std::string(error.what()).find("\"shapes\" in its capabilities"), std::string::npos) << error.what();
    }
  }
}

/// low <= x <= high of the one and of the other have a value in common.
bool overlapping(const SignedDepth& x, const SignedDepth& y, const mpq_class& factor) {
  const auto low = [](const SignedDepth& d) { return d.bounds() ? d.bounds()->low : exact_value(d.low_binary64()); };
  const auto high = [](const SignedDepth& d) { return d.bounds() ? d.bounds()->high : exact_value(d.high_binary64()); };
  return low(x) * factor <= high(y) && low(y) <= high(x) * factor;
}

TEST(ShapesSeen, VariantsAreTheSameProblem) {
  std::set<std::string> made;
  for (const families::Family& family : families::families(families::Kind::shapes)) {
    const std::optional<Case> seen = as_seen(family.make(5, family.usual_size), Precision::binary32, every_word());
    ASSERT_TRUE(seen);
    const ShapeTruth truth = truth_about(files::shape_of(seen->a), files::shape_of(seen->b));
    for (const Variant& variant : variants(*seen, Precision::binary32, all_variants)) {
      const ShapeTruth anew = truth_about(files::shape_of(variant.seen.a), files::shape_of(variant.seen.b));
      EXPECT_TRUE(overlapping(truth.depth, anew.depth, scaled(1, variant.exponent)))
          << family.name << ' ' << variant.name;
      EXPECT_NE(digest_of(variant.seen), digest_of(*seen));
      for (const Body* moved : {&variant.seen.a, &variant.seen.b}) {
        ASSERT_TRUE(moved->words) << variant.name;
        EXPECT_EQ(files::shape_of(*moved), files::shape_of(*moved->words));
        EXPECT_EQ(rounded(*moved->words, Precision::binary32)->place, moved->words->place);
      }
      if (variant.name == "translate") EXPECT_FALSE(variant.seen.a.words->place == seen->a.words->place);
      made.insert(variant.name);
    }
  }
  EXPECT_EQ(made.size(), all_variants.size());
}

TEST(ShapesSeen, TheTruthIsProved) {
  const Case exact{"exact", ball(1), body("sphere", {{"radius", {mpq_class(1, 3)}}})};
  const Case enclosed{"enclosed", body("cylinder", {{"radius", {1}}, {"half_length", {1}}}),
                      body("ellipsoid", {{"radii", {1, 2, 3}}})};
  for (const Case& pair : {exact, enclosed}) {
    const std::string text = accepted_certificate(pair, nullptr);
    EXPECT_TRUE(fathom_check::verify(text).accepted());
    EXPECT_NE(text.find(pair.id), std::string::npos);
    ShapeTruth truth = truth_about(files::shape_of(pair.a), files::shape_of(pair.b));
    EXPECT_EQ(accepted_certificate(pair.id, truth, nullptr), text);
    if (truth.depth.bounds())
      truth.depth.value = Bounds{truth.depth.bounds()->high + 1, truth.depth.bounds()->high + 2};
    else truth.depth.value = Surd{truth.depth.exact()->rational + 1, truth.depth.exact()->root};
    EXPECT_THROW(accepted_certificate(pair.id, truth, nullptr), std::logic_error);
  }
}

TEST(ShapesSeen, AreJudgedAsTheyWereSeen) {
  SubjectInfo info;
  info.format = Precision::binary32;
  info.shapes = {"sphere"};
  const Case pair{
      "id", ball(tenth),
      files::body_of(posed(named("sphere", {{"radius", {tenth}}}), {1, 0, 0, 0}, {mpq_class(3, 20), 0, 0}))};
  const Case seen = *as_seen(pair, info.format, info.shapes);
  Reply reply;
  reply.overlap = true;
  reply.depth = round_binary32(2 * exact_value(0.1F) - exact_value(0.15F));
  reply.direction = Triple{-1, 0, 0};
  Judging judging;
  judging.tolerance = {0, 0, 0};
  Outcome outcome = outcome_for(seen);
  judge_answer(outcome, seen, {"", reply}, info, judging);
  EXPECT_EQ(outcome.judgement->accuracy, Accuracy::correctly_rounded) << outcome.judgement->sentence;
  const std::optional<Outcome> read = read_outcome(outcome_line(outcome));
  ASSERT_TRUE(read);
  EXPECT_EQ(outcome_line(*read), outcome_line(outcome));
  EXPECT_EQ(read->judgement->signed_depth, outcome.judgement->signed_depth);
  EXPECT_EQ(read->judgement->separating_distance, outcome.judgement->separating_distance);
  outcome.judgement->status.reset();
  EXPECT_NE(outcome_line(outcome).find(R"("status":"undecided")"), std::string::npos);
  EXPECT_FALSE(read_outcome(outcome_line(outcome))->judgement->status);
}

}  // namespace
}  // namespace fathom::harness
