// SPDX-License-Identifier: GPL-3.0-or-later
// What coincides of the shapes of the catalogue, by hand; nothing of shapes in general position; of
// polytopes what their own study says.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

#include "fathom/study.hpp"
#include "reference/files/shape_names.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/random_shapes.hpp"
#include "verify/families/families.hpp"
#include "verify/study/solid.hpp"

namespace fathom::studies {
namespace {

std::uint64_t count(const ShapeStudy& study, ShapeCoincidence kind) { return study[kind].count; }

/// Where optima form a continuum, bounds end by the number of calls.
ShapeStudy study_of(const Shape& a, const Shape& b) { return study(a, b, {.support_calls = 300}); }

std::string names(const ShapeStudy& study) {
  std::string result;
  for (std::size_t i = 0; i < shape_coincidence_names.size(); ++i)
    if (const auto many = study.coincidences[i].count)
      result += (result.empty() ? "" : ", ") + std::string(shape_coincidence_names[i]) + " " + std::to_string(many);
  return result;
}

// clang-format off
const std::map<std::string, std::string, std::less<>> of_catalogue{
    {"spheres_concentric", "concentric 1, touching_cores 1"},
    {"spheres_touching", "equal_radii 1, distance_of_radii 1, touching_features 1"},
    {"spheres_at_equality", "distance_of_radii 1, touching_features 1"},
    {"spheres_one_ulp_deep", ""},
    {"spheres_one_ulp_apart", ""},
    {"spheres_above_a_root", "equal_radii 1"},
    {"spheres_below_a_root", "equal_radii 1"},
    {"sphere_on_plane", "supporting_faces 1, tangent_to_face 1, touching_features 1"},
    {"sphere_centre_on_plane", "touching_cores 1"},
    {"sphere_on_box", "supporting_faces 1, distance_of_radii 1, tangent_to_face 1, touching_features 1"},
    {"sphere_centre_on_face", "touching_cores 1"},
    {"sphere_centre_on_edge", "touching_cores 1"},
    {"sphere_centre_on_vertex", "touching_cores 1"},
    {"sphere_centre_in_triangle", "touching_cores 1"},
    {"sphere_under_vertex", "distance_of_radii 1, touching_features 1"},
    {"ball_that_is_an_ellipsoid", "equal_radii 1"},
    {"capsules_equal", "equal_bodies 1, concentric 1, coaxial 1, parallel_axes 1, equal_radii 1, parallel_generators 1, touching_cores 1"},
    {"capsules_coaxial", "concentric 1, coaxial 1, parallel_axes 1, parallel_generators 1, touching_cores 1"},
    {"capsules_end_to_end", "coaxial 1, parallel_axes 1, equal_radii 1, parallel_generators 1, distance_of_radii 1, touching_features 1"},
    {"capsules_crossing", "concentric 1, centre_on_axis 2, orthogonal_axes 1, intersecting_axes 1, equal_radii 1, touching_cores 1"},
    {"capsules_across", "orthogonal_axes 1, equal_radii 1, distance_of_radii 1, touching_features 1"},
    {"capsules_axis_on_end", "orthogonal_axes 1, intersecting_axes 1, equal_radii 1, touching_cores 1"},
    {"capsules_parallel_touching", "parallel_axes 1, equal_radii 1, parallel_generators 1, tangent_generators 1, "
     "distance_of_radii 1, touching_features 1"},
    {"capsules_parallel_deep", "parallel_axes 1, equal_radii 1, parallel_generators 1"},
    {"capsules_at_equality", "parallel_axes 1, parallel_generators 1, tangent_generators 1, distance_of_radii 1, touching_features 1"},
    {"capsules_one_ulp_deep", "parallel_axes 1, parallel_generators 1"},
    {"capsules_one_ulp_apart", "parallel_axes 1, parallel_generators 1"},
    {"sphere_centre_on_segment", "centre_on_axis 1, touching_cores 1"},
    {"sphere_centre_on_end", "centre_on_axis 1, touching_cores 1"},
    {"capsule_standing_on_plane", "supporting_faces 1, tangent_to_face 1, touching_features 1"},
    {"capsule_lying_on_plane", "generators_along_faces 1, supporting_faces 1, generator_on_face 1, touching_features 1"},
    {"capsule_lying_on_box", "generators_along_faces 4, supporting_faces 1, distance_of_radii 1, generator_on_face 1, touching_features 1"},
    {"capsule_along_edge", "generators_along_faces 4, touching_cores 1"},
    {"cylinder_standing_on_box", "centre_on_axis 1, parallel_faces 4, coplanar_faces 1, generators_along_faces 4, "
     "supporting_faces 2, face_on_face 1, touching_features 1"},
    {"cylinder_standing_over_edge", "parallel_faces 4, coplanar_faces 1, generators_along_faces 4, supporting_faces 2, "
     "face_on_face 1, touching_features 1"},
    {"cylinder_one_ulp_above_box", "centre_on_axis 1, parallel_faces 4, generators_along_faces 4"},
    {"cylinder_one_ulp_in_box", "centre_on_axis 1, parallel_faces 4, generators_along_faces 4"},
    {"cylinder_sunk_in_box", "centre_on_axis 1, parallel_faces 4, generators_along_faces 4"},
    {"cylinder_lying_on_box", "parallel_faces 4, generators_along_faces 4, supporting_faces 1, generator_on_face 1, touching_features 1"},
    {"cylinder_lying_in_box", "parallel_faces 4, generators_along_faces 4"},
    {"cylinder_standing_on_plane", "parallel_faces 2, coplanar_faces 1, supporting_faces 1, face_on_face 1, touching_features 1"},
    {"cylinder_lying_on_plane", "generators_along_faces 1, supporting_faces 1, generator_on_face 1, touching_features 1"},
    {"cylinder_under_plane", "parallel_faces 2"},
    {"rim_on_plane", "supporting_faces 1, rim_on_face 1, touching_features 1"},
    {"rim_on_face", "generators_along_faces 4, supporting_faces 1, rim_on_face 1, touching_features 1"},
    {"rim_in_face", "generators_along_faces 4"},
    {"rim_on_rim", "parallel_axes 1, equal_radii 1, parallel_faces 4, coplanar_faces 1, supporting_faces 2, "
     "parallel_generators 1, tangent_generators 1, touching_features 1"},
    {"cylinders_equal", "equal_bodies 1, concentric 1, coaxial 1, parallel_axes 1, equal_radii 1, parallel_faces 4, "
     "coplanar_faces 2, parallel_generators 1"},
    {"cylinders_coaxial", "concentric 1, coaxial 1, parallel_axes 1, parallel_faces 4, parallel_generators 1"},
    {"cylinders_end_to_end", "coaxial 1, parallel_axes 1, parallel_faces 4, coplanar_faces 1, supporting_faces 2, "
     "parallel_generators 1, face_on_face 1, touching_features 1"},
    {"cylinders_side_by_side", "parallel_axes 1, parallel_faces 4, parallel_generators 1, tangent_generators 1, touching_features 1"},
    {"cylinders_crossed", "orthogonal_axes 1, generators_along_faces 4, touching_features 1"},
    {"cylinders_crossed_deep", "orthogonal_axes 1, generators_along_faces 4"},
    {"cylinder_axis_on_sphere", "concentric 1, centre_on_axis 1"},
    {"cylinder_on_capsule", "centre_on_axis 1, orthogonal_axes 1, intersecting_axes 1, generators_along_faces 2, "
     "supporting_faces 1, generator_on_face 1, touching_features 1"},
    {"apex_on_plane", "parallel_faces 1, supporting_faces 1, apex_on_face 1, touching_features 1"},
    {"apex_on_face", "centre_on_axis 1, parallel_faces 2, supporting_faces 1, apex_on_face 1, touching_features 1"},
    {"apex_in_face", "centre_on_axis 1, parallel_faces 2"},
    {"apex_on_apex", "coaxial 1, parallel_axes 1, equal_radii 1, parallel_faces 1, touching_features 1"},
    {"cone_standing_on_box", "centre_on_axis 1, parallel_faces 2, coplanar_faces 1, supporting_faces 2, face_on_face 1, "
     "touching_features 1"},
    {"cone_lying_on_plane", "generators_along_faces 1, supporting_faces 1, generator_on_face 1, touching_features 1"},
    {"cones_along_generators", "parallel_axes 1, equal_radii 1, parallel_faces 1, tangent_generators 1, touching_features 1"},
    {"cones_along_generators_deep", "parallel_axes 1, equal_radii 1, parallel_faces 1"},
    {"cones_equal", "equal_bodies 1, coaxial 1, parallel_axes 1, equal_radii 1, parallel_faces 1, coplanar_faces 1"},
    {"cone_in_cone", "coaxial 1, parallel_axes 1, parallel_faces 1"},
    {"cone_in_cylinder", "coaxial 1, parallel_axes 1, equal_radii 1, parallel_faces 2, coplanar_faces 1"},
    {"frustum_on_frustum", "coaxial 1, parallel_axes 1, equal_radii 2, parallel_faces 4, coplanar_faces 1, "
     "supporting_faces 2, face_on_face 1, touching_features 1"},
    {"frustum_on_plane", "generators_along_faces 1, supporting_faces 1, generator_on_face 1, touching_features 1"},
    {"ellipsoid_on_plane", "supporting_faces 1, tangent_to_face 1, touching_features 1"},
    {"ellipsoid_on_box", "supporting_faces 1, tangent_to_face 1, touching_features 1"},
    {"ellipsoids_at_poles", "touching_features 1"},
    {"ellipsoid_in_sphere", "concentric 1"},
    {"ellipsoid_in_box", "concentric 1"},
    {"tapered_capsule_on_plane", "generators_along_faces 1, supporting_faces 1, generator_on_face 1, touching_features 1"},
    {"tapered_capsule_on_box", "centre_on_axis 1, supporting_faces 1, tangent_to_face 1, touching_features 1"},
    {"margins_touching", "equal_radii 1, parallel_faces 12, coplanar_faces 5, supporting_faces 2, distance_of_radii 1, "
     "face_on_face 1, touching_features 1"},
    {"margins_at_equality", "parallel_faces 12, tangent_generators 1, distance_of_radii 1, touching_features 1"},
    {"margin_of_nothing", "parallel_faces 12, coplanar_faces 3, supporting_faces 2, face_on_face 1, touching_features 1"},
    {"rounded_cylinder_on_plane", "parallel_faces 2, coplanar_faces 1, supporting_faces 1, face_on_face 1, touching_features 1"},
    {"sum_on_plane", "parallel_faces 2, coplanar_faces 1, supporting_faces 1, face_on_face 1, touching_features 1"},
    {"sums_touching", "parallel_faces 12, coplanar_faces 1, supporting_faces 2, face_on_face 1, touching_features 1"},
};
// clang-format on

TEST(ShapeStudy, OfTheCatalogueIsAsByHand) {
  for (const families::ShapeCatalogueEntry& entry : families::shape_catalogue()) {
    const Case pair = entry.shapes.read();
    const Shape a = files::shape_of(pair.a), b = files::shape_of(pair.b);
    const ShapeStudy found = study_of(a, b);
    const auto known = of_catalogue.find(pair.id);
    if (known == of_catalogue.end()) {
      ADD_FAILURE() << pair.id << " is not in the table";
      continue;
    }
    EXPECT_EQ(names(found), known->second) << pair.id << ": " << entry.description;
  }
}

// A law for each kind: what is found does not depend on who is A, or where both are.
TEST(ShapeStudy, DoesNotDependOnThePose) {
  const Pose pose = rigid_pose({3, 1, 2, -1}, {mpq_class(1, 3), -2, mpq_class(5, 7)});
  for (const families::ShapeCatalogueEntry& entry : families::shape_catalogue()) {
    if (!entry.shapes.id.starts_with("c")) continue;  // a half, which are cylinders, capsules and cones
    const Case pair = entry.shapes.read();
    const Shape a = files::shape_of(pair.a), b = files::shape_of(pair.b);
    EXPECT_EQ(names(study_of(moved(b, pose), moved(a, pose))), of_catalogue.find(pair.id)->second) << pair.id;
  }
}

TEST(ShapeStudy, OfGeneralPositionNamesNothing) {
  testing::ShapeMaker maker{families::Random(5), 30};
  for (int i = 0; i < 100; ++i) {
    const Shape a = maker.posed(maker.any_shape(), 2), b = maker.posed(maker.any_shape(), 2);
    EXPECT_EQ(names(study_of(a, b)), "") << i;
  }
}

TEST(ShapeStudy, OfPolytopesFindsWhatTheirOwnStudyFinds) {
  std::uint64_t faces = 0, coplanar = 0, along = 0;
  for (const Case& input : testing::cases_of_all_families(2, 8)) {
    const Study known = fathom::study(input.a.points, input.b.points);
    const ShapeStudy found = study(hull(input.a.points), hull(input.b.points));
    EXPECT_EQ(count(found, ShapeCoincidence::parallel_faces),
              known[Coincidence::coincident_normals].count + known[Coincidence::equal_normals].count)
        << input.id;
    EXPECT_EQ(count(found, ShapeCoincidence::coplanar_faces), known[Coincidence::coplanar_facets].count) << input.id;
    EXPECT_EQ(count(found, ShapeCoincidence::generators_along_faces), known[Coincidence::normals_on_arcs].count)
        << input.id;
    EXPECT_EQ(count(found, ShapeCoincidence::touching_features), known.depth.status() == Status::touching ? 1U : 0U)
        << input.id;
    ASSERT_TRUE(found.cores) << input.id;
    for (std::size_t i = 0; i < coincidence_names.size(); ++i)
      EXPECT_EQ(found.cores->coincidences[i].count, known.coincidences[i].count)
          << input.id << ": " << coincidence_names[i];
    faces += count(found, ShapeCoincidence::parallel_faces);
    coplanar += count(found, ShapeCoincidence::coplanar_faces);
    along += count(found, ShapeCoincidence::generators_along_faces);
  }
  EXPECT_GT(faces, 100U);
  EXPECT_GT(coplanar, 20U);
  EXPECT_GT(along, 20U);
}

TEST(ShapeStudy, FeaturesThatTouchAreTheLeast) {
  const Shape cube = box({1, 1, 1});
  const auto words = [&](const Point& place) {
    const ShapeStudy found = study_of(cube, moved(cube, rigid_pose({1, 0, 0, 0}, place)));
    EXPECT_EQ(found.depth.status(), Status::touching);
    return std::string(found.contact->a.what) + " " + std::string(found.contact->b.what);
  };
  EXPECT_EQ(words({2, 0, 0}), "face face");
  EXPECT_EQ(words({2, 2, 0}), "edge edge");
  EXPECT_EQ(words({2, 2, 2}), "vertex vertex");
}

// One pair that has it, beside one that misses it by a hair.
TEST(ShapeStudy, NoToleranceDecides) {
  const mpq_class hair = families::times_power_of_two(1, -300);
  const auto at = [](const Shape& shape, const Point& place) { return moved(shape, rigid_pose({1, 0, 0, 0}, place)); };
  const auto both = [&](ShapeCoincidence kind, const Shape& a, const auto& b_off_by) {
    const mpq_class zero = 0;
    return std::pair(count(study_of(a, b_off_by(zero)), kind), count(study_of(a, b_off_by(hair)), kind));
  };
  const auto expect_one = [&](ShapeCoincidence kind, const Shape& a, const auto& b_off_by) {
    EXPECT_EQ(both(kind, a, b_off_by), std::pair(std::uint64_t{1}, std::uint64_t{0}))
        << shape_coincidence_names[static_cast<std::size_t>(kind)];
  };
  const Shape drum = cylinder(1, 3), egg = ellipsoid({1, 2, 3});
  expect_one(ShapeCoincidence::concentric, egg, [&](const mpq_class& e) { return at(box({1, 1, 1}), {e, 0, 0}); });
  expect_one(ShapeCoincidence::centre_on_axis, drum, [&](const mpq_class& e) { return at(egg, {e, 0, 7}); });
  expect_one(ShapeCoincidence::coaxial, drum, [&](const mpq_class& e) { return at(cone(1, 1), {0, e, 5}); });
  expect_one(ShapeCoincidence::parallel_axes, drum, [&](const mpq_class& e) {
    return moved(cone(1, 1), rigid_pose({1, e, 0, 0}, {5, 0, 0}));
  });
  expect_one(ShapeCoincidence::orthogonal_axes, drum, [&](const mpq_class& e) {
    return moved(cone(1, 1), rigid_pose({1, 1 + e, 0, 0}, {5, 0, 0}));
  });
  expect_one(ShapeCoincidence::intersecting_axes, drum, [&](const mpq_class& e) {
    return at(cone(1, 1, Axis::x), {0, e, 0});
  });
  expect_one(ShapeCoincidence::equal_radii, drum, [&](const mpq_class& e) { return sphere(1 + e); });
  expect_one(ShapeCoincidence::parallel_generators, drum, [&](const mpq_class& e) {
    return moved(capsule(1, 1), rigid_pose({1, 0, e, 0}, {5, 0, 0}));
  });
  expect_one(ShapeCoincidence::tangent_generators, drum, [&](const mpq_class& e) {
    return at(capsule(1, 1), {2 + e, 0, 0});
  });
  expect_one(ShapeCoincidence::tangent_generators, drum, [&](const mpq_class& e) {
    return at(capsule(mpq_class(1, 2), 1), {mpq_class(1, 2) + e, 0, 0});
  });
  expect_one(ShapeCoincidence::tangent_generators, capsule(mpq_class(1, 2), 1), [&](const mpq_class& e) {
    return at(drum, {mpq_class(1, 2) + e, 0, 0});
  });
  expect_one(ShapeCoincidence::supporting_faces, drum, [&](const mpq_class& e) {
    return at(sphere(1), {9, 0, 4 + e});
  });
  expect_one(ShapeCoincidence::distance_of_radii, capsule(1, 1), [&](const mpq_class& e) {
    return at(sphere(1), {2 + e, 0, 0});
  });
  expect_one(ShapeCoincidence::touching_cores, sphere(1), [&](const mpq_class& e) { return at(sphere(2), {e, 0, 0}); });
}

// Centres, axes and faces against the support function, by their definitions.

mpq_class random_rational(families::Random& random) {
  return families::ratio(random.between(-9, 9), random.between(1, 5));
}

Vector random_direction(families::Random& random) {
  for (;;) {
    const Vector v{mpz_class(random.between(-9, 9)), mpz_class(random.between(-9, 9)),
                   mpz_class(random.between(-9, 9))};
    if (!is_zero(v)) return v;
  }
}

TEST(RootSum, IsZeroWhereTheNumberIs) {
  families::Random random(3);
  int zeros = 0;
  for (int i = 0; i < 20000; ++i) {
    RootSum sum;
    double value = 0;
    for (int k = 0; k < 4; ++k) {
      const mpq_class factor(random.between(-3, 3));
      const mpq_class square = mpq_class(random.between(0, 12)) * families::ratio(1, k == 3 ? 4 : 1);
      sum.add(factor, square);
      value += factor.get_d() * std::sqrt(square.get_d());
    }
    EXPECT_EQ(sum.is_zero(), std::fabs(value) < 1e-12) << i;  // so small numbers are 0 or farther from it
    zeros += sum.is_zero() ? 1 : 0;
  }
  EXPECT_GT(zeros, 50);
}

TEST(RootVector, IsParallelToItsMultiplesAlone) {
  const RootVector u{{1, 0, 0}, {0, 1, 0}, 2}, v{{1, 0, 0}, {}, 0}, w{{0, 2, 0}, {1, 0, 0}, 2};  // w = sqrt(2) u
  EXPECT_TRUE(parallel(u, u) && parallel(u, w) && parallel(w, u) && parallel(v, v));
  EXPECT_TRUE(parallel(u, {{3, 0, 0}, {0, mpq_class(3, 2), 0}, 8}));  // 3 u
  EXPECT_FALSE(parallel(u, v) || parallel(v, u) || parallel(w, v) || parallel(u, {{1, 0, 0}, {0, 1, 0}, 3}));
  EXPECT_FALSE(parallel(u, {{1, 0, 0}, {0, -1, 0}, 2}));
}

RootSum height(const ShapeSolid& solid, const Vector& u) { return support_face(solid.terms(), u).height; }

/// Whether h(u) - <c,u> has the same value at -u.
bool mirrored(const ShapeSolid& solid, const RationalVector& c, const Vector& u) {
  RootSum difference = height(solid, u);
  difference.add(height(solid, -u), -1);
  difference.add(-2 * dot(c, rational_vector(u)));
  return difference.is_zero();
}

/// The rotation v -> q v q^-1 of a direction, as an integer vector of another length: times |q|^2.
Vector turned(const Vector& axis, const mpz_class& w, const Vector& u) {
  const Vector c = cross(axis, u);
  const mpz_class square = w * w - dot(axis, axis), along = 2 * dot(axis, u), twice = 2 * w;
  return {square * u.x + along * axis.x + twice * c.x, square * u.y + along * axis.y + twice * c.y,
          square * u.z + along * axis.z + twice * c.z};
}

/// Whether h, seen from the axis, is the same in two directions that a turn about the axis maps to
/// each other.
bool turns(const ShapeSolid& solid, const Line& axis, const Vector& u, const mpz_class& w) {
  const mpz_class length = w * w + dot(axis.direction, axis.direction);
  const Vector v = turned(axis.direction, w, u);
  EXPECT_EQ(dot(v, v), length * length * dot(u, u));
  RootSum difference = height(solid, v);
  difference.add(-dot(axis.point, rational_vector(v)));
  difference.add(height(solid, u), -length);
  difference.add(length * dot(axis.point, rational_vector(u)));
  return difference.is_zero();
}

TEST(ShapeSolid, CentresAndAxesAreThoseOfTheSupport) {
  const std::set<std::string_view> with_centre{"ellipsoid",        "cylinder",        "box",           "disc", "ball",
                                               "rounded_cylinder", "ellipsoid + box", "flat ellipsoid"};
  const std::set<std::string_view> with_axis{"cylinder", "cone", "frustum", "tapered_capsule", "rounded_cylinder"};
  testing::ShapeMaker maker{families::Random(11), 20};
  for (int i = 0; i < 20; ++i) {
    for (const std::string_view kind : testing::ShapeMaker::kinds) {
      const ShapeSolid solid = solid_of(maker.posed(maker.shape(kind), 3));
      EXPECT_EQ(solid.centre.has_value(), with_centre.contains(kind)) << kind;
      EXPECT_EQ(solid.axis.has_value(), with_axis.contains(kind)) << kind;
      for (int k = 0; k < 10; ++k) {
        const Vector u = random_direction(maker.random);
        EXPECT_TRUE(!solid.centre || mirrored(solid, *solid.centre, u)) << kind;
        EXPECT_TRUE(!solid.axis || turns(solid, *solid.axis, u, 2)) << kind;
      }
    }
  }
}

// Affine images of balls and discs whose axes are not orthogonal: of revolution as a set.
TEST(ShapeSolid, FindsTheAxisOfASpheroidInAnyForm) {
  families::Random random(17);
  for (int i = 0; i < 200; ++i) {
    const Quaternion q{random_rational(random), random_rational(random), random_rational(random), mpq_class(1)};
    const mpq_class thick = families::ratio(random.between(1, 9), 4),
                    high = thick + families::ratio(random.between(1, 9), 4);
    const Shape egg = moved(ellipsoid({thick, thick, high}), rigid_pose(q, {1, 2, 3}));
    const ShapeSolid solid = solid_of(egg);
    ASSERT_TRUE(solid.axis) << i;
    // The same set by other axes: those of a turn of the unit ball.
    Shape other = egg;
    Atom& atom = std::get<std::vector<Term>>(other.core).front().atoms.front();
    const std::vector<Point> m = atom.axes;
    const auto mix = [](const mpq_class& s, const Point& p, const mpq_class& t, const Point& r) {
      return Point{s * p.x + t * r.x, s * p.y + t * r.y, s * p.z + t * r.z};
    };
    const mpq_class c(3, 5), s(4, 5);
    atom.axes = {mix(c, m[0], s, m[2]), m[1], mix(-s, m[0], c, m[2])};
    const ShapeSolid again = solid_of(other);
    ASSERT_TRUE(again.axis) << i;
    EXPECT_TRUE(again.axis->direction == solid.axis->direction || again.axis->direction == -solid.axis->direction) << i;
    EXPECT_FALSE(solid_of(moved(ellipsoid({thick, high, high + thick}), rigid_pose(q, {}))).axis) << i;
  }
}

TEST(ShapeSolid, AnEllipticCylinderHasNoAxis) {
  Shape drum = cylinder(1, 2);
  for (Atom& atom : std::get<std::vector<Term>>(drum.core).front().atoms)
    atom.axes = {{1, 1, 0}, {-2, 2, 0}};  // as wide along x as along y
  const ShapeSolid solid = solid_of(drum);
  EXPECT_FALSE(solid.axis);
  EXPECT_TRUE(solid.centre);
  ASSERT_EQ(solid.sides.size(), 1U);
  EXPECT_FALSE(solid.sides.front().radius);
}

TEST(ShapeSolid, FacesOfNamedShapes) {
  const auto faces = [](const Shape& shape) { return solid_of(shape).faces.size(); };
  EXPECT_EQ(faces(box({1, 2, 3})), 6U);
  EXPECT_EQ(faces(with_margin(box({1, 2, 3}), 1)), 6U);
  EXPECT_EQ(faces(cylinder(1, 2)), 2U);
  EXPECT_EQ(faces(cone(1, 2)), 1U);
  EXPECT_EQ(faces(frustum(1, 2, 2)), 2U);
  EXPECT_EQ(faces(sphere(1)) + faces(capsule(1, 2)) + faces(ellipsoid({1, 2, 3})) + faces(tapered_capsule(1, 2, 3)),
            0U);
  EXPECT_EQ(faces(triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})), 2U);
  EXPECT_EQ(faces(halfspace({2, 0, 4}, 1)), 1U);
  EXPECT_EQ(faces(minkowski_sum(cylinder(1, 2), box({1, 1, 1}))), 6U);  // as of a box with rounded edges along z
  EXPECT_EQ(faces(minkowski_sum(cylinder(1, 2), cylinder(1, 2, Axis::x))), 6U);
  EXPECT_EQ(faces(minkowski_sum(ellipsoid({1, 2, 3}), box({1, 1, 1}))), 6U);
}

}  // namespace
}  // namespace fathom::studies
