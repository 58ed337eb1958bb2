// SPDX-License-Identifier: GPL-3.0-or-later
// What fathom/depth.hpp declares beside the questions: words, accessors of Depth for every status,
// and what follows from a few of an answer's numbers.

#include <stdexcept>

#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/vector.hpp"
#include "reference/depth/contact.hpp"

namespace fathom {

std::string_view name(Status status) {
  switch (status) {
    case Status::penetrating: return "penetrating";
    case Status::touching: return "touching";
    case Status::disjoint: return "disjoint";
  }
  throw std::logic_error("unknown status");
}

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

// The point of the edge of A that lies over the line of the edge of B, seen along n. The edges are
// not parallel.
Point over_line(const CrossingEdges& edges, const Vector& n) {
  const Point start = edges.a[0].exact(), on_b = edges.b[0].exact();
  const Point along = edges.a[1].exact() - start, across = cross(edges.b[1].exact() - on_b, rational(n));
  const mpq_class share = dot(on_b - start, across) / dot(along, across);
  return start + share * along;
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

Point GivenPoint::exact() const {
  if (const Point* point = std::get_if<Point>(&coordinates)) return *point;
  const auto& [x, y, z] = std::get<std::array<double, 3>>(coordinates);
  return {exact_value(x), exact_value(y), exact_value(z)};
}

Point Optimum::translation() const { return mpq_class(support / dot(direction, direction)) * direction; }

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
                               [&](const CrossingEdges& edges) {
                                 Point p = over_line(edges, first.direction), q = p + first.translation();
                                 return Witness{std::move(p), std::move(q)};
                               }},
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
