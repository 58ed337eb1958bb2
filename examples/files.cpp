// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies from meshes and from cases in JSON. Bad input is an InputError that says file, line and
// what was expected.
#include <fathom/files.hpp>
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

int main() {
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

//> 3602879701896397/36028797018963968 or 1/10, 1/3, 1/8
//> points:2: expected 2 columns as in the lines before, found 1 column
//> points, line 2
//> line 1, far: 22/7
//> line 2, odd: cases.jsonl:2: a.vertices: expected at least one point, found none
//> memory:1: a: expected a field 'vertices', found none
