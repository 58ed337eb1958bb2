// SPDX-License-Identifier: GPL-3.0-or-later
// Where two bodies touch, all of it, and how their depth changes as they move: a box that stands in
// a block, a tip in a pyramid, and a cone, for which there is no formula that always holds.
#include <fathom/answer.hpp>
#include <fathom/files.hpp>
#include <fathom/patch.hpp>
#include <iostream>
#include <string>
#include <variant>

std::ostream& operator<<(std::ostream& out, const fathom::Point& p) {
  return out << '(' << p.x << ", " << p.y << ", " << p.z << ')';
}

// Each number is round_binary64 of one that is exact but for a root.
std::ostream& operator<<(std::ostream& out, const fathom::SurdPoint& p) {
  return out << '(' << round_binary64(p[0]) << ", " << round_binary64(p[1]) << ", " << round_binary64(p[2]) << ')';
}

void tell(const fathom::Patch& patch) {
  std::cout << "  rank " << patch.rank() << ", squared size " << patch.squared() << ", A moves by "
            << patch.translation() << ", around " << patch.centroid().a.core << '\n';
  for (std::size_t k = 0; k < patch.corners.size(); ++k)
    std::cout << "  " << patch.a(k).core << " on " << patch.corners[k].on_a.size() << " of A's points, "
              << patch.b(k).core << " on " << patch.corners[k].on_b.size() << " of B's\n";
}

void tell(const std::string& bodies, const fathom::Twist& of_a) {
  const fathom::Case asked = fathom::parse_case(bodies, "memory").value();
  const fathom::ContactGeometry touching =
      fathom::contact_geometry(asked.a, asked.b, fathom::exact_answer(asked.a, asked.b));
  if (touching.no_patches) std::cout << "patches are left out: " << name(*touching.no_patches) << '\n';
  else std::cout << touching.patches.size() << " patch, " << (touching.smooth() ? "smooth" : "not smooth") << '\n';
  for (const fathom::Patch& patch : touching.patches) tell(patch);
  for (const fathom::Kink kink : touching.kinks) std::cout << "  " << name(kink) << '\n';
  if (const auto gradient = touching.gradient())
    std::cout << "  gradient " << gradient->by_translation() << " by v, " << gradient->by_rotation() << " by w\n";
  if (const auto weights = vertex_weights(asked.a, asked.b, touching))
    for (const fathom::Weight& w : weights->b)
      std::cout << "  point " << w.index << " of B: weight " << w.weight << '\n';

  const auto found = directional_derivative(touching, of_a);
  if (const auto* const rate = std::get_if<fathom::DirectionalDerivative>(&found))
    std::cout << "  as A moves, the depth changes at the rate " << round_binary64(rate->value()) << ", squared "
              << rate->root() << ", for corner " << rate->corner << '\n';
  else std::cout << "  its derivative is left out: " << name(std::get<fathom::LeftOut>(found)) << '\n';
}

int main() {
  const fathom::Twist sinking{{0, 0, -1}, {}}, tilting{{}, {1, 0, 0}};
  const std::string block = R"("b": {"shape": "box", "half": [2, 2, 1], "pose": "xyz=0,0,-1"}})";
  tell(R"({"a": {"shape": "box", "half": [1, 2, 1], "pose": "xyz=2,1/2,3/4"}, )" + block, tilting);
  tell(R"({"a": {"vertices": [[0.5, 0.25, -0.25], [2, 0, 3], [-1, 2, 3], [-1, -2, 3]]},
          "b": {"vertices": [[-3, -3, 0], [3, -3, 0], [0, 3, 0], [0, 0, -9]]}})",
       sinking);
  tell(R"({"a": {"shape": "cone", "radius": 1, "half_length": 1}, )" + block, sinking);
}

//> 1 patch, not smooth
//>   rank 2, squared size 49/4, A moves by (0, 0, 1/4), around (3/2, 1/4, -1/4)
//>   (1, -3/2, -1/4) on 1 of A's points, (1, -3/2, 0) on 4 of B's
//>   (2, -3/2, -1/4) on 2 of A's points, (2, -3/2, 0) on 2 of B's
//>   (2, 2, -1/4) on 4 of A's points, (2, 2, 0) on 1 of B's
//>   (1, 2, -1/4) on 2 of A's points, (1, 2, 0) on 2 of B's
//>   extended
//>   as A moves, the depth changes at the rate 1.5, squared 9/4, for corner 0
//> 1 patch, smooth
//>   rank 0, squared size 0, A moves by (0, 0, 1/4), around (1/2, 1/4, -1/4)
//>   (1/2, 1/4, -1/4) on 1 of A's points, (1/2, 1/4, 0) on 3 of B's
//>   gradient (0, 0, -1) by v, (-0.25, 0.5, 0) by w
//>   point 0 of B: weight 7/48
//>   point 1 of B: weight 5/16
//>   point 2 of B: weight 13/24
//>   as A moves, the depth changes at the rate 1, squared 1, for corner 0
//> patches are left out: curved
//>   its derivative is left out: curved
