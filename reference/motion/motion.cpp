// SPDX-License-Identifier: GPL-3.0-or-later
// A motion over an interval is a polynomial in 1-x and x, whose coefficients are products of what
// it is at both ends: so numbers stay integers, and no basis is changed.
//                                                                 [proofs/impact.md, lemmas 1 to 4]
#include "reference/motion/motion.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/files/pose.hpp"

namespace fathom::motion {
namespace {

using Four = std::array<mpz_class, 4>;

// ---- polynomials ----

mpz_class times(const mpz_class& x, const mpz_class& y) { return x * y; }
Vector times(const mpz_class& x, const Vector& v) { return x * v; }
Vector times(const Matrix& m, const Vector& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }
mpz_class plus(const mpz_class& x, const mpz_class& y) { return x + y; }
Vector plus(const Vector& u, const Vector& v) { return u + v; }

/// The product, by that of coefficients.
template <class S, class T, class Product>
auto product(const Over<S>& f, const Over<T>& g, Product of) {
  Over<decltype(of(f[0], g[0]))> result(f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < g.size(); ++j) result[i + j] = plus(result[i + j], of(f[i], g[j]));
  return result;
}
template <class S, class T>
auto product(const Over<S>& f, const Over<T>& g) {
  return product(f, g, [](const S& x, const T& y) { return times(x, y); });
}
Over<mpz_class> dot_product(const Over<Vector>& f, const Over<Vector>& g) {
  return product(f, g, [](const Vector& u, const Vector& v) { return dot(u, v); });
}
Over<Vector> cross_product(const Over<Vector>& f, const Over<Vector>& g) {
  return product(f, g, [](const Vector& u, const Vector& v) { return cross(u, v); });
}

Vector transposed_times(const Matrix& m, const Vector& v) {
  return Vector(Vector(v.x * m[0]) + Vector(v.y * m[1])) + Vector(v.z * m[2]);
}
Over<Vector> transposed_product(const Over<Matrix>& m, const Over<Vector>& f) {
  return product(m, f, transposed_times);
}

/// The same polynomial, as one of this degree: times (1-x) + x.
template <class T>
void raise(Over<T>& f, std::size_t coefficients) {
  while (f.size() < coefficients) {
    f.push_back(f.back());
    for (std::size_t i = f.size() - 2; i > 0; --i) f[i] = plus(f[i], f[i - 1]);
  }
}

// ---- quaternions ----

mpz_class dot4(const Four& p, const Four& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3]; }

/// |q|^2 times the rotation by q.
Matrix matrix_of(const Four& q) {
  const auto& [w, x, y, z] = q;
  const mpz_class ww = w * w, xx = x * x, yy = y * y, zz = z * z, xy = x * y, xz = x * z, yz = y * z, wx = w * x,
                  wy = w * y, wz = w * z;
  return {Vector{ww + xx - yy - zz, 2 * (xy - wz), 2 * (xz + wy)},
          Vector{2 * (xy + wz), ww - xx + yy - zz, 2 * (yz - wx)},
          Vector{2 * (xz - wy), 2 * (yz + wx), ww - xx - yy + zz}};
}

/// (1 - s/d) from + (s/d) to, times d.
template <class T>
T between(const T& from, const T& to, const mpz_class& s, const mpz_class& d) {
  return (d - s) * from + s * to;
}
Vector between(const Vector& from, const Vector& to, const mpz_class& s, const mpz_class& d) {
  return Vector(mpz_class(d - s) * from) + Vector(s * to);
}
Four between(const Four& from, const Four& to, const mpz_class& s, const mpz_class& d) {
  Four result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = between(from[i], to[i], s, d);
  return result;
}

/// Without a common factor.
Four reduced(Four q) {
  mpz_class g = gcd(gcd(q[0], q[1]), gcd(q[2], q[3]));
  for (mpz_class& c : q) c /= g;
  return q;
}

/// Whether p = s q for a rational s of this sign. Neither is O.
bool multiple(const Four& p, const Four& q, int sign) {
  const mpz_class product = dot4(p, q);
  return sgn(product) == sign && product * product == dot4(p, p) * dot4(q, q);
}

mpz_class scaled(const mpq_class& value, const mpz_class& denominator) {
  return value.get_num() * mpz_class(denominator / value.get_den());
}

void extend(mpz_class& denominator, const mpq_class& value) {
  kernels::require_lowest_terms(value);
  denominator = lcm(denominator, value.get_den());
}
void extend(mpz_class& denominator, const Point& p) {
  for (const mpq_class* c : {&p.x, &p.y, &p.z}) extend(denominator, *c);
}

Vector scaled(const Point& p, const mpz_class& denominator) {
  return {scaled(p.x, denominator), scaled(p.y, denominator), scaled(p.z, denominator)};
}

std::array<const mpq_class*, 4> parts(const Quaternion& q) { return {&q.w, &q.x, &q.y, &q.z}; }

std::array<Four, 2> scaled(const RigidMotion& motion) {
  mpz_class denominator = 1;
  for (const Quaternion* q : {&motion.q0, &motion.q1})
    for (const mpq_class* c : parts(*q)) extend(denominator, *c);
  std::array<Four, 2> result;
  for (std::size_t end = 0; end < 2; ++end)
    for (std::size_t i = 0; i < 4; ++i)
      result[end][i] = scaled(*parts(end == 0 ? motion.q0 : motion.q1)[i], denominator);
  const Four none{};
  if (result[0] == none || result[1] == none || multiple(result[0], result[1], -1))
    throw std::invalid_argument("the quaternion of a motion is 0 at some time between its ends");
  return result;
}

std::vector<Vector> scaled(std::span<const Point> points, const mpz_class& denominator) {
  std::vector<Vector> result;
  result.reserve(points.size());
  for (const Point& p : points) result.push_back(scaled(p, denominator));
  return result;
}

/// Whether the points span a line or a plane: two of them that differ, and a third off their line.
struct Span {
  std::size_t rank = 0;
  Vector along, normal;  ///< of the line; of the plane, in either sense
};
Span span_of(const kernels::PointCloud& points, const std::vector<std::uint32_t>& ids) {
  Span span;
  for (const std::uint32_t i : ids) {
    const Vector step = points[i] - points[ids[0]];
    if (is_zero(step)) continue;
    if (span.rank == 0) span.along = step, span.rank = 1;
    Vector normal = cross(span.along, step);
    if (is_zero(normal)) continue;
    return {2, primitive(span.along), primitive(normal)};
  }
  if (span.rank == 1) span.along = primitive(span.along);
  return span;
}

/// The vector with components of at most so many bits.
Vector shortened(const Vector& v, long bits) {
  const long more = kernels::bit_length(v) - bits;
  if (more <= 0) return v;
  const auto part = [&](const mpz_class& c) { return mpz_class((c + (mpz_class(1) << (more - 1))) >> more); };
  return {part(v.x), part(v.y), part(v.z)};
}

}  // namespace

/// [from / denominator, to / denominator].
struct MovingPair::Interval {
  Interval(const mpq_class& s, const mpq_class& e) : denominator(lcm(s.get_den(), e.get_den())) {
    from = scaled(s, denominator);
    to = scaled(e, denominator);
  }
  mpz_class denominator, from, to;
};

MovingPair::MovingPair(std::span<const Point> a, const RigidMotion& of_a, std::span<const Point> b,
                       const RigidMotion& of_b) {
  if (a.empty() || b.empty()) throw std::invalid_argument("a body that moves has no points");
  const auto include = [&](const Point& p) {
    extend(denominator_, p);
    for (const mpq_class* c : {&p.x, &p.y, &p.z}) extent_ = std::max(extent_, mpq_class(abs(*c)));
  };
  for (const Point& p : a) include(p);
  for (const Point& p : b) include(p);
  for (const Point* p : {&of_a.p0, &of_a.p1, &of_b.p0, &of_b.p1}) include(*p);
  const auto mover = [&](std::span<const Point> points, const RigidMotion& motion) {
    std::array<Four, 2> q = scaled(motion);
    const bool turns = !multiple(q[0], q[1], 1);
    if (!turns) q[0] = reduced(q[0]);
    return Mover{std::move(q),
                 {scaled(motion.p0, denominator_), scaled(motion.p1, denominator_)},
                 turns,
                 kernels::PointCloud(scaled(points, denominator_))};
  };
  a_ = mover(a, of_a);
  b_ = mover(b, of_b);
}

MotionOver MovingPair::over(const Mover& mover, const Interval& interval) {
  const auto& [denominator, s, e] = interval;
  MotionOver result;
  if (mover.turns) {
    const Four from = between(mover.q[0], mover.q[1], s, denominator),
               to = between(mover.q[0], mover.q[1], e, denominator);
    Four sum;
    for (std::size_t i = 0; i < 4; ++i) sum[i] = from[i] + to[i];
    const Matrix at_from = matrix_of(from), at_to = matrix_of(to);
    Matrix middle = matrix_of(sum);
    for (std::size_t i = 0; i < 3; ++i) middle[i] = middle[i] - at_from[i] - at_to[i];
    result.weight = {dot4(from, from), 2 * dot4(from, to), dot4(to, to)};
    result.matrix = {at_from, middle, at_to};
  } else {
    result.weight = {dot4(mover.q[0], mover.q[0])};
    result.matrix = {matrix_of(mover.q[0])};
  }
  if (mover.p[0] == mover.p[1]) result.place = {Vector(denominator * mover.p[0])};
  else
    result.place = {between(mover.p[0], mover.p[1], s, denominator), between(mover.p[0], mover.p[1], e, denominator)};
  return result;
}

GapOver MovingPair::gap(const MovingPlane& plane, const Interval& interval) const {
  const MotionOver a = over(a_, interval), b = over(b_, interval);
  Over<Vector> d = a.place, minus = b.place;
  raise(d, minus.size());
  raise(minus, d.size());
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = d[i] - minus[i];
  const Over<Vector> first{plane.first}, second{plane.second};
  GapOver result;
  if (plane.kind == MovingPlane::Kind::of_b) {
    const Over<Vector> n = product(b.matrix, first);
    result = {product(a.weight, dot_product(n, d)), transposed_product(a.matrix, n),
              product(product(a.weight, b.weight), first)};
  } else if (plane.kind == MovingPlane::Kind::of_a) {
    const Over<Vector> n = product(a.matrix, first);
    result = {product(b.weight, dot_product(n, d)), product(product(a.weight, b.weight), first),
              transposed_product(b.matrix, n)};
  } else {
    const Over<Vector> f = product(a.matrix, first), g = product(b.matrix, second);
    result = {dot_product(cross_product(f, g), d), cross_product(first, transposed_product(a.matrix, g)),
              cross_product(transposed_product(b.matrix, f), second)};
  }
  const std::size_t most = std::max({result.constant.size(), result.of_a.size(), result.of_b.size()});
  raise(result.constant, most);
  raise(result.of_a, most);
  raise(result.of_b, most);
  for (Over<Vector>* side : {&result.of_a, &result.of_b})
    for (Vector& v : *side) v = interval.denominator * v;
  return result;
}

Holding MovingPair::holding(const MovingPlane& plane, const mpq_class& s, const mpq_class& e) const {
  const GapOver gap = this->gap(plane, Interval(s, e));
  const auto value = [&](std::size_t k, std::uint32_t i, std::uint32_t j) {
    return mpz_class(gap.constant[k] + dot(gap.of_a[k], a_.points[i]) - dot(gap.of_b[k], b_.points[j]));
  };
  for (std::size_t k = gap.constant.size(); k-- > 0;) {  // the end of the interval is what most often fails
    const std::uint32_t i = extreme_points(a_.points, -gap.of_a[k]).front(),
                        j = extreme_points(b_.points, gap.of_b[k]).front();
    if (sgn(value(k, i, j)) > 0) continue;
    Holding result;
    for (std::size_t c = 0; c < gap.constant.size(); ++c) result.broken.push_back(value(c, i, j));
    return result;
  }
  return {true, {}};
}

polytope::PlacedPair MovingPair::at(const mpq_class& t) const {
  const mpz_class &s = t.get_num(), &d = t.get_den();
  struct Placed {
    mpz_class weight;
    Matrix matrix;
    Vector place;
  };
  const auto now = [&](const Mover& mover) {
    const Four q = mover.turns ? reduced(between(mover.q[0], mover.q[1], s, d)) : mover.q[0];
    return Placed{dot4(q, q), matrix_of(q), between(mover.p[0], mover.p[1], s, d)};
  };
  const Placed a = now(a_), b = now(b_);
  const auto points = [&](const Mover& mover, const Placed& own, const mpz_class& other) {
    const Vector origin = mpz_class(own.weight * other) * own.place;
    Matrix matrix = own.matrix;
    for (Vector& row : matrix) row = mpz_class(d * other) * row;
    std::vector<Vector> result;
    result.reserve(mover.points.size());
    for (const Vector& p : mover.points.points()) result.push_back(origin + times(matrix, p));
    return result;
  };
  return polytope::place_integers(points(a_, a, b.weight), points(b_, b, a.weight),
                                  denominator_ * d * a.weight * b.weight);
}

Vector MovingPair::direction(const MovingPlane& plane, const mpq_class& t) const {
  const Interval now(t, t);
  const Matrix a = over(a_, now).matrix.front(), b = over(b_, now).matrix.front();
  if (plane.kind == MovingPlane::Kind::of_b) return primitive(times(b, plane.first));
  if (plane.kind == MovingPlane::Kind::of_a) return primitive(times(a, plane.first));
  return primitive(cross(times(a, plane.first), times(b, plane.second)));
}

std::optional<MovingPlane> MovingPair::rounded(MovingPlane::Kind kind, const Vector& n, const mpq_class& t) const {
  for (const long bits : {16L, 32L, 64L, kernels::bit_length(n)}) {
    const MovingPlane plane{kind, primitive(shortened(n, bits)), {}};
    if (!is_zero(plane.first) && holding(plane, t, t).holds) return plane;
  }
  return std::nullopt;
}

std::vector<MovingPlane> MovingPair::planes(const mpq_class& t, const polytope::PlacedPair& placed,
                                            const Vector& n) const {
  const Interval now(t, t);
  const Matrix a = over(a_, now).matrix.front(), b = over(b_, now).matrix.front();
  const Vector n_a = transposed_times(a, n), n_b = transposed_times(b, n);
  const Span of_a = span_of(a_.points, extreme_points(placed.a, -n)),
             of_b = span_of(b_.points, extreme_points(placed.b, n));
  std::vector<MovingPlane> planes;
  const auto towards = [](const Vector& v, const Vector& u) { return sgn(dot(v, u)) < 0 ? Vector(-v) : v; };
  if (of_b.rank == 2) planes.push_back({MovingPlane::Kind::of_b, towards(of_b.normal, n_b), {}});
  if (of_a.rank == 2) planes.push_back({MovingPlane::Kind::of_a, towards(of_a.normal, n_a), {}});
  if (of_a.rank == 1 && of_b.rank == 1) {
    const Vector crossed = cross(times(a, of_a.along), times(b, of_b.along));
    if (!is_zero(crossed))
      planes.push_back(
          {MovingPlane::Kind::of_edges, sgn(dot(crossed, n)) < 0 ? Vector(-of_a.along) : of_a.along, of_b.along});
  }
  if (!planes.empty()) return planes;
  for (const auto& [kind, own] : {std::pair(MovingPlane::Kind::of_b, &n_b), std::pair(MovingPlane::Kind::of_a, &n_a)})
    if (std::optional<MovingPlane> plane = rounded(kind, *own, t)) planes.push_back(*std::move(plane));
  return planes;
}

}  // namespace fathom::motion

namespace fathom {

Pose pose_at(const RigidMotion& motion, const mpq_class& t) {
  const auto at = [&](const mpq_class& from, const mpq_class& to) { return mpq_class(from + t * (to - from)); };
  const auto& [q0, q1, p0, p1] = motion;
  return rigid_pose({at(q0.w, q1.w), at(q0.x, q1.x), at(q0.y, q1.y), at(q0.z, q1.z)},
                    {at(p0.x, p1.x), at(p0.y, p1.y), at(p0.z, p1.z)});
}

std::vector<Point> placed_at(std::span<const Point> points, const RigidMotion& motion, const mpq_class& t) {
  const Pose pose = pose_at(motion, t);
  std::vector<Point> result;
  result.reserve(points.size());
  for (const Point& p : points) result.push_back(files::placed(p, pose));
  return result;
}

std::string_view name(MovingPlane::Kind kind) {
  return kind == MovingPlane::Kind::of_b ? "face of B" : kind == MovingPlane::Kind::of_a ? "face of A" : "edges";
}

Vector direction_at(const MovingPlane& plane, const RigidMotion& of_a, const RigidMotion& of_b, const mpq_class& t) {
  const kernels::DefaultFloatEnvironment environment;
  return motion::MovingPair(std::vector<Point>(1), of_a, std::vector<Point>(1), of_b).direction(plane, t);
}

std::string_view name(ImpactStatus status) {
  switch (status) {
    case ImpactStatus::apart: return "apart";
    case ImpactStatus::contact: return "contact";
    case ImpactStatus::grazing: return "grazing";
    case ImpactStatus::at_beginning: return "at the beginning";
  }
  return "";
}

}  // namespace fathom
