// SPDX-License-Identifier: GPL-3.0-or-later

#include "reference/files/pose.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

#include "fathom/files.hpp"
#include "reference/files/cases.hpp"
#include "reference/files/shape_names.hpp"
#include "tests/support/property.hpp"

namespace fathom::files {
namespace {

mpq_class random_rational() {
  mpq_class value(*rc::gen::inRange(-1000, 1000), *rc::gen::inRange(1, 50));
  value.canonicalize();
  return value;
}
Point random_point() { return {random_rational(), random_rational(), random_rational()}; }
Pose random_pose() {
  Pose pose;
  for (auto& row : pose)
    for (mpq_class& entry : row) entry = random_rational();
  return pose;
}
std::array<mpq_class, 3> coordinates(const Point& p) { return {p.x, p.y, p.z}; }

TEST(Pose, IsMatrixTimesPointPlusTranslation) {
  EXPECT_TRUE(holds({.seed = 5, .runs = 1000}, [] {
    const Pose pose = random_pose();
    const Point p = random_point();
    const auto in = coordinates(p), out = coordinates(placed(p, pose));
    for (std::size_t i = 0; i < 3; ++i) {
      mpq_class sum = pose[i][3];
      for (std::size_t j = 0; j < 3; ++j) sum += pose[i][j] * in[j];
      EXPECT_EQ(out[i], sum);
      EXPECT_EQ(gcd(out[i].get_num(), out[i].get_den()), 1);
    }
  }));
}

TEST(Pose, NeedNotBeARotation) {
  const Pose flattening{{{0, 0, 0, mpq_class("1/3")}, {1, 1, 1, 0}, {0, 0, -2, 0}}};
  EXPECT_EQ(placed({1, 2, 3}, flattening), (Point{mpq_class("1/3"), 6, -6}));
}

TEST(Pose, PlacesEachPointOfEachPiece) {
  EXPECT_TRUE(holds({.seed = 5, .runs = 1000}, [] {
    const Pieces pieces{{random_point(), random_point()}, {random_point()}};
    const GivenPose given{random_pose()};
    Body body;
    body.pieces = std::make_shared<const Pieces>(pieces);
    place(body, given);
    const auto at = [&](const Point& p) { return placed(p, *given.matrix); };
    EXPECT_EQ(*body.pieces, (Pieces{{at(pieces[0][0]), at(pieces[0][1])}, {at(pieces[1][0])}}));
    EXPECT_TRUE(body.points.empty());
  }));
}

GivenPose pose_of(const std::string& text, Decimals decimals = Decimals::exact) {
  std::string fault;
  const GivenPose pose = parse_pose(text, decimals, fault);
  EXPECT_EQ(fault, "") << text;
  return pose;
}
std::string fault_of(const std::string& text) {
  std::string fault;
  parse_pose(text, Decimals::exact, fault);
  return fault;
}
std::string note_of(const std::string& text) { return pose_note(pose_of(text), false); }

const Pose quarter{{{0, -1, 0, 1}, {1, 0, 0, 2}, {0, 0, 1, 3}}};  // a quarter turn about z

TEST(PoseText, HasManyForms) {
  for (const char* text :
       {"0 -1 0 1; 1 0 0 2; 0 0 1 3", "0,-1,0,1,1,0,0,2,0,0,1,3", "[[0,-1,0,1],[1,0,0,2],[0,0,1,3]]",
        "0 -1 0 1\n1 0 0 2\n0 0 1 3\n", "0 -1 0 1 1 0 0 2 0 0 1 3 0 0 0 1",
        "[[0,-1,0,1],[1,0,0,2],[0,0,1,3],[0,0,0,1]]", "[0,-1,0,1,1,0,0,2,0,0,1,3,0.0,0,0,1.0]",
        "array([[ 0., -1.,  0.,  1.],\n       [ 1.,  0.,  0.,  2.],\n       [ 0.,  0.,  1.,  3.]])",
        R"([["0",-1,0,"1"],[1,0,0,2],[0,0,1,3]])", "{{0,-1,0,1},{1,0,0,2},{0,0,1,3}}", "xyz=1,2,3 quat=1,0,0,1",
        "quat=2,0,0,2;xyz=1 2 3", "xyz=(1, 2, 3), xyzw=[0, 0, 5, 5]", "translation=1,2,3 quaternion=1,0,0,1",
        "xyz=1,2,3 rpy=0,0,90deg", "rpy = 0, 0, 90 deg xyz=1,2,3", "xyz=1,2,3 rpy=360,0,-270deg"})
    EXPECT_EQ(exact_pose(pose_of(text)), quarter) << text;
  EXPECT_EQ(exact_pose(pose_of("0 1 0 0; -1 0 0 0; 0 0 1 0; 1 2 3 1")), quarter) << "written column by column";
  EXPECT_EQ(exact_pose(pose_of("xyz=1,2,3")), (Pose{{{1, 0, 0, 1}, {0, 1, 0, 2}, {0, 0, 1, 3}}}));
}

TEST(PoseText, OfThePlane) {
  const Pose in_plane{{{0, -1, 0, 1}, {1, 0, 0, 2}, {0, 0, 1, 0}}};
  for (const char* text : {"0 -1 1; 1 0 2", "0,-1,1,1,0,2", "[[0,-1,1],[1,0,2]]", "0 -1 1\n1 0 2\n",
                           "xy=1,2 half_angle=1", "half_angle=1; xyz=1,2,0"}) {
    EXPECT_EQ(exact_pose(pose_of(text)), in_plane) << text;
    EXPECT_TRUE(pose_of(text).plane) << text;
  }
  EXPECT_EQ(exact_pose(pose_of("half_angle=1/2"))[0],
            (std::array<mpq_class, 4>{mpq_class(3, 5), mpq_class(-4, 5), 0, 0}));
  EXPECT_EQ(exact_pose(pose_of("xy=1,2")), (Pose{{{1, 0, 0, 1}, {0, 1, 0, 2}, {0, 0, 1, 0}}}));
  EXPECT_FALSE(pose_of("xyz=1,2,0 rpy=0,0,90deg").plane);
  EXPECT_EQ(fault_of("xy=1,2,3"), "xy: expected two numbers, found 3");
  EXPECT_EQ(fault_of("half_angle=1,2"), "half_angle: expected one number, found 2");
  EXPECT_EQ(fault_of("xy=1,2 xyz=1,2,0"), "expected one translation, found two");
  EXPECT_EQ(fault_of("half_angle=1 rpy=0,0,90deg"), "expected one rotation, found two");
  EXPECT_EQ(fault_of("1 0 x; 0 1 0"), "row 1, number 3: expected a number, found 'x': unexpected 'x'");
  Body body{{{0, 0, 0}}};
  EXPECT_THROW(place(body, pose_of("xy=1,2")), std::invalid_argument) << "law: it is none of a body in space";
  body.dimension = 2;
  place(body, pose_of("xy=1,2"));
  EXPECT_EQ(body.points, (GivenPoints{{1, 2, 0}}));
  EXPECT_THROW(place(body, pose_of("xyz=1,2,3")), std::invalid_argument);
  EXPECT_EQ(note_of("1 0 0; 0 -1 1"), "det -1, a reflection: the body is mirrored");
}

TEST(PoseText, AFileMayBeginWithAByteOrderMark) {
  const std::string path =
      std::filesystem::temp_directory_path() / ("fathom_pose_test_" + std::to_string(std::random_device()()));
  std::ofstream(path) << "\xEF\xBB\xBFxyz=1,2,3 rpy=0,0,90deg\n";
  EXPECT_EQ(exact_pose(read_pose("@" + path, "--pose-a", Decimals::exact)), quarter);
  std::filesystem::remove(path);
}

TEST(PoseText, DecimalsMeanWhatIsSaid) {
  const std::string text = "1 0 0 0.1; 0 1 0 1/3; 0 0 1 \"0.1\"";
  EXPECT_EQ((*pose_of(text, Decimals::binary64).matrix)[0][3], mpq_class(0.1));
  EXPECT_EQ((*pose_of(text, Decimals::exact).matrix)[0][3], mpq_class("1/10"));
  EXPECT_EQ((*pose_of(text, Decimals::binary64).matrix)[1][3], mpq_class("1/3"));
  EXPECT_EQ((*pose_of(text, Decimals::binary64).matrix)[2][3], mpq_class("1/10")) << "in quotes";
}

// Roll about x, then pitch about y, then yaw about z, all of them fixed axes.
TEST(PoseText, AnglesAreThoseOfUrdf) {
  const auto x_to = [](const std::string& rpy, const Point& p) { return placed(p, exact_pose(pose_of("rpy=" + rpy))); };
  EXPECT_EQ(x_to("90,0,0deg", {0, 1, 0}), (Point{0, 0, 1}));
  EXPECT_EQ(x_to("0,90,0deg", {0, 0, 1}), (Point{1, 0, 0}));
  EXPECT_EQ(x_to("0,0,90deg", {1, 0, 0}), (Point{0, 1, 0}));
  EXPECT_EQ(x_to("90,90,0deg", {0, 1, 0}), (Point{1, 0, 0})) << "y to z by the roll, then z to x by the pitch";
  const Pose turned = exact_pose(pose_of("rpy=0.1,-0.2,0.3rad"));
  // By the product of three matrices, in doubles.
  const double expected[3][3] = {{0.9362933635841992, -0.31299182578546797, -0.1593450793079779},
                                 {0.28962947762551555, 0.9447024859948943, -0.1537919979889642},
                                 {0.19866933079506122, 0.09784339500725571, 0.975170327201816}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(turned[i][j].get_d(), expected[i][j], 1e-15);
    for (std::size_t j = 0; j < 3; ++j) {
      const mpq_class product = turned[i][0] * turned[j][0] + turned[i][1] * turned[j][1] + turned[i][2] * turned[j][2];
      EXPECT_EQ(product, i == j ? 1 : 0) << "an exact rotation";
    }
  }
}

TEST(PoseText, EulerAnglesHaveANamedOrder) {
  const auto turn = [](const std::string& euler) { return exact_pose(pose_of("euler=" + euler)); };
  EXPECT_EQ(turn("extrinsic xyz 10,20,30deg"), exact_pose(pose_of("rpy=10,20,30deg")));
  EXPECT_EQ(turn("intrinsic zyx 30,20,10deg"), exact_pose(pose_of("rpy=10,20,30deg")));
  EXPECT_EQ(turn("intrinsic zxz .3,-.2,.1rad"), turn("extrinsic zxz .1 -.2 .3 rad"));
  EXPECT_EQ(placed({1, 0, 0}, turn("intrinsic zyx 90,0,90deg")), (Point{0, 1, 0})) << "then about itself";
  EXPECT_EQ(placed({1, 0, 0}, turn("extrinsic zyx 90,0,90deg")), (Point{0, 0, 1})) << "y to z by the turn about x";
  const Pose turned = exact_pose(pose_of("xyz=1,2,3 euler=intrinsic zxy 0.3,-0.2,0.1rad"));
  // By the product of three matrices, in doubles.
  const double expected[3][3] = {{0.9564250858492325, -0.28962947762551555, 0.03695701352462508},
                                 {0.2750958473182437, 0.9362933635841992, 0.21835066314633444},
                                 {-0.09784339500725571, -0.19866933079506122, 0.975170327201816}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(turned[i][j].get_d(), expected[i][j], 1e-15);
  EXPECT_EQ(turned[2][3], 3);
  const auto of_case = [](const std::string& pose) {
    return parse_case(R"({"a": {"vertices": [[1, 2, 3]], "pose": )" + pose + R"(}, "b": {"vertices": [[0, 0, 0]]}})",
                      "c");
  };
  EXPECT_EQ(of_case(R"({"euler": ["intrinsic zyx", 30, "20", 10], "unit": "deg"})").value().a.points.front(),
            placed({1, 2, 3}, exact_pose(pose_of("rpy=10,20,30deg"))));
  for (const auto& [pose, says] :
       {std::pair(
            R"({"euler": ["zyx", 1, 2, 3], "unit": "deg"})",
            "a.pose: euler: expected an order such as 'intrinsic zyx' or 'extrinsic xyz' before the angles, found "
            "'zyx'"),
        {R"({"euler": ["intrinsic zzx", 1, 2, 3], "unit": "deg"})",
         "a.pose: euler: expected an order such as 'intrinsic zyx' or 'extrinsic xyz' before the angles, found "
         "'intrinsic zzx'"},
        {R"({"euler": ["intrinsic zyx", 1, 2, 3]})", R"(a.pose.unit: expected "deg" or "rad", of euler, found null)"},
        {R"({"euler": [1, 2, 3], "unit": "deg"})",
         R"(a.pose.euler: expected an order and three angles, ["intrinsic zyx", 10, 20, 30], found an array of 3)"},
        {R"({"euler": ["intrinsic zyx", 1, 2, 3], "rpy": [1, 2, 3], "unit": "deg"})",
         "a.pose: expected one rotation, found two"}})
    EXPECT_EQ(of_case(pose).error().what(), std::string("c:1: ") + says);
}

TEST(PoseText, FaultsSayWhatIsMeant) {
  const std::pair<const char*, const char*> faults[] = {
      {"", "expected three rows of four numbers"},
      {"1 0 0; 0 1 0; 0 0 1", "found 3 rows of 3: the translation, a fourth column, is missing"},
      {"1 0 0; 0 1 0; 0 0 1; 1 2 3", "found 4 rows of 3: it looks transposed"},
      {"0 0 0 1 0 0 0", "since both orders are in use"},
      {"1 0 0 0; 0 1 0; 0 0 1 0", "expected three rows of four numbers"},
      {"1 0 0 0; 0 1 0 nan; 0 0 1 0", "row 2, number 4: expected a number"},
      {"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 2", "expected the last row 0 0 0 1 of a 4 x 4 matrix"},
      {"quat=0,0,0,0", "expected a quaternion that is not 0"},
      {"quat=1,0,0,0 xyzw=0,0,0,1", "expected one rotation, found two"},
      {"xyz=1,2,3 xyz=1,2,3", "expected one translation, found two"},
      {"xyz=1,2", "xyz: expected three numbers, found 2"},
      {"euler=zyx 1,2,3deg", "euler: expected an order such as 'intrinsic zyx'"},
      {"euler=intrinsic xyzx 1,2,3deg", "euler: expected an order such as 'intrinsic zyx'"},
      {"euler=intrinsic zyx 1,2,3", "expected euler=intrinsic zyx A,B,C with deg or rad behind"},
      {"euler=intrinsic zyx 1,2deg", "euler: expected three numbers, found 2"},
      {"quat=1,2,3", "quat: expected four numbers, found 3"},
      {"rpy=1,2,3", "with deg or rad behind"},
      {"rpy=1,2,xdeg", "rpy: expected a number"},
      {"pos=1,2,3", "expected xyz=, quat=, xyzw=, rpy= or euler=, in the plane xy= or half_angle=, found 'pos'"},
      {"=1", "expected xyz=, quat=, xyzw=, rpy= or euler=, in the plane xy= or half_angle=, found nothing"},
      {"xyz=1,2,3 foo", "xyz: expected three numbers, found 4"}};
  for (const auto& [text, fault] : faults)
    EXPECT_NE(fault_of(text).find(fault), std::string::npos) << text << ": " << fault_of(text);
  for (const std::string piece : {"=", "xyz", "xyz=", "rpy=deg", "[", "]", "\"", "\"\"", ";;;", "(", "x(", ",", "@",
                                  "xyz=1,2,3 =", "= =", "\xff="})
    EXPECT_NE(fault_of(piece), "") << piece;
}

TEST(PoseNote, NamesWhatIsNoRotation) {
  EXPECT_EQ(note_of("0 -1 0 1; 1 0 0 2; 0 0 1 3"), "");
  EXPECT_EQ(note_of("0.6 -0.8 0 1; 0.800001 0.6 0 2; 0 0 1 3"), "") << "decimals of six digits";
  EXPECT_EQ(note_of("xyz=1,2,3 quat=1,2,3,4"), "");
  EXPECT_EQ(note_of("0 0 0 1; 0 0 0 2; 0 0 0 3"), "the matrix is 0: the body becomes a point");
  EXPECT_EQ(note_of("1 0 0 1; 1 0 0 2; 0 0 1 3"), "det 0, not a rotation: the body becomes flat");
  EXPECT_EQ(note_of("1 0 0 1; 0 1 0 2; 0 0 -1 3"), "det -1, a reflection: the body is mirrored");
  EXPECT_EQ(note_of("0.98 0 0 1; 0 1 0 2; 0 0 1 3"), "det 0.98, not a rotation: the body is scaled or sheared by it");
  EXPECT_EQ(note_of("1 1 0 1; 0 1 0 2; 0 0 1 3"), "det 1, not a rotation: the body is scaled or sheared by it");
  EXPECT_EQ(note_of("1000 0 0 1; 0 1000 0 2; 0 0 1000 3"), "det 1e+09, not a rotation: the body is scaled by 1000");
  EXPECT_EQ(note_of("-2 0 0 1; 0 -2 0 2; 0 0 -2 3"), "det -8, not a rotation: the body is mirrored and scaled by 2");
  EXPECT_EQ(note_of("0 1 0 0; -1 0 0 0; 0 0 1 0; 1 2 3 1"),
            "the last column is 0 0 0 1: this 4 x 4 is read as transposed");
  EXPECT_NE(note_of("0 1 0 -1 0 0 0 0 1 1 2 3").find("read column by column, would be a rotation"), std::string::npos);
  EXPECT_EQ(note_of("1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1"), "");
  EXPECT_NE(pose_note(pose_of("2 0 0 0; 0 2 0 0; 0 0 2 0"), true).find("radius or margin stays"), std::string::npos);
}

TEST(Place, MapsPointsAndShapes) {
  Body points{{{1, 0, 0}}}, ball;
  ball.shape = sphere(2);
  place(points, pose_of("xyz=1,2,3 quat=1,0,0,1"));
  place(ball, pose_of("xyz=1,2,3 quat=1,0,0,1"));
  EXPECT_EQ(points.points.exact().at(0), (Point{1, 3, 3}));
  EXPECT_EQ(*ball.shape, moved(sphere(2), quarter));
  EXPECT_THROW(place(ball, pose_of("0 0 0 0; 0 0 0 0; 0 0 0 0")), std::invalid_argument);
}

TEST(RoundToBinary64, TiesGoToEven) {
  const mpz_class two53 = mpz_class(1) << 53;
  Point p{mpq_class(two53 + 1), mpq_class(two53 + 3), mpq_class(-two53 - 1)};
  ASSERT_TRUE(round_to_binary64(p));
  EXPECT_EQ(p, (Point{mpq_class(two53), mpq_class(two53 + 4), mpq_class(-two53)}));
  Point q{mpq_class("1/10"), mpq_class("-1/3"), mpq_class(1) >> 1076};
  ASSERT_TRUE(round_to_binary64(q));
  EXPECT_EQ(q, (Point{mpq_class(0.1), mpq_class(-1.0 / 3), 0}));
}

TEST(RoundToBinary64, KeepsBinary64) {
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  Point p{mpq_class(most), mpq_class(-least), mpq_class(0.1)};
  const Point before = p;
  ASSERT_TRUE(round_to_binary64(p));
  EXPECT_EQ(p, before);
}

TEST(RoundToBinary64, OverflowIsToldInEachCoordinate) {
  const mpq_class half_ulp = mpq_class(mpz_class(1) << 970), most(std::numeric_limits<double>::max());
  for (int i = 0; i < 3; ++i) {
    Point p{0, 0, 0};
    mpq_class& x = i == 0 ? p.x : i == 1 ? p.y : p.z;
    x = -(most + half_ulp);
    EXPECT_FALSE(round_to_binary64(p));
    p = {0, 0, 0};
    x = most + half_ulp - 1;
    ASSERT_TRUE(round_to_binary64(p));
    EXPECT_EQ(x, most);
  }
}

// The words of a shape survive reading: they build the very body that was read, and print as a case
// that reads as the same again.

Body body_read(const std::string& a) {
  const CaseItem item = parse_case(R"({"a":)" + a + R"(,"b":{"vertices":[[0,0,0]]}})", "test");
  return item.ok() ? item.value().a : throw item.error();
}

void expect_same(const Body& x, const Body& y, const std::string& text) {
  EXPECT_EQ(x.points, y.points) << text;
  EXPECT_EQ(x.shape, y.shape) << text;
}

TEST(NamedBody, WordsBuildAndPrintTheBodyThatWasRead) {
  for (
      const char* text : {
          R"({"shape":"sphere","radius":0.5})",
          R"({"shape":"capsule","radius":"1/3","half_length":1,"axis":"x","margin":0.1})",
          R"({"shape":"box","half":[1,2,3],"pose":{"quaternion":[1,2,3,4],"translation":[0.1,0,5]}})",
          R"({"shape":"box","half":[1,2,3],"pose":[[1,0,0,0.5],[0,0,-1,0],[0,1,0,0]]})",
          R"({"shape":"rounded_box","half":[1,2,3],"margin":0})",
          R"({"shape":"triangle","vertices":[[0,0,0],[1,0,0],[0,1,0]],"margin":0.25})",
          R"({"shape":"halfspace","normal":[0,0,1],"offset":-1})",
          R"({"shape":"sum","terms":[{"shape":"cylinder","radius":1,"half_length":2,"axis":"y","pose":{"quaternion":[1,1,0,0]}},)"
          R"({"shape":"sum","terms":[{"shape":"hull","vertices":[[0,0,0],[1,0,0]]}]}],"margin":2})",
          R"({"vertices":[[0,0,0],[1,0,0]],"margin":0.5})",
      }) {
    const Body body = body_read(text);
    ASSERT_TRUE(body.words) << text;
    expect_same(body_of(*body.words), body, text);
    for (const Defaults defaults : {Defaults::left_out, Defaults::written}) {
      const std::string printed = body_json(*body.words, defaults).text();
      expect_same(body_read(printed), body, printed);
      EXPECT_EQ(body_json(*body_read(printed).words, defaults).text(), printed)
          << "law: printing and reading changes nothing";
    }
  }
}

TEST(NamedBody, SaysWhatItLeavesOut) {
  const Body body = body_read(R"({"shape":"capsule","radius":0.5,"half_length":1})");
  EXPECT_EQ(body_json(body).text(), R"({"shape":"capsule","radius":0.5,"half_length":1})");
  EXPECT_EQ(
      body_json(*body.words, Defaults::written).text(),
      R"({"shape":"capsule","radius":0.5,"half_length":1,"axis":"z","pose":{"quaternion":[1,0,0,0],"translation":[0,0,0]}})");
}

TEST(NamedBody, VerticesHaveNone) {
  EXPECT_FALSE(body_read(R"({"vertices":[[0,0,0],[1,0,0]]})").words);
  EXPECT_FALSE(body_read(R"({"vertices":[[0,0,0],[1,0,0]],"pose":{"quaternion":[1,1,0,0]}})").words);
}

TEST(NamedBody, RoundedPointsAreSaidAsTheyAre) {
  const std::string pose = R"("pose":{"quaternion":[1,2,3,4]},"pose_rounding":"binary64")";
  EXPECT_FALSE(body_read(R"({"shape":"box","half":[1,2,3],)" + pose + "}").words)
      << "law: its vertices are no longer those of a box";
  const Body body = body_read(R"({"shape":"box","half":[1,2,3],"margin":0.5,)" + pose + "}");
  ASSERT_TRUE(body.words);
  EXPECT_EQ(body.words->shape, "hull");
  expect_same(body_of(*body.words), body, "rounded");
}

TEST(NamedBody, FurtherMotionsApplyToMatricesToo) {
  const Body turned =
      body_read(R"({"shape":"box","half":[1,2,3],"pose":{"quaternion":[1,1,0,0],"translation":[1,2,3]}})");
  const Body mapped = body_read(R"({"shape":"box","half":[1,2,3],"pose":[[1,0,0,1],[0,0,-1,2],[0,1,0,3]]})");
  expect_same(turned, mapped, "the same pose in two forms");
  const Quaternion turn{1, 2, 3, 4};
  expect_same(body_of(posed(*turned.words, turn, {5, 6, 7})), body_of(posed(*mapped.words, turn, {5, 6, 7})),
              "moved again");
}

TEST(NamedBody, WordsOfTheCommandLineStay) {
  const Body body = parse_shape("capsule:r=0.5,h=1,axis=y,at=1:2:3", Decimals::binary64);
  ASSERT_TRUE(body.words);
  expect_same(body_of(*body.words), body, "capsule");
  EXPECT_EQ(
      body_json(body).text(),
      R"({"shape":"capsule","radius":0.5,"half_length":1,"axis":"y","pose":{"quaternion":[1,0,0,0],"translation":[1,2,3]}})");
}

}  // namespace
}  // namespace fathom::files
