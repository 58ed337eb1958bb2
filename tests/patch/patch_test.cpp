// SPDX-License-Identifier: GPL-3.0-or-later
// Contact patches against their definition and a naive twin, and derivatives against exact
// differences with a step that falls, over all families and the kinds of bodies.
#include "reference/patch/patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/answer.hpp"
#include "fathom/numbers.hpp"
#include "fathom/shape.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/files/shape_names.hpp"
#include "tests/support/random_shapes.hpp"
#include "verify/families/families.hpp"
#include "verify/families/random.hpp"

namespace fathom {
namespace {

using families::Random;

Body box_body(const Point& half, const Point& center) {
  std::vector<Point> points;
  for (const int z : {-1, 1})
    for (const int y : {-1, 1})
      for (const int x : {-1, 1})
        points.push_back({center.x + x * half.x, center.y + y * half.y, center.z + z * half.z});
  return {points};
}

ContactGeometry geometry_of(const Body& a, const Body& b) { return contact_geometry(a, b, exact_answer(a, b)); }

// ---- what is known ----

TEST(Patch, OfTwoBoxes) {
  const Body a = box_body({1, 1, 1}, {0, 0, 0}), b = box_body({1, 1, 1}, {1, mpq_class(1, 2), mpq_class(1, 4)});
  const ContactGeometry geometry = geometry_of(a, b);
  ASSERT_EQ(geometry.patches.size(), 1U);
  const Patch& patch = geometry.patches[0];
  EXPECT_EQ(patch.direction, (Vector{-1, 0, 0}));
  EXPECT_EQ(patch.rank(), 2);
  ASSERT_EQ(patch.corners.size(), 4U);
  EXPECT_EQ(patch.a(0).core, (Point{1, mpq_class(-1, 2), mpq_class(-3, 4)}));
  EXPECT_EQ(patch.b(0).core, (Point{0, mpq_class(-1, 2), mpq_class(-3, 4)}));
  EXPECT_EQ(patch.translation(), (Point{-1, 0, 0}));
  EXPECT_EQ(patch.a(1).core, (Point{1, mpq_class(-1, 2), 1})) << "seen from the tip of n";
  EXPECT_EQ(patch.corners[0].on_a.size(), 4U);
  EXPECT_EQ(patch.corners[0].on_b.size(), 1U);
  EXPECT_EQ(patch.corners[1].on_a.size(), 2U);
  EXPECT_EQ(patch.corners[1].on_b.size(), 2U);
  EXPECT_EQ(patch.squared(), mpq_class(441, 64));  // (3/2 * 7/4)^2
  EXPECT_EQ(patch.centroid().a.core, (Point{1, mpq_class(1, 4), mpq_class(1, 8)}));
  EXPECT_EQ(geometry.kinks, std::vector{Kink::extended});
  EXPECT_FALSE(geometry.smooth());

  const auto derivative = [&](const Twist& twist) {
    const DirectionalDerivative d = std::get<DirectionalDerivative>(directional_derivative(geometry, twist));
    return mpq_class(d.sign() * d.root());
  };
  EXPECT_EQ(derivative({{1, 0, 0}, {}}), 1) << "deeper as A moves on into B";
  EXPECT_EQ(derivative({{-1, 0, 0}, {}}), -1);
  EXPECT_EQ(derivative({{0, 1, 0}, {}}), 0) << "along the faces";
  // Turning about z: the corner with the greatest y, or the least, decides.
  EXPECT_EQ(derivative({{}, {0, 0, 1}}), mpq_class(1, 4));
  EXPECT_EQ(derivative({{}, {0, 0, -1}}), 1);
}

TEST(Patch, OfASphereOnAPlane) {
  const Body ball{{}, sphere(2)}, ground{{}, halfspace({0, 0, 1}, 0)};
  const ContactGeometry geometry = geometry_of(ball, ground);
  ASSERT_TRUE(geometry.smooth());
  EXPECT_EQ(geometry.patches[0].a(0).core, (Point{0, 0, 0}));
  EXPECT_EQ(geometry.patches[0].a(0).distance, -2);
  EXPECT_EQ(geometry.gradient()->normal, (Vector{0, 0, 1}));
  EXPECT_EQ(geometry.patches[0].corners[0].on_a, std::vector<std::uint32_t>{0});
  EXPECT_TRUE(geometry.patches[0].corners[0].on_b.empty());
  const std::optional<VertexWeights> weights = vertex_weights(ball, ground, geometry);
  ASSERT_TRUE(weights);
  EXPECT_EQ(weights->a, (std::vector<Weight>{{0, 1}}));
  EXPECT_TRUE(weights->b.empty());
}

TEST(Patch, WhatIsLeftOut) {
  const Body cylinder_body{{}, cylinder(1, 1)}, cube = box_body({1, 1, 1}, {1, 0, 0});
  const ContactGeometry curved = geometry_of(cylinder_body, cube);
  EXPECT_EQ(curved.no_patches, LeftOut::curved);
  EXPECT_TRUE(curved.patches.empty());
  EXPECT_EQ(std::get<LeftOut>(directional_derivative(curved, {{1, 0, 0}, {}})), LeftOut::curved);
  EXPECT_EQ(name(LeftOut::exact_fit), "exact-fit");

  const Body same = box_body({1, 1, 1}, {0, 0, 0});
  Question question;
  question.options.optima = 1;
  const ContactGeometry unlisted = contact_geometry(same, same, exact_answer(same, same, question));
  EXPECT_EQ(unlisted.patches.size(), 1U);
  EXPECT_EQ(std::get<LeftOut>(directional_derivative(unlisted, {})), LeftOut::unlisted);
  EXPECT_FALSE(unlisted.smooth());
  EXPECT_THROW(directional_derivative(geometry_of(same, same), {{mpq_class(2, 4), 0, 0}, {}}), std::invalid_argument);
}

// ---- the definition ----

void expect_patches(const Body& a, const Body& b, const std::string& id) {
  const Answer answer = exact_answer(a, b);
  const Depth& depth = std::get<Depth>(answer.found);
  const ContactGeometry geometry = contact_geometry(a, b, answer);
  ASSERT_EQ(geometry.patches.size(), depth.penetration() ? depth.optima().size() : 1U) << id;
  for (std::size_t i = 0; i < geometry.patches.size(); ++i) {
    const Patch& patch = geometry.patches[i];
    std::vector<Point> corners;
    for (std::size_t k = 0; k < patch.corners.size(); ++k) {
      corners.push_back(patch.a(k).core);
      EXPECT_EQ(patch.b(k).core - patch.a(k).core, patch.translation()) << id;
    }
    const Contact contact = depth.penetration() ? depth.optima()[i].contact
                            : depth.distance()  ? depth.distance()->contact
                                                : *signed_depth(files::shape_of(a), files::shape_of(b)).contact();
    const patch::MeetingFaces faces{patch.direction, a.points, contact.a, b.points, contact.b};
    const kernels::Report report = patch::validate(patch, faces);
    EXPECT_TRUE(report.ok()) << id << ": " << report.faults.front();
    const auto less = [](const Point& p, const Point& q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); };
    std::rotate(corners.begin(), std::ranges::min_element(corners, less), corners.end());
    EXPECT_EQ(corners, patch::shared_naive(patch.translation(), faces)) << id;
    EXPECT_EQ(patch.translation(), depth.penetration() ? depth.optima()[i].translation() : depth.contact_translation());
    if (!depth.penetration()) continue;
    const auto dimension = [](std::size_t count) { return std::min<int>(2, static_cast<int>(count) - 1); };
    EXPECT_EQ(patch.rank(), dimension(contact.a.size()) + dimension(contact.b.size()) - 2) << id << ": Lemma 2";
  }
}

/// As sets: of B against A the same corners, with A and B exchanged.
void expect_swapped(const Body& a, const Body& b, const std::string& id) {
  const ContactGeometry there = geometry_of(a, b), back = geometry_of(b, a);
  ASSERT_EQ(there.patches.size(), back.patches.size()) << id;
  EXPECT_EQ(there.kinks, back.kinks) << id;
  const auto ends = [](const ContactGeometry& geometry, bool exchanged) {
    std::vector<std::pair<std::string, std::string>> all;
    for (const Patch& patch : geometry.patches)
      for (std::size_t k = 0; k < patch.corners.size(); ++k) {
        const auto text = [](const Point& p) { return p.x.get_str() + " " + p.y.get_str() + " " + p.z.get_str(); };
        std::pair<std::string, std::string> pair{text(patch.a(k).core), text(patch.b(k).core)};
        if (exchanged) std::swap(pair.first, pair.second);
        all.push_back(std::move(pair));
      }
    std::sort(all.begin(), all.end());
    return all;
  };
  EXPECT_EQ(ends(there, false), ends(back, true)) << id;
}

// ---- exact differences ----

constexpr unsigned more_bits = 300;  // of roots, beyond those of the step

/// floor(2^bits * x), for a signed root.
mpz_class scaled(const Surd& value, mp_bitcnt_t bits) {
  const mpq_class magnitude = abs(value.root);
  const mpz_class square = (magnitude.get_num() << (2 * bits)) / magnitude.get_den();
  const mpz_class whole = (value.rational.get_num() << bits) / value.rational.get_den();
  const mpz_class root = sqrt(square);
  return value.root < 0 ? mpz_class(whole - root) : mpz_class(whole + root);
}

/// How a body is moved by a twist for a time 2^-bits: turned by the exact rotation of the
/// quaternion (1, w s/2), then by v s.
Pose moved_for(const Twist& twist, mp_bitcnt_t bits) {
  const mpq_class s = mpq_class(1) >> bits, half = s / 2;
  return rigid_pose({1, mpq_class(half * twist.w.x), mpq_class(half * twist.w.y), mpq_class(half * twist.w.z)},
                    s * twist.v);
}

Body moved_body(const Body& body, const Pose& pose) {
  if (body.shape) return {{}, moved(*body.shape, pose)};
  const auto place = [&](const Point& p) {
    const auto row = [&](int i) {
      return mpq_class(pose[i][0] * p.x + pose[i][1] * p.y + pose[i][2] * p.z + pose[i][3]);
    };
    return Point{row(0), row(1), row(2)};
  };
  if (body.pieces) {
    auto pieces = std::make_shared<Pieces>(*body.pieces);
    for (std::vector<Point>& piece : *pieces)
      for (Point& p : piece) p = place(p);
    Body result;
    result.pieces = pieces;
    return result;
  }
  std::vector<Point> points;
  for (const Point& p : body.points.exact()) points.push_back(place(p));
  return {points};
}

/// |difference quotient - derivative| times 2^more_bits, for the step 2^-bits.
mpz_class deviation(const Body& a, const Body& b, const Surd& now, const Surd& derivative, const Twist& of_a,
                    const Twist& of_b, mp_bitcnt_t bits) {
  const Surd then = exact_answer(moved_body(a, moved_for(of_a, bits)), moved_body(b, moved_for(of_b, bits))).low();
  const mp_bitcnt_t precision = bits + more_bits;
  // (then - now) 2^bits, in units of 2^-more_bits, is the difference of these.
  return abs(mpz_class(scaled(then, precision) - scaled(now, precision) - scaled(derivative, more_bits)));
}

/// Whether the difference quotients tend to the derivative, at the rate of the step: from one step
/// to its square the error falls by the step.
void expect_derivative(const Body& a, const Body& b, const ContactGeometry& geometry, const Surd& now,
                       const Twist& of_a, const Twist& of_b, const std::string& id) {
  const auto found = directional_derivative(geometry, of_a, of_b);
  ASSERT_TRUE(std::holds_alternative<DirectionalDerivative>(found)) << id << name(std::get<LeftOut>(found));
  const Surd derivative = std::get<DirectionalDerivative>(found).value();
  for (mp_bitcnt_t bits = 40; bits <= 3000; bits *= 2) {
    const mpz_class coarse = deviation(a, b, now, derivative, of_a, of_b, bits);
    if (coarse <= 4) return;
    const mpz_class fine = deviation(a, b, now, derivative, of_a, of_b, 2 * bits);
    if (fine <= 4 || (fine << bits) <= coarse + (coarse >> 10) + (mpz_class(8) << bits)) return;
  }
  ADD_FAILURE() << id << ": the quotients do not tend to " << derivative.root;
}

Point small_vector(Random& random) {
  return {mpq_class(random.between(-3, 3)), mpq_class(random.between(-3, 3)), mpq_class(random.between(-3, 3))};
}

/// Returns how many were compared.
int expect_derivatives(const Body& a, const Body& b, Random& random, int twists, const std::string& id) {
  const Answer answer = exact_answer(a, b);
  const ContactGeometry geometry = contact_geometry(a, b, answer);
  if (geometry.no_first_order) return 0;
  for (int k = 0; k < twists; ++k) {
    Twist of_a{small_vector(random), small_vector(random)}, of_b{};
    if (k % 3 == 1) of_b = {small_vector(random), small_vector(random)};
    if (k % 3 == 2 && !geometry.patches.empty()) {  // about an edge of a patch: corners tie
      const Patch& patch = geometry.patches[0];
      const Point p = patch.a(0).core, q = patch.a(patch.corners.size() - 1).core;
      const Vector along = patch.rank() == 0 ? patch.direction : primitive_along(q - p);
      of_a.w = rational(along);
      of_a.v = -cross(of_a.w, p);
    }
    expect_derivative(a, b, geometry, answer.low(), of_a, of_b, id + ", twist " + std::to_string(k));
  }
  return twists;
}

// ---- families ----

class EveryFamilyPatch : public ::testing::TestWithParam<std::size_t> {};

TEST_P(EveryFamilyPatch, FollowsFromTheDefinitionAndDiffers) {
  const families::Family& family = families::families()[GetParam()];
  Random random(GetParam());
  for (const unsigned size : {8U, 20U})
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const Case made = family.make(seed, size);
      expect_patches(made.a, made.b, made.id);
      expect_swapped(made.a, made.b, made.id);
    }
  const Case made = family.make(4, 8);
  EXPECT_EQ(expect_derivatives(made.a, made.b, random, 3, made.id), 3);
}

INSTANTIATE_TEST_SUITE_P(Families, EveryFamilyPatch, ::testing::Range<std::size_t>(0, families::families().size()),
                         [](const auto& info) { return std::string(families::families()[info.param].name); });

/// Small bodies on a lattice, of every rank, which tie, touch and share planes all the time.
Body lattice_body(Random& random) {
  const int count = static_cast<int>(random.between(1, 7)), flat = static_cast<int>(random.between(0, 3));
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
    points.push_back({mpq_class(random.between(0, 2)), mpq_class(random.between(0, 2)),
                      flat == 0 ? mpq_class(1) : mpq_class(random.between(0, 2))});
  return {points};
}

TEST(Patch, OfLatticeBodiesOfEveryRank) {
  Random random(11);
  std::array<int, 3> ranks{};
  int compared = 0;
  for (int i = 0; i < 600; ++i) {
    const Body a = lattice_body(random), b = lattice_body(random);
    const std::string id = "lattice bodies " + std::to_string(i);
    expect_patches(a, b, id);
    expect_swapped(a, b, id);
    for (const Patch& patch : geometry_of(a, b).patches) ++ranks[static_cast<std::size_t>(patch.rank())];
    if (i % 6 == 0) compared += expect_derivatives(a, b, random, 3, id);
  }
  for (const int count : ranks) EXPECT_GT(count, 30);
  EXPECT_EQ(compared, 300);
}

/// Of bodies that touch, the patch is all that they share.
TEST(Patch, OfTouchingBodiesIsTheirIntersection) {
  Random random(5);
  int checked = 0;
  while (checked < 60) {
    const Body a = lattice_body(random), b = lattice_body(random);
    const Answer answer = exact_answer(a, b);
    if (answer.status() != Status::touching) continue;
    ++checked;
    const ContactGeometry geometry = contact_geometry(a, b, answer);
    ASSERT_EQ(geometry.patches.size(), 1U);
    std::vector<Point> corners;
    for (std::size_t k = 0; k < geometry.patches[0].corners.size(); ++k)
      corners.push_back(geometry.patches[0].a(k).core);
    // The depths of a corner in both bodies, and whether a lattice point of both is in the patch.
    const auto holds = [](const Body& body, const Point& p) {
      return exact_answer(body, Body{std::vector<Point>{p}}).status() != Status::disjoint;
    };
    for (const Point& corner : corners) EXPECT_TRUE(holds(a, corner) && holds(b, corner));
    for (int x = 0; x <= 4; ++x)
      for (int y = 0; y <= 4; ++y)
        for (int z = 0; z <= 4; ++z) {
          const Point p{mpq_class(x) / 2, mpq_class(y) / 2, mpq_class(z) / 2};
          EXPECT_EQ(holds(a, p) && holds(b, p), holds(Body{corners}, p));
        }
  }
}

TEST(Patch, OfRoundedBodiesAndHalfSpaces) {
  Random random(17);
  const auto rational_between = [&](int low, int high) { return families::ratio(random.between(low, high), 4); };
  const auto rounded_body = [&]() -> Body {
    const Point center{rational_between(-6, 6), rational_between(-6, 6), rational_between(-6, 6)};
    Shape shape = random.between(0, 1) == 0
                      ? capsule(rational_between(1, 4), rational_between(1, 8))
                      : with_margin(box({rational_between(1, 6), rational_between(1, 6), 1}), rational_between(0, 3));
    const Quaternion q{1, mpq_class(random.between(-1, 1)), mpq_class(random.between(-1, 1)), 0};
    return {{}, moved(shape, rigid_pose(q, center))};
  };
  int compared = 0;
  for (int i = 0; i < 40; ++i) {
    const Body a = rounded_body();
    const Body b = i % 4 == 3 ? Body{{}, halfspace({mpq_class(random.between(-1, 1)), 1, 1}, rational_between(-8, 8))}
                              : rounded_body();
    compared += expect_derivatives(a, b, random, 3, "rounded " + std::to_string(i));
    if (i % 4 == 3) compared += expect_derivatives(b, a, random, 3, "rounded, exchanged " + std::to_string(i));
  }
  EXPECT_EQ(compared, 150);
}

TEST(Patch, OfUnions) {
  Random random(23);
  int turning = 0;
  for (const families::Family& family : families::families(families::Kind::unions)) {
    const Case made = family.make(1, 3);
    const Answer answer = exact_answer(made.a, made.b);
    const ContactGeometry geometry = contact_geometry(made.a, made.b, answer);
    ASSERT_FALSE(geometry.patches.empty()) << made.id;
    EXPECT_FALSE(geometry.smooth());
    if (geometry.no_first_order) continue;
    for (int k = 0; k < 2; ++k) {
      const Twist push{small_vector(random), {}}, turn{small_vector(random), small_vector(random)};
      expect_derivative(made.a, made.b, geometry, answer.low(), push, {}, made.id);
      if (std::holds_alternative<LeftOut>(directional_derivative(geometry, turn))) continue;
      expect_derivative(made.a, made.b, geometry, answer.low(), turn, {}, made.id);
      ++turning;
    }
  }
  EXPECT_GT(turning, 5);
}

/// Where it is smooth, the gradient and the weights say what the derivative says.
// Edges cross near 2^274, and near 2^53 with a part of 2^-184: integers that hold the numbers of
// each crossing need not hold what compares them.
TEST(Patch, CrossingsOfUnlikeSizesAreCompared) {
  const double far = 0x1p274, wide = 9007199254740991.0, half = 4503599627370497.0, hair = 0x1p-184;
  const Body a{GivenPoints(std::vector<std::array<double, 3>>{
      {-wide, 0, 0}, {wide, hair, 0}, {far, far, 0}, {-far, far, 0}, {0, wide, -1}})};
  const Body b{GivenPoints(std::vector<std::array<double, 3>>{{hair, -wide, 1},
                                                              {half, wide, 1},
                                                              {far / 8, far / 2, 1},
                                                              {far / 4, 2 * far, 1},
                                                              {-far / 4, 2 * far, 1},
                                                              {-far / 8, far / 2, 1},
                                                              {-half, wide, 1},
                                                              {0, wide, 2}})};
  const ContactGeometry geometry = geometry_of(a, b);
  ASSERT_EQ(geometry.patches.size(), 1U);
  const Patch& patch = geometry.patches.front();
  for (const Twist& twist : {Twist{{}, {0, -1, 0}}, Twist{{}, {0, 1, 0}}, Twist{{1, 2, 3}, {1, mpq_class(1, 3), 0}}}) {
    std::optional<mpq_class> greatest;
    for (std::size_t k = 0; k < patch.corners.size(); ++k) {
      mpq_class rate = -dot(patch.direction, twist.v + cross(twist.w, patch.a(k).core));
      if (!greatest || rate > *greatest) greatest = std::move(rate);
    }
    const auto found = std::get<DirectionalDerivative>(directional_derivative(geometry, twist));
    EXPECT_EQ(found.sign() * found.root(), *greatest * abs(*greatest) / dot(patch.direction, patch.direction));
  }
}

TEST(Patch, GradientAndWeights) {
  Random random(3);
  int smooth = 0, weighted = 0;
  for (const families::Family& family : families::families()) {
    const Case made = family.make(2, 12);
    const ContactGeometry geometry = geometry_of(made.a, made.b);
    if (!geometry.smooth()) continue;
    ++smooth;
    const Twist twist{small_vector(random), small_vector(random)};
    const auto found = std::get<DirectionalDerivative>(directional_derivative(geometry, twist));
    const Vector n = geometry.gradient()->normal;
    const mpq_class rate = -dot(n, twist.v + cross(twist.w, geometry.gradient()->point));
    EXPECT_EQ(found.sign() * found.root(), rate * abs(rate) / dot(n, n)) << made.id;
    double in_doubles = 0;
    const SurdPoint by_v = geometry.gradient()->by_translation(), by_w = geometry.gradient()->by_rotation();
    const Point parts[] = {twist.v, twist.w};
    for (const auto& [by, part] : {std::pair(&by_v, &parts[0]), {&by_w, &parts[1]}})
      in_doubles += round_binary64((*by)[0]) * part->x.get_d() + round_binary64((*by)[1]) * part->y.get_d() +
                    round_binary64((*by)[2]) * part->z.get_d();
    if (made.id.find("coordinates") == std::string::npos && made.id.find("far") == std::string::npos)
      EXPECT_NEAR(in_doubles, round_binary64(found.value()), 1e-6) << made.id;
    const std::optional<VertexWeights> weights = vertex_weights(made.a, made.b, geometry);
    if (!weights) continue;
    ++weighted;
    Point sum;
    for (const Weight& w : weights->a) {
      EXPECT_GT(w.weight, 0) << made.id;
      sum = sum + w.weight * made.a.points[w.index];
    }
    EXPECT_EQ(sum, geometry.gradient()->point) << made.id;
    Point sum_b;
    for (const Weight& w : weights->b) sum_b = sum_b + w.weight * made.b.points[w.index];
    EXPECT_EQ(sum_b - sum, geometry.patches[0].translation()) << made.id;
  }
  EXPECT_GT(smooth, 20);
  EXPECT_GT(weighted, 20);
}

}  // namespace
}  // namespace fathom
