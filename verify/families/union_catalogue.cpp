// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "verify/families/catalogue.hpp"
#include "verify/families/union_pairs.hpp"

namespace fathom::families {
namespace {

using UnionEntries = std::vector<UnionCatalogueEntry>;
constexpr std::optional<bool> none = std::nullopt;
mpq_class slack() { return times_power_of_two(1, -16); }

struct KnownAnswer {
  Status status;
  mpq_class squared;
  std::size_t optima;
  std::optional<bool> clearance;
};
KnownAnswer overlapping(mpq_class squared, std::size_t optima, std::optional<bool> clearance) {
  return {Status::penetrating, std::move(squared), optima, clearance};
}
KnownAnswer touching(bool clearance) { return {Status::touching, 0, 1, clearance}; }
KnownAnswer apart(mpq_class squared) { return {Status::disjoint, std::move(squared), 0, none}; }

UnionCatalogueEntry unions(std::string name, std::string_view description, KnownAnswer answer, Pieces a, Pieces b) {
  const auto body = [](Pieces pieces) {
    return Body{.points = {}, .pieces = std::make_shared<const Pieces>(std::move(pieces))};
  };
  return {description,   answer.status,    std::move(answer.squared),
          answer.optima, answer.clearance, {std::move(name), body(std::move(a)), body(std::move(b))}};
}

/// Between walls whose inner faces are at x = 0 and x = width.
Pieces slot(const mpq_class& width) {
  return {box_from({-9, -5, -5}, {0, 5, 5}), box_from({width, -5, -5}, {width + 9, 5, 5})};
}
/// Of width 1, from x.
Pieces plate(const mpq_class& x) { return {box_from({x, -1, -1}, {x + 1, 1, 1})}; }

/// Six walls about the cube [0,width]^3, 2 thick.
Pieces hollow(const mpq_class& width) {
  const mpq_class end = width + 2;
  return {box_from({-2, -2, -2}, {0, end, end}),   box_from({width, -2, -2}, {end, end, end}),
          box_from({0, -2, -2}, {width, 0, end}),  box_from({0, width, -2}, {width, end, end}),
          box_from({0, 0, -2}, {width, width, 0}), box_from({0, 0, width}, {width, width, end})};
}
Pieces unit_cube() { return {box_from({0, 0, 0}, {1, 1, 1})}; }

/// A square frame about the z axis, in four pieces: the hole is 2 wide, the frame 1 thick.
Pieces frame() {
  return {box_from({-2, -2, 0}, {-1, 2, 1}), box_from({1, -2, 0}, {2, 2, 1}), box_from({-1, -2, 0}, {1, -1, 1}),
          box_from({-1, 1, 0}, {1, 2, 1})};
}
Pieces rod(const mpq_class& half) { return {box_from({-half, -half, -4}, {half, half, 5})}; }

/// A link of a chain along x: a frame with a hole 4 long and 2 wide, in the plane z = 0, or y = 0
/// if upright.
Pieces link(const mpq_class& x, bool upright) {
  const mpq_class half = ratio(1, 2);
  const auto part = [&](const Point& low, const Point& high) {
    return upright ? box_from({x + low.x, low.z, low.y}, {x + high.x, high.z, high.y})
                   : box_from({x + low.x, low.y, low.z}, {x + high.x, high.y, high.z});
  };
  return {part({0, -2, -half}, {6, -1, half}), part({0, 1, -half}, {6, 2, half}), part({0, -1, -half}, {1, 1, half}),
          part({5, -1, -half}, {6, 1, half})};
}

/// An L of two boxes, its corner at O, its arms 3 long along x and y.
Pieces angle() { return {box_from({0, 0, 0}, {3, 1, 1}), box_from({0, 1, 0}, {1, 3, 1})}; }

UnionEntries fits() {
  const mpq_class aside = ratio(3, 4);
  return {
      unions("slot_exact_fit", "a plate beside a slot as wide as itself: the way in is a way out",
             overlapping(ratio(9, 16), 1, false), plate(aside), slot(1)),
      unions("slot_wider", "the slot is wider by 2^-16", overlapping((aside - slack()) * (aside - slack()), 1, true),
             plate(aside), slot(1 + slack())),
      unions("slot_narrower", "the slot is narrower by 2^-16: only the ways past its walls are left",
             overlapping(36, 4, true), plate(aside), slot(1 - slack())),
      unions("slot_filled", "the plate is in the slot, and touches both walls", touching(false), plate(0), slot(1)),
      unions("cavity_filled", "a cube in a cavity of its size: it touches six walls", touching(false), unit_cube(),
             hollow(1)),
      unions("cavity_with_room", "a cube in a cavity that is larger by 2^-16", apart(slack() * slack() / 4),
             translated(unit_cube(), {slack() / 2, slack() / 2, slack() / 2}), hollow(1 + slack())),
      unions("cavity_too_small", "the cavity is smaller by 2^-16: the way out is through the nearest walls",
             overlapping((3 - slack()) * (3 - slack()), 3, true), unit_cube(), hollow(1 - slack())),
      unions("cavity_beside", "a cube in the walls of a cavity of its size: all three ways back into it together",
             overlapping(ratio(3, 4), 1, false), translated(unit_cube(), {ratio(-1, 2), ratio(-1, 2), ratio(-1, 2)}),
             hollow(1)),
  };
}

UnionEntries holds() {
  const mpq_class half = ratio(1, 2);
  const Pieces key = {box_from({-2, ratio(7, 2), half}, {11, ratio(9, 2), ratio(3, 2)}),
                      box_from({ratio(5, 4), ratio(13, 4), half}, {ratio(7, 4), ratio(7, 2), ratio(3, 2)}),
                      box_from({ratio(19, 4), 2, half}, {ratio(21, 4), ratio(7, 2), ratio(3, 2)})};
  const Pieces comb = {box_from({0, 0, 0}, {9, 1, 2}), box_from({0, 1, 0}, {ratio(3, 2), 4, 2}),
                       box_from({ratio(5, 2), 1, 0}, {4, 4, 2}), box_from({5, 1, 0}, {ratio(13, 2), 4, 2}),
                       box_from({ratio(15, 2), 1, 0}, {9, 4, 2})};
  return {
      unions("comb_and_key", "a key whose handle lies in the teeth of a comb, and whose bits stand in the sides of two",
             overlapping(ratio(5, 8), 1, true), key, comb),
      unions("combs_meshed", "two combs, the teeth of each in the gaps of the other: no gap is left", touching(false),
             families::comb(4, 2),
             Pieces{box_from({0, 2, 0}, {7, 3, 1}), box_from({1, 0, 0}, {2, 2, 1}), box_from({3, 0, 0}, {4, 2, 1}),
                    box_from({5, 0, 0}, {6, 2, 1})}),
      unions("combs_tooth_on_tooth", "the same by one tooth: half a tooth to the side is a fit",
             overlapping(ratio(1, 4), 1, false), families::comb(4, 2),
             Pieces{box_from({0, 2, 0}, {8, 3, 1}), box_from({ratio(3, 2), 0, 0}, {ratio(5, 2), 2, 1}),
                    box_from({ratio(7, 2), 0, 0}, {ratio(9, 2), 2, 1})}),
      unions("frame_with_room", "a rod through a frame, with room on all sides", apart(ratio(1, 4)), rod(half),
             frame()),
      unions("frame_filled", "a rod that fills the hole of a frame", touching(false), rod(1), frame()),
      unions("frame_beside", "a rod that fills the hole, moved into two sides of the frame: back into it",
             overlapping(half, 1, false), translated(rod(1), {half, half, 0}), frame()),
      unions("frame_too_small", "a rod wider than the hole by 2^-16: it must pass one side of the frame",
             overlapping(9 + 2 * 3 * slack() / 2 + slack() * slack() / 4, 4, true), rod(1 + slack() / 2), frame()),
      unions("links_with_room", "two links of a chain", apart(ratio(1, 4)), link(0, false), link(3, true)),
      unions("links_taut", "two links of a chain, drawn until they touch", touching(true), link(0, false),
             link(4, true)),
      unions("links_pulled", "two links of a chain, drawn past that", overlapping(ratio(1, 16), 1, true),
             link(0, false), link(ratio(17, 4), true)),
      unions("rings_linked", "two square rings of four wedges, one through the other, with room", apart(ratio(1, 192)),
             ring(4, false), translated(ring(4, true), {ratio(7, 8), 0, 0})),
  };
}

UnionEntries seams() {
  const Pieces grid = cut_into_grid({0, 0, 0}, {3, 3, 3}, 3), whole = {box_from({0, 0, 0}, {3, 3, 3})};
  return {
      unions("cube_in_27_on_itself", "a cube cut into 27, on the same: every seam is on a seam, none is a way out",
             overlapping(9, 6, true), grid, grid),
      unions("cube_in_27_in_the_whole", "a cube cut into 27, on the whole", overlapping(9, 6, true), grid, whole),
      unions("cube_in_27_beside", "two of them side by side", touching(true), grid, translated(grid, {3, 1, 0})),
      unions("cube_repeated", "a cube given three times", overlapping(1, 6, true),
             {unit_cube()[0], unit_cube()[0], unit_cube()[0]}, unit_cube()),
      unions("piece_in_a_piece", "a piece within another counts for nothing", overlapping(9, 6, true),
             {whole[0], box_from({1, 1, 1}, {2, 2, 2})}, whole),
      unions(
          "cone_cuts", "an octahedron, cut into cones, against a cube in slabs", overlapping(ratio(4, 3), 8, true),
          cut_into_cones({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}),
          cut_into_slabs(box_from({ratio(-1, 3), ratio(-1, 3), ratio(-1, 3)}, {ratio(1, 3), ratio(1, 3), ratio(1, 3)}),
                         {1, 1, 1}, 4)),
  };
}

UnionEntries others() {
  const Pieces two = {box_from({0, 0, 0}, {1, 1, 1}), box_from({4, 0, 0}, {5, 1, 1})};
  return {
      unions("angles_end_in_end",
             "two angles, one turned by half a turn: the end of each arm is in an arm of the other",
             overlapping(1, 4, true), angle(), {box_from({0, 2, 0}, {3, 3, 1}), box_from({2, 0, 0}, {3, 2, 1})}),
      unions("angles_nested", "an angle in the corner of another: they touch along both arms", touching(true), angle(),
             translated(angle(), {1, 1, 0})),
      unions("gap_of_a_body", "a cube in the gap between two pieces of the same body", apart(1),
             translated(unit_cube(), {2, 0, 0}), two),
      unions("vertex_on_vertex", "one pair of pieces touches in a vertex", touching(true), two,
             translated(unit_cube(), {5, 1, 1})),
      unions("far_piece", "the deepest pair is no measure: out of one piece is into the next",
             overlapping(ratio(9, 4), 2, true),
             {box_from({ratio(1, 2), ratio(-1, 2), 0}, {ratio(3, 2), ratio(1, 2), 1})},
             {box_from({-3, -1, -4}, {1, 1, 4}), box_from({1, -1, -4}, {5, 1, 4})}),
  };
}

}  // namespace

std::span<const UnionCatalogueEntry> union_catalogue() {
  static const UnionEntries all = [] {
    UnionEntries entries;
    for (const auto group : {fits, holds, seams, others}) std::ranges::move(group(), std::back_inserter(entries));
    return entries;
  }();
  return all;
}

}  // namespace fathom::families
