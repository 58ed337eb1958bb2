// SPDX-License-Identifier: GPL-3.0-or-later
// Forged proofs of the position of O are refused, whatever the answer that they claim.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <string>

#include "tests/polytope/position_twin.hpp"
#include "tests/support/property.hpp"

namespace fathom::polytope::position_test {
namespace {

struct Solved {
  std::vector<Vector> a, b;
  PositionOfOrigin answer;
  [[nodiscard]] bool accepted() const { return validate(answer, a, b).ok(); }
};

Solved solved(const SmallSet& a, const SmallSet& b) { return {exact(a), exact(b), proved(exact(a), exact(b))}; }

template <class Change>
bool accepted_after(Solved s, Change change) {
  change(s.answer);
  return s.accepted();
}

TEST(PositionProof, ForgedProofsAreRefused) {
  const Solved inside = solved(solid_with("facet"), mirrored(solid_with("facet"), -1));
  const Solved boundary = solved(solid_with("facet"), mirrored(solid_with("vertex"), 0));
  const Solved outside = solved(solid_with("facet"), mirrored(solid_with("edge"), 1));
  ASSERT_TRUE(inside.accepted() && boundary.accepted() && outside.accepted());
  for (const Solved& s : {inside, boundary, outside}) {
    for (const Position claim : {Position::inside, Position::boundary, Position::outside})
      EXPECT_EQ(accepted_after(s, [&](auto& x) { x.position = claim; }), claim == s.answer.position);
  }
  for (const Solved& s : {boundary, outside}) {
    EXPECT_FALSE(accepted_after(s, [](auto& x) { x.normal.reset(); }));
    EXPECT_FALSE(accepted_after(s, [](auto& x) { x.normal = Vector{0, 0, 0}; }));
    EXPECT_FALSE(accepted_after(s, [](auto& x) { x.normal = -*x.normal; }));
    EXPECT_FALSE(accepted_after(s, [](auto& x) { x.normal = *x.normal + *x.normal; }));
  }
  for (const Solved& s : {inside, boundary}) {
    EXPECT_FALSE(accepted_after(s, [](auto& x) { x.a.clear(); }));
    EXPECT_FALSE(accepted_after(s, [](auto& x) { x.b.front().weight += mpq_class(1, 7); }));
    EXPECT_FALSE(accepted_after(s, [](auto& x) { x.a.front().index = 99; }));
    EXPECT_FALSE(accepted_after(s, [](auto& x) { x.a.push_back({x.a.front().index, 0}); }));
    EXPECT_FALSE(accepted_after(s, [](auto& x) {
      for (Weight& w : x.a) w.weight *= 2;
      for (Weight& w : x.b) w.weight *= 2;
    })) << "facets touch at z = 0, but 2 is not 1";
    EXPECT_FALSE(accepted_after(s, [](auto& x) {
      x.a.push_back({x.a.front().index, -1});
      x.a.push_back({x.a.front().index, 1});
    }));
  }
  EXPECT_FALSE(accepted_after(inside, [](auto& x) { x.surrounding.pop_back(); }));
  EXPECT_FALSE(accepted_after(inside, [](auto& x) { x.surrounding.front().second = 99; }));
  EXPECT_FALSE(accepted_after(inside, [](auto& x) { x.surrounding.assign(5, x.surrounding.front()); }));
  EXPECT_FALSE(accepted_after(inside, [](auto& x) { x.normal = Vector{0, 0, 1}; }));
  EXPECT_FALSE(accepted_after(boundary, [](auto& x) { x.surrounding.emplace_back(0, 0); }));
  EXPECT_FALSE(accepted_after(outside, [](auto& x) { x.a.push_back({0, 1}); }));
}

// The checker of `surrounding` alone: it complains exactly when O is not in the interior of the
// hull.
TEST(PositionProof, SurroundingIsJudgedLikeTheNaiveTwinDoes) {
  EXPECT_TRUE(holds({.seed = 20240229, .runs = 4000}, [] {
    const SmallSet b = *lattice_set();
    PositionOfOrigin claim;
    claim.position = Position::inside;
    for (std::uint32_t j = 0; j < b.size(); ++j) claim.surrounding.emplace_back(0, j);
    bool refused = false;
    for (const std::string& fault : validate(claim, std::vector<Vector>{{0, 0, 0}}, exact(b)).faults)
      refused = refused || fault.find("surrounding") != std::string::npos;
    RC_ASSERT(refused == (position_naive({{0, 0, 0}}, b) != Position::inside));
  }));
}

}  // namespace
}  // namespace fathom::polytope::position_test
