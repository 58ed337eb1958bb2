// SPDX-License-Identifier: GPL-3.0-or-later
// The families of the plane: what they promise of their bodies.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>

#include "fathom/answer.hpp"
#include "fathom/numbers.hpp"
#include "reference/answer/plane.hpp"
#include "reference/files/cases.hpp"
#include "verify/families/families.hpp"
#include "verify/harness/seen_case.hpp"

namespace fathom::families {
namespace {

constexpr unsigned seeds = 20;
const std::set<std::string_view> too_fine = {"plane_far", "plane_thin", "plane_tilted_edges"};  // for binary32

Status status_of(const Case& pair) { return exact_answer(pair.a, pair.b).status().value(); }

TEST(PlaneFamilies, BodiesOfThePlaneInBinary32) {
  for (const Family& family : families(Kind::plane)) {
    std::set<std::string> digests;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
      const Case pair = family.make(seed, family.usual_size);
      EXPECT_EQ(pair.a.dimension, 2U) << pair.id;
      EXPECT_EQ(pair.b.dimension, 2U) << pair.id;
      digests.insert(harness::digest_of(pair));
      const auto seen = harness::as_seen(pair, Precision::binary32, {"circle", "capsule", "margin"}, nullptr, 2);
      ASSERT_TRUE(seen) << pair.id;
      if (too_fine.contains(family.name)) continue;
      EXPECT_EQ(harness::digest_of(*seen), harness::digest_of(pair)) << pair.id << " is not exact in binary32";
    }
    EXPECT_GT(digests.size(), seeds / 2) << family.name;
  }
}

TEST(PlaneFamilies, MadeAsTheirNamesSay) {
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const auto made = [seed](const char* name) { return find_family(name)->make(seed, 7); };
    EXPECT_EQ(status_of(made("plane_touching")), Status::touching) << seed;
    EXPECT_NE(status_of(made("plane_nearly_touching")), Status::touching) << seed;
    for (const char* deep :
         {"plane_ties", "plane_identical", "plane_nested", "plane_parallel_edges", "plane_tilted_edges"})
      EXPECT_EQ(status_of(made(deep)), Status::penetrating) << deep << ' ' << seed;
    const Case flat = made("plane_flat");
    EXPECT_TRUE(answer::is_flat_body(flat.a) || answer::is_flat_body(flat.b)) << seed;
    const Case ties = made("plane_ties");
    EXPECT_GE(std::get<Depth>(exact_answer(ties.a, ties.b).found).optima().size(), 2U) << seed;
    const Case parallel = made("plane_parallel_edges");
    EXPECT_EQ(std::get<Depth>(exact_answer(parallel.a, parallel.b).found).optima().front().contact.kind,
              ContactKind::edge_edge)
        << seed;
  }
}

TEST(PlaneFamilies, NotAmongThoseOfSpace) {
  for (const Kind kind : {Kind::polytopes, Kind::shapes, Kind::unions})
    for (const Family& family : families(kind)) EXPECT_FALSE(family.name.starts_with("plane_")) << family.name;
}

}  // namespace
}  // namespace fathom::families
