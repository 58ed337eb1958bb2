// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are cut off, changed or noise: each is refused with a sentence, or is a well-formed
// body. Nothing else may happen.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>

#include "fathom/files.hpp"
#include "reference/files/file_io.hpp"
#include "tests/support/property.hpp"

namespace fathom::files {
namespace {

const std::string data = FATHOM_TEST_DATA "/";
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

TEST(Noise, TokensThatNearlyFit) {
  const std::vector<std::string> tokens{"OFF",
                                        "3",
                                        "0",
                                        "1",
                                        "-1",
                                        "1e400",
                                        "nan",
                                        "0x1p3",
                                        "1/2",
                                        "\n",
                                        "\n",
                                        "\r\n",
                                        "#",
                                        "v",
                                        "f",
                                        "1/1/1",
                                        "ply",
                                        "format",
                                        "ascii",
                                        "1.0",
                                        "element",
                                        "vertex",
                                        "face",
                                        "property",
                                        "list",
                                        "float",
                                        "int",
                                        "x",
                                        "y",
                                        "z",
                                        "vertex_indices",
                                        "end_header",
                                        "solid",
                                        "facet",
                                        "normal",
                                        "outer",
                                        "loop",
                                        "endloop",
                                        "endfacet",
                                        "endsolid",
                                        ",",
                                        "\\",
                                        "18446744073709551615",
                                        "COFF"};
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

}  // namespace
}  // namespace fathom::files
