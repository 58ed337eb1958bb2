// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that are not convex: how far is a bar from leaving the slot of a block in the shape of a
// U?
#include <fathom/certificate.hpp>
#include <fathom/files.hpp>
#include <fathom/union.hpp>
#include <fstream>
#include <iostream>
#include <vector>

std::vector<fathom::Point> box(const fathom::Point& low, const fathom::Point& high) {
  return {{low.x, low.y, low.z},  {high.x, low.y, low.z},  {low.x, high.y, low.z},  {high.x, high.y, low.z},
          {low.x, low.y, high.z}, {high.x, low.y, high.z}, {low.x, high.y, high.z}, {high.x, high.y, high.z}};
}

// As tools for convex decomposition write them: a group for each piece.
constexpr std::string_view groups = R"(o one
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 2 3 4
o two
v 0 0 -1
f 1 2 3 5
)";

int main() {
  const fathom::Pieces block{box({0, 0, 0}, {2, 4, 4}), box({4, 0, 0}, {6, 4, 4}), box({2, 0, 0}, {4, 4, 1})};
  const fathom::Pieces bar{box({1, 1, 2}, {3, 3, 6})};
  const fathom::UnionDepth depth = fathom::union_depth(bar, block);
  const fathom::UnionOptimum& out = depth.optima.front();
  std::cout << "depth^2 = " << depth.squared() << " along (" << out.translation.x << ", " << out.translation.y << ", "
            << out.translation.z << "), " << (out.clearance ? "into a gap" : "into an exact fit") << ", where "
            << out.contacts.size() << " pairs touch\n"
            << "deepest pair " << depth.bounds->deepest_pair << ", hulls " << depth.bounds->hulls << '\n';

  std::ofstream("two.obj") << groups;
  const fathom::Pieces pieces = fathom::read_pieces("two.obj");
  std::cout << pieces.size() << " pieces, "
            << fathom::union_depth(pieces, fathom::parse_pieces(groups, "memory")).squared() << '\n';

  // Of a case, either body may be a union or a polytope, which is one piece.
  const fathom::CaseItem item = fathom::parse_case(
      R"({"a": {"shape": "box", "half": [1, 1, 1]}, "b": {"pieces": [{"shape": "box", "half": [1, 1, 1], "pose": "xyz=1,0,0"}]}})",
      "memory");
  const fathom::Pieces a = fathom::pieces_of(item.value().a), b = fathom::pieces_of(item.value().b);
  const fathom::UnionDepth of_case = fathom::union_depth(a, b);
  std::cout << of_case.squared() << ", proved by " << fathom::certificate_text(a, b, of_case).substr(0, 20) << '\n';
}

//> depth^2 = 1 along (1, 0, 0), into an exact fit, where 2 pairs touch
//> deepest pair 1, hulls 4
//> 2 pieces, 1/2
//> 1, proved by fathom-certificate 3
