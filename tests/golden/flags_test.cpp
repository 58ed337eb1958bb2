// SPDX-License-Identifier: GPL-3.0-or-later
// Each flag on a pair that has it, and none on a pair that has none; all of them are explained in
// the notes and known to the schema.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "fathom/numbers.hpp"
#include "verify/golden/records/facts.hpp"
#include "verify/golden/records/record.hpp"
#include "verify/golden/release/embedded_pages.hpp"

namespace fathom::golden {
namespace {

using Json = nlohmann::json;
using Names = std::set<std::string>;

mpq_class exact(const std::string& text) { return *parse_number(text, Decimals::exact).value; }

/// "0 0 0  1 0 0": coordinates as texts.
Body body(const std::string& text) {
  std::istringstream in(text);
  Body result;
  for (std::string x, y, z; in >> x >> y >> z;) result.points.push_back({exact(x), exact(y), exact(z)});
  return result;
}

Body scaled(Body body, const mpq_class& by) {
  for (Point& p : body.points.edit()) p = {p.x * by, p.y * by, p.z * by};
  return body;
}

Body moved(Body body, const mpq_class& x) {
  for (Point& p : body.points.edit()) p.x += x;
  return body;
}

const Body tetrahedron = body("0 0 0  7 1 0  1 8 2  2 1 9");
const Body other_tetrahedron = body("2 2 3  12 3 2  3 11 6  5 4 14");
const Body cube = body("0 0 0  2 0 0  0 2 0  2 2 0  0 0 2  2 0 2  0 2 2  2 2 2");
const Body square = body("0 0 0  4 0 0  0 4 0  4 4 0");
const Body point = body("5 1 3");

Json record(const Body& a, const Body& b) {
  return Json::parse(record_of({Source::family, "by_hand", 0, 0}, {Form::given, "by_hand", HullPair{a, b}}).line);
}

Names flags(const Body& a, const Body& b) { return record(a, b)["flags"].get<Names>(); }

void expect(const std::string& flag, const Body& a, const Body& b) { EXPECT_TRUE(flags(a, b).contains(flag)) << flag; }

TEST(Flags, AreNoneOnAPlainPair) { EXPECT_EQ(flags(tetrahedron, other_tetrahedron), Names{}); }

TEST(Flags, OfFlatBodies) {
  EXPECT_EQ(flags(square, other_tetrahedron).count("flat_a") + flags(square, other_tetrahedron).count("flat_b"), 1u);
  expect("flat_b", tetrahedron, point);
  expect("flat_difference", square, square);
  EXPECT_FALSE(flags(square, tetrahedron).contains("flat_difference"));
}

TEST(Flags, OfTies) {
  expect("ties", cube, cube);
  expect("all_tie", cube, cube);
  const Body longer = body(
      "0 0 0  2 0 0  0 2 0  2 2 0  0 0 200000001/100000000  2 0 200000001/100000000  0 2 200000001/100000000 2 2 "
      "200000001/100000000");
  expect("near_tie", cube, longer);
  EXPECT_FALSE(flags(cube, longer).contains("all_tie"));
  EXPECT_FALSE(flags(cube, moved(cube, 1)).contains("near_tie"));
  EXPECT_FALSE(flags(cube, moved(cube, 1)).contains("ties"));
}

TEST(Flags, OfPointsAndFeatures) {
  Body twice = tetrahedron, inner = tetrahedron;
  twice.points.push_back(twice.points.front());
  inner.points.push_back({2, 2, 2});
  EXPECT_EQ(flags(twice, other_tetrahedron), Names{"duplicate_points"});
  EXPECT_EQ(flags(other_tetrahedron, inner), Names{"redundant_points"});
  const Body shared = body("0 0 0  -3 5 1  4 -6 11  -5 -7 3");
  EXPECT_EQ(flags(tetrahedron, shared).count("shared_points"), 1u);
  expect("identical_bodies", tetrahedron, tetrahedron);
  EXPECT_FALSE(flags(tetrahedron, shared).contains("identical_bodies"));
  for (const char* flag :
       {"degenerate_contact", "polygonal_facets", "parallel_edges", "equal_normals", "opposite_normals"})
    expect(flag, cube, moved(cube, exact("1/2")));
  EXPECT_TRUE(flags(tetrahedron, moved(tetrahedron, 1)).contains("equal_normals"));
  EXPECT_FALSE(flags(tetrahedron, moved(tetrahedron, 1)).contains("opposite_normals"));
}

TEST(Flags, OfCoordinates) {
  const mpq_class huge = exact("0x1p128");
  expect("huge_coordinates", scaled(tetrahedron, huge), scaled(other_tetrahedron, huge));
  EXPECT_FALSE(
      flags(scaled(tetrahedron, huge / 16), scaled(other_tetrahedron, huge / 16)).contains("huge_coordinates"));
  expect("tiny_coordinates", scaled(tetrahedron, exact("0x1p-130")), other_tetrahedron);
  expect("uneven_coordinates", scaled(tetrahedron, exact("0x1p-60")), other_tetrahedron);
  expect("offset_coordinates", moved(tetrahedron, exact("0x1p40")), moved(other_tetrahedron, exact("0x1p40")));
}

TEST(Flags, OfThinAndDeepPairs) {
  const mpq_class slightly = exact("0x1p-30");
  expect("thin_penetration", cube, moved(cube, 2 - slightly));
  expect("thin_clearance", cube, moved(cube, 2 + slightly));
  expect("deep_penetration", cube, cube);
  EXPECT_FALSE(flags(cube, moved(cube, exact("3/2"))).contains("deep_penetration"));
}

TEST(Flags, OfRounding) {
  const auto with_depth = [](const std::string& depth) { return flags(cube, moved(cube, 2 - exact(depth))); };
  const Names in_both = with_depth("1/2"), wide = with_depth("0x1.0000001p-2"), neither = with_depth("1/3");
  EXPECT_TRUE(in_both.contains("depth_in_binary64") && in_both.contains("depth_in_binary32"));
  EXPECT_TRUE(wide.contains("depth_in_binary64") && !wide.contains("depth_in_binary32"));
  EXPECT_FALSE(neither.contains("depth_in_binary64") || neither.contains("hard_rounding_binary64"));
  for (const char* hard : {"0x1.00000000000008p-1", "0x1.00000000000008000001p-1", "0x1.00000000000007ffffffp-1",
                           "0x1.0000000000001000001p-1"})
    EXPECT_TRUE(with_depth(hard).contains("hard_rounding_binary64")) << hard;
  EXPECT_FALSE(with_depth("0x1.00000000000004p-1").contains("hard_rounding_binary64"));
  EXPECT_TRUE(with_depth("0x1.000001p-1").contains("hard_rounding_binary32"));
  EXPECT_FALSE(with_depth("0x1.0000008p-1").contains("hard_rounding_binary32"));
  EXPECT_TRUE(with_depth("0x1p-1040").contains("depth_outside_binary64"));
  EXPECT_FALSE(with_depth("0x1p-1022").contains("depth_outside_binary64"));
  EXPECT_TRUE(with_depth("0x1p-130").contains("depth_outside_binary32"));
  const mpq_class huge = exact("0x1p1023");
  expect("depth_outside_binary64", scaled(cube, huge), scaled(cube, huge));
}

/// The flags that the page explains.
Names explained() {
  std::string_view page = notes();
  page.remove_prefix(page.find("## Flags"));
  page = page.substr(0, page.find("## ", 4));
  Names result;
  for (std::size_t at = 0; (at = page.find("\n| `", at)) != std::string_view::npos; ++at)
    result.insert(std::string(page.substr(at + 4, page.find('`', at + 4) - at - 4)));
  return result;
}

TEST(Flags, AreExplainedInTheNotesAndKnownToTheSchema) {
  const std::vector<std::string_view> names = flag_names();
  const Names all(names.begin(), names.end());
  EXPECT_EQ(all.size(), names.size()) << "a name twice";
  EXPECT_EQ(explained(), all);
  const Json schema = Json::parse(record_schema());
  EXPECT_EQ(schema["$defs"]["record_of_polytopes"]["properties"]["flags"]["items"]["enum"].get<Names>(), all);
}

TEST(Notes, ExplainEveryFieldOfARecord) {
  const Json penetrating = record(tetrahedron, other_tetrahedron), disjoint = record(tetrahedron, moved(cube, 100));
  for (const Json* part : {&penetrating, &disjoint, &penetrating["expected"], &disjoint["expected"],
                           &penetrating["expected"]["optima"][0]}) {
    for (const auto& [key, value] : part->items())
      EXPECT_NE(notes().find("`" + key + "`"), std::string_view::npos) << key;
  }
  for (const Recipe& recipe :
       {Recipe{Source::shape_catalogue, "sphere_centre_on_vertex"}, Recipe{Source::shape_family, "cylinders", 8, 1}}) {
    const Json shapes = Json::parse(records_of(recipe).front().line);
    for (const Json* part : {&shapes, &shapes["source"], &shapes["expected"], &shapes["expected"]["signed_depth"]})
      for (const auto& [key, value] : part->items())
        EXPECT_NE(notes().find("`" + key + "`"), std::string_view::npos) << key;
  }
}

}  // namespace
}  // namespace fathom::golden
