// SPDX-License-Identifier: GPL-3.0-or-later
// One body in every format, and what each format may vary.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "fathom/files.hpp"
#include "reference/files/file_io.hpp"
#include "tests/support/case_files.hpp"
#include "tests/support/property.hpp"
#include "tests/support/words.hpp"

namespace fathom::files {
namespace {

using testing::data;

using Points = std::vector<Point>;

Points read(const std::string& name, Decimals decimals = Decimals::binary64) {
  return read_mesh(data + name, decimals).points;
}
Points parse(const std::string& text, const std::string& name, Decimals decimals = Decimals::binary64) {
  return parse_mesh(text, name, decimals).points;
}
Point point(const char* x, const char* y, const char* z) { return {mpq_class(x), mpq_class(y), mpq_class(z)}; }

const Points wedge{point("-3/2", "0", "-2"),     point("9/4", "1/8", "-2"), point("1/2", "3", "-5/2"),
                   point("-3/2", "1/16", "7/4"), point("9/4", "0", "2"),    point("3/8", "11/4", "1000")};
constexpr std::size_t corners[]{0, 2, 1, 3, 4, 5, 0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4, 2, 0, 3, 2, 3, 5};

TEST(Mesh, TheSameBodyInEveryFormat) {
  for (const char* name : {"wedge.off", "wedge_colours.off", "wedge.obj", "wedge_text.ply", "wedge_little.ply",
                           "wedge_big.ply", "wedge.xyz", "wedge.pts", "wedge.txt"}) {
    EXPECT_EQ(read(name), wedge) << name;
    EXPECT_EQ(read(name, Decimals::exact), wedge) << name;
  }
}

TEST(Mesh, StlRepeatsEachCorner) {
  Points expected;
  for (const std::size_t corner : corners) expected.push_back(wedge[corner]);
  EXPECT_EQ(read("wedge_text.stl"), expected);
  EXPECT_EQ(read("wedge_binary.stl"), expected) << "its header begins with 'solid'; its size tells";
}

TEST(Mesh, AnUnknownExtensionIsToldByContent) {
  for (const char* name :
       {"wedge.off", "wedge_colours.off", "wedge.obj", "wedge_text.ply", "wedge_little.ply", "wedge_big.ply",
        "wedge.xyz", "wedge.pts", "wedge.txt", "wedge_text.stl", "wedge_binary.stl"}) {
    const std::string bytes = read_file(data + name);
    for (const char* other : {"mesh", "mesh.dat", ".d/mesh", "a.off/mesh", "mesh."})
      EXPECT_EQ(parse(bytes, other), read(name)) << name;
  }
}

TEST(Mesh, ABinaryStlIsToldByItsSize) {
  std::string bytes = read_file(data + "wedge_binary.stl");
  bytes.replace(0, 5, "model");
  EXPECT_EQ(parse(bytes, "mesh"), read("wedge_binary.stl"));
}

TEST(Mesh, ExtensionsAreComparedWithoutCase) { EXPECT_EQ(parse("1 2 3\n", "A.XYZ"), Points{point("1", "2", "3")}); }

TEST(Mesh, CubeAndIcosahedron) {
  const Points cube = read("cube.off"), icosahedron = read("icosahedron.off");
  ASSERT_EQ(cube.size(), 8u);
  EXPECT_EQ(cube[6], point("0", "1", "1"));
  ASSERT_EQ(icosahedron.size(), 12u);
  EXPECT_EQ(icosahedron[0].z, mpq_class(1.6840169943749475));
}

TEST(Mesh, DecimalsMeanBinary64UnlessExact) {
  const std::string text = "0.1 1e-1 -0.1\n";
  const Point rounded{mpq_class(0.1), mpq_class(0.1), mpq_class(-0.1)};
  for (const std::string& prefix : {std::string("OFF 1 0 0\n"), std::string("v "), std::string()}) {
    const std::string name = prefix.empty() ? "m.xyz" : prefix == "v " ? "m.obj" : "m.off";
    EXPECT_EQ(parse(prefix + text, name), Points{rounded}) << name;
    EXPECT_EQ(parse(prefix + text, name, Decimals::exact), (Points{point("1/10", "1/10", "-1/10")})) << name;
  }
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n" +
      text;
  EXPECT_EQ(parse(ply, "m.ply"), Points{rounded}) << "the declared type does not round a second time";
  EXPECT_EQ(parse(ply, "m.ply", Decimals::exact), (Points{point("1/10", "1/10", "-1/10")}));
}

TEST(Mesh, IntegersRatiosAndHexFloatsAreExact) {
  for (const Decimals decimals : {Decimals::binary64, Decimals::exact}) {
    EXPECT_EQ(parse("100000000000000000000000000001 -22/7 0x1.8p-3\n", "m.xyz", decimals),
              (Points{point("100000000000000000000000000001", "-22/7", "3/16")}));
    EXPECT_EQ(parse("9007199254740993 +5 0x.1p+4\n", "m.xyz", decimals), (Points{point("9007199254740993", "5", "1")}));
  }
}

TEST(Mesh, ExactDecimalsMayLieBeyondBinary64) {
  EXPECT_EQ(parse("1e400 0 0\n", "m.xyz", Decimals::exact)[0].x, mpq_class("1" + std::string(400, '0')));
  EXPECT_EQ(parse("1e-400 0 0\n", "m.xyz")[0].x, 0) << "the nearest binary64";
}

TEST(Mesh, RepeatedPointsKeepTheirIds) {
  EXPECT_EQ(parse("1 2 3\n1 2 3\n", "m.xyz"), (Points{point("1", "2", "3"), point("1", "2", "3")}));
}

// --- OFF

TEST(MeshOff, HeaderAndCountsMayShareALine) {
  const Points expected{point("1", "2", "3"), point("4", "5", "6")};
  for (const char* text :
       {"OFF\n2 0 0\n1 2 3\n4 5 6\n", "OFF 2 0 0\n1 2 3\n4 5 6", "OFF2 0 0\n1 2 3\n4 5 6\n",
        "off\n2 0 0\n1 2 3\n4 5 6\n", "OFF\r\n2 0\r\n1 2 3\r\n4 5 6\r\n", "OFF\r2 0 0\r1 2 3\r4 5 6\r",
        "\xEF\xBB\xBFOFF # header\n\n# counts\n2 0 0 # two\n\n1 2 3#first\n  4\t5 6  \n\n# end\n",
        "STOFF\n2 0 0\n1 2 3 .5 .5\n4 5 6 .5 .5\n", "NOFF\n2 0 0\n1 2 3 0 0 1\n4 5 6 0 0 1\n",
        "STCNOFF\n2 0 0\n1 2 3 0 0 1 1 0 0 1 0 0\n4 5 6 0 0 1 1 0 0 1 0 0\n"}) {
    EXPECT_EQ(parse(text, "m.off"), expected) << text;
  }
}

TEST(MeshOff, FacesOfAnySizeWithColours) {
  EXPECT_EQ(parse("OFF\n2 4 0\n1 2 3\n4 5 6\n0\n1 0\n2 0 1 255 0 0\n3 1 1 0 .5 .5 .5\n", "m.off").size(), 2u);
}

// --- OBJ

TEST(MeshObj, IndicesInEveryForm) {
  const std::string vertices = "v 0 0 0 1.0\nv 1 0 0 .5 .5 .5\nv 0 1 0\n";
  for (const char* face :
       {"f 1 2 3", "f 1/2 2/2 3/2", "f 1//2 2//2 3//2", "f 1/2/3 2/2/3 3/2/3", "f -1 -2 -3",
        "f -1/-1/-1 -2/-1/-1 1//-1", "f 1 2 \\\n 3", "f 1 \\\r\n\\\r\n 2 3 # comment", "f 1\\\n 2 3"}) {
    EXPECT_EQ(parse(vertices + face + "\n", "m.obj").size(), 3u) << face;
    EXPECT_EQ(parse(vertices + face, "m.obj").size(), 3u) << face;
  }
  EXPECT_EQ(parse("f 1 2 3\n" + vertices, "m.obj").size(), 3u) << "a face may name vertices that come later";
}

TEST(MeshObj, OtherLinesArePassedOver) {
  EXPECT_EQ(parse("mtllib a\nvn x\nvt\nusemtl \xff\n\tv 1 2 3\nl 1 9\np 7\ncurv 1\n", "m.obj"),
            Points{point("1", "2", "3")});
}

TEST(MeshObj, AJoinedLineEndsWhereItEnds) {
  EXPECT_EQ(parse("# no joining \\\nv 1 2 3\n", "m.obj"), Points{point("1", "2", "3")});
  EXPECT_EQ(parse("g a \\\nv 9 9 9\nv 1 2 \\\n3\n", "m.obj"), Points{point("1", "2", "3")})
      << "the second line belongs to g";
}

// --- PLY

std::string ply_header(const std::string& format, const std::string& elements, const std::string& end = "\n") {
  std::string text = "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
  for (std::size_t at = 0; end != "\n" && (at = text.find('\n', at)) != std::string::npos; at += end.size())
    text.replace(at, 1, end);
  return text;
}

template <class T>
std::string bytes_of(T value, bool big) {
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
  if (big != (std::endian::native == std::endian::big)) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

template <class T>
void expect_ply_type(const std::vector<std::string>& names, T value, const mpq_class& meaning) {
  for (const std::string& type : names) {
    for (const bool big : {false, true}) {
      const std::string elements =
          "element vertex 1\nproperty " + type + " z\nproperty " + type + " x\nproperty " + type + " y\n";
      const std::string bytes = ply_header(big ? "binary_big_endian" : "binary_little_endian", elements) +
                                bytes_of(value, big) + bytes_of(T(1), big) + bytes_of(T(2), big);
      EXPECT_EQ(parse(bytes, "m.ply"), (Points{{1, 2, meaning}})) << type;
    }
  }
}

TEST(MeshPly, EveryScalarTypeIsExact) {
  expect_ply_type<std::int8_t>({"char", "int8"}, -128, -128);
  expect_ply_type<std::uint8_t>({"uchar", "uint8"}, 255, 255);
  expect_ply_type<std::int16_t>({"short", "int16"}, -32768, -32768);
  expect_ply_type<std::uint16_t>({"ushort", "uint16"}, 65535, 65535);
  expect_ply_type<std::int32_t>({"int", "int32"}, INT32_MIN, INT32_MIN);
  expect_ply_type<std::uint32_t>({"uint", "uint32"}, UINT32_MAX, UINT32_MAX);
  expect_ply_type<float>({"float", "float32"}, 0.1f, mpq_class(static_cast<double>(0.1f)));
  expect_ply_type<double>({"double", "float64"}, 5e-324, mpq_class(5e-324));
}

TEST(MeshPly, ListsAndElementsInAnyOrder) {
  const std::string elements =
      "obj_info x\nelement nothing 1000000000000000000\nelement face 2\nproperty list uchar int other\nproperty list "
      "uchar int "
      "vertex_indices\nelement vertex 2\nproperty double y\nproperty list int float more\nproperty int x\nproperty "
      "float z\ncomment end\n";
  const Points expected{point("1", "2", "3"), point("4", "5", "6")};
  EXPECT_EQ(parse(ply_header("ascii", elements) + "0 2 0 1\n3 7 8 9 1 1\n2 2 .5 .5 1 3\n5 0 4 6\n", "m.ply"), expected);
  EXPECT_EQ(parse(ply_header("ascii", elements, "\r\n") + "0 2 0 1\r\n3 7 8 9 1 1\r\n2 0 1 3\r\n5 0 4 6", "m.ply"),
            expected);
}

TEST(MeshPly, ABinaryBodyMayStartWithALineFeed) {
  const std::string elements = "element vertex 1\nproperty uchar x\nproperty uchar y\nproperty uchar z\n";
  for (const char* end : {"\r", "\r\n", "\n"})
    EXPECT_EQ(parse(ply_header("binary_little_endian", elements, end) + "\n\r\n", "m.ply"),
              (Points{point("10", "13", "10")}))
        << end;
}

// --- STL

TEST(MeshStl, TextInAnyCaseWithSeveralSolids) {
  const std::string facet =
      "FACET NORMAL nan -inf 0\nouter loop vertex 0 0 0\nvertex 1 0 0\n\n VERTEX 0 1 0 endloop\nendfacet\n";
  EXPECT_EQ(parse("solid\n" + facet + "endsolid\n", "m.stl").size(), 3u);
  EXPECT_EQ(
      parse("Solid a b\n" + facet + facet + "EndSolid a b\nsolid endsolid\n" + facet + "endsolid endsolid", "m.stl")
          .size(),
      9u);
}

// --- points

TEST(MeshXyz, SeparatorsAndColumns) {
  const Points expected{point("1", "2", "3"), point("4", "5", "6")};
  for (const char* text : {"1 2 3\n4 5 6", "1,2,3\n4, 5 ,6\n", "# x\n\n 1\t2 3 # y\r\n4 5 6\r\n",
                           "1 2 3 0 0 1\n4 5 6 0 0 1\n", "2\n1 2 3\n4 5 6\n", "1,2,3,red\n4,5,6,\n"}) {
    EXPECT_EQ(parse(text, "m.xyz"), expected) << text;
  }
}

// --- size

TEST(Mesh, ManyVertices) {
  constexpr int vertices = 100'000;
  std::string text = "OFF\n" + std::to_string(vertices) + " " + std::to_string(vertices) + " 0\n";
  for (int i = 0; i < vertices; ++i) text += std::to_string(i) + " " + std::to_string(i * 0.001) + " -1e-5\n";
  for (int i = 0; i < vertices; ++i) text += "3 " + std::to_string(i) + " 0 1\n";
  const Points points = parse(text, "m.off");
  ASSERT_EQ(points.size(), static_cast<std::size_t>(vertices));
  EXPECT_EQ(points.back(), (Point{vertices - 1, mpq_class(99.999), mpq_class(-1e-5)}));
}

// Files that are cut off, changed or noise: each is refused with a sentence, or is a well-formed
// body. Nothing else may happen.

constexpr std::array whole_files{"wedge.off",        "wedge_colours.off", "wedge.obj",      "wedge_text.ply",
                                 "wedge_little.ply", "wedge_big.ply",     "wedge_text.stl", "wedge_binary.stl",
                                 "wedge.xyz",        "wedge.pts",         "wedge.txt"};
constexpr std::array names{"m.off", "m.obj", "m.ply", "m.stl", "m.xyz", "m"};

/// True for a body that stands for something; false for a refusal that names the file and says why.
/// Anything else fails the test.
bool is_body(std::string_view bytes, const std::string& name) {
  try {
    const Body body = parse_mesh(bytes, name, Decimals::binary64);
    EXPECT_FALSE(body.points.empty());
    for (const Point& p : body.points)
      for (const mpq_class* x : {&p.x, &p.y, &p.z}) EXPECT_EQ(gcd(x->get_num(), x->get_den()), 1);
    return true;
  } catch (const InputError& error) {
    const std::string sentence = error.what();
    EXPECT_TRUE(sentence.starts_with(name + ":")) << sentence;
    EXPECT_NE(sentence.find("expected "), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(", found "), std::string::npos) << sentence;
    return false;
  }
}

TEST(Truncation, EveryPrefixOfEveryFormat) {
  for (const std::string name : whole_files) {
    const std::string bytes = read_file(data + name);
    ASSERT_TRUE(is_body(bytes, name)) << name;
    for (std::size_t length = 0; length < bytes.size(); ++length)
      is_body(std::string_view(bytes).substr(0, length), name);
  }
}

// In these formats the end is known: what lacks more than blanks, a comment or a digit of the last
// number is refused.
TEST(Truncation, CutsAreNoticedWhereTheFormatCanTell) {
  struct Tail {
    const char* name;
    std::size_t may_lack;
  };
  for (const auto& [name, may_lack] :
       {Tail{"wedge.off", 1}, Tail{"wedge_colours.off", 11}, Tail{"wedge_text.ply", 1}, Tail{"wedge_little.ply", 0},
        Tail{"wedge_big.ply", 0}, Tail{"wedge_text.stl", 14}, Tail{"wedge_binary.stl", 0}}) {
    const std::string bytes = read_file(data + name);
    for (std::size_t length = 0; length < bytes.size(); ++length)
      EXPECT_EQ(is_body(std::string_view(bytes).substr(0, length), name), length + may_lack >= bytes.size())
          << name << " cut to " << length;
  }
}

std::string noise() {
  const auto byte = rc::gen::inRange<int>(0, 256);
  std::string bytes;
  for (const int b : *rc::gen::container<std::vector<int>>(byte)) bytes += static_cast<char>(b);
  return bytes;
}

TEST(Noise, BytesAfterEveryHeader) {
  const std::array<std::string, 8> headers{
      "",
      "OFF\n",
      "OFF 3 1 0\n",
      "v ",
      "solid\nfacet normal",
      "ply\nformat ascii 1.0\n",
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty char y\nproperty "
      "double z\nelement face 4\nproperty list uchar ushort vertex_index\nend_header\n",
      std::string(80, '\0') + std::string("\1\0\0\0", 4)};
  EXPECT_TRUE(holds({.seed = 8, .runs = 3000, .max_size = 300},
                    [&] { is_body(*rc::gen::elementOf(headers) + noise(), *rc::gen::elementOf(names)); }));
}

TEST(Noise, TokensOfMeshesThatNearlyFit) {
  std::vector<std::string> tokens = testing::words(
      R"(OFF 3 0 1 -1 1e400 nan 0x1p3 1/2 # v f 1/1/1 ply format ascii 1.0 element vertex face property list float int x
      y z vertex_indices end_header solid facet normal outer loop endloop endfacet endsolid , \ 18446744073709551615
      COFF)");
  tokens.insert(tokens.end(), {"\n", "\n", "\r\n"});
  EXPECT_TRUE(holds({.seed = 8, .runs = 3000, .max_size = 300}, [&] {
    std::string text;
    for (const std::string& token : *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(tokens)))
      text += token + " ";
    is_body(text, *rc::gen::elementOf(names));
  }));
}

TEST(Noise, AByteChanged) {
  EXPECT_TRUE(holds({.seed = 8, .runs = 3000, .max_size = 300}, [&] {
    const std::string name = *rc::gen::elementOf(whole_files);
    std::string bytes = read_file(data + name);
    bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] = static_cast<char>(*rc::gen::inRange(0, 256));
    is_body(bytes, name);
  }));
}

// Files are read whole; what may have no end, a pipe or a device, up to a limit.

constexpr std::size_t limit = 1000;

std::string complaint_of(const std::string& path) {
  try {
    read_file(path, limit);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// A pipe that holds so many bytes and ends; its name.
class Pipe {
 public:
  explicit Pipe(std::size_t size) {
    if (::pipe(ends_.data()) != 0) throw std::runtime_error("no pipe");
    const std::string bytes(size, 'x');
    const bool written = ::write(ends_[1], bytes.data(), size) == static_cast<ssize_t>(size);
    ::close(ends_[1]);
    if (!written) throw std::runtime_error("a pipe that takes nothing");
  }
  ~Pipe() { ::close(ends_[0]); }
  [[nodiscard]] std::string name() const { return "/proc/self/fd/" + std::to_string(ends_[0]); }

 private:
  std::array<int, 2> ends_{};
};

TEST(ReadFile, PipesAndDevicesHaveALimit) {
  EXPECT_EQ(complaint_of("/dev/zero"),
            "/dev/zero: expected a readable file, found a pipe or device of more than 1000 bytes");
  EXPECT_EQ(complaint_of("/dev/null"), "");
  EXPECT_EQ(complaint_of(Pipe(limit).name()), "");
  const Pipe longer(limit + 1);
  EXPECT_EQ(complaint_of(longer.name()),
            longer.name() + ": expected a readable file, found a pipe or device of more than 1000 bytes");
}

TEST(ReadFile, FilesHaveNone) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("fathom-source-" + std::to_string(::getpid()));
  std::ofstream(path) << std::string(2 * limit, 'x');
  EXPECT_EQ(read_file(path, limit), std::string(2 * limit, 'x'));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace fathom::files
