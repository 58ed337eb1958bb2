// SPDX-License-Identifier: GPL-3.0-or-later
// The derivative of the signed depth along a motion: of each optimal direction the greatest rate at
// the corners of its patch, and of these the least; of unions that are apart the greatest.
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "fathom/patch.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/patch/patch.hpp"
#include "reference/rounded/optimal_cone.hpp"

namespace fathom::patch {
namespace {

/// A velocity over one denominator.
struct ScaledTwist {
  Vector v, w;
  mpz_class denominator = 1;

  /// How fast B moves against A. As <n, w x n> = 0, it does not matter along n where a contact
  /// point is taken to be.
  ScaledTwist(const Twist& of_a, const Twist& of_b) {
    for (const Twist* twist : {&of_a, &of_b})
      for (const Point* part : {&twist->v, &twist->w})
        for (const mpq_class* c : {&part->x, &part->y, &part->z})
          if (c->get_den() != 1) denominator = lcm(denominator, c->get_den());
    v = difference(of_b.v, of_a.v);
    w = difference(of_b.w, of_a.w);
  }

 private:
  [[nodiscard]] Vector difference(const Point& p, const Point& q) const {
    const auto integer = [&](const mpq_class& c) { return mpz_class(c.get_num() * (denominator / c.get_den())); };
    const auto along = [&](const mpq_class& c, const mpq_class& d) { return mpz_class(integer(c) - integer(d)); };
    return {along(p.x, q.x), along(p.y, q.y), along(p.z, q.z)};
  }
};

/// How fast B's point of a corner moves against A's.
Point relative_velocity(const Patch& patch, std::size_t corner, const Twist& of_a, const Twist& of_b) {
  return of_b.v + cross(of_b.w, patch.b(corner).core) - of_a.v - cross(of_a.w, patch.a(corner).core);
}

mpq_class signed_square(const mpq_class& x) { return x * abs(x); }

/// The rate rate / |direction|.
struct Rate {
  mpq_class rate;     ///< where it is needed
  mpq_class squared;  ///< of the quotient, with its sign
  Vector direction;
  std::size_t patch = 0, corner = 0;
};

DirectionalDerivative derivative_of(const Rate& rate) {
  return {sgn(rate.squared), abs(rate.squared), rate.direction, rate.patch, rate.corner};
}

/// The greatest at the corners of a patch, whose A moves along its direction.
Rate greatest(const Patch& patch, std::size_t index, const ScaledTwist& motion) {
  const Vector& n = patch.direction;
  const Vector turn = cross(n, motion.w);  // <n, w x p> = <n x w, p>
  const mpz_class push = dot(n, motion.v);
  mpz_class above, below = 1;
  std::size_t best = 0;
  for (std::size_t k = 0; k < patch.corners.size(); ++k) {
    const Numerators p = contact_numerators(patch, k);
    mpz_class rate = push * p.denominator + dot(turn, p.point);
    if (k > 0 && rate * below <= above * p.denominator) continue;
    above = std::move(rate), below = p.denominator, best = k;
  }
  below *= motion.denominator;
  return {{}, kernels::ratio(above * abs(above), below * below * dot(n, n)), n, index, best};
}

/// The same for pieces of unions, which a way out moves along another direction.
Rate greatest_of_pieces(const Patch& patch, std::size_t index, const Twist& of_a, const Twist& of_b) {
  Rate best{{}, {}, patch.direction, index, 0};
  for (std::size_t k = 0; k < patch.corners.size(); ++k) {
    mpq_class rate = dot(patch.direction, relative_velocity(patch, k, of_a, of_b));
    if (k == 0 || rate > best.rate) (best.rate = std::move(rate), best.corner = k);
  }
  return best;
}

/// Of bodies that penetrate or are apart: the least over all directions; of unions that are apart
/// the greatest over all pairs of pieces.
DirectionalDerivative by_optima(const ContactGeometry& geometry, const Twist& of_a, const Twist& of_b) {
  const ScaledTwist motion(of_a, of_b);
  Rate best = greatest(geometry.patches[0], 0, motion);
  for (std::size_t i = 1; i < geometry.patches.size(); ++i) {
    Rate rate = greatest(geometry.patches[i], i, motion);
    if (geometry.of_unions ? rate.squared > best.squared : rate.squared < best.squared) best = std::move(rate);
  }
  return derivative_of(best);
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
  if (const std::optional<Point> outside = nearest(m)) {
    const Point u = -*outside;
    return {-1, dot(*outside, *outside), primitive_along(u), 0, m.farthest(u)};
  }
  std::optional<Rate> best;
  for (const Vector& u : normals(m)) {
    if (std::ranges::any_of(m.rays, [&](const Vector& g) { return dot(g, u) > 0; })) continue;
    const std::size_t corner = m.farthest(rational(u));
    Rate rate{dot(u, m.corners[corner]), {}, u, 0, corner};
    rate.squared = signed_square(rate.rate) / dot(u, u);
    if (!best || rate.squared < best->squared) best = std::move(rate);
  }
  return derivative_of(best.value());
}

// ---- unions that overlap ----

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
Rate greatest_sum(const std::vector<Rate>& rates, const Point& t) {
  std::optional<Rate> best;
  const auto try_these = [&](const std::vector<const Rate*>& chosen) {
    std::vector<Point> normals;
    for (const Rate* rate : chosen) normals.push_back(rational(rate->direction));
    const auto shares = shares_of(t, normals);
    if (!shares) return;
    Rate sum = *chosen.front();
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
  std::optional<Rate> best;
  for (std::size_t i = 0; i < geometry.patches.size();) {
    const std::size_t way = geometry.patches[i].way;
    const Point t = geometry.patches[i].translation();
    std::vector<Rate> rates;
    const std::size_t first = i;
    for (; i < geometry.patches.size() && geometry.patches[i].way == way; ++i) {
      if (turns && !geometry.patches[i].one_plane) return LeftOut::many_planes;
      if (turns) rates.push_back(greatest_of_pieces(geometry.patches[i], i, of_a, of_b));
    }
    if (turns && !geometry.clearance[way]) return LeftOut::exact_fit;
    Rate rate = turns ? greatest_sum(rates, t) : Rate{dot(t, of_b.v - of_a.v), {}, {}, first, 0};
    rate.squared = signed_square(rate.rate) / dot(t, t);
    rate.direction = primitive_along(t);
    if (!best || rate.squared < best->squared) best = std::move(rate);
  }
  return derivative_of(best.value());
}

}  // namespace
}  // namespace fathom::patch

namespace fathom {

std::variant<DirectionalDerivative, LeftOut> directional_derivative(const ContactGeometry& geometry, const Twist& of_a,
                                                                    const Twist& of_b) {
  for (const Twist* const twist : {&of_a, &of_b})
    for (const Point* const part : {&twist->v, &twist->w})
      for (const mpq_class* const c : {&part->x, &part->y, &part->z}) kernels::require_lowest_terms(*c);
  if (geometry.no_first_order) return *geometry.no_first_order;
  if (geometry.cone) return patch::by_cone(geometry, of_a, of_b);
  if (geometry.of_unions && geometry.cores == Status::penetrating) return patch::by_ways(geometry, of_a, of_b);
  return patch::by_optima(geometry, of_a, of_b);
}

}  // namespace fathom
