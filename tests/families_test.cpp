// SPDX-License-Identifier: GPL-3.0-or-later
// The case generators and their building blocks: exact, and reproducible to the last digit.
#include "verify/families/families.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/solids.hpp"

namespace {

using namespace fathom;
using namespace fathom::families;

/// FNV-1a of all coordinates as text.
std::uint64_t hash(const Case& pair) {
  std::uint64_t value = 0xcbf29ce484222325u;
  const auto add = [&value](const std::string& text) {
    for (const char c : text + ' ') value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  };
  for (const Body* body : {&pair.a, &pair.b}) {
    for (const Point& p : body->points)
      for (const mpq_class* x : {&p.x, &p.y, &p.z}) add(x->get_str());
    add("|");
  }
  return value;
}

// --- Building blocks

TEST(Random, IsSplitmix64) {
  Random random(1234567);
  for (const std::uint64_t expected :
       {6457827717110365317u, 3203168211198807973u, 9817491932198370423u, 4593380528125082431u})
    EXPECT_EQ(random.next(), expected);
}

TEST(Random, BetweenReachesBothEndsAndNothingElse) {
  Random random(7);
  std::set<std::int64_t> seen;
  for (int i = 0; i < 300; ++i) seen.insert(random.between(-2, 3));
  EXPECT_EQ(seen, (std::set<std::int64_t>{-2, -1, 0, 1, 2, 3}));
  EXPECT_EQ(random.between(5, 5), 5);
  random.between(INT64_MIN, INT64_MAX);
}

TEST(Placement, RotationsAreOrthonormalWithDeterminantOne) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const Rotation r = random_rotation(random);
    const Body images = rotated(Body{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, r);
    const auto vec = [](const Point& p) { return Vec3<mpq_class>{p.x, p.y, p.z}; };
    const Vec3<mpq_class> x = vec(images.points[0]), y = vec(images.points[1]), z = vec(images.points[2]);
    EXPECT_TRUE(dot(x, x) == 1 && dot(y, y) == 1 && dot(z, z) == 1 && dot(x, y) == 0 && dot(y, z) == 0 &&
                dot(z, x) == 0);
    EXPECT_EQ(det(x, y, z), 1);
  }
}

TEST(Circle, PointsAreWithinOneUnitAndEveryCornerTurnsLeft) {
  for (const std::uint64_t n : {3u, 4u, 5u, 8u, 97u, 1000u, 65537u}) {
    const std::vector<CirclePoint> corners = regular_polygon(n, static_cast<unsigned>(n % 4));
    const mpz_class radius = mpz_class(1) << circle_bits(n);
    for (std::size_t i = 0; i < n; ++i) {
      const CirclePoint &p = corners[i], &q = corners[(i + 1) % n], &r = corners[(i + 2) % n];
      const mpz_class error = mpz_class(p.cosine) * p.cosine + mpz_class(p.sine) * p.sine - radius * radius;
      ASSERT_LE(abs(error), 2 * radius) << "n = " << n << ", corner " << i;
      const mpz_class turn =
          mpz_class(q.cosine - p.cosine) * (r.sine - q.sine) - mpz_class(q.sine - p.sine) * (r.cosine - q.cosine);
      ASSERT_GT(turn, 0) << "n = " << n << ", corner " << i;
    }
  }
}

TEST(Circle, QuarterTurnsAndReflectionsAreExact) {
  for (std::uint64_t k = 0; k < 40; ++k) {
    const CirclePoint p = circle_point(k, 160, 40), quarter = circle_point(k + 40, 160, 40),
                      mirrored = circle_point(40 - k, 160, 40);
    EXPECT_TRUE(quarter.cosine == -p.sine && quarter.sine == p.cosine) << k;
    EXPECT_TRUE(mirrored.cosine == p.sine && mirrored.sine == p.cosine) << k;
  }
  EXPECT_EQ(circle_point(1, 12, 50).sine, std::int64_t{1} << 49) << "sin 30 degrees = 1/2";
}

TEST(Solids, HaveTheirVerticesAndFacets) {
  const auto counts = [](const Body& body) {
    const polytope::Polytope p = fathom::testing::hull_of(body);
    return std::array<std::size_t, 3>{p.vertices.size(), p.edges.size(), p.facets.size()};
  };
  EXPECT_EQ(counts(tetrahedron()), (std::array<std::size_t, 3>{4, 6, 4}));
  EXPECT_EQ(counts(cube()), (std::array<std::size_t, 3>{8, 12, 6}));
  EXPECT_EQ(counts(octahedron()), (std::array<std::size_t, 3>{6, 12, 8}));
  EXPECT_EQ(counts(dodecahedron()), (std::array<std::size_t, 3>{20, 30, 12}));
  EXPECT_EQ(counts(icosahedron()), (std::array<std::size_t, 3>{12, 30, 20}));
  EXPECT_EQ(counts(prism(7, 1)), (std::array<std::size_t, 3>{14, 21, 9}));
  EXPECT_EQ(counts(antiprism(7, 1)), (std::array<std::size_t, 3>{14, 28, 16}));
}

// --- All families

TEST(Families, NamesAreUniqueAndPlain) {
  std::set<std::string_view> names;
  for (const Family& family : all_families()) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    EXPECT_TRUE(std::regex_match(std::string(family.name), std::regex("[a-z0-9_]+"))) << family.name;
    EXPECT_FALSE(family.description.empty()) << family.name;
    EXPECT_EQ(find_family(family.name), &family);
  }
  EXPECT_EQ(find_family("no_such_family"), nullptr);
  EXPECT_FALSE(names.contains("all"));
}

TEST(Families, EachIsOfTheKindThatItIsListedAmong) {
  std::size_t listed = 0;
  for (const Kind kind : {Kind::polytopes, Kind::shapes, Kind::unions, Kind::plane})
    for (const Family& family : fathom::families::families(kind)) {
      EXPECT_EQ(family.kind(), kind) << family.name;
      EXPECT_EQ(&family, &all_families()[listed++]);
      const Case pair = family.make(1, 5);
      for (const Body* body : {&pair.a, &pair.b}) {
        // Of a shape's pair one may be a hull.
        EXPECT_TRUE(kind == Kind::shapes || kind == Kind::plane || !body->shape) << family.name;
        EXPECT_EQ(body->dimension, kind == Kind::plane ? 2U : 3U) << family.name;
        EXPECT_EQ(body->pieces != nullptr, kind == Kind::unions) << family.name;
      }
    }
  EXPECT_EQ(listed, all_families().size());
}

TEST(Families, EverySizeAndSeedGivesACase) {
  for (const Family& family : fathom::families::families())
    for (const unsigned size : {0u, 1u, 3u, 9u, 40u})
      for (std::uint64_t seed = 0; seed < 3; ++seed) {
        const Case pair = family.make(seed, size);
        EXPECT_EQ(pair.id, std::string(family.name) + "-n" + std::to_string(size) + "-s" + std::to_string(seed));
        EXPECT_TRUE(!pair.a.points.empty() && !pair.b.points.empty()) << pair.id;
        for (const Body* body : {&pair.a, &pair.b})
          for (const Point& p : body->points)
            for (mpq_class x : {p.x, p.y, p.z}) {
              const mpz_class denominator = x.get_den();
              x.canonicalize();
              ASSERT_EQ(denominator, x.get_den()) << pair.id << ": a coordinate is not in lowest terms";
            }
      }
}

TEST(Families, SameSeedSameCaseOtherSeedOtherCase) {
  const std::set<std::string_view> not_random{"crossed_parabolas", "crossed_patch"};
  for (const Family& family : fathom::families::families()) {
    std::set<std::uint64_t> hashes;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      EXPECT_EQ(hash(family.make(seed, 8)), hash(family.make(seed, 8))) << family.name;
      hashes.insert(hash(family.make(seed, 8)));
    }
    EXPECT_EQ(hashes.size() == 1, not_random.contains(family.name)) << family.name;
  }
}

TEST(Families, FarBodiesAreFar) {
  for (const std::string_view name : {"far_boxes", "far_sphere"}) {
    mpq_class farthest = 0;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const Case pair = find_family(name)->make(seed, 10);
      for (const Body* body : {&pair.a, &pair.b})
        for (const Point& p : body->points)
          for (const mpq_class& x : {p.x, p.y, p.z}) {
            EXPECT_GE(abs(x), 990) << pair.id;
            farthest = std::max<mpq_class>(farthest, abs(x));
          }
    }
    EXPECT_GT(farthest, 5'000'000) << name;
    EXPECT_LT(farthest, 9'000'010) << name;
  }
}

TEST(Families, FacesInFacesAreAtTheirAngle) {
  const std::map<std::string_view, mpq_class> tilts{{"faces_parallel", 0},
                                                    {"faces_tilted_hair", ratio(1, 1'000'000'000)},
                                                    {"faces_tilted_slightly", ratio(1, 10'000)},
                                                    {"faces_tilted", ratio(1, 100)}};
  for (const auto& [name, tilt] : tilts)
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const Case pair = find_family(name)->make(seed, 10);
      for (const Body* body : {&pair.a, &pair.b})
        for (const Point& p : body->points)
          for (const mpq_class& x : {p.x, p.y, p.z}) ASSERT_EQ(exact_value(round_binary64(x)), x) << pair.id;
      const Depth depth = penetration_depth(pair.a, pair.b);
      ASSERT_EQ(depth.status(), Status::penetrating) << pair.id;
      // B's face lies across an axis: that with the largest part of the direction.
      const Vector n = depth.optima().front().direction;
      mpq_class along = std::max({abs(n.x), abs(n.y), abs(n.z)});
      const mpq_class sine_squared = 1 - along * along / dot(n, n);
      EXPECT_LE(sine_squared, 4 * tilt * tilt) << pair.id;
      if (tilt > 0) continue;
      EXPECT_EQ(depth.optima().size(), 1U) << pair.id;
      EXPECT_EQ(depth.optima().front().contact.kind, ContactKind::facet_facet) << pair.id;
      EXPECT_EQ(depth.squared().get_num(), 1) << pair.id;
      EXPECT_GE(depth.squared(), mpq_class(1, 1 << 20)) << pair.id;
      EXPECT_LE(depth.squared(), mpq_class(1, 1 << 10)) << pair.id;
    }
}

/// Published cases must stay what they are: these values change only together with the data made
/// from them.
TEST(Families, CasesNeverChange) {
  const std::map<std::string_view, std::uint64_t> expected{
      {"random_ball", 1123440530497500322u},         {"random_lattice", 3993437288160012140u},
      {"boxes_posed", 15774920730084928624u},        {"prisms_posed", 4724086424335675478u},
      {"crossed_fans", 9535316249083486565u},        {"near_ties", 7532345502325144697u},
      {"touching_edge_edge", 15236103143204360882u}, {"segment_polygon", 688436399412356945u},
      {"wild_coordinates", 7486417950729874106u},    {"crossed_ties", 1298696010173432859u},
      {"crossed_fillets", 971371957160753009u},
  };
  for (const auto& [name, value] : expected) EXPECT_EQ(hash(find_family(name)->make(1, 12)), value) << name;
  std::uint64_t all = 0;
  for (const Family& family : fathom::families::families()) all = all * 31 + hash(family.make(2, 10));
  EXPECT_EQ(all, 7280341930766886016u) << "some family changed";
}

}  // namespace
