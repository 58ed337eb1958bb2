// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/solids/arrangement.hpp"

#include <initializer_list>
#include <stdexcept>
#include <utility>

#include "kernels/predicates/direction.hpp"
#include "reference/polytope/hull.hpp"

namespace fathom::solids {
namespace {

using polytope::hash_value;

std::size_t hash_of(const Vector& v, const mpz_class& w) { return hash_value(v) * 0x9e3779b97f4a7c15 + hash_value(w); }

/// Divides the numbers by what they share, with this sign.
void reduce(std::initializer_list<mpz_class*> numbers, int sign) {
  mpz_class shared;
  for (const mpz_class* n : numbers)
    if (shared != 1) mpz_gcd(shared.get_mpz_t(), shared.get_mpz_t(), n->get_mpz_t());
  if (sign < 0) shared = -shared;
  if (shared == 1) return;
  for (mpz_class* n : numbers) mpz_divexact(n->get_mpz_t(), n->get_mpz_t(), shared.get_mpz_t());
}

/// Normal to the plane through three points, on the side where they appear counter-clockwise.
Vector normal_through(const kernels::RationalPoint& a, const kernels::RationalPoint& b,
                      const kernels::RationalPoint& c) {
  return cross(a.w * b.v - b.w * a.v, a.w * c.v - c.w * a.v);
}

/// Which component of v, not zero, is the first that is not 0.
int first_axis(const Vector& v) { return v.x != 0 ? 0 : v.y != 0 ? 1 : 2; }

/// The id of the element for which `is_it`, or of a new one, which `make` returns.
template <class I, class T, class IsIt, class Make>
I interned(kernels::IdVector<I, T>& all, std::unordered_multimap<std::size_t, std::uint32_t>& known, std::size_t hash,
           IsIt is_it, Make make) {
  const auto [begin, end] = known.equal_range(hash);
  for (auto entry = begin; entry != end; ++entry)
    if (is_it(all[I(entry->second)])) return I(entry->second);
  const I id(static_cast<std::uint32_t>(all.size()));
  all.push_back(make());
  known.emplace(hash, id.value);
  return id;
}

}  // namespace

PointId Arrangement::point(Vector v, mpz_class w) {
  reduce({&w, &v.x, &v.y, &v.z}, sgn(w));
  return interned(
      points_, known_points_, hash_of(v, w), [&](const kernels::RationalPoint& p) { return p.v == v && p.w == w; },
      [&] { return kernels::rational_point(v, w, exponent_); });
}

PointId Arrangement::point_at(const Point& position) {
  const auto& [x, y, z] = position;
  const mpz_class w = lcm(lcm(x.get_den(), y.get_den()), z.get_den());
  const auto over_w = [&](const mpq_class& c) { return mpz_class(c.get_num() * (w / c.get_den())); };
  return point({over_w(x), over_w(y), over_w(z)}, w);
}

std::optional<PlaneSide> Arrangement::plane(PointId p, PointId q, PointId r) {
  const kernels::RationalPoint& origin = points_[p];
  Vector normal = normal_through(origin, points_[q], points_[r]);
  if (is_zero(normal)) return std::nullopt;
  mpz_class height = dot(normal, origin.v);
  if (origin.w != 1) normal = origin.w * normal;
  const int sign = sgn(kernels::coordinate(normal, first_axis(normal)));
  reduce({&normal.x, &normal.y, &normal.z, &height}, sign);
  return PlaneSide{plane(normal, height), sign < 0};
}

PlaneId Arrangement::plane_across(int axis, PointId p) {
  const Vector normal{axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0};
  return plane(normal, kernels::coordinate(points_[p].v, axis));
}

PlaneId Arrangement::plane(const Vector& normal, const mpz_class& height) {
  return interned(
      planes_, known_planes_, hash_of(normal, height),
      [&](const kernels::OrientedPlane& e) { return e.normal == normal && e.height == height; },
      [&] { return kernels::oriented_plane(normal, height, exponent_); });
}

LineId Arrangement::line(Vector direction, Vector moment) {
  const int axis = first_axis(direction);
  reduce({&direction.x, &direction.y, &direction.z, &moment.x, &moment.y, &moment.z},
         sgn(kernels::coordinate(direction, axis)));
  return interned(
      lines_, known_lines_, hash_value(direction) * 31 + hash_value(moment),
      [&](const SpaceLine& l) { return l.direction == direction && l.moment == moment; },
      [&] {
        return SpaceLine{direction, moment, axis, {kernels::direction_image(direction), 0}};
      });
}

LineId Arrangement::line(PointId p, PointId q) {
  const kernels::RationalPoint &from = points_[p], &to = points_[q];
  return line(from.w * to.v - to.w * from.v, cross(from.v, to.v));
}

LineId Arrangement::line(PlaneId e, PlaneId f) {
  const kernels::OrientedPlane &g = planes_[e], &h = planes_[f];
  return line(cross(g.normal, h.normal), h.height * g.normal - g.height * h.normal);
}

PointId Arrangement::meeting(LineId l, PlaneId e) {
  const SpaceLine& line = lines_[l];
  const kernels::OrientedPlane& plane = planes_[e];
  return point(cross(plane.normal, line.moment) + plane.height * line.direction, dot(plane.normal, line.direction));
}

int Arrangement::turn(PlaneSide e, PlaneSide f, LineId l) const {
  const kernels::OrientedPlane &g = planes_[e.plane], &h = planes_[f.plane];
  const SpaceLine& line = lines_[l];
  const std::optional<kernels::Sign> sure = kernels::MeetingLine(g.image, h.image).leads_beyond(line.image);
  const int sign = sure ? to_int(*sure) : sgn(det(g.normal, h.normal, line.direction));
  return e.reversed == f.reversed ? sign : -sign;
}

int Arrangement::turn(PlaneSide e, PointId p, PointId q, PointId r) const {
  const int sign = sgn(dot(planes_[e.plane].normal, normal_through(points_[p], points_[q], points_[r])));
  return e.reversed ? -sign : sign;
}

}  // namespace fathom::solids
