// SPDX-License-Identifier: GPL-3.0-or-later
// One certificate for two bodies of which one is a solid, and for unions that format 3 is too
// narrow for: which format is written, and that checkers accept it.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "fathom/answer.hpp"
#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#include "fathom/solid.hpp"
#include "tests/solids/meshes.hpp"
#include "tests/support/boxes.hpp"
#include "verify/check/check.hpp"

namespace fathom {
namespace {

using solids::box_mesh;
using solids::Mesh;
using solids::moved;

/// A rotation by rationals, and a translation.
Mesh posed(Mesh mesh) {
  const auto r = [](long n) { return mpq_class(n, 9); };
  for (Point& p : mesh.points)
    p = {r(1) * p.x - r(8) * p.y + r(4) * p.z + mpq_class(1, 7), r(4) * p.x + r(4) * p.y + r(7) * p.z,
         -r(8) * p.x + r(1) * p.y + r(4) * p.z - mpq_class(2, 3)};
  return mesh;
}

/// A ring of m times n quadrilaterals, which are not flat, around the z axis.
Mesh torus(int m, int n) {
  // Of a circle around O, by rationals: (1 - t^2, 2 t) / (1 + t^2).
  const auto on_circle = [](int i, int count) {
    const bool far = 4 * (i % count) > count && 4 * (i % count) < 3 * count;
    const mpq_class share(2 * (i % count), count);
    mpq_class u = share;
    u.canonicalize();
    if (far) u = 1 - u;
    else if (u > 1) u -= 2;
    const mpq_class t = u * mpq_class(3, 2) / (mpq_class(2) - abs(u));
    const mpq_class x = (1 - t * t) / (1 + t * t), y = 2 * t / (1 + t * t);
    return std::pair(far ? mpq_class(-x) : x, y);
  };
  Mesh mesh;
  for (int i = 0; i < m; ++i)
    for (int k = 0; k < n; ++k) {
      const auto [x, y] = on_circle(i, m);
      const auto [u, z] = on_circle(k, n);
      const mpq_class radius = 3 + u;
      mesh.points.push_back({radius * x, radius * y, z});
    }
  const auto at = [&](int i, int k) { return static_cast<std::uint32_t>(i % m * n + k % n); };
  for (int i = 0; i < m; ++i)
    for (int k = 0; k < n; ++k) {
      mesh.faces.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      mesh.faces.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  return mesh;
}

Mesh l_shape() { return solids::prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1); }
Mesh with_cavity() { return box_mesh({-3, -3, -3}, {3, 3, 3}) + turned(box_mesh({-2, -2, -2}, {2, 2, 2})); }
Mesh at(const Mesh& mesh, const Point& t) { return moved(mesh, 1, t); }
Mesh menger(int level) { return solids::cells_mesh(solids::menger_cells(level)); }

Body polytope_of(const Point& low, const Point& high) { return Body{GivenPoints(testing::box(low, high))}; }
Body union_of(Pieces pieces) {
  Body body;
  body.pieces = std::make_shared<const Pieces>(std::move(pieces));
  return body;
}

std::string size_of(const Body& body, bool triangles) {
  if (triangles) return body.solid ? std::to_string(body.solid->triangles.size()) : "-";
  return std::to_string(body.solid ? body.solid->pieces.size() : pieces_of(body).size());
}

/// What checkers are to say.
std::string line_of(const Body& a, const Body& b, const UnionDepth& answer) {
  std::ostringstream line;
  line << "s VERIFIED " << name(answer.status);
  if (answer.apart) line << " distance_squared=" << answer.apart->distance.squared;
  else line << " depth_squared=" << answer.squared();
  if (answer.status == Status::penetrating) line << " optima=" << answer.optima.size();
  line << " pieces=" << size_of(a, false) << 'x' << size_of(b, false);
  line << " triangles=" << size_of(a, true) << 'x' << size_of(b, true) << " two%20bodies";
  return line.str();
}

struct Tried {
  Status status;
  std::string text;
};

Tried expect_accepted(const Body& a, const Body& b) {
  const Answer answer{union_depth(pieces_of(a), pieces_of(b))};
  const std::string text = certificate_text(a, b, answer, "two bodies");
  const auto& unions = std::get<UnionDepth>(answer.found);
  EXPECT_TRUE(text.starts_with("fathom-certificate 5\nid two%20bodies\n"));
  EXPECT_EQ(fathom_check::verdict_line(fathom_check::verify(text), "unnamed"), line_of(a, b, unions));
  return {unions.status, text};
}

Status status_of(const Mesh& a, const Mesh& b) {
  const Status here = expect_accepted(solid_body(a.body()), solid_body(b.body())).status;
  EXPECT_EQ(expect_accepted(solid_body(posed(a).body()), solid_body(posed(b).body())).status, here);
  return here;
}

TEST(UnionCertificate, OfSolidsIsAcceptedWhereverTheyStand) {
  const mpq_class half(1, 2);
  const Mesh cube = box_mesh({-1, -1, -1}, {1, 1, 1});
  EXPECT_EQ(status_of(l_shape(), at(l_shape(), {half, half, mpq_class(1, 3)})), Status::penetrating);
  EXPECT_EQ(status_of(l_shape(), at(cube, {2, 2, 0})), Status::touching) << "in the notch";
  EXPECT_EQ(status_of(with_cavity(), cube), Status::disjoint) << "in the cavity";
  EXPECT_EQ(status_of(with_cavity(), moved(cube, 2, {})), Status::touching) << "an exact fit";
  EXPECT_EQ(status_of(with_cavity(), moved(cube, mpq_class(9, 4), {})), Status::penetrating);
  EXPECT_EQ(status_of(solids::ring_mesh(false), at(solids::ring_mesh(true), {half, 2, -2})), Status::penetrating);
  EXPECT_EQ(status_of(solids::ring_mesh(false), at(solids::ring_mesh(true), {2, 2, -2})), Status::disjoint)
      << "linked rings";
  EXPECT_EQ(status_of(menger(2), at(menger(2), {4, 3, mpq_class(5, 2)})), Status::penetrating);
  EXPECT_EQ(status_of(menger(1), at(menger(1), {3, 0, 1})), Status::touching);
  EXPECT_EQ(status_of(solids::schoenhardt(), at(solids::schoenhardt(), {3, 1, 1})), Status::penetrating);
  EXPECT_EQ(status_of(cube + at(cube, {1, 1, 1}), at(l_shape(), {half, 0, 0})), Status::penetrating) << "overlaps";
  EXPECT_EQ(status_of(cube + at(cube, {1, 1, 1}), at(l_shape(), {half, -3, 2})), Status::disjoint) << "overlaps";
  EXPECT_EQ(status_of(cube + cube, at(cube, {2, 1, 0})), Status::touching) << "listed twice";
}

std::size_t blocks_of(const Tried& tried) { return std::stoul(tried.text.substr(tried.text.find("\napart ") + 7)); }

TEST(UnionCertificate, HasFewBlocksAsPiecesAreInTheOrderOfSpace) {
  const Body a = solid_body(menger(2).body()), b = solid_body(at(menger(2), {4, 3, mpq_class(5, 2)}).body());
  EXPECT_LE(blocks_of(expect_accepted(a, b)), 900U) << "of 25,600 pairs, of which hundreds touch";
  Solid mixed = *a.solid;
  std::mt19937 random(1);
  std::shuffle(mixed.pieces.begin(), mixed.pieces.end(), random);
  Body other;
  other.pieces = std::make_shared<const Pieces>(pieces_of(mixed));
  other.solid = std::make_shared<const Solid>(std::move(mixed));
  EXPECT_GT(blocks_of(expect_accepted(other, b)), 1600U) << "law: the order counts";
}

TEST(UnionCertificate, OfToriIsAccepted) {
  const Mesh ring = torus(12, 8);
  for (const auto& [t, status] :
       {std::pair(Point{5, 1, mpq_class(1, 3)}, Status::penetrating), std::pair(Point{7, 3, 1}, Status::disjoint)})
    EXPECT_EQ(expect_accepted(solid_body(ring.body()), solid_body(at(posed(ring), t).body())).status, status);
}

TEST(UnionCertificate, OfASolidAndAnotherBodyIsAccepted) {
  const Body solid = solid_body(l_shape().body()), box = polytope_of({1, 1, 0}, {3, 3, 1}),
             deep = polytope_of({mpq_class(1, 2), mpq_class(1, 2), 0}, {3, 3, 1}),
             away = polytope_of({4, 5, 6}, {7, 8, 9});
  for (const auto& [other, status] :
       {std::pair(box, Status::touching), std::pair(deep, Status::penetrating), std::pair(away, Status::disjoint)}) {
    EXPECT_EQ(expect_accepted(solid, other).status, status);
    EXPECT_EQ(expect_accepted(other, solid).status, status);
    const Body two = union_of({other.points, testing::box({-3, -3, -3}, {-1, -1, -1})});
    EXPECT_EQ(expect_accepted(solid, two).status, status);
  }
}

// Where a common denominator would be in no proportion, or the pairs too many.
TEST(UnionCertificate, OfUnionsHasBlocksWhereFormat3IsTooNarrow) {
  const auto text_of = [](const Pieces& a, const Pieces& b) { return certificate_text(a, b, union_depth(a, b)); };
  Pieces boxes, wide;
  for (int i = 0; i < 1900; ++i) {
    const mpq_class x = 2 * i, shift(1, mpz_class(1) << 100 | 2 * i + 1);
    boxes.push_back(testing::box({x, 0, 0}, {x + 1, 1, 1}));
    wide.push_back(testing::box({x + shift, 0, 0}, {x + 1, 1, 1}));
  }
  const Pieces few(boxes.begin(), boxes.begin() + 20), few_wide(wide.begin(), wide.begin() + 20),
      many_wide(wide.begin(), wide.begin() + 100);
  const Pieces slab{testing::box({0, 0, mpq_class(1, 2)}, {400, 1, 2})};
  EXPECT_TRUE(text_of(few, slab).starts_with("fathom-certificate 3\n"));
  EXPECT_TRUE(text_of(few_wide, slab).starts_with("fathom-certificate 3\n"));
  EXPECT_TRUE(text_of(many_wide, slab).starts_with("fathom-certificate 5\n")) << "a denominator of 10,000 bits";
  EXPECT_EQ(expect_accepted(union_of(many_wide), union_of(slab)).status, Status::penetrating);
  Pieces above = boxes;
  for (std::vector<Point>& piece : above)
    for (Point& p : piece) p.z += 3;
  EXPECT_EQ(expect_accepted(union_of(boxes), union_of(above)).status, Status::disjoint) << "3,610,000 pairs";
}

TEST(UnionCertificate, ContradictsAnotherAnswer) {
  const Body solid = solid_body(l_shape().body()), box = polytope_of({mpq_class(1, 2), 0, 0}, {3, 3, 1});
  Answer answer{union_depth(pieces_of(solid), pieces_of(box))};
  auto& found = std::get<UnionDepth>(answer.found);
  found.low = found.high = found.low * 2;
  EXPECT_THROW((void)certificate_text(solid, box, answer), std::logic_error);
  found.status = Status::disjoint;
  found.apart = union_depth(pieces_of(solid), pieces_of(polytope_of({4, 0, 0}, {5, 1, 1}))).apart;
  EXPECT_ANY_THROW((void)certificate_text(solid, box, answer));
  found.apart->a = 7;
  EXPECT_THROW((void)certificate_text(solid, box, answer), std::logic_error) << "no such piece";
}

}  // namespace
}  // namespace fathom
