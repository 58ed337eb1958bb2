// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies from meshes and from cases in JSON. Bad input is an InputError that says file, line and what was expected.
#include <fathom/files.hpp>
#include <iostream>
#include <sstream>

constexpr std::string_view mesh = R"(OFF
4 0 0
0 0 0
0.1 0 0
0 1/3 0
0 0 0x1p-3
)";

// A pipe or a file: CaseStream::open(path, std::cin).
constexpr const char* cases = R"({"id": "far", "a": {"vertices": [[0, 0, 0]]}, "b": {"vertices": [["22/7", 0, 0]]}}
{"id": "odd", "a": {"vertices": []}}
)";

int main() {
  // fathom::read_mesh("tetrahedron.off") reads a file.
  const fathom::Body doubles = fathom::parse_mesh(mesh, "tetrahedron.off");
  const fathom::Body decimals = fathom::parse_mesh(mesh, "tetrahedron.off", fathom::Decimals::exact);
  std::cout << doubles.points[1].x << " or " << decimals.points[1].x << ", " << decimals.points[2].y << ", " << decimals.points[3].z
            << "\n";
  try {
    fathom::parse_mesh("0 0\n", "points", fathom::Decimals::exact, fathom::MeshFormat::xyz);
  } catch (const fathom::InputError& error) {
    std::cout << error.what() << "\n";
  }

  std::istringstream input(cases);
  fathom::CaseStream stream(input, "cases");
  while (const auto item = stream.next()) {
    std::cout << item->id << ": " << (item->ok() ? item->value().b.points[0].x.get_str() : item->error().what()) << "\n";
  }
  std::cout << fathom::parse_case(R"({"a": {}})", "memory").error().what() << "\n";
}

//> TODO
