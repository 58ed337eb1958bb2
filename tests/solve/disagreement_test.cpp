// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/solve/disagreement.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "verify/families/catalogue.hpp"
#include "verify/families/families.hpp"

namespace fathom::solve {
namespace {

Depth depth_of(const Case& pair) { return penetration_depth(pair.a.points, pair.b.points); }

/// Four optima.
Depth penetrating() {
  const Body square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}}};
  return depth_of({"square prisms", square, square});
}
Depth touching() {
  return depth_of({"touching", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{0, 0, 0}, {-1, 0, 0}, {0, -1, 1}}}});
}
Depth disjoint() { return depth_of({"disjoint", {{{0, 0, 0}, {1, 0, 0}}}, {{{0, 2, 1}, {1, 3, 1}}}}); }

/// Changes one field; the sentence must begin with its name.
struct Change {
  const char* field;
  std::function<void(Depth&)> change;
};

void expect_named(const std::function<Depth()>& make, const std::vector<Change>& changes) {
  const Depth right = make();
  EXPECT_EQ(disagreement(right, right), std::nullopt);
  for (const Change& change : changes) {
    Depth wrong = right;
    change.change(wrong);
    for (const auto& sentence : {disagreement(right, wrong), disagreement(wrong, right)})
      EXPECT_TRUE(sentence && sentence->starts_with(std::string(change.field) + ": "))
          << change.field << " / " << sentence.value_or("none");
  }
}

Penetration& in(Depth& depth) { return std::get<Penetration>(depth.outcome); }
Witness& with_another_witness(Depth& depth) { return in(depth).meeting.emplace<Witness>(in(depth).witness()); }

TEST(Disagreement, NamesTheFieldOfPenetration) {
  ASSERT_EQ(penetrating().optima().size(), 4u);
  expect_named(penetrating,
               {{"status",
                 [](Depth& d) {
                   d.outcome = Touch{{1, 0, 0}, {0, 0, 0}};
                 }},
                {"flat_a", [](Depth& d) { d.flat_a = true; }},
                {"flat_b", [](Depth& d) { d.flat_b = true; }},
                {"squared", [](Depth& d) { in(d).optima[0].support += mpq_class(1, 1000); }},
                {"number of optima", [](Depth& d) { in(d).optima.pop_back(); }},
                {"optima[3].direction", [](Depth& d) { in(d).optima[3].direction.z += 1; }},
                {"optima[2].translation", [](Depth& d) { in(d).optima[2].support += 1; }},
                {"optima[1].contact", [](Depth& d) { in(d).optima[1].contact.kind = ContactKind::edge_edge; }},
                {"optima[0].contact", [](Depth& d) { in(d).optima[0].contact.a.pop_back(); }},
                {"optima[0].contact", [](Depth& d) { in(d).optima[0].contact.b.front() += 9; }},
                {"witness", [](Depth& d) { with_another_witness(d).a.y += 1; }},
                {"witness", [](Depth& d) { with_another_witness(d).b.z += 1; }}});
}

TEST(Disagreement, NamesTheFieldOfTouchingAndDisjointBodies) {
  ASSERT_EQ(touching().status(), Status::touching);
  expect_named(touching, {{"direction", [](Depth& d) { std::get<Touch>(d.outcome).direction.x += 1; }},
                          {"witness", [](Depth& d) { std::get<Touch>(d.outcome).point.x += 1; }}});
  ASSERT_EQ(disjoint().status(), Status::disjoint);
  expect_named(disjoint, {{"direction", [](Depth& d) { std::get<Distance>(d.outcome).direction.x += 1; }},
                          {"distance.squared", [](Depth& d) { std::get<Distance>(d.outcome).squared += 1; }},
                          {"distance.translation", [](Depth& d) { std::get<Distance>(d.outcome).translation.x += 1; }},
                          {"distance.witness", [](Depth& d) { std::get<Distance>(d.outcome).witness.a.x += 1; }}});
}

TEST(Disagreement, DoesNotMindWhatDependsOnTheMethod) {
  const Case pair = families::find_family("random_ball")->make(1, 12);
  const Depth x = depth_of(pair), y = penetration_depth(pair.a.points, pair.b.points, {.method = Method::exact});
  ASSERT_NE(x.method, y.method);
  ASSERT_NE(x.extreme_a, y.extreme_a);
  EXPECT_EQ(disagreement(x, y), std::nullopt);
}

TEST(Disagreement, SaysBothValues) {
  Depth wrong = penetrating();
  in(wrong).optima[0].support = mpq_class(1, 2);
  EXPECT_EQ(disagreement(penetrating(), wrong), "squared: 1 and 1/4");
  wrong = penetrating();
  in(wrong).optima[0].contact.a.pop_back();
  const std::string kind = "facet-facet: points ";
  EXPECT_EQ(disagreement(penetrating(), wrong),
            "optima[0].contact: " + kind + "1 2 5 6 of A, 0 3 4 7 of B and " + kind + "1 2 5 of A, 0 3 4 7 of B");
}

TEST(SecondMethod, IsExactOrNaive) {
  EXPECT_EQ(second_method("exact"), Method::exact);
  EXPECT_EQ(second_method("naive"), Method::naive);
  for (const char* word : {"automatic", "auto", "certificate", "", "Exact"}) EXPECT_FALSE(second_method(word)) << word;
}

}  // namespace
}  // namespace fathom::solve
