// SPDX-License-Identifier: GPL-3.0-or-later
// A lowest point of A and a highest point of B in some direction are found, nearly where roots are
// irrational, and B is moved so that they lie in line. Along coordinate axes the points are exact
// for bodies turned by symmetries of the cube: those pairs touch exactly.

#include <algorithm>
#include <array>
#include <iterator>

#include "kernels/vector.hpp"
#include "verify/families/shape_pairs.hpp"
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

/// A point of the shape, which is no half-space, that is highest in direction u, nearly where roots
/// are irrational.
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

}  // namespace fathom::families
