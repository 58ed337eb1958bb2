// SPDX-License-Identifier: GPL-3.0-or-later
// Robots: an arm whose depths are known in closed form, positions against products of matrices,
// what is refused, and mutants, which crash nothing.
#include "reference/files/robot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "fathom/answer.hpp"
#include "fathom/files.hpp"
#include "kernels/messages.hpp"

namespace fathom::files {
namespace {

const std::string arm = FATHOM_TEST_DATA "/../../examples/data/arm.urdf";

std::string text_in(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A folder of its own, with files.
class Folder {
 public:
  Folder()
      : path_(std::filesystem::temp_directory_path() / ("fathom_robot_" + std::to_string(std::random_device()()))) {
    std::filesystem::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name) << text;
    return (path_ / name).string();
  }
  [[nodiscard]] std::string at(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

std::size_t link_of(const PosedRobot& posed, const std::string& name) {
  for (std::size_t i = 0; i < posed.robot.links.size(); ++i)
    if (posed.robot.links[i].name == name) return i;
  ADD_FAILURE() << name;
  return 0;
}

PosedRobot posed_file(const std::string& path, const JointValues& joints, Decimals decimals = Decimals::binary64) {
  return posed(read_robot(path, decimals), joints);
}

Surd signed_depth_of(const PosedRobot& posed, const std::string& a, const std::string& b,
                     const RobotOptions& options = {}) {
  const Answer answer =
      exact_answer(body_of(posed, link_of(posed, a), options), body_of(posed, link_of(posed, b), options));
  EXPECT_TRUE(answer.exact());
  return answer.low();
}

void expect_depth(const JointValues& joints, const std::string& a, const std::string& b, const mpq_class& expected) {
  EXPECT_EQ(compare(signed_depth_of(posed_file(arm, joints), a, b), expected), 0) << a << " " << b << " " << expected;
}

// The base is a box of 1/2 x 1/2 x 1/4 around O. The shoulder is on its top, the elbow 1 above, the
// forearm 5/4 long, and all of them turn in the plane y = 0.
TEST(Arm, HasDepthsInClosedForm) {
  expect_depth({}, "base", "forearm", mpq_class(-1));  // it stands upright
  // Folded by half a turn, its tip is 1/4 below the top of the base; aside it is 5/16.
  expect_depth({{"elbow", mpq_class(3.141592653589793)}}, "base", "forearm", mpq_class("1/4"));
  // A quarter turn: it lies 1/16 below the elbow.
  expect_depth({{"elbow", mpq_class(1.5707963267948966)}}, "base", "forearm", mpq_class("-15/16"));
  // Of the angle 2 atan 2 cosine and sine are -3/5 and 4/5: the edge of the base at (1/4, 1/8)
  // looks at the side of the forearm, which is 9/10 - 1/16 from O along (3/5, 4/5); the edge is at
  // 1/4.
  expect_depth({{"elbow", mpq_class(2.214297435588181)}}, "base", "forearm", mpq_class("-47/80"));
  // The fingers, each 1/32 aside and 1/32 wide to either side, move apart together.
  expect_depth({}, "left", "right", 0);
  expect_depth({{"grip", mpq_class("1/32")}}, "left", "right", mpq_class("-1/16"));
  expect_depth({{"shoulder", 1}, {"elbow", 2}, {"grip", mpq_class("1/32")}}, "left", "right", mpq_class("-1/16"));
}

// The other way: 4 x 4 matrices, multiplied along the joints.
TEST(Arm, StandsWhereProductsOfMatricesPutIt) {
  const PosedRobot at =
      posed_file(arm, {{"shoulder", mpq_class("-7/5")}, {"elbow", mpq_class("2/3")}, {"grip", mpq_class("1/20")}});
  const Robot& robot = at.robot;
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    Point p{1, 2, 3};
    for (std::optional<std::size_t> up = robot.links[link].joint; up;
         up = robot.links[robot.joints[*up].parent].joint) {
      const RobotJoint& joint = robot.joints[*up];
      const mpq_class& value = at.values[*up];
      const bool slides = joint.kind == JointKind::prismatic;
      const Quaternion turn = slides ? Quaternion{1, 0, 0, 0} : turn_near(joint.axis, value);
      const Point slide = slides ? Point{joint.axis.x * value, joint.axis.y * value, joint.axis.z * value} : Point{};
      p = placed(p, rigid_pose(turn, slide));
      p = placed(p, rigid_pose(joint.origin.turn, joint.origin.place));
    }
    EXPECT_EQ(placed({1, 2, 3}, exact_pose(at.poses[link])), p) << robot.links[link].name;
  }
}

TEST(Arm, LeavesOutLinksWithOneMovingJointBetweenThem) {
  const PosedRobot at = posed_file(arm, {});
  const auto adjacent = [&](const char* a, const char* b) {
    return are_adjacent(at.robot, link_of(at, a), link_of(at, b));
  };
  EXPECT_TRUE(adjacent("base", "upper"));
  EXPECT_TRUE(adjacent("forearm", "upper"));
  EXPECT_TRUE(adjacent("left", "forearm"));
  EXPECT_FALSE(adjacent("left", "right"));
  EXPECT_FALSE(adjacent("base", "forearm"));
  EXPECT_FALSE(adjacent("upper", "left"));
}

std::string robot(const std::string& inside) { return "<robot name='r'>\n" + inside + "</robot>\n"; }
std::string link(const std::string& name, const std::string& geometry = "") {
  return "<link name='" + name + "'>" +
         (geometry.empty() ? "" : "<collision><geometry>" + geometry + "</geometry></collision>") + "</link>\n";
}
std::string joint(const std::string& name, const std::string& type, const std::string& parent, const std::string& child,
                  const std::string& inside = "") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child + "'/>" +
         inside + "</joint>\n";
}

TEST(Arm, FixedJointsHoldLinksTogether) {
  const Folder folder;
  const PosedRobot at =
      posed_file(folder.write("r.urdf", robot(link("a") + link("b") + link("c") + link("d") + link("e") +
                                              joint("1", "fixed", "a", "b") + joint("2", "continuous", "b", "c") +
                                              joint("3", "fixed", "c", "d") + joint("4", "continuous", "d", "e"))),
                 {});
  for (const auto& [pair, adjacent] : {std::pair("ab", true),
                                       {"ac", true},
                                       {"ad", true},
                                       {"bd", true},
                                       {"ae", false},
                                       {"be", false},
                                       {"ce", true},
                                       {"de", true}})
    EXPECT_EQ(are_adjacent(at.robot, link_of(at, {pair[0]}), link_of(at, {pair[1]})), adjacent) << pair;
}

TEST(Joints, FollowOthersOrStandAtALimit) {
  const Folder folder;
  const std::string limit = "<limit lower='1' upper='2'/>";
  const std::string path = folder.write(
      "r.urdf", robot(link("a") + link("b") + link("c") + link("d") + joint("x", "prismatic", "a", "b", limit) +
                      joint("y", "continuous", "b", "c", "<mimic joint='x' multiplier='-2' offset='0.5'/>") +
                      joint("z", "floating", "c", "d")));
  const PosedRobot still = posed_file(path, {}), moved = posed_file(path, {{"x", 2}});
  EXPECT_EQ(still.values, (std::vector<mpq_class>{1, mpq_class("-3/2"), 0}));
  EXPECT_EQ(moved.values, (std::vector<mpq_class>{2, mpq_class("-7/2"), 0}));
  ASSERT_EQ(still.notes.size(), 3u);
  EXPECT_EQ(still.notes[0], "the joint 'x' stands at its limit, 1, as it cannot be at 0");
  EXPECT_EQ(still.notes[1], "the joint 'z' is not moved: planar and floating ones stand still");
}

// By long double, whose errors are far below the bound.
TEST(Turns, AreLessThanTheBoundFromTheirAngles) {
  std::mt19937 random(7);
  const auto number = [&](int digits) { return mpq_class(static_cast<long>(random() % 2000001) - 1000000, digits); };
  for (int i = 0; i < 2000; ++i) {
    mpq_class angle = number(318309);  // within half a turn, or nearly
    angle.canonicalize();
    const Point axis = i % 2 ? Point{0, 0, i % 3 ? 1 : -1} : Point{number(1), number(1), 1};
    const Quaternion q = turn_near(axis, angle);
    const auto value = [](const mpq_class& x) {
      return static_cast<long double>(x.get_num().get_d()) / static_cast<long double>(x.get_den().get_d());
    };
    const long double length = std::sqrt(value(axis.x) * value(axis.x) + value(axis.y) * value(axis.y) + 1);
    const mpq_class along = q.z / axis.z;  // of the axis
    EXPECT_EQ(q.x, along * axis.x);
    EXPECT_EQ(q.y, along * axis.y);
    const long double turn = 2 * std::atan2(value(along) * length, value(q.w)), full = 2 * std::acos(-1.0L);
    const long double off = std::remainder(turn - value(angle), full);
    EXPECT_LT(std::abs(off), std::ldexp(1.0L, -45)) << angle;
  }
}

TEST(Turns, AreExactWhereAnglesAreWrittenToFifteenDigits) {
  for (const auto& [angle, turn] : {std::pair("1.5707963267948966", Quaternion{1, 0, 0, 1}),
                                    {"1.5707963267949", {1, 0, 0, 1}},
                                    {"-1.57079632679490", {1, 0, 0, -1}},
                                    {"3.14159265358979", {0, 0, 0, 1}},
                                    {"-3.141592653589793", {0, 0, 0, 1}},
                                    {"6.28318530717959", {1, 0, 0, 0}},
                                    {"4.71238898038469", {1, 0, 0, -1}}}) {
    const Pose expected = rigid_pose(turn, {});
    for (const Decimals decimals : {Decimals::exact, Decimals::binary64})
      EXPECT_EQ(rigid_pose(turn_near({0, 0, 1}, *parse_number(angle, decimals).value), {}), expected) << angle;
  }
  EXPECT_NE(rigid_pose(turn_near({0, 0, 1}, *parse_number("1.5708", Decimals::exact).value), {}),
            rigid_pose({1, 0, 0, 1}, {}));
}

/// The row of the reports with this id, as a case and its JSON.
std::pair<Case, nlohmann::json> report(const std::string& id) {
  std::ifstream file(FATHOM_TEST_DATA "/report_cases.jsonl");
  for (std::string line; std::getline(file, line);)
    if (line.find('"' + id + '"') != std::string::npos)
      return {parse_case(line, id).value(), nlohmann::json::parse(line)};
  ADD_FAILURE() << id;
  return {};
}

std::string obj_of(const nlohmann::json& body) {
  std::string text;
  for (const auto& p : body["vertices"]) text += "v " + p[0].dump() + " " + p[1].dump() + " " + p[2].dump() + "\n";
  return text;
}

// What others report of robots: a mesh in millimetres, and one that is mirrored.
TEST(Reports, ScaledAndMirroredMeshesAreThoseOfTheCases) {
  const Folder folder;
  for (const auto& [id, scale, place] : {std::tuple("report::scikit-robot-374", "0.001 0.001 0.001", "1.5 0 0"),
                                         {"report::gz-2656", "1 1 -1", "0 0 -2.4"}}) {
    const auto [given, json] = report(id);
    folder.write("meshes/a.obj", obj_of(json["a"]));
    const bool box = json["b"].contains("half");
    if (!box) folder.write("meshes/b.obj", obj_of(json["b"]));
    const std::string b = box ? "<box size='4 4 1'/>" : "<mesh filename='meshes/b.obj'/>";
    const std::string path = folder.write(
        "r.urdf", robot(link("a", std::string("<mesh filename='package://own/a.obj' scale='") + scale + "'/>") +
                        link("b", b) + joint("j", "fixed", "a", "b", std::string("<origin xyz='") + place + "'/>")));
    std::filesystem::remove_all(folder.at("own"));
    std::filesystem::create_directory_symlink(folder.at("meshes"), folder.at("own"));
    const RobotOptions options{.package_paths = {folder.at("own")}};
    const bool exact = json["a"]["pose"][0][0].is_string();  // as the case has the scale
    const PosedRobot at = posed_file(path, {}, exact ? Decimals::exact : Decimals::binary64);
    EXPECT_EQ(compare(signed_depth_of(at, "a", "b", options), exact_answer(given.a, given.b).low()), 0) << id;
  }
}

TEST(Meshes, AreReadFromTheFolderAndFromPackagesAlone) {
  const Folder folder;
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  folder.write("robot/near.obj", points);
  folder.write("packages/arm/meshes/far.obj", points);
  const std::string secret = folder.write("secret.obj", points);
  std::filesystem::create_symlink(secret, folder.at("robot/link.obj"));
  std::filesystem::create_directory(folder.at("robot/folder.obj"));
  const auto said = [&](const std::string& name, const std::vector<std::string>& packages) -> std::string {
    const std::string path = folder.write("robot/r.urdf", robot("\n" + link("a", "<mesh filename='" + name + "'/>")));
    try {
      body_of(posed_file(path, {}), 0, {.package_paths = packages});
      return "";
    } catch (const InputError& error) {
      EXPECT_EQ(error.file(), path);
      EXPECT_EQ(error.line(), 3u);
      return error.what();
    }
  };
  EXPECT_EQ(said("near.obj", {}), "");
  EXPECT_EQ(said("../robot/near.obj", {}), "");
  EXPECT_EQ(said("package://arm/meshes/far.obj", {folder.at("packages")}), "");
  EXPECT_EQ(said("package://arm/meshes/far.obj", {folder.at("robot"), folder.at("packages/arm")}), "");
  EXPECT_EQ(said("package://arm/meshes/far.obj", {folder.at("packages/arm/")}), "");
  EXPECT_EQ(said("file://" + folder.at("packages/arm/meshes/far.obj"), {folder.at("packages/arm")}), "");
  const std::string elsewhere = " elsewhere", none = " in none of them";
  for (const std::string& name : {std::string("../secret.obj"), std::string("link.obj"), secret, "file://" + secret})
    EXPECT_TRUE(said(name, {folder.at("packages")}).ends_with(elsewhere)) << name;
  EXPECT_TRUE(said("package://../secret.obj", {folder.at("packages")}).ends_with(elsewhere));
  EXPECT_TRUE(said("package://arm/../../secret.obj", {folder.at("packages/arm")}).ends_with(elsewhere));
  for (const char* name : {"none.obj", "folder.obj", "package://arm/meshes/far.obj", "http://x/near.obj", "/dev/zero"})
    EXPECT_TRUE(said(name, {}).ends_with(none)) << name;
}

TEST(Links, OfSeveralPolytopesAreUnions) {
  const Folder folder;
  const std::string box = "<collision><geometry><box size='2 2 2'/></geometry></collision>",
                    there = "<collision><origin xyz='3 0 0'/><geometry><box size='2 2 2'/></geometry></collision>",
                    ball = "<collision><geometry><sphere radius='1'/></geometry></collision>";
  const PosedRobot at = posed_file(
      folder.write("r.urdf", robot("<link name='u'>" + box + there + "</link><link name='m'>" + box + ball + "</link>" +
                                   link("n") + joint("1", "fixed", "u", "m") + joint("2", "fixed", "u", "n"))),
      {});
  const std::vector<Body> both = bodies_of(at, 0, {});
  ASSERT_EQ(both.size(), 1u);
  ASSERT_EQ(both[0].pieces->size(), 2u);
  EXPECT_EQ(bodies_of(at, 1, {}).size(), 2u);
  EXPECT_THROW(body_of(at, 1, {}), InputError);
  EXPECT_TRUE(bodies_of(at, 2, {}).empty());
  EXPECT_THROW(body_of(at, 2, {}), InputError);
}

/// What is said of the robot, without the name of the file.
std::string complaint(const std::string& text, const JointValues& joints = {}) {
  static const Folder folder;
  const std::string path = folder.write("r.urdf", text);
  try {
    const Robot robot = read_robot(path, Decimals::binary64);
    posed(robot, joints);
    require_joints({robot}, joints);
    return "";
  } catch (const InputError& error) {
    const std::string said = error.what();
    return said.starts_with(path) ? said.substr(path.size()) : said;
  }
}

TEST(BadRobot, EachHasItsSentence) {
  const std::string a = link("a"), b = link("b"), c = link("c"), limit = "<limit lower='-1' upper='2'/>";
  const std::string two = robot(a + b + joint("j", "revolute", "a", "b", limit));
  EXPECT_EQ(complaint(two, {{"j", 2}}), "");
  for (const auto& [text, says] : std::vector<std::pair<std::string, std::string>>{
           {"", ":1: expected <robot>, the root of a URDF, found no element"},
           {"<robot>\n<link name='a'>\n</robot>",
            ":3: expected the end of the element that was begun last, found that of another"},
           {"<robot>\n<link", ":2: expected XML, found the end of the file"},
           {std::string("<robot>\n\0", 9), ":2: expected XML in UTF-8, found a null byte"},
           {"<mujoco/>", ":1: expected <robot>, the root of a URDF, found 'mujoco': SDF, MJCF and xacro are not read"},
           {robot(""), ":1: expected a <link>, found none"},
           {robot("<link/>"), ":2: link: expected name=\"...\" in <link>, found none"},
           {robot(a + a), ":3: expected one link of a name, found a second 'a'"},
           {robot(link("a", "<cone/>")),
            ":2: link 'a': expected box, sphere, cylinder, capsule or mesh in <geometry>, found 'cone'"},
           {robot(link("a", "<box size='1 1'/>")), ":2: link 'a': size=: expected 3 numbers, found '1 1'"},
           {robot(link("a", "<box size='1 0 1'/>")),
            ":2: link 'a': size=: expected three lengths above 0, found another"},
           {robot(link("a", "<box size='1 1 1' size='1 1 1'/>")),
            ":2: link 'a': expected size= once in <box>, found it twice"},
           {robot(link("a", "<sphere radius='${r}'/>")),
            ":2: link 'a': radius=: expected a number, found '${r}': unexpected '$'"},
           {robot(link("a", "<sphere radius='-1'/>")), ":2: link 'a': radius=: expected a length above 0, found -1"},
           {robot(link("a", "<box/><box/>")), ":2: link 'a': expected one shape in <geometry>, found two"},
           {robot(link("a", "<mesh filename=''/>")),
            ":2: link 'a': filename=: expected the name of a mesh, found nothing"},
           {robot(link("a", "<mesh filename='a.obj' scale='1 0 1'/>")),
            ":2: link 'a': scale=: expected factors other than 0, found 0"},
           {robot(a + b), ":3: expected one link without a parent, found 'b' beside 'a'"},
           {robot(a + joint("j", "fixed", "a", "x")),
            ":3: joint 'j': expected a child that is a link of the robot, found 'x'"},
           {robot(a + b + joint("j", "hinge", "a", "b")),
            ":4: joint 'j': expected the type fixed, revolute, continuous, prismatic, planar, floating, found 'hinge'"},
           {robot(a + b + joint("j", "revolute", "a", "b")), ":4: joint 'j': expected <limit>, found none"},
           {robot(a + b + joint("j", "revolute", "a", "b", "<limit lower='2' upper='1'/>")),
            ":4: joint 'j': expected lower= at most upper=, found more"},
           {robot(a + b + joint("j", "continuous", "a", "b", "<axis xyz='0 0 0'/>")),
            ":4: joint 'j': expected an axis other than 0, found 0 0 0"},
           {robot(a + b + joint("j", "fixed", "a", "b", "<origin/><origin/>")),
            ":4: joint 'j': expected one <origin>, found two"},
           {robot(a + b + joint("j", "fixed", "a", "b") + joint("k", "fixed", "a", "b")),
            ":5: joint 'k': expected one joint with the child 'b', found a second: links make a tree"},
           {robot(a + b + c + joint("j", "fixed", "b", "c") + joint("k", "fixed", "c", "b")),
            ":3: expected links that make a tree, found 'b' in a cycle, or below one"},
           {robot(a + b + joint("j", "continuous", "a", "b", "<mimic joint='k'/>")),
            ":4: joint 'j': expected <mimic> of a joint that moves, found 'k'"},
           {robot(a + b + joint("j", "continuous", "a", "b", "<mimic joint='j'/>")),
            ":4: joint 'j': expected <mimic> of a joint that does not follow it, found a cycle"}})
    EXPECT_EQ(complaint(text), says) << text;
  EXPECT_EQ(complaint(two, {{"j", mpq_class("5/2")}}), ":4: joint 'j': expected a value from -1 to 2, found 2.5");
  EXPECT_EQ(complaint(two, {{"k", 1}}), "--joints: expected a joint that moves by itself ('j'), found 'k'");
  EXPECT_EQ(complaint(robot(a + b + joint("j", "fixed", "a", "b")), {{"j", 1}}),
            "--joints: expected a joint that moves by itself (none), found 'j'");
}

TEST(BadRobot, ManyLinksAreRefused) {
  std::string text;
  for (std::size_t i = 0; i <= most_links; ++i) text += link(std::to_string(i));
  EXPECT_EQ(complaint(robot(text)), ":1002: expected at most 1000 links, found more");
}

TEST(BadRobot, ElementsMayBeNestedDeeply) {
  const std::size_t depth = 300000;
  std::string text = "<robot>";
  for (std::size_t i = 0; i < depth; ++i) text += "<a>";
  EXPECT_NE(complaint(text), "");
  for (std::size_t i = 0; i < depth; ++i) text += "</a>";
  EXPECT_EQ(complaint(text + "<link name='a'/></robot>"), "");
}

// Bytes are changed, left out and doubled: each file is read, or refused with a sentence.
TEST(BadRobot, MutantsAreReadOrRefused) {
  const std::string whole = text_in(arm);
  std::mt19937 random(11);
  const auto below = [&](std::size_t n) { return random() % n; };
  std::size_t read = 0, refused = 0;
  for (int i = 0; i < 1500; ++i) {
    std::string text = whole;
    for (std::size_t edits = 1 + below(3); edits > 0; --edits) {
      const std::size_t at = below(text.size()), length = below(40);
      const std::size_t kind = below(4);
      if (kind == 0) text[at] = static_cast<char>(below(256));
      if (kind == 1) text.erase(at, length);
      if (kind == 2) text.insert(at, text.substr(below(text.size()), length));
      if (kind == 3) text[at] = "<>/\"'=&0-e"[below(10)];
      if (text.empty()) text = whole;
    }
    const std::string said = complaint(text, {{"elbow", 1}});
    ++(said.empty() ? read : refused);
    EXPECT_EQ(said.find("pugi"), std::string::npos);
  }
  EXPECT_GT(read, 50u);
  EXPECT_GT(refused, 100u);
}

}  // namespace
}  // namespace fathom::files
