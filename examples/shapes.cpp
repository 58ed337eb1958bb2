// SPDX-License-Identifier: GPL-3.0-or-later
// Round bodies: a capsule leans into a rounded box, exactly. Spheres, half-spaces, poses by
// quaternions, cores that touch; and in the plane, where a sphere is a circle.
#include <fathom/answer.hpp>
#include <fathom/approximate.hpp>
#include <fathom/certificate.hpp>
#include <fathom/plane.hpp>
#include <fathom/shape.hpp>
#include <fathom/signed_depth.hpp>
#include <iostream>
#include <string>

void in_the_plane() {
  using namespace fathom;
  Body disc;
  disc.shape = sphere(mpq_class(1, 2));
  const Body square = in_plane({{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}});
  const Answer answer = exact_answer(square, in_plane(disc));
  const Vector n = *answer.direction();
  std::cout << answer.status_name() << " " << *answer.nearest_binary64() << " (" << n.x << ", " << n.y << ") "
            << name(answer.contact()->kind) << ", dimension " << answer.dimension() << "\n";
  const Body diamond = in_plane({{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}});
  const Body triangle = in_plane({{{1, 1, 0}, {4, 1, 0}, {1, 5, 0}}});
  std::cout << "up " << directional_depth(square, triangle, {0, 1, 0}).factor() << ", in the norm "
            << metric_depth(square, triangle, unit_ball(diamond)).depth() << ", growth "
            << growth_distance(square, triangle).growth << "\n";
}

int main() {
  using namespace fathom;
  const mpq_class tenth(1, 10);
  const Shape crate = with_margin(box({1, 1, 1}), tenth);
  const Pose lean =
      rigid_pose({3, 1, 0, 0}, {0, 0, mpq_class(5, 2)});  // exactly orthogonal, though the quaternion is no unit
  const Shape pill = moved(capsule(mpq_class(1, 2), 2), lean);

  const SignedDepth depth = signed_depth(pill, crate);
  const Surd value = *depth.exact();
  std::cout << name(*depth.status()) << ": " << value.rational << " + root of " << value.root << ", from "
            << depth.low_binary64() << " to " << depth.high_binary64() << "\n";
  const AlongNormal out = depth.translations().front();
  std::cout << "move by " << out.alpha << " n + " << out.beta << " n/|n|, n = " << out.normal.x << " " << out.normal.y
            << " " << out.normal.z << "\n";
  const RoundedWitness witness = *depth.witness();
  std::cout << name(depth.contact()->kind) << " of the cores\n";
  std::cout << "the pill's point: " << witness.a.core.y << " along y on its axis, then " << witness.a.distance
            << " n/|n|\n";

  const std::string proof = certificate_text(pill, crate, depth, "pill");
  std::cout << proof.substr(0, proof.find('\n')) << ", radius " << make_certificate(pill, crate, depth).a.radius
            << "\n";

  const SignedDepth resting = signed_depth(sphere(1), halfspace({0, 0, 1}, -1));
  std::cout << name(*resting.status()) << ", bounds: " << (resting.bounds() != nullptr)
            << ", support calls: " << resting.counters().support_calls << "\n";

  // Crossing capsules: the cores touch, and every way out is a multiple of the cone's directions.
  const SignedDepth crossing = signed_depth(capsule(tenth, 1, Axis::x), capsule(tenth, 1, Axis::y));
  const Vector up = crossing.cone->direction(), first = crossing.direction();
  std::cout << "a line along z, " << crossing.cone->rays.size() << " rays; " << up.z << " " << first.z << "\n";

  // A pill in a can: every direction around their axis is as good.
  const SignedDepth inside = signed_depth(capsule(tenth, 1), cylinder(2, 6));
  std::cout << inside.exact()->rational << ", around an axis along z: " << inside.around()->z << "\n";

  const Shape others[] = {cylinder(1, 2),
                          cone(1, 2),
                          frustum(2, 1, 1),
                          ellipsoid({1, 2, 3}),
                          tapered_capsule(1, 2, 3),
                          hull({{Point{1, 2, 3}}}),
                          triangle({1, 0, 0}, {0, 1, 0}, {0, 0, 1})};
  Shape all = others[0];
  for (const Shape& other : others) all = minkowski_sum(all, other);
  std::cout << std::get<std::vector<Term>>(all.core).size() << " terms; flat: " << is_flat(all)
            << ", a triangle: " << is_flat(others[6]) << "\n";
  in_the_plane();
}

//> penetrating: 3/5 + root of -1/100, from 0.5 to 0.5
//> move by -1/50 n + 3/5 n/|n|, n = 0 4 3
//> edge-edge of the cores
//> the pill's point: 27/25 along y on its axis, then -1/2 n/|n|
//> fathom-certificate 2, radius 1/2
//> touching, bounds: 0, support calls: 1
//> a line along z, 0 rays; -1 -1
//> 21/10, around an axis along z: 1
//> 8 terms; flat: 0, a triangle: 1
//> penetrating 0.5 (0, 1) vertex-vertex, dimension 2
//> up 5, in the norm 1, growth 4/7
