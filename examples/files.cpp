// SPDX-License-Identifier: GPL-3.0-or-later
// Exact numbers in, correctly rounded numbers out: a depth is the square root of a rational. And
// bodies from meshes and from cases in JSON: bad input is an InputError that says file, line and
// what was expected.
#include <fathom/files.hpp>
#include <fathom/numbers.hpp>
#include <fstream>
#include <iostream>

constexpr std::string_view mesh = R"(OFF
4 0 0
0 0 0
0.1 0 0
0 1/3 0
0 0 0x1p-3
)";

constexpr std::string_view cases = R"({"id": "far", "a": {"vertices": [[0, 0, 0]]}, "b": {"vertices": [["22/7", 0, 0]]}}
{"id": "odd", "a": {"vertices": []}}
)";

void exact_numbers() {
  using fathom::Rounding;
  const mpq_class tenth = *fathom::parse_number("0.1", fathom::Decimals::exact).value;
  const mpq_class nearly = *fathom::parse_number("0.1", fathom::Decimals::binary64).value;
  std::cout << fathom::exact_text(tenth) << " or " << fathom::exact_text(nearly) << ", as a double holds "
            << (fathom::exact_value(0.1) == nearly) << "\n";
  std::cout << fathom::parse_number("1/0", fathom::Decimals::exact).error << "\n";

  const mpq_class squared = 2;  // depth^2
  for (const Rounding mode : {Rounding::rn, Rounding::rd, Rounding::ru}) {
    std::cout << fathom::hex_text(fathom::root_binary64(squared, mode)) << " "
              << fathom::hex_text(fathom::root_binary32(squared, mode)) << " "
              << fathom::hex_text(fathom::round_binary64(tenth, mode)) << " "
              << fathom::hex_text(fathom::round_binary32(tenth, mode)) << "\n";
  }
  const fathom::Enclosure root = fathom::enclose_root(squared, 30);
  std::cout << root.low << " < sqrt(2) < " << root.high << "\n";

  const fathom::Surd apart{mpq_class(3, 2), -2};  // 3/2 - sqrt(2)
  const fathom::Enclosure digits = fathom::enclose(apart, 5);
  std::cout << fathom::sign(apart) << " " << fathom::compare(apart, tenth) << " "
            << fathom::compare(apart, fathom::Surd{1, 0}) << " " << fathom::round_binary64(apart) << " " << digits.low
            << " " << digits.high << "\n";
}

int main() {
  exact_numbers();

  std::ofstream("tetrahedron.off") << mesh;
  std::ofstream("cases.jsonl") << cases;

  const fathom::Body doubles = fathom::read_mesh("tetrahedron.off");
  const fathom::Body decimals = fathom::parse_mesh(mesh, "in_memory.off", fathom::Decimals::exact);
  std::cout << doubles.points[1].x << " or " << decimals.points[1].x << ", " << decimals.points[2].y << ", "
            << decimals.points[3].z << "\n";
  try {
    fathom::parse_mesh("0 0\n1\n", "points", fathom::Decimals::exact, fathom::MeshFormat::xyz);
  } catch (const fathom::InputError& error) {
    std::cout << error.what() << "\n" << error.file() << ", line " << error.line() << "\n";
  }

  fathom::CaseStream stream = fathom::CaseStream::open("cases.jsonl", std::cin);  // "-" is std::cin
  while (const auto item = stream.next()) {
    std::cout << "line " << stream.case_line() << ", " << item->id << ": "
              << (item->ok() ? item->value().b.points[0].x.get_str() : item->error().what()) << "\n";
  }
  std::cout << fathom::parse_case(R"({"a": {}})", "memory").error().what() << "\n";
}

//> 1/10 or 3602879701896397/36028797018963968, as a double holds 1
//> expected a number, found '1/0': the denominator is zero
//> 0x1.6a09e667f3bcdp+0 0x1.6a09e6p+0 0x1.999999999999ap-4 0x1.99999ap-4
//> 0x1.6a09e667f3bccp+0 0x1.6a09e6p+0 0x1.9999999999999p-4 0x1.999998p-4
//> 0x1.6a09e667f3bcdp+0 0x1.6a09e8p+0 0x1.999999999999ap-4 0x1.99999ap-4
//> 1.41421356237309504880168872420 < sqrt(2) < 1.41421356237309504880168872421
//> 1 -1 -1 0.0857864 0.085786 0.085787
//> 3602879701896397/36028797018963968 or 1/10, 1/3, 1/8
//> points:2: expected 2 columns as in the lines before, found 1 column
//> points, line 2
//> line 1, far: 22/7
//> line 2, odd: cases.jsonl:2: a.vertices: expected at least one point, found none
//> memory:1: a: expected a field 'vertices', found none
