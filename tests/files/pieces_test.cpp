// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of a body from an OBJ file with groups, or from a folder of files.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/union.hpp"
#include "reference/files/piece_files.hpp"

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
  EXPECT_EQ(pieces_of(five + ("o a\n" + f) + "o a\n" + f).size(), 2U) << "law: each line 'o' begins an object";
  EXPECT_EQ(pieces_of(five + ("o a\ng x\n" + f) + "o a\ng x\n" + f).size(), 2U);
  EXPECT_EQ(pieces_of(five + ("o a\ng b\n" + f)).size(), 1U) << "law: a group without faces is no piece";
}

TEST(Pieces, NamesRunToTheEndOfTheirLine) {
  const std::string f = "f 1 2 3 4 # a comment\n";
  for (const char* const letter : {"o", "g"})
    for (const char* const name : {" wall#", " wall #", " # ", " #"})
      EXPECT_EQ(pieces_of(five + ((letter + std::string(name) + "1\n") + f) + letter + name + "2\n" + f).size(), 2U)
          << letter << name;
  EXPECT_EQ(pieces_of(five + ("g wall#1\n" + f) + "g b\n" + f + "g wall#1 \n" + f).size(), 2U);
}

TEST(Pieces, KeepTheFacesOfTheirMeshes) {
  const Body body =
      files::union_of({Body{.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .faces = std::make_shared<const MeshFaces>()},
                       Body{.points = {{5, 0, 0}}},
                       Body{.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                            .faces = std::make_shared<const MeshFaces>(MeshFaces{{3, 2, 1, 0}, {4}})}});
  ASSERT_TRUE(body.pieces && body.faces);
  EXPECT_EQ(body.pieces->size(), 3U);
  EXPECT_EQ(*body.faces, (MeshFaces{{0, 1, 2, 7, 6, 5, 4}, {3, 7}})) << "law: corners count the points of all pieces";
}

TEST(Pieces, BadFilesAreRefusedWithTheirLine) {
  EXPECT_EQ(complaint("o a\n"), "body.obj:1: expected at least one vertex 'v x y z', found the end of the file");
  EXPECT_EQ(complaint(std::string(five) + "f 1 2 6\n"), "body.obj:6: expected a vertex index of at most 5, found '6'");
  EXPECT_EQ(complaint("v 0 0 zero\n").substr(0, 11), "body.obj:1:");
  EXPECT_EQ(complaint(five).substr(0, 38), "body.obj:5: expected at least one face");
  EXPECT_THROW(read_pieces("no such file.obj"), InputError);
}

/// A folder for the length of a test.
class Folder {
 public:
  Folder()
      : path_(std::filesystem::temp_directory_path() /
              ("fathom_pieces_test_" + std::to_string(std::random_device()()))) {
    std::filesystem::create_directory(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }
  void add(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }
  [[nodiscard]] std::string path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string off(int last) { return "OFF\n4 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 " + std::to_string(last) + "\n"; }

TEST(PieceFolders, FilesArePiecesInNaturalOrder) {
  const Folder folder;
  folder.add("part_10.off", off(10));
  folder.add("part_9.off", off(9));
  folder.add("part_11.OBJ", std::string(five) + "o a\nf 1 2 3 4\no b\nf 1 2 3 5\n");
  folder.add("part_12.stl",
             "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
             "12\nendloop\nendfacet\nendsolid\n");
  folder.add("part_13.ply",
             "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
             "z\nend_header\n0 0 0\n1 0 0\n0 1 "
             "0\n0 0 13\n");
  folder.add("notes.txt", "no piece");
  folder.add(".part_1.off", "hidden");
  std::filesystem::create_directory(folder.path() + "/part_2.off");
  for (const std::string& path : {folder.path(), folder.path() + "/"}) {
    const Pieces pieces = read_pieces(path);
    ASSERT_EQ(pieces.size(), 6U);
    EXPECT_EQ(pieces[0].back(), (Point{0, 0, 9}));
    EXPECT_EQ(pieces[1].back(), (Point{0, 0, 10}));
    EXPECT_EQ(pieces[2].back(), (Point{0, 0, 1}));
    EXPECT_EQ(pieces[3].back(), (Point{mpq_class(1, 3), mpq_class(1, 4), exact_value(0.1)}));
    EXPECT_EQ(pieces[4].back(), (Point{0, 1, 12}));
    EXPECT_EQ(pieces[5].back(), (Point{0, 0, 13}));
  }
}

TEST(PieceFolders, AnotherMeshIsOnePiece) {
  const Folder folder;
  folder.add("one.off", off(7));
  folder.add("points", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  EXPECT_EQ(read_pieces(folder.path() + "/one.off"), (Pieces{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 7}}}));
  EXPECT_EQ(read_pieces(folder.path() + "/points").size(), 1U);
}

std::string complaint_of_folder(const Folder& folder) {
  try {
    read_pieces(folder.path());
  } catch (const InputError& e) {
    return e.what();
  }
  return "none";
}

TEST(PieceFolders, SolidsOfStlArePiecesAndAPathNamesOne) {
  const std::string folder = std::filesystem::temp_directory_path() / "fathom-solids";
  std::filesystem::create_directory(folder);
  const auto facet = [](const std::string& x) {
    return "facet normal 0 0 1\nouter loop\nvertex " + x + " 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\n";
  };
  const std::string file = folder + "/a.stl";
  std::ofstream(file) << "solid left wall\n"
                      << facet("1") << facet("2") << "endsolid left wall\nsolid\nendsolid\nsolid b\n"
                      << facet("3") << "endsolid b\n";
  const Body both = files::read_union(file, Decimals::exact);
  ASSERT_EQ(both.pieces->size(), 2U) << "law: a solid without facets is no piece";
  EXPECT_EQ((*both.pieces)[0].size(), 6U);
  EXPECT_EQ(files::piece_name(both, 0), "left wall");
  EXPECT_EQ(read_mesh(file).points.size(), 9U) << "law: without a name all of the file";
  const Body one = read_mesh(file + "#b");
  ASSERT_EQ(one.points.size(), 3U);
  EXPECT_EQ(one.points[0], (Point{3, 0, 0}));
  const auto refusal = [](const std::string& path) {
    try {
      read_mesh(path);
      return std::string("none");
    } catch (const InputError& e) {
      return std::string(e.what());
    }
  };
  EXPECT_EQ(refusal(file + "#c"), file + ": expected one mesh named 'c', found none among 'left wall', 'b'");
  std::filesystem::rename(file, folder + "/a#b.stl");
  EXPECT_EQ(read_mesh(folder + "/a#b.stl").points.size(), 9U) << "law: a file that is there is meant";
  std::filesystem::remove_all(folder);
}

TEST(PieceFolders, BadOnesAreRefusedWithFileAndLine) {
  const Folder empty, bad, open;
  empty.add("a.mtl", "");
  EXPECT_EQ(complaint_of_folder(empty), empty.path() +
                                            ": expected a folder with mesh files (.off, .obj, .ply, .stl, .gltf, .glb, "
                                            ".dae, .3mf), the pieces, found none there");
  bad.add("a.off", off(1));
  bad.add("b.off", "OFF\n4 0 0\n0 0 0\n1 0 zero\n");
  EXPECT_EQ(complaint_of_folder(bad).substr(0, bad.path().size() + 9), bad.path() + "/b.off:4:");
  const Folder piped;
  ASSERT_EQ(::mkfifo((piped.path() + "/x.ply").c_str(), 0600), 0);
  EXPECT_EQ(complaint_of_folder(piped),
            piped.path() + "/x.ply: expected a file, found a named pipe, whose writer may never come");
  open.add("b.obj", "v 0 0 0\no a\n");
  EXPECT_EQ(complaint_of_folder(open).substr(0, open.path().size() + 36),
            open.path() + "/b.obj:2: expected at least one face");
}

TEST(NaturalOrder, IsThatInWhichPeopleCount) {
  const std::vector<std::string> sorted = {"",
                                           "0",
                                           "00",
                                           "01",
                                           "1",
                                           "2",
                                           "10",
                                           "99999999999999999998",
                                           "99999999999999999999",
                                           "a",
                                           "a01",
                                           "a1",
                                           "a1b",
                                           "a2",
                                           "a10",
                                           "a10b",
                                           "ab",
                                           "b1c2",
                                           "b1c10",
                                           "b01c11",
                                           "b2c1",
                                           "\xff"};
  std::vector<std::string> shuffled = sorted;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937_64(1));
  std::sort(shuffled.begin(), shuffled.end(), files::natural_less);
  for (std::size_t i = 0; i < sorted.size(); ++i)
    for (std::size_t j = 0; j < sorted.size(); ++j)
      EXPECT_EQ(files::natural_less(sorted[i], sorted[j]), i < j) << sorted[i] << " and " << sorted[j];
  EXPECT_TRUE(files::natural_less("piece_2.obj", "piece_10.obj"));
  EXPECT_FALSE(files::natural_less("piece_10.obj", "piece_2.obj"));
  EXPECT_EQ(shuffled, sorted);
}

}  // namespace
}  // namespace fathom
