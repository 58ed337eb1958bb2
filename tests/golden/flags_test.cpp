// SPDX-License-Identifier: GPL-3.0-or-later
// Each flag on a pair that has it, and none on a pair that has none; all of them are explained in
// the notes and known to the schema.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <vector>

#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/polytope.hpp"
#include "tests/golden/forged.hpp"
#include "tests/golden/some_recipes.hpp"
#include "tests/support/monitors.hpp"
#include "verify/families/families.hpp"
#include "verify/golden/records/facts.hpp"
#include "verify/golden/records/prove.hpp"
#include "verify/golden/records/record.hpp"
#include "verify/golden/release/release.hpp"

namespace fathom::golden {
namespace {

using testing::Json;
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

// Faces by their definition against the faces of convex hulls.

// Every facet, every edge (in the sum of its facets' directions) and every vertex of bodies with
// repeated, collinear and interior points.
TEST(Faces, AreThoseOfTheHull) {
  for (const char* name :
       {"redundant_points", "boxes_aligned", "degraded_coplanar_points", "solid_polygon", "random_lattice"}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Case pair = families::find_family(name)->make(seed, 10);
      const Integers bodies = integers_of(pair.a.points, pair.b.points);
      for (const std::vector<Vector>* points : {&bodies.a, &bodies.b}) {
        const polytope::Polytope hull = polytope::convex_hull(*points);
        for (const polytope::Facet& facet : hull.facets) {
          std::vector<std::uint32_t> corners;
          for (std::uint32_t i = facet.begin; i < facet.end; ++i) corners.push_back(hull.input_ids[hull.corners[i]]);
          std::ranges::sort(corners);
          EXPECT_EQ(face_in_direction(*points, facet.normal).corners, corners) << pair.id;
        }
        if (hull.rank < 3) continue;
        for (const polytope::Edge& edge : hull.edges) {
          const std::vector<std::uint32_t> ends{hull.input_ids[edge.from], hull.input_ids[edge.to]};
          EXPECT_EQ(face_in_direction(*points, hull.facets[edge.left].normal + hull.facets[edge.right].normal).corners,
                    ends)
              << pair.id;
        }
      }
    }
  }
}

TEST(Faces, HoldTheirPointsAndNoOthers) {
  const std::vector<Point> points{
      {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {2, 2, 0}, {1, 1, 3}, {mpq_class(1, 3), 0, 0}};
  const Integers bodies = integers_of(points, points);
  EXPECT_EQ(bodies.denominator, 3);
  const Vector down{0, 0, -1}, side{-3, 0, 1}, corner{-1, -2, -3};
  const SupportingFace square = face_in_direction(bodies.a, down), edge = face_in_direction(bodies.a, side),
                       tip = face_in_direction(bodies.a, corner);
  EXPECT_EQ(square.corners, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  EXPECT_EQ(tip.corners, (std::vector<std::uint32_t>{0}));
  const auto in = [&](const SupportingFace& face, const Vector& n, const Point& p) {
    return contains(face, n, bodies.denominator, p);
  };
  for (const Point& p : {points[0], points[4], points[6], mpq_class(1, 2) * (points[1] + points[3]),
                         Point{mpq_class(1, 7), mpq_class(1, 5), 0}})
    EXPECT_TRUE(in(square, down, p));
  for (const Point& p : {points[5], Point{2, 2, mpq_class(1, 9)}, Point{mpq_class(-1, 99), 1, 0}, Point{5, 0, 0},
                         Point{4, mpq_class(41, 10), 0}})
    EXPECT_FALSE(in(square, down, p));
  EXPECT_TRUE(in(tip, corner, points[0]));
  EXPECT_FALSE(in(tip, corner, points[6]));
  ASSERT_EQ(edge.corners.size(), 3u) << "0, 2 and 5 lie in one plane";
}

TEST(Faces, EdgesEndAtTheirEnds) {
  const std::vector<Point> points{{0, 0, 0}, {2, 4, 6}, {1, 2, 3}, {5, 0, 0}};
  const Vector n{-7, 2, 1};  // <n, (1,2,3)> = 0
  const Integers bodies = integers_of(points, points);
  const SupportingFace edge = face_in_direction(bodies.a, n);
  EXPECT_EQ(edge.corners, (std::vector<std::uint32_t>{0, 1}));
  const auto in = [&](const Point& p) { return contains(edge, n, bodies.denominator, p); };
  EXPECT_TRUE(in(points[0]) && in(points[1]) && in(points[2]));
  EXPECT_TRUE(in({mpq_class(1, 3), mpq_class(2, 3), 1}));
  EXPECT_FALSE(in({3, 6, 9}));
  EXPECT_FALSE(in({-1, -2, -3}));
  EXPECT_FALSE(in({0, -1, 2}));
}

// The CSV says what the records say.

std::vector<Record> sample() {
  std::vector<Record> result;
  for (const Recipe& recipe :
       {Recipe{Source::family, "boxes_posed", 8, 5}, Recipe{Source::family, "solid_point", 4, 2},
        Recipe{Source::family, "touching_vertex_face", 4, 1}, Recipe{Source::family, "random_disjoint", 4, 1},
        Recipe{Source::family, "random_ball", 5, 2}}) {
    for (Record& record : records_of(recipe)) result.push_back(std::move(record));
  }
  return result;
}

std::vector<std::string> fields(const std::string& row) {
  EXPECT_TRUE(row.ends_with('\n'));
  std::vector<std::string> result{""};
  for (const char c : row.substr(0, row.size() - 1)) {
    if (c == ',') result.emplace_back();
    else result.back() += c;
  }
  return result;
}

TEST(Csv, RowsHaveTheColumnsOfTheHeader) {
  const std::vector<std::string> header = fields(csv_header());
  const auto column = [&header](const std::vector<std::string>& row, const std::string& name) {
    const auto at = std::ranges::find(header, name);
    EXPECT_NE(at, header.end()) << name;
    return row[static_cast<std::size_t>(at - header.begin())];
  };
  for (const Record& record : sample()) {
    const std::string text = record.csv_row;
    ASSERT_EQ(!text.empty(), record.in_binary64) << record.id;
    if (text.empty()) continue;
    const std::vector<std::string> row = fields(text);
    ASSERT_EQ(row.size(), header.size()) << record.id;
    const Json parsed = Json::parse(record.line);
    const Json& expected = parsed["expected"];
    EXPECT_EQ(column(row, "id"), record.id);
    EXPECT_EQ(column(row, "status"), expected["status"]);
    EXPECT_EQ(column(row, "format"), record.in_binary32 ? "binary32" : "binary64");
    EXPECT_EQ(column(row, "depth_squared"), expected["depth"]["squared"]);
    EXPECT_EQ(column(row, "depth_f64_ru"), expected["depth"]["f64"]["ru"]);
    EXPECT_EQ(column(row, "depth_f32_rd"), expected["depth"]["f32"]["rd"]);
    EXPECT_EQ(column(row, "optima"), std::to_string(expected["optima"].size()));
    EXPECT_EQ(column(row, "a_count"), std::to_string(parsed["a"]["vertices"].size()));
    std::istringstream points(column(row, "b_points"));
    for (const Json& vertex : parsed["b"]["vertices"]) {
      for (const Json& coordinate : vertex) {
        std::string hex;
        points >> hex;
        EXPECT_EQ(hex, coordinate) << record.id;
      }
    }
    std::string more;
    EXPECT_FALSE(points >> more);
  }
}

TEST(Csv, LeavesOutWhatIsNotBinary64) {
  const std::vector<Record> records = records_of({Source::family, "boxes_posed", 8, 5});
  ASSERT_EQ(records.size(), 3u);
  EXPECT_EQ(records[0].csv_row, "");
  for (const std::size_t i : {1U, 2U}) EXPECT_NE(records[i].csv_row, "");
}

TEST(Csv, WritesInfinity) {
  constexpr double largest = std::numeric_limits<double>::max();
  const Body box{GivenPoints(std::vector<std::array<double, 3>>{{-largest, -largest, -largest},
                                                                {largest, largest, largest},
                                                                {-largest, largest, largest},
                                                                {largest, -largest, largest},
                                                                {largest, largest, -largest},
                                                                {largest, -largest, -largest},
                                                                {-largest, largest, -largest},
                                                                {-largest, -largest, largest}})};
  const Record record = record_of({Source::family, "by_hand", 0, 0}, {Form::given, "by_hand", HullPair{box, box}});
  EXPECT_NE(record.csv_row.find(",inf,0x1.fffffffffffffp+1023,inf,"), std::string::npos);
}

// Whatever is changed in a record, the other methods notice. That they give what is right:
// prove_test.cpp.

using testing::read;

/// Every place of a value below `json`, as a JSON pointer.
void leaves_of(const Json& json, const std::string& path, std::vector<std::string>& leaves) {
  if (!json.is_structured()) return leaves.push_back(path);
  for (const auto& [key, value] : json.items()) leaves_of(value, path + "/" + key, leaves);
}

/// Another value of the same kind.
Json other(const Json& value) {
  if (value.is_number()) return value.get<std::uint64_t>() + 1;
  if (value.is_null()) return "0";
  std::string text = value;
  text.back() = text.back() == '1' ? '2' : '1';
  return text;
}

TEST(Recompute, NoticesEveryChangedValue) {
  std::size_t changed = 0;
  for (const Recipe& recipe :
       {Recipe{Source::family, "random_ball", 6, 4}, Recipe{Source::family, "exact_ties", 6, 2},
        Recipe{Source::family, "touching_edge_face", 4, 1}, Recipe{Source::family, "random_disjoint", 4, 1},
        Recipe{Source::shape_family, "capsules", 8, 1}, Recipe{Source::union_catalogue, "cavity_too_small"},
        Recipe{Source::union_catalogue, "gap_of_a_body"}}) {
    const Record record = records_of(recipe).front();
    const Json right = Json::parse(record.line);
    for (const char* part : {"/expected", "/flags", "/formats"}) {
      std::vector<std::string> leaves;
      if (!right.contains(Json::json_pointer(part))) continue;  // shapes and unions have no flags
      leaves_of(right.at(Json::json_pointer(part)), part, leaves);
      for (const std::string& leaf : leaves) {
        Json wrong = right;
        Json& value = wrong[Json::json_pointer(leaf)];
        value = other(value);
        const std::optional<std::string> sentence = disagreement_with(Method::exact, wrong.dump());
        EXPECT_TRUE(sentence && sentence->starts_with("by the method exact: ")) << record.id << leaf;
        ++changed;
      }
    }
  }
  EXPECT_GT(changed, 200u);
}

TEST(Recompute, SaysWhereAndHow) {
  const Record record = records_of({Source::family, "random_ball", 6, 4}).front();
  Json wrong = Json::parse(record.line);
  const std::string right = wrong["expected"]["depth"]["squared"].dump();
  wrong["expected"]["depth"]["squared"] = "1/7";
  EXPECT_EQ(disagreement_with(Method::naive, wrong.dump()),
            "by the method naive: expected.depth.squared: expected " + right + ", found \"1/7\"");
  EXPECT_EQ(disagreement_with(Method::exact, "{}").value_or("").substr(0, 41),
            "by the method exact: expected a record, f");
}

TEST(Recompute, CanBeStopped) {
  const Record record = records_of({Source::family, "random_ball", 6, 4}).front();
  fathom::testing::Recorder impatient(0);
  EXPECT_THROW(disagreement_with(Method::exact, record.line, &impatient), Interrupted);
}

TEST(Recompute, ShapesNeedAnotherSignedDepthToDiffer) {
  Json wrong = Json::parse(records_of({Source::shape_family, "capsules", 8, 1}).front().line);
  wrong["expected"]["signed_depth"]["exact"]["plus"] = "100";
  EXPECT_EQ(disagreement_with(Method::naive, wrong.dump()),
            "by the method naive: expected.signed_depth: the bodies, turned and exchanged, have another one");
  wrong = Json::parse(testing::enclosed_record().line);
  Json& bounds = wrong["expected"]["signed_depth"]["bounds"];
  for (Json& bound : bounds) bound = exact_text(mpq_class(read(bound) + mpq_class(1, 1000)));
  EXPECT_NE(disagreement_with(Method::exact, wrong.dump()).value_or("").find("have another one"), std::string::npos);
  bounds = Json::array();
  EXPECT_NE(disagreement_with(Method::exact, wrong.dump()).value_or("").find("expected a record"), std::string::npos);
}

TEST(Recompute, NearestPiecesMustBeTheNearest) {
  const auto by_exact = [](const Json& line) { return disagreement_with(Method::exact, line.dump()).value_or(""); };
  Json wrong = Json::parse(records_of({Source::union_catalogue, "gap_of_a_body"}).front().line);
  ASSERT_EQ(wrong["expected"]["distance"]["pieces"], (Json{0, 0}));
  wrong["expected"]["distance"]["pieces"] = {0, 7};
  EXPECT_NE(by_exact(wrong).find("there are no such pieces"), std::string::npos);
  const Json chain = Json::parse(records_of({Source::union_catalogue, "rings_linked"}).front().line);
  EXPECT_EQ(by_exact(chain), "");
  const std::uint32_t a = chain["expected"]["distance"]["pieces"][0];
  wrong = chain;
  wrong["expected"]["distance"]["pieces"][0] = (a + 2) % 4;
  EXPECT_NE(by_exact(wrong).find("not the nearest"), std::string::npos) << by_exact(wrong);
  wrong["expected"]["distance"].erase("pieces");
  EXPECT_NE(by_exact(wrong).find("expected a record"), std::string::npos);
}

}  // namespace
}  // namespace fathom::golden
