// SPDX-License-Identifier: GPL-3.0-or-later
// The texts are in the two spellings of FCL: 0.6 and 0.7, and what followed.
#include "reference/files/fcl_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace fathom::files {
namespace {

const std::string old_boxes =
    "terminate called after throwing an instance of 'std::logic_error'\n"
    "  what():  Error with configuration\n"
    "  Original error message: gjk_libccd-inl.h:(1715): validate(): The origin is outside.\n"
    "  Shape 1: Box0.5 1 2\n"
    "  X_FS1\n"
    " 0.96193976625564348026  0.15401279915737359216  0.22572537250328919556   2.0770063995786869349\n"
    "-0.19134171618254486313  0.96936494951283913579  0.15401279915737359216                    -3.5\n"
    "                      0                       0                       1                   1e-3\n"
    "                      0                       0                       0                       1\n"
    "  Shape 2: Box0.10000000000000000555   0.3499999999999999778   1.8449999999999999734\n"
    "  X_FS2\n"
    "1 0 0 2\n0 1 0 0\n0 0 1 1.25\n0 0 0 1\n"
    "  Solver: GjkSolver_libccd\n"
    "    collision_tolerance:      2.0097183471152322134e-14\n";

const std::string new_prism =
    "  Shape 1:\n"
    "Convex<double>(\n"
    "  std::make_shared<std::vector<Vector3<double>>>(\n"
    "    std::initializer_list<Vector3<double>>{\n"
    "      Vector3<double>(0.5, 0.5, -0.86602500000000004476),\n"
    "      Vector3<double>(0.5, -0.5, 0), Vector3<double>(1, 2, 3),\n"
    "      Vector3<double>(-1, 0, 0)}),\n"
    "  4,\n"
    "  std::make_shared<std::vector<int>>(\n"
    "    std::initializer_list<int>{\n"
    "      3, 0, 1, 2,\n"
    "      3, 0, 2, 3}),\n"
    "  false);\n"
    "  X_FS1\n"
    "1, 0, 0, 12,\n0, 1, 0, 13,\n0, 0, 1, 14,\n0, 0, 0, 1;\n"
    "  Shape 2:\n"
    "Box<double>(1, 2, 3);\n"
    "  X_FS2\n"
    "1, 0, 0, 17,\n0, 1, 0, 18,\n0, 0, 1, 19,\n0, 0, 0, 1;\n"
    "  Solver: GjkSolver_libccd\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string refusal(const std::string& text) {
  try {
    read_fcl_text(text, "log");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(FclText, OfBoxesInTheOldSpelling) {
  const std::vector<FclFailure> failures = read_fcl_text(old_boxes, "log");
  ASSERT_EQ(failures.size(), 1u);
  const FclFailure& failure = failures[0];
  EXPECT_EQ(failure.line, 4u);
  EXPECT_EQ(failure.message, "gjk_libccd-inl.h:(1715): validate(): The origin is outside.");
  ASSERT_EQ(failure.first.body.points.size(), 8u);
  EXPECT_EQ(failure.first.body.points[0], (Point{mpq_class(-1, 4), mpq_class(-1, 2), -1}));
  EXPECT_EQ(failure.first.body.points[7], (Point{mpq_class(1, 4), mpq_class(1, 2), 1}));
  EXPECT_EQ(failure.first.pose[0][1], mpq_class(0.15401279915737359216));
  EXPECT_EQ(failure.first.pose[1][3], mpq_class(-7, 2));
  EXPECT_EQ(failure.first.pose[2][3], mpq_class(1e-3));
  EXPECT_EQ(failure.second.body.points[1].x, mpq_class(0.1) / 2);
  EXPECT_EQ(failure.second.pose[2][3], mpq_class(5, 4));
}

TEST(FclText, OfAConvexInTheNewSpelling) {
  const std::vector<FclFailure> failures = read_fcl_text(new_prism, "log");
  ASSERT_EQ(failures.size(), 1u);
  const std::vector<Point>& points = failures[0].first.body.points;
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[0], (Point{mpq_class(1, 2), mpq_class(1, 2), mpq_class(-0.86602500000000004476)}));
  EXPECT_EQ(points[2], (Point{1, 2, 3}));
  EXPECT_EQ(points[3], (Point{-1, 0, 0}));
  EXPECT_EQ(failures[0].second.body.points[7], (Point{mpq_class(1, 2), 1, mpq_class(3, 2)}));
  EXPECT_EQ(failures[0].second.pose[0][3], 17);
  EXPECT_EQ(failures[0].message, "");
}

TEST(FclText, SeveralInALogWhoseLinesHaveAPrefix) {
  std::string log = "other words\n";
  for (const std::string& text : {old_boxes, new_prism}) {
    std::size_t begin = 0;
    while (begin < text.size()) {
      const std::size_t end = text.find('\n', begin);
      log += "[12:00] " + text.substr(begin, end - begin) + "\r\n";
      begin = end + 1;
    }
  }
  const std::vector<FclFailure> failures = read_fcl_text(log, "log");
  ASSERT_EQ(failures.size(), 2u);
  EXPECT_EQ(failures[0].second.pose[2][3], mpq_class(5, 4));
  EXPECT_EQ(failures[1].first.body.points.size(), 4u);
  EXPECT_EQ(failures[1].message, "");
}

TEST(FclText, IsRefusedWithItsLine) {
  const auto expects = [](const std::string& text, const std::string& words) {
    const std::string said = refusal(text);
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  expects("", "expected the text of an exception of FCL");
  expects(replaced(new_prism, "Box<double>(1, 2, 3)", "Sphere<double>(1.5)"),
          "log:20: expected a Box or a Convex (other shapes are not polytopes)");
  expects(replaced(old_boxes, "Box0.5 1 2", "Convex(v count: 8, f count: 6)"),
          "log:4: expected a Convex with its points");
  expects(replaced(old_boxes, "Box0.5 1 2", "Box0.5 1"), "log:4: expected the three sides of a Box");
  expects(replaced(old_boxes, "Box0.5 1 2", "Box0.5 1 2 3"), "log:4: expected the three sides of a Box");
  expects(replaced(old_boxes, "Box0.5 1 2", "Box0.5 -1 2"), "none negative");
  expects(replaced(old_boxes, "Box0.5 1 2", "Box0.5 nan 2"), "log:4: expected the three sides");
  expects(replaced(old_boxes, "-3.5", "inf"), "log:7: expected number 8 of a 4 x 4 matrix, found 'inf'");
  expects(replaced(old_boxes, "-3.5", "1e400"), "log:7: expected number 8");
  expects(replaced(old_boxes, "0 0 0 1", "0 0 0 2"), "log:15: expected a last row of 0 0 0 1");
  expects(replaced(old_boxes, "0 0 0 1", "0 0 0 1 1"), "log:15: expected the end of a 4 x 4 matrix, found '1'");
  expects(replaced(old_boxes, "  X_FS1\n", ""), "log:5: expected X_FS1");
  expects(replaced(old_boxes, "Shape 2", "Shape 3"), "log:10: expected 'Shape 2:'");
  expects(replaced(new_prism, "(1, 2, 3),", "(1, 2),"), "log:6: expected the three coordinates of a point");
  expects(replaced(new_prism, "Vector3<double>(1, 2, 3)", "Vector3<double>(1, 2, x)"),
          "log:6: expected the three coordinates");
}

TEST(FclText, AnyPrefixOfItIsReadOrRefused) {
  for (const std::string& text : {old_boxes, new_prism})
    for (std::size_t length = 0; length < text.size(); ++length) {
      const std::string said = refusal(text.substr(0, length));
      EXPECT_TRUE(said.empty() || said.find("expected") != std::string::npos) << said;
    }
  EXPECT_NE(refusal(new_prism.substr(0, new_prism.find("19,"))), "");
}

}  // namespace
}  // namespace fathom::files
