// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of CGAL straight in, exact numbers and points of CGAL out. The kernels need not agree.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <fathom/cgal.hpp>
#include <iostream>
#include <vector>

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

int main() {
  CGAL::Surface_mesh<Inexact::Point_3> mesh;
  for (int i = 0; i < 8; ++i) mesh.add_vertex(Inexact::Point_3(i & 1, i >> 1 & 1, i >> 2));
  const Exact::FT third = Exact::FT(1) / 3;
  const std::vector<Exact::Point_3> points{{0, 0, 0}, {third, 1, 0}, {0, 1, third}, {third, third, third}};

  const fathom::Depth depth = fathom::penetration_depth(mesh, points);
  const CGAL::Exact_rational squared = fathom::to_exact_rational(depth.squared());
  const Exact::Vector_3 way_out = fathom::to_vector_3<Exact>(depth.translation());
  const Exact::Point_3 witness = fathom::to_point_3<Exact>(depth.penetration()->witness().a);
  std::cout << "depth^2 = " << squared
            << ", which is the length^2 of the way out: " << (CGAL::exact(way_out.squared_length()) == squared) << "\n";
  std::cout << "it begins in (" << CGAL::exact(witness.x()) << ", " << CGAL::exact(witness.y()) << ", "
            << CGAL::exact(witness.z()) << ")\n";

  // Other functions take exact points, and what they return can be made a number or point of any
  // exact kernel.
  const fathom::Depth width = fathom::width(fathom::exact_points(mesh));
  const auto across = fathom::to_vector_3<Exact>(width.direction());
  std::cout << "width^2 = " << fathom::to_number<Exact::FT>(width.squared()) << ", across (" << across << ")\n";
  std::cout << "a third is " << fathom::exact_value(third) << ", and " << fathom::exact_point(points[1]).x << "\n";
}

//> depth^2 = 1/9, which is the length^2 of the way out: 1
//> it begins in (1/6, 2/3, 0)
//> width^2 = 1, across (-1 0 0)
//> a third is 1/3, and 1/3
