// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include "verify/families/families.hpp"
#include "verify/families/shape_pairs.hpp"

namespace fathom::families {
namespace {

template <ShapeKind A, ShapeKind B>
NamedPair pair(Random& random, unsigned n) {
  return random_pair(A, B, random, n);
}

NamedPair with_plane(Random& random, unsigned n) {
  const ShapeKind kind = random_kind(random);
  return random_pair_with_plane(kind, random, n);
}

template <NamedPair (*Pair)(ShapeKind, ShapeKind, Random&, unsigned)>
NamedPair of_any_kinds(Random& random, unsigned n) {
  const ShapeKind a = random_kind(random), b = random_kind(random);
  return Pair(a, b, random, n);
}

template <MakeMeetingBody First, MakeMeetingBody Second>
NamedPair inverse(Random& random, unsigned /*n*/) {
  return meeting(First, Second, random);
}

constexpr unsigned points = 8;
using enum ShapeKind;

constexpr ShapeFamily table[] = {
    // Random pairs in doubles: deep, shallow, apart, touching.
    {"spheres", "two spheres", points, pair<sphere, sphere>},
    {"capsules", "two capsules", points, pair<capsule, capsule>},
    {"sphere_capsule", "a sphere against a capsule", points, pair<sphere, capsule>},
    {"capsule_box", "a capsule against a box", points, pair<capsule, box>},
    {"capsule_hull", "a capsule against a hull", points, pair<capsule, hull>},
    {"hulls_posed", "two hulls, the same two in every case of a size, in poses by quaternions", points, prepared_hulls},
    {"rounded_boxes", "two boxes with margins", points, pair<rounded_box, rounded_box>},
    {"rounded_hulls", "two hulls with margins", points, pair<rounded_hull, rounded_hull>},
    {"rounded_triangle_sphere", "a triangle with a margin against a sphere", points, pair<rounded_triangle, sphere>},
    {"tapered_capsules", "two hulls of two balls", points, pair<tapered_capsule, tapered_capsule>},
    {"tapered_capsule_box", "a hull of two balls against a box", points, pair<tapered_capsule, box>},
    {"cylinders", "two cylinders", points, pair<cylinder, cylinder>},
    {"cylinder_box", "a cylinder against a box", points, pair<cylinder, box>},
    {"cylinder_capsule", "a cylinder against a capsule", points, pair<cylinder, capsule>},
    {"rounded_cylinders", "two cylinders with margins", points, pair<rounded_cylinder, rounded_cylinder>},
    {"cones", "two cones", points, pair<cone, cone>},
    {"cone_box", "a cone against a box", points, pair<cone, box>},
    {"cone_cylinder", "a cone against a cylinder", points, pair<cone, cylinder>},
    {"frusta", "two cones that are cut off", points, pair<frustum, frustum>},
    {"ellipsoids", "two ellipsoids", points, pair<ellipsoid, ellipsoid>},
    {"ellipsoid_box", "an ellipsoid against a box", points, pair<ellipsoid, box>},
    {"ellipsoid_hull", "an ellipsoid against a hull", points, pair<ellipsoid, hull>},
    {"sums", "sums of two shapes", points, pair<ShapeKind::sum, ShapeKind::sum>},
    {"shapes_halfspace", "a shape of any kind against a half-space", points, with_plane},
    {"shapes_mixed", "shapes of any two kinds", points, of_any_kinds<random_pair>},
    {"shapes_stretched", "shapes of any two kinds, each length up to 256 times larger or smaller", points, of_any_kinds<stretched_pair>},
    // By inverse construction: first the contact and the signed depth, then the bodies, in exact rational poses.
    {"inverse_sphere_sphere", "two spheres", points, inverse<sphere_cap, sphere_cap>},
    {"inverse_cap_cap", "the ends of two capsules", points, inverse<capsule_cap, capsule_cap>},
    {"inverse_side_side", "the sides of two capsules: their segments are edge to edge", points, inverse<capsule_side, capsule_side>},
    {"inverse_side_face", "a capsule lies on a box", points, inverse<capsule_side, box_face>},
    {"inverse_tapered_sides", "generators of two hulls of two balls", points, inverse<tapered_side, tapered_side>},
    {"inverse_end_faces", "the end faces of two cylinders, in parallel planes", points, inverse<cylinder_face, cylinder_face>},
    {"inverse_face_on_face", "a cylinder stands on a box", points, inverse<cylinder_face, box_face>},
    {"inverse_barrels", "two cylinders lie across each other", points, inverse<cylinder_barrel, cylinder_barrel>},
    {"inverse_barrel_on_face", "a cylinder lies on a box", points, inverse<cylinder_barrel, box_face>},
    {"inverse_rim_on_face", "the rim of a cylinder on a box", points, inverse<cylinder_rim, box_face>},
    {"inverse_rim_on_barrel", "the rim of a cylinder on the barrel of another", points, inverse<cylinder_rim, cylinder_barrel>},
    {"inverse_rims", "the rims of two cylinders: they touch or are apart", points, inverse<cylinder_rim, cylinder_rim>},
    {"inverse_apex_on_face", "the apex of a cone on a box", points, inverse<cone_apex, box_face>},
    {"inverse_apexes", "the apexes of two cones: they touch or are apart", points, inverse<cone_apex, cone_apex>},
    {"inverse_generators", "generators of two cones across each other", points, inverse<cone_generator, cone_generator>},
    {"inverse_generator_on_base", "a cone lies on the base of another", points, inverse<cone_generator, cone_base>},
    {"inverse_vertex_on_cap", "the corner of a box on a sphere", points, inverse<box_vertex, sphere_cap>},
    {"inverse_edge_on_barrel", "the edge of a box across a cylinder", points, inverse<box_edge, cylinder_barrel>},
    {"inverse_poles", "the poles of two ellipsoids", points, inverse<ellipsoid_pole, ellipsoid_pole>},
    {"inverse_rounded_edges", "edges of two boxes with margins across each other", points, inverse<rounded_box_edge, rounded_box_edge>},
    {"inverse_plane", "any contact with a half-space", points, inverse<any_side, plane>},
    {"inverse_shapes", "any two contacts", points, inverse<any_side, any_side>},
};

}  // namespace

ShapeCase ShapeFamily::make(std::uint64_t seed, unsigned size) const {
  Random random = stream_of(name, seed);
  return {case_id(name, size, seed), build(random, size)};
}

std::span<const ShapeFamily> shape_families() { return table; }

const ShapeFamily* find_shape_family(std::string_view name) {
  const auto found = std::ranges::find(table, name, &ShapeFamily::name);
  return found == std::end(table) ? nullptr : &*found;
}

}  // namespace fathom::families
