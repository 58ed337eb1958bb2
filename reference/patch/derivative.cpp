// SPDX-License-Identifier: GPL-3.0-or-later
// The derivative of the signed depth along a motion: of each optimal direction the greatest rate at
// the corners of its patch, and of these the least; of unions that are apart the greatest.
#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "fathom/patch.hpp"
#include "kernels/number/fixed_integer.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/patch/patch.hpp"
#include "reference/rounded/optimal_cone.hpp"

namespace fathom::patch {
namespace {

/// How fast B moves against A, over one denominator. As <n, w x n> = 0, it does not matter along n
/// where a contact point is taken to be.
struct RelativeTwist {
  Vector v, w;
  mpz_class denominator = 1;
  long bits;  ///< of the largest component

  RelativeTwist(const Twist& of_a, const Twist& of_b) {
    for (const Twist* twist : {&of_a, &of_b})
      for (const Point* part : {&twist->v, &twist->w})
        for (const mpq_class* c : {&part->x, &part->y, &part->z})
          if (c->get_den() != 1) denominator = lcm(denominator, c->get_den());
    v = difference(of_b.v, of_a.v);
    w = difference(of_b.w, of_a.w);
    bits = std::max(kernels::bit_length(v), kernels::bit_length(w));
  }

 private:
  [[nodiscard]] Vector difference(const Point& p, const Point& q) const {
    const auto integer = [&](const mpq_class& c) {
      if (c.get_den() == denominator) return c.get_num();
      return mpz_class(c.get_num() * (denominator / c.get_den()));
    };
    const auto along = [&](const mpq_class& c, const mpq_class& d) {
      return sgn(d) == 0 ? integer(c) : mpz_class(integer(c) - integer(d));
    };
    return {along(p.x, q.x), along(p.y, q.y), along(p.z, q.z)};
  }
};

/// How fast B's point of a corner moves against A's.
Point relative_velocity(const Patch& patch, std::size_t corner, const Twist& of_a, const Twist& of_b) {
  return of_b.v + cross(of_b.w, patch.b(corner).core) - of_a.v - cross(of_a.w, patch.a(corner).core);
}

int compare(const DirectionalDerivative& x, const DirectionalDerivative& y) {
  if (x.sign() != y.sign()) return x.sign() < y.sign() ? -1 : 1;
  const auto square = [](const DirectionalDerivative& of, const DirectionalDerivative& other) {
    const mpz_class scaled = of.over * other.under;
    return mpz_class(scaled * scaled * dot(other.direction, other.direction));
  };
  return x.sign() * cmp(square(x, y), square(y, x));
}

// ---- of one patch ----

/// How fast B moves against A along n, in integers over one denominator.
template <class Integer>
struct MotionAlong {
  Vec3<Integer> n;
  Integer push;        ///< <n,v>
  Vec3<Integer> turn;  ///< n x w: <n, w x p> = <turn, p>

  MotionAlong(const Vec3<Integer>& n, const Vec3<Integer>& v, const Vec3<Integer>& w)
      : n(n), push(dot(n, v)), turn(cross(n, w)) {}
};

/// A rate along n, times |n|.
template <class Integer>
struct Quotient {
  Integer over, under;  ///< under > 0
};

/// At a corner that is a point, or where two edges cross along n, from p to q and from r to s:
/// points over one denominator.
template <class Integer>
Quotient<Integer> rate_at(const MotionAlong<Integer>& motion, const std::vector<Vec3<Integer>>& points,
                          const Integer& denominator) {
  const Vec3<Integer>& p = points[0];
  const Integer at_p(motion.push * denominator + dot(motion.turn, p));
  if (points.size() == 1) return {at_p, denominator};
  const Vec3<Integer> edge = points[1] - p, across = cross(points[3] - points[2], motion.n);
  Integer share = dot(points[2] - p, across), whole = dot(edge, across);
  if (sgn(whole) < 0) (whole = -whole, share = -share);
  return {Integer(whole * at_p + share * dot(motion.turn, edge)), Integer(denominator * whole)};
}

/// The points that a corner follows from.
std::span<const GivenPoint> points_of(const PatchCorner& corner, std::array<GivenPoint, 4>& crossing) {
  if (const auto* const a = std::get_if<CornerOfA>(&corner.meeting)) return {&a->point, 1};
  if (const auto* const b = std::get_if<CornerOfB>(&corner.meeting)) return {&b->point, 1};
  const CrossingEdges& edges = std::get<CrossingEdges>(corner.meeting);
  crossing = {edges.a[0], edges.a[1], edges.b[0], edges.b[1]};
  return crossing;
}

/// For points of P bits, a direction of N, a twist of T and a denominator of D bits, a rate has at
/// most 2 P + 2 N + T + max(P, D) + 10 bits over 2 P + N + D + 5. Two are compared by products of
/// these, whose points may differ in size.
constexpr long over_bits = 1152, under_bits = 768;
using Wide = kernels::FixedInteger<over_bits + under_bits>;

/// Of points in binary64, if that is wide enough.
std::optional<PointsOver<Wide>> in_wide(std::span<const GivenPoint> given, long direction_bits, long twist_bits) {
  const std::optional<BinaryRange> range = binary_range(given);
  if (!range) return std::nullopt;
  const long bits = range->high - range->low;
  if (2 * (bits + direction_bits) + twist_bits + std::max(bits, -range->low) + 10 > over_bits ||
      2 * bits + direction_bits - range->low + 5 > under_bits)
    return std::nullopt;
  return over_power_of_two<Wide>(given, range->low, Wide::shifted);
}

/// The greatest at the corners of a patch: the first corner that has it, and the rate. nullopt if
/// `points_over` has no integers for some points.
template <class Integer, class PointsOf>
std::optional<std::pair<std::size_t, Quotient<Integer>>> greatest_at(const Patch& patch,
                                                                     const MotionAlong<Integer>& motion,
                                                                     const PointsOf& points_over) {
  std::optional<std::pair<std::size_t, Quotient<Integer>>> best;
  for (std::size_t k = 0; k < patch.corners.size(); ++k) {
    std::array<GivenPoint, 4> crossing;
    const std::optional<PointsOver<Integer>> at = points_over(points_of(patch.corners[k], crossing));
    if (!at) return std::nullopt;
    Quotient<Integer> rate = rate_at(motion, at->points, at->denominator);
    if (best && cmp(Integer(rate.over * best->second.under), Integer(best->second.over * rate.under)) <= 0) continue;
    best = std::pair(k, std::move(rate));
  }
  return best;
}

/// The greatest at the corners of a patch, whose A moves along its direction.
DirectionalDerivative greatest(const Patch& patch, std::size_t index, const RelativeTwist& twist) {
  const Vector& n = patch.direction;
  const auto rate = [&](std::size_t corner, const mpz_class& over, const mpz_class& under) {
    return DirectionalDerivative{over, mpz_class(under * twist.denominator), n, index, corner};
  };
  const long bits = kernels::bit_length(n);
  const auto wide = [](const Vector& v) { return Vec3<Wide>{Wide(v.x), Wide(v.y), Wide(v.z)}; };
  if (2 * bits + twist.bits < over_bits) {
    const auto best = greatest_at(patch, MotionAlong(wide(n), wide(twist.v), wide(twist.w)),
                                  [&](std::span<const GivenPoint> given) { return in_wide(given, bits, twist.bits); });
    if (best) return rate(best->first, best->second.over.to_mpz(), best->second.under.to_mpz());
  }
  const auto best = greatest_at(patch, MotionAlong(n, twist.v, twist.w),
                                [](std::span<const GivenPoint> given) { return std::optional(scaled(given)); });
  return rate(best->first, best->second.over, best->second.under);
}

/// Of bodies that penetrate or are apart: the least over all directions; of unions that are apart
/// the greatest over all pairs of pieces.
DirectionalDerivative by_optima(const ContactGeometry& geometry, const Twist& of_a, const Twist& of_b) {
  const RelativeTwist motion(of_a, of_b);
  DirectionalDerivative best = greatest(geometry.patches[0], 0, motion);
  for (std::size_t i = 1; i < geometry.patches.size(); ++i) {
    DirectionalDerivative rate = greatest(geometry.patches[i], i, motion);
    if (compare(rate, best) * (geometry.of_unions ? -1 : 1) < 0) best = std::move(rate);
  }
  return best;
}

// ---- cores that touch ----
//
// The derivative is the signed depth of M = conv{z} + T, where z are the relative velocities at the
// corners, and T is the polar of the cone: all sums of multiples >= 0 of b - x and x - a, for a
// common point x.                                                    [proofs/patch.md, "Touching"]

/// The rays that span T: of its lines both senses.
std::vector<Vector> polar_rays(const OptimalCone& cone) {
  rounded::ClippedCone polar = rounded::whole_space();
  for (const Vector& line : rounded::lineality_basis(cone))
    for (const Vector& g : {line, -line}) rounded::clip(polar, g);
  for (const Vector& ray : cone.rays) rounded::clip(polar, ray);
  std::vector<Vector> rays = std::move(polar.rays);
  for (const Vector& line : polar.lines) rays.insert(rays.end(), {line, -line});
  return rays;
}

/// M by the corners of a point, segment or polygon, in order, and by rays.
struct Polyhedron {
  std::vector<Point> corners;
  std::vector<Vector> rays;

  /// Whether <u,m> >= level for all of its points m.
  [[nodiscard]] bool beyond(const Point& u, const mpq_class& level) const {
    return std::ranges::all_of(corners, [&](const Point& z) { return dot(u, z) >= level; }) &&
           std::ranges::all_of(rays, [&](const Vector& g) { return sgn(dot(g, u)) >= 0; });
  }
  /// Which corner has the greatest <u,z>.
  [[nodiscard]] std::size_t farthest(const Point& u) const {
    std::size_t best = 0;
    for (std::size_t k = 1; k < corners.size(); ++k)
      if (dot(u, corners[k]) > dot(u, corners[best])) best = k;
    return best;
  }
};

/// The corners that span the faces of the convex hull of corners in order, a polygon by triangles.
std::vector<std::vector<Point>> faces_of(const std::vector<Point>& z) {
  std::vector<std::vector<Point>> faces;
  for (const Point& p : z) faces.push_back({p});
  for (std::size_t k = 0; k + 1 < z.size(); ++k) faces.push_back({z[k], z[k + 1]});
  if (z.size() > 2) faces.push_back({z.back(), z.front()});
  for (std::size_t k = 1; k + 1 < z.size(); ++k) faces.push_back({z[0], z[k], z[k + 1]});
  return faces;
}

/// The foot of O on the affine space through z that is spanned by up to two vectors; nullopt if
/// these are not independent.
std::optional<Point> foot(const Point& z, const std::vector<Point>& along) {
  if (along.empty()) return z;
  const Point& e = along[0];
  const mpq_class ee = dot(e, e), ze = dot(z, e);
  if (ee == 0) return std::nullopt;
  if (along.size() == 1) return z - mpq_class(ze / ee) * e;
  const Point& f = along[1];
  const mpq_class ef = dot(e, f), ff = dot(f, f), zf = dot(z, f), det = ee * ff - ef * ef;
  if (det == 0) return std::nullopt;
  return z - mpq_class((ze * ff - zf * ef) / det) * e - mpq_class((zf * ee - ze * ef) / det) * f;
}

/// Whether z + sum of multiples of `along` is x with multiples >= 0, of the first `bounded` of them
/// a sum of at most 1. There are at most two, independent ones.
bool reaches(const Point& z, const std::vector<Point>& along, std::size_t bounded, const Point& x) {
  std::vector<mpq_class> shares;
  const Point d = x - z;
  if (along.size() == 1) shares = {mpq_class(dot(d, along[0]) / dot(along[0], along[0]))};
  if (along.size() == 2) {
    const Point area = cross(along[0], along[1]);
    const mpq_class whole = dot(area, area);
    shares = {mpq_class(dot(area, cross(d, along[1])) / whole), mpq_class(dot(area, cross(along[0], d)) / whole)};
  }
  mpq_class sum;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (shares[k] < 0) return false;
    if (k < bounded) sum += shares[k];
  }
  return sum <= 1;
}

/// The point of M nearest to O, if O is not in M.
std::optional<Point> nearest(const Polyhedron& m) {
  const auto nearest_in = [&](const std::vector<Point>& face, const std::vector<Vector>& rays) -> std::optional<Point> {
    std::vector<Point> along;
    for (std::size_t k = 1; k < face.size(); ++k) along.push_back(face[k] - face[0]);
    for (const Vector& g : rays) along.push_back(rational(g));
    const std::optional<Point> f = foot(face[0], along);
    if (!f || *f == Point{} || !reaches(face[0], along, face.size() - 1, *f)) return std::nullopt;
    return m.beyond(*f, dot(*f, *f)) ? f : std::nullopt;
  };
  for (const std::vector<Point>& face : faces_of(m.corners)) {
    if (auto f = nearest_in(face, {})) return f;
    for (std::size_t i = 0; face.size() < 3 && i < m.rays.size(); ++i) {
      if (auto f = nearest_in(face, {m.rays[i]})) return f;
      for (std::size_t j = 0; face.size() < 2 && j < i; ++j)
        if (auto f = nearest_in(face, {m.rays[i], m.rays[j]})) return f;
    }
  }
  return std::nullopt;
}

/// All directions orthogonal to two edges or rays of M, among them the normals of its facets; of M
/// in a line one that is orthogonal to it.
std::vector<Vector> normals(const Polyhedron& m) {
  std::vector<Vector> along = m.rays;
  for (std::size_t k = 0; k + 1 < m.corners.size(); ++k)
    along.push_back(primitive_along(m.corners[k + 1] - m.corners[k]));
  if (m.corners.size() > 2) along.push_back(primitive_along(m.corners.front() - m.corners.back()));
  std::vector<Vector> found;
  const auto add = [&](const Vector& u) {
    if (!is_zero(u)) found.insert(found.end(), {primitive(u), primitive(-u)});
  };
  for (std::size_t i = 0; i < along.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) add(cross(along[i], along[j]));
  if (found.empty())
    for (const Vector& e : rounded::whole_space().lines) add(along.empty() ? e : cross(along[0], e));
  return found;
}

DirectionalDerivative by_cone(const ContactGeometry& geometry, const Twist& of_a, const Twist& of_b) {
  const Patch& patch = geometry.patches.front();
  Polyhedron m{{}, polar_rays(*geometry.cone)};
  for (std::size_t k = 0; k < patch.corners.size(); ++k) m.corners.push_back(relative_velocity(patch, k, of_a, of_b));
  const auto rate_along = [&](const Vector& u, const Point& at, std::size_t corner) {
    const mpq_class rate = dot(u, at);
    return DirectionalDerivative{rate.get_num(), rate.get_den(), u, 0, corner};
  };
  if (const std::optional<Point> outside = nearest(m)) {
    const Vector u = primitive_along(-*outside);
    return rate_along(u, *outside, m.farthest(rational(u)));
  }
  std::optional<DirectionalDerivative> best;
  for (const Vector& u : normals(m)) {
    if (std::ranges::any_of(m.rays, [&](const Vector& g) { return dot(g, u) > 0; })) continue;
    const std::size_t corner = m.farthest(rational(u));
    DirectionalDerivative rate = rate_along(u, m.corners[corner], corner);
    if (!best || compare(rate, *best) < 0) best = std::move(rate);
  }
  return std::move(best).value();
}

// ---- unions that overlap ----

/// Of pieces that touch after a way out, times |direction|.
struct PieceRate {
  mpq_class rate;
  Vector direction;
  std::size_t patch, corner;
};

/// The greatest at the corners of their patch.
PieceRate greatest_of_pieces(const Patch& patch, std::size_t index, const Twist& of_a, const Twist& of_b) {
  PieceRate best{{}, patch.direction, index, 0};
  for (std::size_t k = 0; k < patch.corners.size(); ++k) {
    mpq_class rate = dot(patch.direction, relative_velocity(patch, k, of_a, of_b));
    if (k == 0 || rate > best.rate) (best.rate = std::move(rate), best.corner = k);
  }
  return best;
}

/// The share of each vector in t, if t is a sum of multiples >= 0 of these: at most three, which
/// must be independent.
std::optional<std::vector<mpq_class>> shares_of(const Point& t, const std::vector<Point>& n) {
  Point rest = t;
  std::vector<mpq_class> shares;
  if (n.size() == 3) {
    const mpq_class whole = dot(n[0], cross(n[1], n[2]));
    if (whole == 0) return std::nullopt;
    shares = {mpq_class(dot(t, cross(n[1], n[2])) / whole), mpq_class(dot(n[0], cross(t, n[2])) / whole),
              mpq_class(dot(n[0], cross(n[1], t)) / whole)};
  } else if (n.size() == 2) {
    const Point area = cross(n[0], n[1]);
    const mpq_class whole = dot(area, area);
    if (whole == 0) return std::nullopt;
    shares = {mpq_class(dot(area, cross(t, n[1])) / whole), mpq_class(dot(area, cross(n[0], t)) / whole)};
  } else {
    shares = {mpq_class(dot(n[0], t) / dot(n[0], n[0]))};
  }
  for (std::size_t k = 0; k < n.size(); ++k) {
    if (shares[k] < 0) return std::nullopt;
    rest = rest - shares[k] * n[k];
  }
  return rest == Point{} ? std::optional(std::move(shares)) : std::nullopt;
}

/// The greatest sum of l_k g_k over all l >= 0 with sum l_k n_k = t, for the rates g_k at the
/// patches of one way out: it is reached with at most three l_k > 0, whose n_k are independent. The
/// patch named is one of these.
PieceRate greatest_sum(const std::vector<PieceRate>& rates, const Point& t) {
  std::optional<PieceRate> best;
  const auto try_these = [&](const std::vector<const PieceRate*>& chosen) {
    std::vector<Point> normals;
    for (const PieceRate* rate : chosen) normals.push_back(rational(rate->direction));
    const auto shares = shares_of(t, normals);
    if (!shares) return;
    PieceRate sum = *chosen.front();
    sum.rate = 0;
    for (std::size_t k = 0; k < chosen.size(); ++k) sum.rate += (*shares)[k] * chosen[k]->rate;
    if (!best || sum.rate > best->rate) best = std::move(sum);
  };
  for (std::size_t i = 0; i < rates.size(); ++i) {
    try_these({&rates[i]});
    for (std::size_t j = 0; j < i; ++j) {
      try_these({&rates[i], &rates[j]});
      for (std::size_t k = 0; k < j; ++k) try_these({&rates[i], &rates[j], &rates[k]});
    }
  }
  if (!best) throw std::logic_error("a way out that is not held by its contacts");
  return std::move(*best);
}

/// The least over all ways out of <t, x> / |t| for the x that the motion allows.
std::variant<DirectionalDerivative, LeftOut> by_ways(const ContactGeometry& geometry, const Twist& of_a,
                                                     const Twist& of_b) {
  const bool turns = of_a.w != Point{} || of_b.w != Point{};
  std::optional<DirectionalDerivative> best;
  for (std::size_t i = 0; i < geometry.patches.size();) {
    const std::size_t way = geometry.patches[i].way;
    const Point t = geometry.patches[i].translation();
    std::vector<PieceRate> rates;
    const std::size_t first = i;
    for (; i < geometry.patches.size() && geometry.patches[i].way == way; ++i) {
      if (turns && !geometry.patches[i].one_plane) return LeftOut::many_planes;
      if (turns) rates.push_back(greatest_of_pieces(geometry.patches[i], i, of_a, of_b));
    }
    if (turns && !geometry.clearance[way]) return LeftOut::exact_fit;
    const PieceRate sum = turns ? greatest_sum(rates, t) : PieceRate{dot(t, of_b.v - of_a.v), {}, first, 0};
    const Vector n = primitive_along(t);
    const mpq_class along_n = sum.rate * dot(n, n) / dot(rational(n), t);  // t is longer than n by so much
    DirectionalDerivative rate{along_n.get_num(), along_n.get_den(), n, sum.patch, sum.corner};
    if (!best || compare(rate, *best) < 0) best = std::move(rate);
  }
  return std::move(best).value();
}

}  // namespace
}  // namespace fathom::patch

namespace fathom {

mpq_class DirectionalDerivative::root() const {
  return kernels::ratio(over * over, under * under * dot(direction, direction));
}

Surd DirectionalDerivative::value() const { return {0, sign() < 0 ? mpq_class(-root()) : root()}; }

std::variant<DirectionalDerivative, LeftOut> directional_derivative(const ContactGeometry& geometry, const Twist& of_a,
                                                                    const Twist& of_b) {
  for (const Twist* const twist : {&of_a, &of_b})
    for (const Point* const part : {&twist->v, &twist->w})
      for (const mpq_class* const c : {&part->x, &part->y, &part->z}) kernels::require_lowest_terms(*c);
  for (const auto& [v, w] : {of_a, of_b})
    if (geometry.dimension == 2 && (v.z != 0 || w.x != 0 || w.y != 0))
      throw std::invalid_argument(
          "a twist of a body of the plane leaves it: of v only x and y, of w only z may be set");
  if (geometry.no_first_order) return *geometry.no_first_order;
  if (geometry.cone) return patch::by_cone(geometry, of_a, of_b);
  if (geometry.of_unions && geometry.cores == Status::penetrating) return patch::by_ways(geometry, of_a, of_b);
  return patch::by_optima(geometry, of_a, of_b);
}

}  // namespace fathom
