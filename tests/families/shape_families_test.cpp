// SPDX-License-Identifier: GPL-3.0-or-later
// Families of shapes: the same on every machine, and in doubles where they say so.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "fathom/signed_depth.hpp"
#include "kernels/vector.hpp"
#include "verify/families/families.hpp"

namespace fathom::families {
namespace {

bool is_inverse(std::string_view name) { return name.starts_with("inverse_"); }

void each_number(const NamedBody& body, const std::function<void(const mpq_class&)>& use) {
  const auto point = [&use](const Point& p) {
    for (const mpq_class* x : {&p.x, &p.y, &p.z}) use(*x);
  };
  for (const auto& [name, values] : body.fields.numbers)
    for (const mpq_class& value : values) use(value);
  for (const Point& p : body.fields.vertices) point(p);
  for (const NamedBody& term : body.terms) each_number(term, use);
  for (const mpq_class* x : {&body.turn.w, &body.turn.x, &body.turn.y, &body.turn.z}) use(*x);
  point(body.place);
}

/// FNV-1a of all names and numbers as text.
std::uint64_t hash(const ShapeCase& shapes) {
  std::uint64_t value = 0xcbf29ce484222325U;
  const auto add = [&value](const std::string& text) {
    for (const char c : text + ' ') value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  };
  for (const NamedBody* body : {&shapes.pair.a, &shapes.pair.b}) {
    add(body->shape);
    add(std::to_string(static_cast<int>(body->fields.axis)));
    for (const NamedBody& term : body->terms) add(term.shape);
    each_number(*body, [&add](const mpq_class& x) { add(x.get_str()); });
  }
  return value;
}

TEST(ShapeFamilies, PosedHullsDifferInTheirPosesAlone) {
  const Family& family = *find_family("hulls_posed");
  const NamedPair first = family.make_shapes(1, 7).pair, second = family.make_shapes(2, 7).pair;
  for (const auto body : {&NamedPair::a, &NamedPair::b}) {
    EXPECT_EQ((first.*body).shape, "hull");
    EXPECT_EQ((first.*body).fields.vertices, (second.*body).fields.vertices);
    EXPECT_FALSE((first.*body).turn == (second.*body).turn && (first.*body).place == (second.*body).place);
  }
  EXPECT_NE(first.a.fields.vertices, first.b.fields.vertices);
  EXPECT_NE(first.a.fields.vertices, family.make_shapes(1, 8).pair.a.fields.vertices);
}

TEST(ShapeFamilies, SameSeedSameCaseOtherSeedOtherCase) {
  for (const Family& family : fathom::families::families(Kind::shapes)) {
    std::set<std::uint64_t> hashes;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const ShapeCase shapes = family.make_shapes(seed, 5);
      EXPECT_EQ(shapes.id, std::string(family.name) + "-n5-s" + std::to_string(seed));
      EXPECT_EQ(hash(shapes), hash(family.make_shapes(seed, 5))) << shapes.id;
      hashes.insert(hash(shapes));
    }
    EXPECT_EQ(hashes.size(), 8U) << family.name;
  }
}

/// Published cases must stay what they are.
TEST(ShapeFamilies, CasesNeverChange) {
  std::uint64_t all = 0;
  for (const Family& family : fathom::families::families(Kind::shapes))
    all = all * 31 + hash(family.make_shapes(2, 10));
  EXPECT_EQ(all, 993028135343414840U) << "some family changed";
}

TEST(ShapeFamilies, HullsHaveTheirSize) {
  for (const unsigned size : {0U, 3U, 4U, 25U})
    EXPECT_EQ(find_family("capsule_hull")->make_shapes(1, size).pair.b.fields.vertices.size(), std::max(4U, size));
}

TEST(ShapeFamilies, NumbersAreBinary64UnlessConstructed) {
  for (const Family& family : fathom::families::families(Kind::shapes)) {
    EXPECT_EQ(family.make_shapes(1, 8).pair.known.has_value(), is_inverse(family.name)) << family.name;
    if (is_inverse(family.name)) continue;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const ShapeCase shapes = family.make_shapes(seed, 8);
      for (const NamedBody* body : {&shapes.pair.a, &shapes.pair.b})
        each_number(*body, [&shapes](const mpq_class& x) { EXPECT_EQ(mpq_class(x.get_d()), x) << shapes.id; });
    }
  }
}

/// How deep, as tests see it.
enum class Situation { apart, nearly, touching, shallow, deep };

std::optional<Situation> situation_of(const SignedDepth& depth) {
  if (depth.status() == Status::touching) return Situation::touching;
  const double low = depth.low_binary64(), high = depth.high_binary64();
  if (high < 0) return low > -0.0625 ? Situation::nearly : Situation::apart;
  if (low > 0) return high < 0.0625 ? Situation::shallow : Situation::deep;
  return std::nullopt;
}

TEST(ShapeFamilies, EverySituationOccurs) {
  for (const Family& family : fathom::families::families(Kind::shapes)) {
    if (is_inverse(family.name)) continue;
    std::map<Situation, int> seen;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const Case pair = family.make(seed, 8);
      const auto shape = [](const Body& body) { return body.shape ? *body.shape : hull(body.points); };
      if (const auto situation = situation_of(signed_depth(shape(pair.a), shape(pair.b)))) ++seen[*situation];
    }
    for (const Situation situation :
         {Situation::apart, Situation::nearly, Situation::touching, Situation::shallow, Situation::deep})
      EXPECT_GE(seen[situation], 1) << family.name << ", situation " << static_cast<int>(situation);
  }
}

// Shapes whose signed depth is known before it is asked for: by inverse construction, and in the
// catalogue.

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

// Random shapes against other ways to their signed depth: segments in closed form, and polytopes
// inside and outside of discs and balls.

// ---- segments ----

struct Segment {
  Point p, q;
};

Segment core(const Shape& shape) {
  const std::vector<Atom>& atoms = std::get<std::vector<Term>>(shape.core).front().atoms;
  return {atoms.front().center, atoms.back().center};
}

mpq_class squared_distance(const Point& point, const Segment& s) {
  const Point along = s.q - s.p, to = point - s.p;
  const mpq_class length = dot(along, along);
  mpq_class t = length == 0 ? mpq_class(0) : mpq_class(dot(to, along) / length);
  t = std::clamp<mpq_class>(t, 0, 1);
  const Point gap = to - t * along;
  return dot(gap, gap);
}

/// The least of: each end to the other segment; the common perpendicular, if both its feet are on
/// the segments.
mpq_class squared_distance(const Segment& s, const Segment& t) {
  mpq_class least = std::min(
      {squared_distance(s.p, t), squared_distance(s.q, t), squared_distance(t.p, s), squared_distance(t.q, s)});
  const Point u = s.q - s.p, v = t.q - t.p, w = t.p - s.p;
  const mpq_class uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), determinant = uu * vv - uv * uv;
  if (determinant == 0) return least;
  const mpq_class x = (dot(w, u) * vv - dot(w, v) * uv) / determinant,
                  y = (dot(w, u) * uv - dot(w, v) * uu) / determinant;
  if (x < 0 || x > 1 || y < 0 || y > 1) return least;
  const Point gap = w + y * v - x * u;
  return std::min<mpq_class>(least, dot(gap, gap));
}

TEST(RandomShapes, SpheresAndCapsulesHaveTheDistanceOfTheirSegments) {
  for (const char* name :
       {"spheres", "capsules", "sphere_capsule", "inverse_sphere_sphere", "inverse_cap_cap", "inverse_side_side"})
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const ShapeCase shapes = find_family(name)->make_shapes(seed, 1);
      const Shape a = shape_of(shapes.pair.a), b = shape_of(shapes.pair.b);
      const SignedDepth depth = signed_depth(a, b);
      ASSERT_TRUE(depth.exact()) << shapes.id;
      const Surd expected{a.radius + b.radius, -squared_distance(core(a), core(b))};
      EXPECT_EQ(compare(*depth.exact(), expected), 0) << shapes.id;
    }
}

// ---- polytopes inside and outside ----

/// Points of the unit circle, and the corners of the polygon that touches it there.
struct Polygons {
  std::vector<Point> inside, outside;
};

const Polygons& polygons() {
  static const Polygons both = [] {
    Polygons result;
    for (int quarter = 0; quarter < 4; ++quarter)
      for (int i = 0; i < 4; ++i) {
        const mpq_class t(i, 4), scale = 1 / (1 + t * t);
        Point p{(1 - t * t) * scale, 2 * t * scale, 0};
        for (int turn = 0; turn < quarter; ++turn) p = {-p.y, p.x, 0};
        result.inside.push_back(p);
      }
    for (std::size_t i = 0; i < result.inside.size(); ++i) {
      const Point &p = result.inside[i], &q = result.inside[(i + 1) % result.inside.size()];
      result.outside.push_back((1 / (1 + dot(p, q))) * (p + q));
    }
    return result;
  }();
  return both;
}

/// Points of the unit sphere, and the same blown up until their hull holds the ball.
const Polygons& polyhedra() {
  static const Polygons both = [] {
    Polygons result;
    const std::array<Point, 3> kinds{
        {{1, 0, 0}, {mpq_class(3, 5), mpq_class(4, 5), 0}, {mpq_class(2, 3), mpq_class(2, 3), mpq_class(1, 3)}}};
    for (const Point& p : kinds)
      for (const Point& q : {Point{p.x, p.y, p.z}, Point{p.y, p.z, p.x}, Point{p.z, p.x, p.y}, Point{p.y, p.x, p.z},
                             Point{p.x, p.z, p.y}, Point{p.z, p.y, p.x}})
        for (unsigned signs = 0; signs < 8; ++signs)
          result.inside.push_back({signs & 1 ? mpq_class(-q.x) : q.x, signs & 2 ? mpq_class(-q.y) : q.y,
                                   signs & 4 ? mpq_class(-q.z) : q.z});
    const std::vector<Point> center{{}};
    const mpq_class inner =
        exact_value(root_binary64(penetration_depth(result.inside, center).squared(), Rounding::rd));
    for (const Point& p : result.inside) result.outside.push_back((1 / inner) * p);
    return result;
  }();
  return both;
}

/// The shape with points instead of discs and balls.
Shape polytope_of(const Shape& shape, std::vector<Point> Polygons::*which) {
  if (std::holds_alternative<HalfSpace>(shape.core)) return shape;
  std::vector<Term> terms;
  for (const Term& term : std::get<std::vector<Term>>(shape.core)) {
    Term& points = terms.emplace_back();
    for (const Atom& atom : term.atoms) {
      if (atom.axes.empty()) points.atoms.push_back(atom);
      else
        for (const Point& local : (atom.axes.size() == 2 ? polygons() : polyhedra()).*which) {
          Point p = atom.center + local.x * atom.axes[0] + local.y * atom.axes[1];
          if (atom.axes.size() == 3) p = p + local.z * atom.axes[2];
          points.atoms.push_back({p, {}});
        }
    }
  }
  return {terms, shape.radius};
}

int compare_with_low(const SignedDepth& depth, const Surd& value) {
  return depth.exact() ? compare(value, *depth.exact()) : compare(value, depth.bounds()->low);
}

int compare_with_high(const SignedDepth& depth, const Surd& value) {
  return depth.exact() ? compare(value, *depth.exact()) : compare(value, depth.bounds()->high);
}

TEST(RandomShapes, LieBetweenPolytopesInsideAndOutside) {
  for (const Family& family : fathom::families::families(Kind::shapes)) {
    if (family.name == "sums") continue;  // sums of two solids have too many points
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const ShapeCase shapes = family.make_shapes(seed, 8);
      if (shapes.pair.a.shape == "sum" || shapes.pair.b.shape == "sum") continue;
      const Shape a = shape_of(shapes.pair.a), b = shape_of(shapes.pair.b);
      const SignedDepth depth = signed_depth(a, b);
      const SignedDepth inside = signed_depth(polytope_of(a, &Polygons::inside), polytope_of(b, &Polygons::inside));
      const SignedDepth outside = signed_depth(polytope_of(a, &Polygons::outside), polytope_of(b, &Polygons::outside));
      ASSERT_TRUE(inside.exact() && outside.exact()) << shapes.id;
      EXPECT_LE(compare_with_high(depth, *inside.exact()), 0) << shapes.id;
      EXPECT_GE(compare_with_low(depth, *outside.exact()), 0) << shapes.id;
    }
  }
}

}  // namespace
}  // namespace fathom::families
