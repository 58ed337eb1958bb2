// SPDX-License-Identifier: GPL-3.0-or-later
// What is degenerate about two unit cubes that overlap by a half, and what decides where the
// predicates are zero; what coincides of a cone that stands on its apex on a box, and of two
// capsules side by side.
#include <fathom/shape.hpp>
#include <fathom/study.hpp>
#include <iostream>
#include <vector>

std::vector<fathom::Point> cube(const mpq_class& x) {
  std::vector<fathom::Point> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({x + (i & 1), mpq_class(i >> 1 & 1), mpq_class(i >> 2)});
  return corners;
}

void print(const fathom::ShapeStudy& study) {
  std::cout << fathom::name(*study.depth.status()) << ", " << study.contact->a.what << " and " << study.contact->b.what
            << ":";
  for (std::size_t kind = 0; kind < study.coincidences.size(); ++kind)
    if (study.coincidences[kind].count > 0) std::cout << " " << fathom::shape_coincidence_names[kind];
  std::cout << "\n";
}

void about_shapes() {
  using namespace fathom;
  const Shape top = moved(cone(1, 1), rigid_pose({0, 1, 0, 0}, {0, 0, 2}));  // upside down
  print(study(top, box({1, 1, 1})));

  const Shape pill = capsule(1, 2);
  const ShapeStudy pills = study(pill, moved(pill, rigid_pose({1, 0, 0, 0}, {2, 0, 0})));
  print(pills);
  std::cout << "their axes: " << (*pills.cores)[Coincidence::parallel_edges].count << " pair of parallel edges\n";
}

int main() {
  const fathom::Study study = fathom::study(cube(0), cube(mpq_class(1, 2)));
  for (std::size_t kind = 0; kind < study.coincidences.size(); ++kind) {
    if (const auto count = study.coincidences[kind].count)
      std::cout << fathom::coincidence_names[kind] << ": " << count << "\n";
  }
  const auto& coplanar = study[fathom::Coincidence::coplanar_facets].listed.front();
  std::cout << "the first coplanar facets have " << coplanar.a[0].size() << " and " << coplanar.b[0].size()
            << " corners\n";

  const auto& x_order = study.predicates[static_cast<std::size_t>(fathom::Predicate::x_order)];
  std::cout << "x_order: ";
  for (const auto& [monomial, zeros] : x_order.decided)
    std::cout << zeros << " zeros decided by " << fathom::monomial_name(monomial) << "; ";
  std::cout << x_order.zero << " in all\n";

  about_shapes();
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
//> touching, apex and face: centre_on_axis parallel_faces supporting_faces apex_on_face touching_features
//> touching, generator and generator: parallel_axes equal_radii parallel_generators tangent_generators distance_of_radii touching_features
//> their axes: 1 pair of parallel edges
