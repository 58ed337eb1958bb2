// SPDX-License-Identifier: GPL-3.0-or-later
// What coincides of two shapes: a cone that stands on its apex on a box, and two capsules side by side.
#include <fathom/shape.hpp>
#include <fathom/study.hpp>
#include <iostream>

namespace {

void print(const fathom::ShapeStudy& study) {
  std::cout << fathom::name(*study.depth.status()) << ", " << study.contact->a.what << " and " << study.contact->b.what << ":";
  for (std::size_t kind = 0; kind < study.coincidences.size(); ++kind)
    if (study.coincidences[kind].count > 0) std::cout << " " << fathom::shape_coincidence_names[kind];
  std::cout << "\n";
}

}  // namespace

int main() {
  using namespace fathom;
  const Shape top = moved(cone(1, 1), rigid_pose({0, 1, 0, 0}, {0, 0, 2}));  // upside down
  print(study(top, box({1, 1, 1})));

  const Shape pill = capsule(1, 2);
  const ShapeStudy pills = study(pill, moved(pill, rigid_pose({1, 0, 0, 0}, {2, 0, 0})));
  print(pills);
  std::cout << "their axes: " << (*pills.cores)[Coincidence::parallel_edges].count << " pair of parallel edges\n";
}

//> touching, apex and face: centre_on_axis parallel_faces supporting_faces apex_on_face touching_features
//> touching, generator and generator: parallel_axes equal_radii parallel_generators tangent_generators distance_of_radii touching_features
//> their axes: 1 pair of parallel edges
