// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "verify/families/families.hpp"
#include "reference/files/piece_files.hpp"

namespace fathom::families {
namespace {

constexpr UnionFamily table[] = {
    // Random pieces: deep, touching, apart.
    {"clusters", "hulls of 20 points each, one beside the last", 5, clusters},
    {"clusters_on_lattice", "hulls of points of a coarse lattice: coplanar facets abound", 4, lattice_clusters},
    {"clusters_apart", "clusters with a plane between them", 5, clusters_apart},
    {"box_unions", "boxes with corners on a coarse lattice: ties and seams abound", 5, box_unions},
    {"box_unions_touching", "the same, with a plane between them that both touch", 5, box_unions_touching},
    // Convex bodies in pieces that abut exactly: the depth is that of the whole.
    {"cut_cones", "cut into cones over the facets", 10, cut_cones},
    {"cut_slabs", "cut by parallel planes, at times the same ones for both", 6, cut_slabs},
    {"cut_planes", "cut by random planes", 8, cut_planes},
    {"cut_grids", "boxes cut into cubes or boxes, on one lattice", 8, cut_grids},
    {"cut_repeated", "cut by random planes, with pieces twice, the whole among them, in random order", 6, cut_repeated},
    {"cut_same", "one body twice, cut in the same way or in two", 8, cut_same},
    {"cut_and_whole", "one is cut, the other is a single piece", 8, cut_and_whole},
    // Bodies that hold on to each other.
    {"combs", "two combs, teeth towards each other", 4, combs},
    {"keys", "a key in a keyhole, its bits between the wards of the lock", 2, keys},
    {"slots", "a plate beside one of the slots of its own width", 3, slots},
    {"slots_narrow", "the same with slots that are narrower by 2^-16: no plate fits", 3, slots_narrow},
    {"rings_linked", "two rings of wedges, one through the other: at times with room", 12, rings_linked},
    {"ring_and_rod", "a square rod through a ring: at times with room", 12, ring_and_rod},
};

}  // namespace

Case UnionFamily::make(std::uint64_t seed, unsigned size) const {
  Random random = stream_of(name, seed);
  UnionPair pair = build(random, size);
  return {case_id(name, size, seed), files::union_of(std::move(pair.a)), files::union_of(std::move(pair.b))};
}

std::span<const UnionFamily> union_families() { return table; }

const UnionFamily* find_union_family(std::string_view name) {
  const auto found = std::ranges::find(table, name, &UnionFamily::name);
  return found == std::end(table) ? nullptr : &*found;
}

}  // namespace fathom::families
