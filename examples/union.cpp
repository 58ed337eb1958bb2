// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that are not convex: how far is a bar from leaving the slot of a block in the shape of a
// U? And a closed mesh as it is: its volume, its convex pieces, and its depth in another one.
#include <fathom/answer.hpp>
#include <fathom/certificate.hpp>
#include <fathom/check.hpp>
#include <fathom/files.hpp>
#include <fathom/solid.hpp>
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

void of_pieces() {
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

// An L: two of its faces are polygons that are not convex.
constexpr std::string_view ell = R"(OFF
12 8 0
0 0 0
2 0 0
2 1 0
1 1 0
1 2 0
0 2 0
0 0 1
2 0 1
2 1 1
1 1 1
1 2 1
0 2 1
6 5 4 3 2 1 0
6 6 7 8 9 10 11
4 0 1 7 6
4 1 2 8 7
4 2 3 9 8
4 3 4 10 9
4 4 5 11 10
4 5 0 6 11
)";

void of_a_mesh() {
  const fathom::Solid solid = fathom::solid_of(fathom::parse_mesh(ell, "ell.off"));
  std::cout << fathom::given_points(solid) << " of " << solid.points.size() << " points are the mesh's, "
            << solid.pieces.size() << " pieces, volume " << fathom::volume(solid) << ", " << fathom::notes(solid).size()
            << " notes\n";
  std::ofstream("ell_pieces.obj") << fathom::pieces_obj(solid);
  const fathom::Pieces pieces = fathom::pieces_of(solid);
  const fathom::UnionDepth depth = fathom::union_depth(pieces, fathom::read_pieces("ell_pieces.obj"));
  std::cout << "in itself: depth^2 = " << depth.squared() << '\n';
  const fathom::PieceCoverage of_one = fathom::coverage(solid, {pieces[0]});
  std::cout << "its first piece alone: " << of_one.missing << " is missing, " << of_one.outside << " outside, "
            << (of_one.tiles() || of_one.same_union() || of_one.most_outside() ? "not so\n" : "no piece sticks out\n");
  const fathom::Body body = fathom::solid_body(fathom::parse_mesh(ell, "ell.off"));
  const fathom::Answer answer = fathom::exact_answer(body, body);
  const std::string proof = fathom::certificate_text(body, body, answer, "two ells");
  std::cout << "as a body: " << body.pieces->size() << " pieces; "
            << fathom_check::verdict_line(fathom_check::verify(proof), "proof") << '\n';

  // Pieces are made by cuts; what touches after the way out is named by the mesh.
  const mpq_class low(3, 4);
  const fathom::Body bar{
      {{low, 1, 0}, {2, 1, 0}, {low, 2, 0}, {2, 2, 0}, {low, 1, 1}, {2, 1, 1}, {low, 2, 1}, {2, 2, 1}}};
  const fathom::Answer of_bar = fathom::exact_answer(bar, body);
  for (const fathom::PieceContact& met : std::get<fathom::UnionDepth>(of_bar.found).optima.front().contacts)
    for (const fathom::MeshFeature& feature : met.mesh_b)
      std::cout << "touches piece " << met.b << " at " << name(feature.kind) << ' ' << feature.ids.front() << '\n';

  try {
    fathom::solid_of(fathom::parse_mesh("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "open.off"));
  } catch (const std::exception& error) {
    std::cout << error.what() << '\n';
  }
}

int main() {
  of_pieces();
  of_a_mesh();
}

//> depth^2 = 1 along (1, 0, 0), into an exact fit, where 2 pairs touch
//> deepest pair 1, hulls 4
//> 2 pieces, 1/2
//> 1, proved by fathom-certificate 3
//> 12 of 14 points are the mesh's, 2 pieces, volume 3, 0 notes
//> in itself: depth^2 = 1
//> its first piece alone: 1 is missing, 0 outside, no piece sticks out
//> as a body: 2 pieces; s VERIFIED penetrating depth_squared=1 optima=2 pieces=2x2 triangles=20x20 two%20ells
//> touches piece 0 at face 4
//> touches piece 1 at face 5
//> the mesh is not closed: 3 edges have more faces on one side than on the other, such as (0, 0, 0) -> (1, 0, 0). A solid has no hole in its surface
