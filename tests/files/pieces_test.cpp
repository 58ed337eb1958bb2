// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of a body from an OBJ file with groups.
#include <gtest/gtest.h>

#include <string>

#include "fathom/files.hpp"
#include "fathom/union.hpp"

namespace fathom {
namespace {

Pieces pieces_of(const std::string& text) { return parse_pieces(text, "body.obj"); }

std::string complaint(const std::string& text) {
  try {
    pieces_of(text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "none";
}

constexpr const char* five = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1/3 0x1p-2 0.1\n";

TEST(Pieces, AreTheCornersOfTheFacesOfEachGroup) {
  const Pieces pieces = pieces_of(std::string(five) + "o a\nf 3 1 2\nf 1/1 2/2 4//1\no b\nf -1 2 3\nf 2 -1 4\n");
  ASSERT_EQ(pieces.size(), 2U);
  ASSERT_EQ(pieces[0].size(), 4U) << "law: each corner once";
  EXPECT_EQ(pieces[0][1], (Point{1, 0, 0})) << "law: in the order of their numbers";
  ASSERT_EQ(pieces[1].size(), 4U);
  EXPECT_EQ(pieces[1][3], (Point{mpq_class(1, 3), mpq_class(1, 4), exact_value(0.1)}));
  EXPECT_EQ(parse_pieces(std::string(five) + "f 1 2 3 5\n", "b", Decimals::exact)[0][3].z, mpq_class(1, 10));
}

TEST(Pieces, GroupsOfOneNameAreOneAndUnnamedOnesAreNew) {
  const std::string f = "f 1 2 3 4\n";
  EXPECT_EQ(pieces_of(five + f).size(), 1U);
  EXPECT_EQ(pieces_of(five + ("g a\n" + f) + "g b\n" + f + "g a\n" + f).size(), 2U);
  EXPECT_EQ(pieces_of(five + ("o a\ng x\n" + f) + "o b\ng x\n" + f).size(), 2U) << "law: groups are those of an object";
  EXPECT_EQ(pieces_of(five + ("o\n" + f) + "o\n" + f).size(), 2U);
  EXPECT_EQ(pieces_of(five + ("o a\ng b\n" + f)).size(), 1U) << "law: a group without faces is no piece";
}

TEST(Pieces, BadFilesAreRefusedWithTheirLine) {
  EXPECT_EQ(complaint("o a\n"), "body.obj:1: expected at least one vertex 'v x y z', found the end of the file");
  EXPECT_EQ(complaint(std::string(five) + "f 1 2 6\n"), "body.obj:6: expected a vertex index of at most 5, found '6'");
  EXPECT_EQ(complaint("v 0 0 zero\n").substr(0, 11), "body.obj:1:");
  EXPECT_EQ(complaint(five).substr(0, 38), "body.obj:5: expected at least one face");
  EXPECT_THROW(read_pieces("no such file.obj"), InputError);
}

}  // namespace
}  // namespace fathom
