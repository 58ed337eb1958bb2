// SPDX-License-Identifier: GPL-3.0-or-later
// How bodies of the plane are put to a subject of the plane, and its replies read.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fathom/plane.hpp"
#include "fathom/shape.hpp"
#include "verify/families/families.hpp"
#include "verify/harness/journal.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/variants.hpp"

namespace fathom::harness {
namespace {

Body polygon(std::vector<Point> points) { return in_plane(Body{std::move(points)}); }
Body grown(const std::vector<Point>& core, const mpq_class& radius) {
  Body body;
  body.shape = with_margin(hull(core), radius);
  return in_plane(std::move(body));
}
const std::vector<Point> square = {{0, 0, 0}, {1, 0, 0}, {mpq_class(1, 2), mpq_class(1, 2), 0}, {1, 1, 0}, {0, 1, 0}};

TEST(PlaneSeen, WrittenWithTwoCoordinatesAndEdges) {
  const Case pair{"id", polygon(square), grown({{0, 2, 0}, {mpq_class(1, 10), 3, 0}}, mpq_class(1, 10))};
  const std::optional<Case> seen = as_seen(pair, Precision::binary32, {"capsule"}, nullptr, 2);
  ASSERT_TRUE(seen);
  EXPECT_EQ(
      run_message("1", *seen, Precision::binary32, true),
      R"({"type":"run","id":"1","a":{"vertices":[[0,0],[1,0],[0.5,0.5],[1,1],[0,1]],"faces":[[0,1],[1,3],[3,4],[4,0]]},)"
      R"("b":{"vertices":[[0,2],[0.10000000149011612,3]],"margin":0.10000000149011612}})");
  EXPECT_EQ(as_seen(*seen, Precision::binary32, {"capsule"}, nullptr, 2)->b.shape->radius, seen->b.shape->radius);
  EXPECT_TRUE(edges_in_plane({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}).empty());
}

TEST(PlaneSeen, ByThoseWhoTakeIt) {
  const auto why_not = [](const Case& pair, const std::set<std::string>& words, unsigned dimension) {
    std::string why;
    EXPECT_FALSE(as_seen(pair, Precision::binary64, words, &why, dimension));
    return why;
  };
  const Case of_plane{"id", polygon(square), grown({{0, 2, 0}}, 1)};
  const Case of_space{"id", Body{square}, Body{square}};
  EXPECT_EQ(why_not(of_space, {}, 2), "the bodies are of space, and the subject takes those of the plane alone");
  EXPECT_EQ(why_not(of_plane, {"circle"}, 3),
            "the bodies are of the plane, and the subject takes those of space alone");
  EXPECT_EQ(why_not(of_plane, {"capsule", "margin"}, 2), R"(the subject does not declare "circle" among its shapes)");
  EXPECT_EQ(why_not({"id", polygon(square), grown(square, 1)}, {"circle"}, 2),
            R"(the subject does not declare "margin" among its shapes)");
}

TEST(PlaneSeen, HellosAndRepliesOfThePlane) {
  const std::string rest = R"("name":"n","version":"1","precision":"binary64","conventions":)"
                           R"({"touching":"either","depth":"positive","moves":"a","unit":true})";
  const auto hello = [&](const std::string& more) {
    return read_hello(R"({"type":"hello","protocol":"fathom/subject/1",)" + rest + more + "}");
  };
  EXPECT_EQ(hello("").dimension, 3U);
  const SubjectInfo info = hello(R"(,"dimension":2,"capabilities":{"shapes":["circle","margin"]})");
  EXPECT_EQ(info.dimension, 2U);
  EXPECT_EQ(read_hello(hello_text(info)).dimension, 2U);
  for (const char* wrong :
       {R"(,"dimension":4)", R"(,"dimension":"2")", R"(,"dimension":2,"capabilities":{"shapes":["sphere"]})",
        R"(,"capabilities":{"shapes":["circle"]})", R"(,"dimension":2,"capabilities":{"twist":true})"})
    EXPECT_THROW(hello(wrong), ProtocolError) << wrong;
  const std::string said = R"({"type":"reply","id":"1","overlap":true,"depth":1,"direction":[0.5,-1],)"
                           R"("witness":{"a":[1,2],"b":[3,4]},"contacts":[{"position":[5,6]}],"hull":{"a":[[7,8]]}})";
  const SubjectAnswer answer = read_reply(said, Precision::binary64, 2);
  const Reply& reply = std::get<Reply>(answer.said);
  EXPECT_EQ(reply.direction, (Triple{0.5, -1, 0}));
  EXPECT_EQ(reply.witness_b, (Triple{3, 4, 0}));
  EXPECT_EQ(reply.contacts[0].position, (Triple{5, 6, 0}));
  EXPECT_EQ(answer.hull_a->front(), (Triple{7, 8, 0}));
  EXPECT_THROW(read_reply(said, Precision::binary64), ProtocolError);
  EXPECT_THROW(
      read_reply(R"({"type":"reply","id":"1","overlap":true,"depth":1,"direction":[0,1,0]})", Precision::binary64, 2),
      ProtocolError);
}

TEST(PlaneSeen, LinesHaveTwoCoordinates) {
  Outcome outcome;
  outcome.id = "id", outcome.dimension = 2, outcome.verdict = Verdict::witness_off;
  Reply& reply = outcome.reply.emplace();
  reply.overlap = true, reply.depth = 1, reply.direction = Triple{1, 0, 0};
  reply.contacts = {{{2, 3, 0}, 0.5}};
  outcome.judgement.emplace().findings = {Verdict::nan, Verdict::too_deep, Verdict::witness_off};
  const std::string line = outcome_line(outcome);
  EXPECT_TRUE(begins_line(line, "case")) << line;
  EXPECT_NE(line.find(R"("dimension":2)"), line.npos) << line;
  EXPECT_NE(line.find(R"("direction":[1.0,0.0])"), line.npos) << line;
  EXPECT_NE(line.find(R"("position":[2.0,3.0])"), line.npos) << line;
  const std::optional<Outcome> again = read_outcome(line);
  ASSERT_TRUE(again) << line;
  EXPECT_EQ(again->reply->direction, reply.direction);
  EXPECT_EQ(again->judgement->findings.size(), 3U);
  EXPECT_EQ(outcome_line(*again), line);
}

TEST(PlaneSeen, VariantsStayInThePlane) {
  const std::vector<std::string> all = {"swap", "translate", "permute", "scale"};
  for (const families::Family& family : families::families(families::Kind::plane)) {
    const Case pair = *as_seen(family.make(3, 6), Precision::binary64, {"circle", "capsule", "margin"});
    EXPECT_GE(variants(pair, Precision::binary64, all).size(), 2U) << pair.id;
    for (const Variant& variant : variants(pair, Precision::binary64, all)) {
      EXPECT_EQ(variant.step.z, 0) << pair.id;
      for (const Body* body : {&variant.seen.a, &variant.seen.b}) {
        EXPECT_EQ(body->dimension, 2U) << pair.id << ' ' << variant.name;
        EXPECT_NO_THROW(static_cast<void>(in_plane(*body))) << pair.id << ' ' << variant.name;
      }
      if (!variant.swapped) EXPECT_NE(digest_of(variant.seen), digest_of(pair)) << pair.id << ' ' << variant.name;
    }
  }
}

}  // namespace
}  // namespace fathom::harness
