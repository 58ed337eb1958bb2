// SPDX-License-Identifier: GPL-3.0-or-later
// What is degenerate about two unit cubes that overlap by a half, and what decides where the predicates are zero.
#include <fathom/study.hpp>
#include <iostream>
#include <vector>

std::vector<fathom::Point> cube(const mpq_class& x) {
  std::vector<fathom::Point> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({x + (i & 1), mpq_class(i >> 1 & 1), mpq_class(i >> 2)});
  return corners;
}

int main() {
  const fathom::Study study = fathom::study(cube(0), cube(mpq_class(1, 2)));
  for (std::size_t kind = 0; kind < study.coincidences.size(); ++kind) {
    if (const auto count = study.coincidences[kind].count) std::cout << fathom::coincidence_names[kind] << ": " << count << "\n";
  }
  const auto& coplanar = study[fathom::Coincidence::coplanar_facets].listed.front();
  std::cout << "the first coplanar facets have " << coplanar.a[0].size() << " and " << coplanar.b[0].size() << " corners\n";

  const auto& x_order = study.predicates[static_cast<std::size_t>(fathom::Predicate::x_order)];
  std::cout << "x_order: ";
  for (const auto& [monomial, zeros] : x_order.decided)
    std::cout << zeros << " zeros decided by " << fathom::monomial_name(monomial) << "; ";
  std::cout << x_order.zero << " in all\n";
}

//> parallel_edges: 48
//> parallel_edges_of_a: 18
//> parallel_edges_of_b: 18
//> coincident_normals: 6
//> equal_normals: 6
//> coplanar_facets: 4
//> nodes_on_equator: 8
//> arcs_on_equator: 8
//> nodes_on_one_vertical: 2
//> arcs_on_verticals: 16
//> the first coplanar facets have 4 and 4 corners
//> x_order: 7 zeros decided by a; 2 zeros decided by b; 4 zeros decided by E12 b; 4 zeros decided by E13; 4 zeros decided by E21 b; 21 in all
