// SPDX-License-Identifier: GPL-3.0-or-later
// Proofs of the depth of unions, checked by their definition; and what is forged is refused.
#include "reference/unions/union_prover.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "kernels/number/rational.hpp"
#include "reference/polytope/lattice.hpp"
#include "tests/unions/naive_union.hpp"
#include "tests/unions/pieces.hpp"

namespace fathom::unions {
namespace {

// For unions of integer points. Fails with the first broken law.
class ProofCheck {
 public:
  ProofCheck(const Pieces& a, const Pieces& b, const UnionProof& proof) : proof_(proof) {
    for (const std::vector<Point>& p : a) a_.push_back(integers(p));
    for (const std::vector<Point>& p : b) b_.push_back(integers(p));
  }

  std::string run() {
    for (const PiecePolytope& polytope : proof_.polytopes) read(polytope);
    std::size_t next = 0;
    std::vector<Plane> path;
    subtree(next, path);
    expect(next == proof_.nodes.size(), "nodes are left over");
    for (const Point& optimum : proof_.optima) check(optimum);
    for (const auto& foot : feet_) expect(optima_.count(foot) == 1, "a nearest point of a leaf is no optimum");
    return fault_;
  }

 private:
  struct Plane {
    Vector n;  // n, h: the half-space <n,x> >= h
    mpz_class h;
  };

  void expect(bool holds, const char* law) {
    if (!holds && fault_.empty()) fault_ = law;
  }

  void read(const PiecePolytope& polytope) {
    std::vector<Vector> corners;
    for (const auto& [i, j] : polytope.inner.vertices)
      corners.push_back(b_.at(polytope.b).at(j) - a_.at(polytope.a).at(i));
    Vector sum{0, 0, 0};
    for (const Vector& v : corners) sum = sum + v;
    std::vector<Plane>& planes = planes_.emplace_back();
    for (const std::vector<std::uint32_t>& f : polytope.inner.facets) {
      const Vector &p = corners.at(f.at(0)), n = primitive(cross(corners.at(f.at(1)) - p, corners.at(f.at(2)) - p));
      planes.push_back({n, dot(n, p)});
      for (const Vector& v : corners) expect(dot(n, v) <= planes.back().h, "a polytope is not convex");
      expect(dot(n, sum) < mpz_class(corners.size()) * planes.back().h, "the mean is not inside");
    }
    expect(polytope::convex_hull(corners).facets.size() == planes.size(), "a polytope is not closed");
  }

  // Whether c^2 >= q <n,n>, c > 0; remembers the foot where both are equal.
  bool far_enough(const Vector& n, const mpq_class& c) {
    if (c <= 0) return false;
    const mpq_class square = c * c, limit = proof_.squared * dot(n, n);
    if (square == limit && limit > 0) {
      const mpq_class s = c / dot(n, n);
      feet_.emplace(s * n.x, s * n.y, s * n.z);
    }
    return square >= limit;
  }

  void subtree(std::size_t& next, std::vector<Plane>& path) {
    if (next >= proof_.nodes.size()) return expect(false, "nodes are missing");
    const ProofNode& node = proof_.nodes[next++];
    if (!node.split) return expect(closed(node, path), "a leaf is not closed");
    const std::vector<Plane>& planes = planes_.at(node.polytope);
    std::set<std::uint32_t> named;
    const std::size_t before = path.size();
    for (const std::uint32_t facet : node.numbers) {
      named.insert(facet);
      path.push_back(planes.at(facet));
      subtree(next, path);
      path.back() = {-planes[facet].n, -planes[facet].h};
    }
    path.resize(before);
    expect(named.size() == node.numbers.size(), "a facet is named twice");
    for (std::uint32_t f = 0; f < planes.size(); ++f)
      if (named.count(f) == 0) expect(far_enough(planes[f].n, planes[f].h), "a facet that is not named is near");
  }

  // Whether the active constraints alone hold their cell at the depth.
  bool closed(const ProofNode& node, const std::vector<Plane>& path) {
    std::vector<Plane> active;
    for (const std::uint32_t i : node.numbers) active.push_back(path.at(i));
    if (active.empty() || active.size() > 4) return false;
    kernels::RationalPoint nearest;
    std::vector<kernels::OrientedPlane> planes;
    for (const Plane& f : active) planes.push_back(kernels::oriented_plane(f.n, f.h, 8));
    std::vector<Barrier> barriers;
    for (const kernels::OrientedPlane& f : planes) barriers.push_back(&f);
    if (nearest_in_cell(barriers, 8, nearest) == CellEnd::infeasible) return true;
    return far_enough(nearest.v, kernels::ratio(dot(nearest.v, nearest.v), nearest.w));
  }

  void check(const Point& t) {
    optima_.emplace(t.x, t.y, t.z);
    expect(t.x * t.x + t.y * t.y + t.z * t.z == proof_.squared, "an optimum is not at the depth");
  }

  const UnionProof& proof_;
  std::vector<std::vector<Vector>> a_, b_;
  std::vector<std::vector<Plane>> planes_;
  std::set<std::tuple<mpq_class, mpq_class, mpq_class>> feet_, optima_;
  std::string fault_;
};

void expect_proof(const Pieces& a, const Pieces& b) {
  const UnionDepth depth = union_depth(a, b);
  if (depth.status != Status::penetrating) return;
  kernels::Context context;
  UnionProof proof = prove(context, place_pieces(a, b), depth.optima);
  EXPECT_EQ(proof.squared, depth.squared());
  ASSERT_EQ(proof.optima.size(), depth.optima.size());
  for (std::size_t i = 0; i < proof.optima.size(); ++i) EXPECT_EQ(proof.optima[i], depth.optima[i].translation);
  EXPECT_EQ(ProofCheck(a, b, proof).run(), "");
  UnionProof fewer = proof;
  fewer.optima.pop_back();
  EXPECT_EQ(ProofCheck(a, b, fewer).run(), "a nearest point of a leaf is no optimum");
  proof.squared *= mpq_class(1000001, 1000000);
  EXPECT_NE(ProofCheck(a, b, proof).run(), "") << "a larger depth is accepted";
}

TEST(UnionProver, ProvesRandomUnions) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937_64 random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_proof(random_pieces(random, 1 + seed % 4, 6, 60, 25), random_pieces(random, 1 + seed % 3, 6, 60, 25));
  }
}

TEST(UnionProver, ProvesUnionsOfBoxesWithManyTiesAndSeams) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937_64 random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_proof(random_boxes(random, 1 + seed % 3, 6), random_boxes(random, 1 + seed % 4, 6));
  }
  expect_proof(grid({0, 0, 0}, {6, 6, 6}, 2), grid({0, 0, 0}, {6, 6, 6}, 3));
}

TEST(UnionProver, ProvesLinkedRings) { expect_proof(scaled(ring(12, false, 0), 10), scaled(ring(12, true, 26), 10)); }

TEST(UnionProver, RefusesWhatIsNotTheAnswer) {
  kernels::Context context;
  const PlacedPieces touching = place_pieces({box({0, 0, 0}, {1, 1, 1})}, {box({1, 0, 0}, {2, 1, 1})});
  EXPECT_THROW(prove(context, touching, {}), std::logic_error);
  const Pieces a{box({0, 0, 0}, {2, 2, 2})}, b{box({0, 0, 0}, {2, 2, 2})};
  const UnionDepth depth = union_depth(a, b);
  ASSERT_EQ(depth.optima.size(), 6U);
  const PlacedPieces pieces = place_pieces(a, b);
  std::vector<UnionOptimum> optima = depth.optima;
  optima.pop_back();
  EXPECT_THROW(prove(context, pieces, optima), std::logic_error) << "an optimum is missing";
  optima.assign(1, depth.optima.front());
  optima.front().translation = {1, 0, 0};
  EXPECT_THROW(prove(context, pieces, optima), std::logic_error) << "not a way out";
  optima.front().translation = {3, 0, 0};
  EXPECT_THROW(prove(context, pieces, optima), std::logic_error) << "not the shortest";
}

}  // namespace
}  // namespace fathom::unions
