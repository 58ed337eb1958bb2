// SPDX-License-Identifier: GPL-3.0-or-later
// What fathom/depth.hpp declares beside the questions: words, accessors of Depth for every status,
// and what follows from a few of an answer's numbers.

#include <algorithm>
#include <array>
#include <stdexcept>

#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/depth/contact.hpp"
#include "reference/files/pose.hpp"

namespace fathom {

std::string_view name(Status status) {
  switch (status) {
    case Status::penetrating: return "penetrating";
    case Status::touching: return "touching";
    case Status::disjoint: return "disjoint";
  }
  throw std::logic_error("unknown status");
}

std::string_view name(const std::optional<Status>& status) { return status ? name(*status) : "undecided"; }

std::string_view name(ContactKind kind) {
  switch (kind) {
    case ContactKind::facet_vertex: return "facet-vertex";
    case ContactKind::vertex_facet: return "vertex-facet";
    case ContactKind::facet_edge: return "facet-edge";
    case ContactKind::edge_facet: return "edge-facet";
    case ContactKind::facet_facet: return "facet-facet";
    case ContactKind::edge_edge: return "edge-edge";
    case ContactKind::vertex_vertex: return "vertex-vertex";
    case ContactKind::vertex_edge: return "vertex-edge";
    case ContactKind::edge_vertex: return "edge-vertex";
  }
  throw std::logic_error("unknown contact kind");
}

std::string_view name(Method method) {
  switch (method) {
    case Method::automatic: return "automatic";
    case Method::exact: return "exact";
    case Method::naive: return "naive";
    case Method::certificate: return "certificate";
  }
  throw std::logic_error("unknown method");
}

std::optional<Status> status_named(std::string_view text) {
  for (const Status status : {Status::penetrating, Status::touching, Status::disjoint})
    if (name(status) == text) return status;
  return std::nullopt;
}

namespace {

// The point of an edge that lies over the line of another one, seen along n: it divides the edge in
// the ratio `over` / `under`. The edges are not parallel.
template <class Position>
struct Crossing {
  Position start, along;
  decltype(Position::x) over, under;

  Crossing(const std::array<Position, 2>& edge, const std::array<Position, 2>& other, const Position& n)
      : start(edge[0]), along(edge[1] - edge[0]) {
    const Position across = cross(other[1] - other[0], n);
    over = dot(other[0] - start, across);
    under = dot(along, across);
  }
};

Point place_of(const Crossing<Point>& c) { return c.start + mpq_class(c.over / c.under) * c.along; }

// The same, of ends that were multiplied by 2^shift. If p/q is a multiple of `along` in lowest
// terms, start + p/q = (start q + p)/q is in lowest terms too, but for a power of two.
Point place_of(const Crossing<Vector>& c, mp_bitcnt_t shift) {
  const mpq_class share = kernels::ratio(c.over, c.under);
  const auto coordinate = [&](const mpz_class& start, const mpz_class& along) {
    mpq_class result = rational_product(share, along);
    const mpz_ptr above = result.get_num_mpz_t(), below = result.get_den_mpz_t();
    mpz_addmul(above, start.get_mpz_t(), below);
    if (mpz_sgn(above) == 0) return result;
    const mp_bitcnt_t zeros = std::min(mpz_scan1(above, 0), shift);
    mpz_tdiv_q_2exp(above, above, zeros);
    mpz_mul_2exp(below, below, shift - zeros);
    return result;
  };
  return {coordinate(c.start.x, c.along.x), coordinate(c.start.y, c.along.y), coordinate(c.start.z, c.along.z)};
}

// The ends in binary64 as integers, each times 2^shift; nullopt if they are given in another form.
struct BinaryEnds {
  std::array<Vector, 2> a, b;
  mp_bitcnt_t shift;
};
std::optional<BinaryEnds> binary_ends(const CrossingEdges& edges) {
  std::array<std::array<kernels::Dyadic, 3>, 4> all;
  long least = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const GivenPoint& point = i < 2 ? edges.a[i] : edges.b[i - 2];
    const auto* const given = std::get_if<std::array<double, 3>>(&point.coordinates);
    if (!given) return std::nullopt;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      all[i][axis] = kernels::dyadic((*given)[axis]);
      least = std::min(least, all[i][axis].exponent);
    }
  }
  const auto scaled = [&](const kernels::Dyadic& c) {
    mpz_class result(c.mantissa);
    result <<= static_cast<mp_bitcnt_t>(c.exponent - least);
    return result;
  };
  const auto point = [&](std::size_t i) { return Vector{scaled(all[i][0]), scaled(all[i][1]), scaled(all[i][2])}; };
  return BinaryEnds{{point(0), point(1)}, {point(2), point(3)}, static_cast<mp_bitcnt_t>(-least)};
}

// The faces overlap on the lattice of the answer.
Witness witness_of(const OverlappingFaces& faces, const Vector& n) {
  const polytope::PlacedPair frame{faces.units, faces.origin.exact(), {}, {}};
  const auto corners = [&](const std::vector<GivenPoint>& given) {
    std::vector<Vector> points;
    for (const GivenPoint& p : given) points.push_back(frame.vector(p.exact()));
    return depth::ExtremeFace{std::move(points), {}};
  };
  return depth::overlap(frame, n, {corners(faces.a), corners(faces.b)});
}

// Calls the overload for the kind of meeting.
template <class... Calls>
struct Overloaded : Calls... {
  using Calls::operator()...;
};
template <class... Calls>
Overloaded(Calls...) -> Overloaded<Calls...>;

}  // namespace

Witness depth::crossing_of(const CrossingEdges& edges, const Vector& n) {
  if (const std::optional<BinaryEnds> ends = binary_ends(edges))
    return {place_of(Crossing<Vector>(ends->a, ends->b, n), ends->shift),
            place_of(Crossing<Vector>(ends->b, ends->a, n), ends->shift)};
  const std::array a{edges.a[0].exact(), edges.a[1].exact()}, b{edges.b[0].exact(), edges.b[1].exact()};
  return {place_of(Crossing<Point>(a, b, rational(n))), place_of(Crossing<Point>(b, a, rational(n)))};
}

Point GivenPoint::exact() const {
  if (const Point* point = std::get_if<Point>(&coordinates)) return *point;
  const auto of = [](const std::array<double, 3>& p) {
    return Point{exact_value(p[0]), exact_value(p[1]), exact_value(p[2])};
  };
  if (const auto* binary64 = std::get_if<std::array<double, 3>>(&coordinates)) return of(*binary64);
  const MovedPoint& moved = std::get<MovedPoint>(coordinates);
  return files::placed(of(moved.point), files::exact_pose(moved.pose));
}

Point Optimum::translation() const {
  // As h(n) is in lowest terms, only its numerator shares a factor with <n,n>.
  const mpz_class length = dot(direction, direction), shared = gcd(support.get_num(), length);
  const mpq_class share(support.get_num() / shared, support.get_den() * (length / shared));
  return share * direction;
}

mpq_class Penetration::squared() const {
  // h(n) is in lowest terms, so only its numerator can share a factor with <n,n>.
  const Optimum& first = optima.front();
  const mpz_class square = first.support.get_num() * first.support.get_num(),
                  length = dot(first.direction, first.direction);
  const mpz_class shared = gcd(square, length);
  return {square / shared, first.support.get_den() * first.support.get_den() * (length / shared)};
}

Witness Penetration::witness() const {
  const Optimum& first = optima.front();
  return std::visit(Overloaded{[](const Witness& given) { return given; },
                               [&](const OverlappingFaces& faces) {
                                 const kernels::DefaultFloatEnvironment environment;
                                 return witness_of(faces, first.direction);
                               },
                               [&](const CornerOfA& a) {
                                 return Witness{a.point.exact(), a.point.exact() + first.translation()};
                               },
                               [&](const CornerOfB& b) {
                                 return Witness{b.point.exact() - first.translation(), b.point.exact()};
                               },
                               [&](const CrossingEdges& edges) { return depth::crossing_of(edges, first.direction); }},
                    meeting);
}

mpq_class Depth::squared() const { return penetration() ? penetration()->squared() : mpq_class(0); }

const std::vector<Optimum>& Depth::optima() const {
  static const std::vector<Optimum> none;
  return penetration() ? penetration()->optima : none;
}

std::size_t Depth::optima_count() const {
  return penetration() ? penetration()->optima.size() + penetration()->unlisted : 0;
}

const Vector& Depth::direction() const {
  if (touch()) return touch()->direction;
  return distance() ? distance()->direction : optima().front().direction;
}

Point Depth::translation() const { return penetration() ? optima().front().translation() : Point{}; }

const Contact* Depth::contact() const {
  if (penetration()) return &optima().front().contact;
  return distance() ? &distance()->contact : nullptr;
}

std::optional<Witness> Depth::witness() const {
  if (touch()) return Witness{touch()->point, touch()->point};
  return penetration() ? std::optional(penetration()->witness()) : std::nullopt;
}

Point Depth::contact_translation() const { return distance() ? distance()->translation : translation(); }

Witness Depth::contact_points() const { return distance() ? distance()->witness : *witness(); }

mpq_class signed_square(const Depth& depth) {
  return depth.distance() ? mpq_class(-depth.distance()->squared) : depth.squared();
}

}  // namespace fathom
