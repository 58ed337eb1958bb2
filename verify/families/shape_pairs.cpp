// SPDX-License-Identifier: GPL-3.0-or-later
// Finds a lowest point of A and a highest point of B in some direction, approximately if roots are
// irrational, and moves B so that they lie in line. Along coordinate axes the points are exact for
// bodies turned by symmetries of the cube: those pairs touch exactly.
#include "verify/families/shape_pairs.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "kernels/vector.hpp"
#include "reference/files/pose.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {
namespace {

constexpr unsigned bits_of_turns = 20;
constexpr long bits_of_places = 40, bits_of_roots = 60;

/// In [1/4, 2].
mpq_class random_length(Random& random) { return ratio(random.between(1 << 8, 1 << 11), 1 << 10); }

Axis random_axis(Random& random) { return static_cast<Axis>(random.between(0, 2)); }

NamedBody with_two_lengths(const char* shape, Random& random) {
  const Axis axis = random_axis(random);
  return named(shape, {{"radius", {random_length(random)}}, {"half_length", {random_length(random)}}}, axis);
}

NamedBody with_two_ends(const char* shape, Random& random) {
  const Axis axis = random_axis(random);
  return named(shape,
               {{"radius_low", {random_length(random)}},
                {"radius_high", {random_length(random)}},
                {"half_length", {random_length(random)}}},
               axis);
}

std::vector<mpq_class> three_lengths(Random& random) {
  return {random_length(random), random_length(random), random_length(random)};
}

NamedBody random_hull(Random& random, unsigned n) {
  std::vector<Point> vertices;
  for (unsigned i = 0; i < std::max(4U, n); ++i) vertices.push_back(random_shift(random, 1));
  return named_hull(std::move(vertices));
}

NamedBody random_triangle(Random& random) {
  NamedBody body = random_hull(random, 4);
  body.shape = "triangle";
  body.fields.vertices.pop_back();
  return body;
}

Quaternion random_turn(Random& random) {
  const auto part = [&random] { return random_dyadic(random, -1, 1, bits_of_turns); };
  Quaternion q{part(), part(), part(), part()};
  if (q == Quaternion{0, 0, 0, 0}) q.w = 1;
  return q;
}

/// A symmetry of the cube.
Quaternion aligned_turn(Random& random) {
  static const std::array<Quaternion, 10> turns{{{1, 0, 0, 0},
                                                 {1, 1, 0, 0},
                                                 {1, 0, 1, 0},
                                                 {1, 0, 0, 1},
                                                 {0, 1, 0, 0},
                                                 {0, 0, 1, 0},
                                                 {1, 1, 1, 1},
                                                 {1, -1, 1, 1},
                                                 {0, 1, 1, 0},
                                                 {0, 1, 0, 1}}};
  return turns[random.next() % turns.size()];
}

NamedBody random_body(ShapeKind kind, Random& random, unsigned n);

NamedBody random_sum(Random& random) {
  constexpr std::array kinds{ShapeKind::capsule, ShapeKind::box, ShapeKind::cylinder, ShapeKind::cone,
                             ShapeKind::ellipsoid};
  std::vector<NamedBody> terms;
  for (int i = 0; i < 2; ++i) {
    NamedBody term = random_body(kinds[random.next() % kinds.size()], random, 4);
    term.turn = aligned_turn(random);
    terms.push_back(std::move(term));
  }
  return named_sum(std::move(terms));
}

NamedBody random_body(ShapeKind kind, Random& random, unsigned n) {
  const auto with_margin = [&random](NamedBody body) { return rounded(std::move(body), random_length(random) / 4); };
  switch (kind) {
    case ShapeKind::sphere: return named("sphere", {{"radius", {random_length(random)}}});
    case ShapeKind::capsule: return with_two_lengths("capsule", random);
    case ShapeKind::tapered_capsule: return with_two_ends("tapered_capsule", random);
    case ShapeKind::box: return named("box", {{"half", three_lengths(random)}});
    case ShapeKind::rounded_box: return with_margin(random_body(ShapeKind::box, random, n));
    case ShapeKind::cylinder: return with_two_lengths("cylinder", random);
    case ShapeKind::rounded_cylinder: return with_margin(random_body(ShapeKind::cylinder, random, n));
    case ShapeKind::cone: return with_two_lengths("cone", random);
    case ShapeKind::rounded_cone: return with_margin(random_body(ShapeKind::cone, random, n));
    case ShapeKind::frustum: return with_two_ends("frustum", random);
    case ShapeKind::ellipsoid: return named("ellipsoid", {{"radii", three_lengths(random)}});
    case ShapeKind::hull: return random_hull(random, n);
    case ShapeKind::rounded_hull: return with_margin(random_hull(random, n));
    case ShapeKind::rounded_triangle: return with_margin(random_triangle(random));
    case ShapeKind::sum: break;
  }
  return random_sum(random);
}

NamedBody stretched(NamedBody body, Random& random) {
  for (auto& [name, values] : body.fields.numbers)
    for (mpq_class& value : values) value = times_power_of_two(value, random.between(-8, 8));
  for (NamedBody& term : body.terms) term = stretched(std::move(term), random);
  return body;
}

// ---- lowest and highest points ----

/// Rounded down to a multiple of 2^-60; so exact if it is one.
mpq_class root(const mpq_class& square) {
  const mpq_class scaled = times_power_of_two(square, 2 * bits_of_roots);
  mpz_class whole = scaled.get_num() / scaled.get_den();
  mpz_sqrt(whole.get_mpz_t(), whole.get_mpz_t());
  return times_power_of_two(whole, -bits_of_roots);
}

/// A highest point of the atom, and its height.
std::pair<Point, mpq_class> highest(const Atom& atom, const Point& u) {
  std::vector<mpq_class> along;
  mpq_class square = 0;
  for (const Point& axis : atom.axes) {
    along.push_back(dot(axis, u));
    square += along.back() * along.back();
  }
  const mpq_class length = root(square);
  Point top = atom.center;
  if (length != 0)
    for (std::size_t i = 0; i < along.size(); ++i) top = top + (along[i] / length) * atom.axes[i];
  return {top, dot(atom.center, u) + length};
}

/// Returns a point of the shape, which must not be a half-space, that is highest in direction u;
/// approximately if roots are irrational.
Point highest(const Shape& shape, const Point& u) {
  Point result = (shape.radius / root(dot(u, u))) * u;
  for (const Term& term : std::get<std::vector<Term>>(shape.core)) {
    std::pair<Point, mpq_class> best = highest(term.atoms.front(), u);
    for (const Atom& atom : term.atoms)
      if (std::pair<Point, mpq_class> other = highest(atom, u); other.second > best.second) best = std::move(other);
    result = result + best.first;
  }
  return result;
}

mpq_class to_grid(const mpq_class& value) {
  const mpq_class scaled = times_power_of_two(value, bits_of_places) + ratio(1, 2);
  mpz_class whole;
  mpz_fdiv_q(whole.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  return times_power_of_two(whole, -bits_of_places);
}

// ---- pairs ----

/// How two bodies are to meet.
struct Encounter {
  bool aligned = false;
  mpq_class overlap;
};

Encounter random_encounter(Random& random) {
  const std::int64_t what = random.between(0, 4);
  const bool aligned = what == 0 || random.next() % 4 == 0;
  const mpq_class hair = times_power_of_two(1, -random.between(4, 30)), much = random_length(random);
  switch (what) {
    case 0: return {aligned, 0};
    case 1: return {aligned, hair};
    case 2: return {aligned, -hair};
    case 3: return {aligned, -much};
    default: break;
  }
  return {aligned, much};
}

Point random_direction(Random& random, bool aligned) {
  if (aligned) {
    Point u;
    const Axis axis = random_axis(random);
    (axis == Axis::x ? u.x : axis == Axis::y ? u.y : u.z) = random.coin() ? 1 : -1;
    return u;
  }
  const std::int64_t x = random.between(1, 40), y = random.between(-40, 40), z = random.between(-40, 40);
  return random.coin() ? Point{mpq_class(x), mpq_class(y), mpq_class(z)}
                       : Point{mpq_class(y), mpq_class(z), mpq_class(-x)};
}

void turn(NamedBody& body, Random& random, bool aligned) {
  body.turn = aligned ? aligned_turn(random) : random_turn(random);
}

NamedPair met(NamedBody a, NamedBody b, Random& random, const Encounter& encounter) {
  turn(a, random, encounter.aligned);
  turn(b, random, encounter.aligned);
  a.place = random_shift(random, 2);
  const Point u = random_direction(random, encounter.aligned), down = -u;
  const Point low = highest(shape_of(a), down), high = highest(shape_of(b), u);
  const Point place = low - high + (encounter.overlap / root(dot(u, u))) * u;
  b.place = {to_grid(place.x), to_grid(place.y), to_grid(place.z)};
  return {std::move(a), std::move(b)};
}

/// In [1/4, 2], with a small denominator.
mpq_class length(Random& random) { return ratio(random.between(16, 128), 64); }

/// In (-1, 1).
mpq_class part(Random& random) { return ratio(random.between(-15, 15), 16); }

/// In (0, 1).
mpq_class share(Random& random) { return ratio(random.between(1, 15), 16); }

Point rotated(const Point& p, const Quaternion& turn) { return files::placed(p, rigid_pose(turn, {})); }

/// Returns the vector that the rotation takes to (0, 0, 1).
Point upward(const Quaternion& turn) { return rotated({0, 0, 1}, {turn.w, -turn.x, -turn.y, -turn.z}); }

/// The body turned, and moved so that this point of it comes to O.
MeetingBody with_top(NamedBody body, const Quaternion& turn, const Point& top, const mpq_class& inner) {
  body = posed(std::move(body), turn, {});
  body.place = -rotated(top, turn);
  return {std::move(body), inner};
}

/// Adds a margin, by which the point at the top and the radius of the ball inside grow too.
MeetingBody with_margin(MeetingBody side, const mpq_class& margin) {
  side.body = rounded(std::move(side.body), margin);
  side.body.place.z -= margin;
  return {std::move(side.body), side.inner + margin};
}

/// Less than a right angle, about the x axis.
Quaternion tilt(Random& random) {
  const std::int64_t w = random.between(2, 4), x = random.between(-1, 1);
  return {mpq_class(w), mpq_class(x), 0, 0};
}

const Quaternion standing{1, 0, 0, 0}, lying{1, 1, 0, 0}, turned_over{0, 1, 0, 0};

/// A right triangle: p^2 + q^2 = s^2.
struct Triple {
  mpq_class p, q, s;
};

Triple random_triple(Random& random) {
  static const std::array<Triple, 4> triples{{{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}}};
  Triple triple = triples[random.next() % triples.size()];
  if (random.coin()) std::swap(triple.p, triple.q);
  const mpq_class scale = length(random) / 8;
  return {triple.p * scale, triple.q * scale, triple.s * scale};
}

/// About the y axis: turns (q, 0, p)/s into (0, 0, 1).
Quaternion turn_of(const Triple& triple) { return {triple.s + triple.p, 0, -triple.q, 0}; }

struct Lengths {
  mpq_class radius, half_length;
};
Lengths lengths(Random& random) { return {length(random), length(random)}; }

NamedBody with_lengths(const char* shape, const Lengths& of) {
  return named(shape, {{"radius", {of.radius}}, {"half_length", {of.half_length}}});
}

struct Block {
  Point half;
  NamedBody body;
};
Block block(Random& random) {
  const Point half{length(random), length(random), length(random)};
  return {half, named("box", {{"half", {half.x, half.y, half.z}}})};
}

mpq_class signed_as(const mpq_class& size, const mpq_class& sign) { return sign < 0 ? mpq_class(-size) : size; }

/// Returns a random signed depth of at most `allowed` >= 0.
mpq_class random_depth(Random& random, const mpq_class& allowed) {
  const std::int64_t what = random.between(0, allowed == 0 ? 2 : 4);
  const mpq_class hair = times_power_of_two(1, -random.between(4, 60));
  switch (what) {
    case 0: return 0;
    case 1: return -hair;
    case 2: return -length(random);
    case 3: return std::min(hair, allowed);
    default: break;
  }
  return allowed * ratio(random.between(1, 8), 8);
}

MeetingBody frustum_face(Random& random) {
  const mpq_class low = length(random), high = length(random), half_length = length(random);
  const mpq_class x = part(random) * high, least = std::min(low, high);
  NamedBody body = named("frustum", {{"radius_low", {low}}, {"radius_high", {high}}, {"half_length", {half_length}}});
  return with_top(std::move(body), standing, {x, 0, half_length},
                  std::clamp<mpq_class>(least - abs(x), 0, half_length));
}

MeetingBody rounded_hull_vertex(Random& random) {
  std::vector<Point> vertices{{}};
  for (int i = 0; i < 6; ++i) {
    Point p = random_shift(random, 1);
    p.z -= ratio(5, 4);
    vertices.push_back(std::move(p));
  }
  MeetingBody side{named_hull(std::move(vertices)), 0};
  return with_margin(std::move(side), length(random) / 4);
}

MeetingBody sum_face(Random& random) {
  MeetingBody first = cylinder_face(random), second = box_face(random);
  return {named_sum({std::move(first.body), std::move(second.body)}), first.inner + second.inner};
}

}  // namespace

ShapeKind random_kind(Random& random) { return static_cast<ShapeKind>(random.between(0, shape_kinds - 1)); }

NamedPair random_pair(ShapeKind a, ShapeKind b, Random& random, unsigned n) {
  NamedBody of_a = random_body(a, random, n), of_b = random_body(b, random, n);
  return met(std::move(of_a), std::move(of_b), random, random_encounter(random));
}

NamedPair prepared_hulls(Random& random, unsigned n) {
  Random of_size(n);
  NamedBody a = random_hull(of_size, n), b = random_hull(of_size, n);
  return met(std::move(a), std::move(b), random, random_encounter(random));
}

NamedPair stretched_pair(ShapeKind a, ShapeKind b, Random& random, unsigned n) {
  NamedBody of_a = stretched(random_body(a, random, n), random), of_b = stretched(random_body(b, random, n), random);
  return met(std::move(of_a), std::move(of_b), random, random_encounter(random));
}

NamedPair random_pair_with_plane(ShapeKind kind, Random& random, unsigned n) {
  NamedBody body = random_body(kind, random, n);
  const Encounter encounter = random_encounter(random);
  turn(body, random, encounter.aligned);
  body.place = random_shift(random, 2);
  const Point normal = random_direction(random, encounter.aligned);
  const Point low = highest(shape_of(body), -normal);
  const mpq_class offset = to_grid(dot(low, normal) + encounter.overlap * root(dot(normal, normal)));
  NamedBody plane = named("halfspace", {{"normal", {normal.x, normal.y, normal.z}}, {"offset", {offset}}});
  if (random.coin()) std::swap(body, plane);
  return {std::move(body), std::move(plane)};
}

MeetingBody sphere_cap(Random& random) {
  const mpq_class r = length(random);
  return with_top(named("sphere", {{"radius", {r}}}), standing, {0, 0, r}, r);
}

MeetingBody capsule_cap(Random& random) {
  const Lengths of = lengths(random);
  const Quaternion turn = tilt(random);
  return with_top(with_lengths("capsule", of), turn, Point{0, 0, of.half_length} + of.radius * upward(turn), of.radius);
}

MeetingBody capsule_side(Random& random) {
  const Lengths of = lengths(random);
  const Point on_axis{0, 0, part(random) * of.half_length};
  return with_top(with_lengths("capsule", of), lying, on_axis + of.radius * upward(lying), of.radius);
}

// The generator is a tangent of the circles in the plane of x and z: the radii differ by p, their
// centres are s apart.
MeetingBody tapered_side(Random& random) {
  const Triple triple = random_triple(random);
  const mpq_class high = length(random), low = high + triple.p, half_length = triple.s / 2, place = share(random);
  NamedBody body =
      named("tapered_capsule", {{"radius_low", {low}}, {"radius_high", {high}}, {"half_length", {half_length}}});
  const Quaternion turn = turn_of(triple);
  const mpq_class inner = low + place * (high - low);
  return with_top(std::move(body), turn, Point{0, 0, (2 * place - 1) * half_length} + inner * upward(turn), inner);
}

MeetingBody cylinder_face(Random& random) {
  const Lengths of = lengths(random);
  const mpq_class x = part(random) * of.radius;
  return with_top(with_lengths("cylinder", of), standing, {x, 0, of.half_length},
                  std::min(of.half_length, mpq_class(of.radius - abs(x))));
}

MeetingBody cylinder_barrel(Random& random) {
  const Lengths of = lengths(random);
  const mpq_class z = part(random) * of.half_length;
  return with_top(with_lengths("cylinder", of), lying, Point{0, 0, z} + of.radius * upward(lying),
                  std::min(of.radius, mpq_class(of.half_length - abs(z))));
}

MeetingBody cylinder_rim(Random& random) {
  const Lengths of = lengths(random);
  const std::int64_t w = random.between(2, 4), y = random.coin() ? 1 : -1;
  const Quaternion turn{mpq_class(w), 0, mpq_class(y), 0};
  return with_top(with_lengths("cylinder", of), turn, {signed_as(of.radius, upward(turn).x), 0, of.half_length}, 0);
}

// The cone over the largest disc about the point holds a ball of r h/(r + sqrt(r^2 + h^2)) at its
// base, and the root is less than r + h.
MeetingBody cone_base(Random& random) {
  const Lengths of = lengths(random);
  const mpq_class x = part(random) * of.radius, r = of.radius - abs(x), height = 2 * of.half_length * r / of.radius;
  return with_top(with_lengths("cone", of), turned_over, {x, 0, -of.half_length}, r * height / (2 * r + height));
}

// The plane is outside as long as the tangent of the tilt is at most 2 half_length / radius; it is
// at most 4/3.
MeetingBody cone_apex(Random& random) {
  Lengths of = lengths(random);
  of.half_length = std::max(of.half_length, of.radius);
  return with_top(with_lengths("cone", of), tilt(random), {0, 0, of.half_length}, 0);
}

// Radius p, height q. The normal of the generator meets the axis at the centre of a ball that
// touches the cone there; the ball may have to be smaller, so that it stays above the base.
MeetingBody cone_generator(Random& random) {
  const Triple triple = random_triple(random);
  const auto& [radius, height, s] = triple;
  const mpq_class half_length = height / 2, place = share(random), x = (1 - place) * radius;
  const mpq_class inner = std::min<mpq_class>(x * s / height, place * height / (1 + radius / s));
  return with_top(with_lengths("cone", {radius, half_length}), turn_of(triple), {x, 0, (2 * place - 1) * half_length},
                  inner);
}

// The ball is no larger than the radii of curvature at the pole, nor than the least radius.
MeetingBody ellipsoid_pole(Random& random) {
  const Point radii{length(random), length(random), length(random)};
  const mpq_class inner = std::min<mpq_class>({radii.x * radii.x / radii.z, radii.y * radii.y / radii.z, radii.z});
  return with_top(named("ellipsoid", {{"radii", {radii.x, radii.y, radii.z}}}), standing, {0, 0, radii.z}, inner);
}

MeetingBody box_face(Random& random) {
  const Block of = block(random);
  const mpq_class x = part(random) * of.half.x, y = part(random) * of.half.y;
  return with_top(of.body, standing, {x, y, of.half.z},
                  std::min<mpq_class>({of.half.x - abs(x), of.half.y - abs(y), of.half.z}));
}

MeetingBody box_edge(Random& random) {
  const Block of = block(random);
  const std::int64_t w = random.between(2, 4), x = random.coin() ? 1 : -1;
  const Quaternion turn{mpq_class(w), mpq_class(x), 0, 0};
  const mpq_class along = part(random) * of.half.x;
  return with_top(of.body, turn, {along, signed_as(of.half.y, upward(turn).y), of.half.z}, 0);
}

MeetingBody box_vertex(Random& random) {
  const Block of = block(random);
  const std::int64_t w = random.between(3, 5), x = random.coin() ? 1 : -2, y = random.coin() ? 2 : -1;
  const Quaternion turn{mpq_class(w), mpq_class(x), mpq_class(y), 0};
  const Point up = upward(turn);
  return with_top(of.body, turn, {signed_as(of.half.x, up.x), signed_as(of.half.y, up.y), of.half.z}, 0);
}

MeetingBody rounded_box_edge(Random& random) {
  MeetingBody side = box_edge(random);
  return with_margin(std::move(side), length(random) / 4);
}

MeetingBody plane(Random& random) {
  const mpq_class length_of_normal = length(random);
  return {named("halfspace", {{"normal", {mpq_class(0), mpq_class(0), length_of_normal}}, {"offset", {mpq_class(0)}}}),
          4};
}

MeetingBody any_side(Random& random) {
  constexpr std::array all{sphere_cap,       capsule_cap,         capsule_side, tapered_side, cylinder_face,
                           cylinder_barrel,  cylinder_rim,        cone_base,    cone_apex,    cone_generator,
                           frustum_face,     ellipsoid_pole,      box_face,     box_edge,     box_vertex,
                           rounded_box_edge, rounded_hull_vertex, sum_face};
  return all[random.next() % all.size()](random);
}

NamedPair meeting(MakeMeetingBody first, MakeMeetingBody second, Random& random) {
  MeetingBody of_a = first(random), of_b = second(random);
  if (random.coin()) std::swap(of_a, of_b);
  for (MeetingBody* side : {&of_a, &of_b}) {
    const std::int64_t w = random.between(1, 3), z = random.between(-3, 3);
    side->body = posed(std::move(side->body), {mpq_class(w), 0, 0, mpq_class(z)}, {});
  }
  const mpq_class depth = random_depth(random, of_a.inner + of_b.inner);
  const Quaternion turn{mpq_class(random.between(1, 5)), mpq_class(random.between(-5, 5)),
                        mpq_class(random.between(-5, 5)), mpq_class(random.between(-5, 5))};
  const Point shift = random_shift(random, 2);
  NamedBody a = posed(posed(std::move(of_a.body), turned_over, {0, 0, mpq_class(-depth)}), turn, shift);
  NamedBody b = posed(std::move(of_b.body), turn, shift);
  return {std::move(a), std::move(b), KnownDepth{{depth, 0}, rotated({0, 0, 1}, turn)}};
}

}  // namespace fathom::families
