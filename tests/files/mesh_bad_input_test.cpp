// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of bad mesh gets its sentence: file, line, what was expected, what was found. Those
// that are text are rows of tests/data/bad_meshes.jsonl.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>
#include <tuple>

#include "fathom/files.hpp"
#include "kernels/messages.hpp"
#include "reference/files/file_io.hpp"

namespace fathom::files {
namespace {

/// What the reader says of `text`; the empty string if it takes it.
std::string complaint(const std::string& text, const std::string& name, Decimals decimals = Decimals::binary64) {
  try {
    parse_mesh(text, name, decimals);
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), name);
    return error.what();
  }
  return "";
}

/// Rows of a name, a text and the whole sentence.
TEST(BadMesh, EachTextHasItsSentence) {
  std::ifstream file(FATHOM_TEST_DATA "/bad_meshes.jsonl");
  std::size_t rows = 0;
  for (std::string line; std::getline(file, line); ++rows) {
    const nlohmann::json row = nlohmann::json::parse(line);
    EXPECT_EQ(complaint(row["text"], row["name"]), row["says"].get<std::string>()) << row["text"];
  }
  EXPECT_GE(rows, 93U);
}

TEST(BadOff, ANullByte) {
  EXPECT_EQ(complaint(std::string("OFF\n1 0 0\n0 0\0 0\n", 18), "m.off"),
            "m.off:3: expected a number, found '0\\x00': unexpected '\\x00'");
}

TEST(BadObj, IndicesThatAreNone) {
  const auto obj = [](const std::string& text) { return complaint(text, "m.obj"); };
  for (const char* index : {"0", "a", "1.5", "1/a", "1 a", "/1", "99999999999999999999", "+1"}) {
    const std::string text = std::string("v 0 0 0\nf ") + index + "\n";
    EXPECT_TRUE(obj(text).starts_with("m.obj:2: expected a vertex index such as 3, -1, 3/1 or 3//2, found '"))
        << obj(text);
  }
}

std::string ply(const std::string& format, const std::string& elements, const std::string& body = "") {
  return complaint("ply\nformat " + format + " 1.0\n" + elements + "end_header\n" + body, "m.ply");
}
const std::string xyz_floats = "property float x\nproperty float y\nproperty float z\n";

std::string float_bytes(float value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

TEST(BadPly, Binary) {
  const std::string vertex = "element vertex 1\n" + xyz_floats;
  const std::string face = vertex + "element face 1\nproperty list uint int vertex_indices\n";
  const std::string other = vertex + "element other 1\nproperty list uint double x\n";
  const std::string zeros(12, '\0'), little = "binary_little_endian";
  const auto at = [&](const std::string& elements, std::size_t offset) {
    return " at byte " +
           std::to_string(("ply\nformat " + little + " 1.0\n" + elements + "end_header\n").size() + offset);
  };
  EXPECT_EQ(ply(little, vertex, zeros.substr(1)),
            "m.ply: expected 4 more bytes for vertex 1 of 1, found the end of the file" + at(vertex, 8));
  EXPECT_EQ(ply(little, vertex, zeros + "ab"),
            "m.ply: expected the end of the file, found 2 more bytes" + at(vertex, 12));
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(ply(little, vertex, float_bytes(0) + float_bytes(nan) + float_bytes(0)),
            "m.ply: expected a finite number, found nan" + at(vertex, 4));
  EXPECT_EQ(ply(little, vertex, float_bytes(infinity) + zeros),
            "m.ply: expected a finite number, found inf" + at(vertex, 0));
  EXPECT_EQ(ply(little, face, zeros + std::string("\1\0\0\0\1\0\0\0", 8)),
            "m.ply: expected a vertex index below 1, found 1" + at(face, 16));
  EXPECT_EQ(ply(little, face, zeros + "\xff\xff\xff\xff"),
            "m.ply: expected 4 more bytes for face 1 of 1, found the end of the file" + at(face, 16));
  EXPECT_EQ(ply(little, other, zeros + "\xff\xff\xff\xff"),
            "m.ply: expected 34359738360 more bytes for other 1 of 1, found the end of the file" + at(other, 16));
  const std::string huge = "element vertex 18446744073709551615\n" + xyz_floats;
  EXPECT_EQ(
      ply(little, huge, zeros),
      "m.ply: expected 4 more bytes for vertex 2 of 18446744073709551615, found the end of the file" + at(huge, 12));
  const std::string negative = vertex + "element face 1\nproperty list char int vertex_indices\n";
  EXPECT_EQ(ply(little, negative, zeros + "\xff"),
            "m.ply: expected the number of corners of a face, found -1" + at(negative, 12));
}

TEST(BadStl, Binary) {
  const auto stl = [](const std::string& text) { return complaint(text, "m.stl"); };
  const std::string header = std::string(80, ' ') + std::string("\2\0\0\0", 4);
  EXPECT_EQ(stl(header), "m.stl: expected 184 bytes for 2 triangles of a binary STL, found 84 bytes");
  EXPECT_EQ(stl(header + std::string(101, '\0')),
            "m.stl: expected 184 bytes for 2 triangles of a binary STL, found 185 bytes");
  EXPECT_EQ(stl("solid" + std::string(75, '\0') + header.substr(80)),
            "m.stl: expected 184 bytes for 2 triangles of a binary STL, found 84 bytes");
  EXPECT_EQ(stl(std::string(84, '\0')), "m.stl: expected at least one triangle, found 0");
  EXPECT_EQ(stl(std::string(80, 'x') + "\xff\xff\xff\xff"),
            "m.stl: expected 214748364834 bytes for 4294967295 triangles of a binary STL, found 84 bytes");
  std::string triangles = header + std::string(100, '\0');
  triangles.replace(84 + 12 + 4, 4, float_bytes(std::numeric_limits<float>::infinity()));
  EXPECT_EQ(stl(triangles), "m.stl: expected a finite number, found inf at byte 100");
}

TEST(BadXyz, AnExponentBeyondTheLimitOfExactDecimals) {
  EXPECT_EQ(complaint("1e100001 0 0", "m.xyz", Decimals::exact),
            "m.xyz:1: expected a number, found '1e100001': the decimal exponent is beyond 100000");
}

TEST(BadMesh, UnknownContent) {
  EXPECT_EQ(complaint("\x7f"
                      "ELF",
                      "m"),
            "m:1: expected a mesh (OFF, OBJ, PLY, STL, glTF, COLLADA, 3MF or lines x y z), found '\\x7fELF'");
}

TEST(BadMesh, OtherFormatsAreNamed) {
  const std::string expected = "expected a mesh (OFF, OBJ, PLY, STL, glTF, COLLADA, 3MF or lines x y z), found ";
  for (const auto& [bytes, name, what] :
       {std::tuple("<?xml version=\"1.0\"?>\n<robot name=\"r\">", "r.urdf",
                   "a description of a robot, which is not read: name the mesh"),
        std::tuple("<robot>", "m.xml", "a description of a robot"),
        std::tuple("\x93NUMPY\x01", "m.npy", "an array of numpy, which is not read"),
        std::tuple("x,y,z\n0,0,0\n", "m.csv",
                   "'x,y,z\\x0a0,0,0\\x0a': a table of points has no line with names above them")})
    EXPECT_TRUE(complaint(bytes, name).starts_with(std::string(name) + ":1: " + expected + what))
        << complaint(bytes, name);
}

TEST(BadScene, FirstBytesTellItWithoutAName) {
  EXPECT_EQ(complaint("glTF\x02", "m"),
            "m: expected a header 'glTF' of 12 bytes and a chunk of JSON, found 'glTF\\x02'");
  EXPECT_EQ(complaint("{\"asset\":{}}", "m.gltf"), "m.gltf: asset.version: expected 2.0, found none");
  EXPECT_EQ(complaint("<?xml version=\"1.0\"?>\n<COLLADA>", "m"),
            "m:2: expected '</COLLADA>', for line 2, found the end of the file");
  EXPECT_EQ(complaint("PK", "m.3mf"),
            "m.3mf: expected a ZIP archive with its directory at the end, found 2 bytes without one");
}

TEST(BadScene, FromMemoryNoFileIsRead) {
  EXPECT_EQ(complaint("{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":1,\"uri\":\"a.bin\"}]}", "m.gltf"),
            "m.gltf: buffers[0].uri: expected a buffer within the file, as it is read from memory, found 'a.bin'");
}

std::string complaint_of_file(const std::string& path) {
  try {
    read_mesh(path, Decimals::binary64);
  } catch (const InputError& error) {
    EXPECT_EQ(error.line(), 0u);
    return error.what();
  }
  return "";
}

class Files : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "fathom-files-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

TEST_F(Files, MissingDirectoryEmptyDevice) {
  EXPECT_EQ(complaint_of_file(path("none.off")),
            path("none.off") + ": expected a readable file, found none of this name");
  EXPECT_EQ(complaint_of_file(path("none/m.off")),
            path("none/m.off") + ": expected a readable file, found none of this name");
  EXPECT_EQ(complaint_of_file(folder_.string()), folder_.string() + ": expected a readable file, found a directory");
  EXPECT_EQ(complaint_of_file("/dev/null"), "/dev/null: expected a mesh, found an empty file");
  EXPECT_EQ(complaint_of_file(""), ": expected a readable file, found none of this name");
  std::ofstream(path("empty.obj")).close();
  EXPECT_EQ(complaint_of_file(path("empty.obj")), path("empty.obj") + ": expected a mesh, found an empty file");
  EXPECT_EQ(complaint_of_file(path("empty.obj") + "/m.off"),
            path("empty.obj") + "/m.off: expected a readable file, found none of this name");
  EXPECT_EQ(complaint_of_file(std::string("a\0.off", 6)),
            "'a\\x00.off': expected a readable file, found a null byte in its name");
}

/// The superuser may read everything: for the length of a test, be somebody else.
class Nobody {
 public:
  Nobody() : self_(geteuid()) { changed_ = self_ == 0 && seteuid(65534) == 0; }
  ~Nobody() {
    if (changed_ && seteuid(self_) != 0) std::abort();
  }

 private:
  uid_t self_;
  bool changed_;
};

TEST_F(Files, Unreadable) {
  const std::string name = path("secret.off");
  std::ofstream(name) << "OFF\n1 0 0\n0 0 0\n";
  std::filesystem::permissions(name, std::filesystem::perms::none);
  std::filesystem::permissions(folder_, std::filesystem::perms(0755));
  const Nobody nobody;
  if (geteuid() == 0) GTEST_SKIP() << "cannot be anybody else";
  EXPECT_EQ(complaint_of_file(name), name + ": expected a readable file, found 'Permission denied'");
  EXPECT_THROW(require_readable(name), InputError);
}

TEST_F(Files, ALoopOfLinksAndOneThatFails) {
  std::filesystem::create_symlink("loop.off", folder_ / "loop.off");
  EXPECT_EQ(complaint_of_file(path("loop.off")),
            path("loop.off") + ": expected a readable file, found 'Too many levels of symbolic links'");
  EXPECT_THROW(read_file("/proc/self/mem"), InputError) << "opens, but reading fails";
}

TEST_F(Files, APipeIsReadToItsEnd) {
  const std::string name = path("pipe.xyz");
  ASSERT_EQ(mkfifo(name.c_str(), 0600), 0);
  std::thread writer([&] {
    std::ofstream pipe(name);
    pipe << "1 2 3\n" << std::flush;
    pipe << "4 5 6\n";
  });
  EXPECT_EQ(read_mesh(name, Decimals::binary64).points.size(), 2u);
  writer.join();
}

TEST(Source, Extension) {
  EXPECT_EQ(extension("a/b.c/d.OFF"), "off");
  EXPECT_EQ(extension("a.b/c"), "");
  EXPECT_EQ(extension("c."), "");
  EXPECT_EQ(extension("-"), "");
}

TEST(Source, Shown) {
  EXPECT_EQ(kernels::shown(""), "nothing");
  EXPECT_EQ(kernels::shown("a\tb\xc3\xa4"), "'a\\x09b\\xc3\\xa4'");
  EXPECT_EQ(kernels::shown(std::string(41, 'x')), "'" + std::string(40, 'x') + "...'");
}

}  // namespace
}  // namespace fathom::files
