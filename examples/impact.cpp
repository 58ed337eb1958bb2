// SPDX-License-Identifier: GPL-3.0-or-later
// A cube tips over while it falls onto another: when do they meet, where, and what shows it?
#include <fathom/impact.hpp>
#include <iostream>
#include <vector>

int main() {
  std::vector<fathom::Point> cube;
  for (int i = 0; i < 8; ++i) cube.push_back({i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
  const fathom::RigidMotion fall =
      fathom::shorter_way({{1, 0, 0, 0}, {-1, mpq_class(-1, 2), 0, 0}, {0, 0, 4}, {0, 0, 0}});
  const fathom::RigidMotion at_rest;

  fathom::ImpactOptions options;
  options.bits = 10;
  const fathom::Impact impact = fathom::first_contact(cube, fall, cube, at_rest, options);
  std::cout << fathom::name(impact.status) << " between " << impact.contact->t0 << " and " << impact.contact->t1
            << "\n";
  const fathom::Vector& n = impact.contact->normal;
  std::cout << "normal " << n.x << " " << n.y << " " << n.z << ", " << fathom::name(impact.contact->contact.kind)
            << "\n";

  // Each piece of the time has a plane that separates the bodies in it.
  for (const fathom::ImpactPiece& piece : impact.pieces) {
    const fathom::Vector d = fathom::direction_at(*piece.plane, fall, at_rest, piece.until);
    std::cout << "until " << piece.until << " by a " << fathom::name(piece.plane->kind) << ", " << d.x << " " << d.y
              << " " << d.z << "\n";
  }
  std::cout << "lowest corner at t0: " << fathom::placed_at(cube, fall, impact.contact->t0)[0].z << "\n";
  std::cout << "cosine of the turn: " << fathom::pose_at(fall, 1)[1][1] << "\n";
  std::cout << fathom::certificate_text(cube, fall, cube, at_rest, impact).substr(0, 20) << "\n";
}

//> contact between 215/512 and 431/1024
//> normal 0 0 1, edge-facet
//> until 215/512 by a face of B, 0 0 1
//> lowest corner at t0: 140494009/140134528
//> cosine of the turn: 3/5
//> fathom-certificate 6
