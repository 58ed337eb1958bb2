// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes whose signed depth is known before it is asked for: by inverse construction, and in the
// catalogue.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <regex>
#include <set>
#include <string>

#include "fathom/signed_depth.hpp"
#include "kernels/vector.hpp"
#include "verify/families/catalogue.hpp"
#include "verify/families/families.hpp"

namespace fathom::families {
namespace {

/// The root of a square of a rational.
mpq_class exact_root(const mpq_class& square) {
  EXPECT_TRUE(mpz_perfect_square_p(square.get_num_mpz_t()) && mpz_perfect_square_p(square.get_den_mpz_t()));
  return {sqrt(square.get_num()), sqrt(square.get_den())};
}

/// The greatest <u,x> over the body, for |u| = 1. By the definition: all roots must be rational.
mpq_class support(const Shape& shape, const Point& u) {
  mpq_class sum = shape.radius;
  if (const auto* const half = std::get_if<HalfSpace>(&shape.core)) {
    const mpq_class length = dot(half->normal, u);
    EXPECT_TRUE(length > 0 && length * length == dot(half->normal, half->normal)) << "not bounded in that direction";
    return sum + half->offset / length;
  }
  for (const Term& term : std::get<std::vector<Term>>(shape.core)) {
    std::optional<mpq_class> greatest;
    for (const Atom& atom : term.atoms) {
      mpq_class square;
      for (const Point& axis : atom.axes) square += dot(axis, u) * dot(axis, u);
      const mpq_class height = dot(atom.center, u) + exact_root(square);
      greatest = greatest ? std::max(*greatest, height) : height;
    }
    sum += *greatest;
  }
  return sum;
}

/// The answer is what is known, and decides the status.
void expect_known(const SignedDepth& depth, const Surd& known, const std::string& id) {
  const int side = sign(known);
  EXPECT_EQ(depth.status(), side > 0 ? Status::penetrating : side < 0 ? Status::disjoint : Status::touching) << id;
  if (const Surd* const exact = depth.exact()) {
    EXPECT_EQ(compare(*exact, known), 0) << id;
    return;
  }
  const Bounds& bounds = *depth.bounds();
  EXPECT_GE(compare(known, bounds.low), 0) << id;
  EXPECT_LE(compare(known, bounds.high), 0) << id;
  EXPECT_LT(bounds.high - bounds.low, mpq_class(1, 1 << 10)) << id;
}

TEST(InverseShapes, HaveTheSignedDepthThatWasChosen) {
  std::size_t exact = 0, all = 0;
  for (const Family& family : fathom::families::families(Kind::shapes)) {
    if (!family.name.starts_with("inverse_")) continue;
    std::set<int> seen;
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
      const ShapeCase shapes = family.make_shapes(seed, family.usual_size);
      const Shape a = shape_of(shapes.pair.a), b = shape_of(shapes.pair.b);
      const Surd& known = shapes.pair.known->signed_depth;
      const Point& u = *shapes.pair.known->direction;
      const SignedDepth depth = signed_depth(a, b);
      expect_known(depth, known, shapes.id);
      seen.insert(sign(known));
      ++all;
      exact += depth.exact() != nullptr;
      EXPECT_EQ(dot(u, u), 1) << shapes.id;
      // Only one of the two sides of a half-space is bounded: that is the direction.
      EXPECT_EQ(support(b, u) + support(a, {-u.x, -u.y, -u.z}), known.rational) << shapes.id;
      EXPECT_EQ(known.root, 0) << shapes.id;
    }
    EXPECT_TRUE(seen.contains(0) && seen.contains(-1)) << family.name;
    const bool sharp = family.name == "inverse_rims" || family.name == "inverse_apexes";
    EXPECT_EQ(seen.contains(1), !sharp) << family.name;
  }
  EXPECT_GT(4 * exact, 3 * all);
}

TEST(ShapeCatalogue, NamesAreUniqueAndPlain) {
  EXPECT_GE(shape_catalogue().size(), 80U);
  std::set<std::string> names;
  for (const ShapeCatalogueEntry& entry : shape_catalogue()) {
    EXPECT_TRUE(names.insert(entry.shapes.id).second) << entry.shapes.id;
    EXPECT_TRUE(std::regex_match(entry.shapes.id, std::regex("[a-z_]+"))) << entry.shapes.id;
    EXPECT_FALSE(entry.description.empty()) << entry.shapes.id;
  }
}

TEST(ShapeCatalogue, HasTheSignedDepthThatIsWrittenThere) {
  for (const ShapeCatalogueEntry& entry : shape_catalogue()) {
    const NamedPair& pair = entry.shapes.pair;
    const Shape a = shape_of(pair.a), b = shape_of(pair.b);
    expect_known(signed_depth(a, b), pair.known->signed_depth, entry.shapes.id);
    expect_known(signed_depth(b, a), pair.known->signed_depth, entry.shapes.id + ", exchanged");
  }
}

// In a pose that no machine number holds.
TEST(ShapeCatalogue, HasTheSameStatusInOtherPoses) {
  const Pose pose =
      rigid_pose({exact_value(0.3), exact_value(0.1), exact_value(-0.7), exact_value(0.52)}, {ratio(1, 3), 1, -2});
  for (const ShapeCatalogueEntry& entry : shape_catalogue()) {
    const NamedPair& pair = entry.shapes.pair;
    const Shape a = shape_of(pair.a), b = shape_of(pair.b);
    if (std::holds_alternative<HalfSpace>(a.core) || std::holds_alternative<HalfSpace>(b.core)) continue;
    expect_known(signed_depth(moved(a, pose), moved(b, pose)), pair.known->signed_depth, entry.shapes.id + ", turned");
  }
}

const ShapeCatalogueEntry& entry(const std::string& name) {
  return *std::ranges::find_if(shape_catalogue(),
                               [&name](const ShapeCatalogueEntry& e) { return e.shapes.id == name; });
}

TEST(ShapeCatalogue, StatusFlipsAtEquality) {
  const auto status = [](const std::string& name) {
    const NamedPair& pair = entry(name).shapes.pair;
    return signed_depth(shape_of(pair.a), shape_of(pair.b)).status();
  };
  for (const std::string kind : {"spheres", "capsules"}) {
    EXPECT_EQ(status(kind + "_at_equality"), Status::touching);
    EXPECT_EQ(status(kind + "_one_ulp_deep"), Status::penetrating);
    EXPECT_EQ(status(kind + "_one_ulp_apart"), Status::disjoint);
  }
  EXPECT_EQ(status("spheres_above_a_root"), Status::penetrating);
  EXPECT_EQ(status("spheres_below_a_root"), Status::disjoint);
}

}  // namespace
}  // namespace fathom::families
