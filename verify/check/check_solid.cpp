// SPDX-License-Identifier: Apache-2.0
// Whether convex pieces tile what a mesh encloses. Each piece is a convex polytope; and the flags
// of all facets, a point, a line through it and a plane through that, sum to those of the mesh.
//                                                                           [FORMAT.md, section 14]
#include <algorithm>

#include "budget.hpp"
#include "checks.hpp"
#include "polygons.hpp"

namespace fathom_check {
namespace {

/// Whether the first entry that is not zero is negative.
template <class V>
bool is_negative(const V& v) {
  const int x = mpz_sgn(v.x.get_mpz_t()), y = mpz_sgn(v.y.get_mpz_t());
  return x != 0 ? x < 0 : y != 0 ? y < 0 : mpz_sgn(v.z.get_mpz_t()) < 0;
}

void negate(MutableVector& v) {
  for (mpz_class* const entry : {&v.x, &v.y, &v.z}) mpz_neg(entry->get_mpz_t(), entry->get_mpz_t());
}

class Tiling {
 public:
  explicit Tiling(const Body& body) : body_(&body), polygons_(homogeneous(body)) {}

  void check() {
    const SolidParts& parts = body_->solid;
    if (parts.pieces.empty()) throw refused(parts.line, "there is no piece");
    check_points();
    for (std::size_t piece = 0; piece < parts.pieces.size(); ++piece)
      polygons_.take_polytope(parts.facets, begin_of(parts.pieces, piece), parts.pieces[piece].end,
                              parts.pieces[piece].line);
    for (std::size_t k = 0; k < parts.mesh.items.size(); ++k) {
      const SolidParts::Triangle& triangle = parts.mesh.items[k];
      polygons_.require_points(triangle.data(), 3, parts.mesh.lines[k]);
      if (polygons_.has_area(triangle.data())) polygons_.take({triangle.data(), 3, parts.mesh.lines[k], 1, {}});
    }
    check_flags();
  }

 private:
  void check_points() const;
  void check_flags();
  void check_plane(const Polygon* const* begin, const Polygon* const* end);

  const Body* body_;
  Polygons polygons_;
  Arena integers_;  ///< of normals with the other sense
};

/// No two are the same.
void Tiling::check_points() const {
  std::vector<const Homogeneous*> order;
  for (const Homogeneous& p : polygons_.points()) order.push_back(&p);
  const auto before = [](const Homogeneous* p, const Homogeneous* q) {
    return p->w != q->w ? p->w < q->w : ascending(p->x, q->x);
  };
  std::sort(order.begin(), order.end(), before);
  const auto twice =
      std::adjacent_find(order.begin(), order.end(), [&before](const auto* p, const auto* q) { return !before(p, q); });
  if (twice == order.end()) return;
  const auto number = static_cast<std::size_t>(std::max(twice[0], twice[1]) - polygons_.points().data());
  throw refused(body_->points.lines[number], "this point is there twice");
}

/// Plane by plane, so that only the directions of one plane are kept at a time.
void Tiling::check_flags() {
  std::vector<Polygon>& polygons = polygons_.all();
  for (Polygon& polygon : polygons)
    if (is_negative(polygon.normal)) polygon.normal = kept(integers_, negated(polygon.normal));
  std::vector<const Polygon*> order;
  order.reserve(polygons.size());
  for (const Polygon& polygon : polygons) order.push_back(&polygon);
  std::sort(order.begin(), order.end(),
            [](const Polygon* p, const Polygon* q) { return ascending(p->normal, q->normal); });
  const Polygon *const *const end = order.data() + order.size(), *const *next = order.data();
  for (const Polygon* const* begin = next; begin != end; begin = next) {
    while (next != end && same_vector((*begin)->normal, (*next)->normal)) ++next;
    check_plane(begin, next);
  }
}

/// The flags of these polygons, whose planes are parallel, sum to nothing.
void Tiling::check_plane(const Polygon* const* begin, const Polygon* const* end) {
  struct Flag {
    Vector along;
    std::uint32_t point;
    int count;
    std::size_t line;
  };
  Arena integers;
  std::vector<Flag> flags;
  MutableVector direction;
  for (const Polygon* const* polygon = begin; polygon != end; ++polygon)
    for (std::size_t k = 0; k < (*polygon)->size; ++k) {
      const std::uint32_t u = (*polygon)->corner(k), v = (*polygon)->corner(k + 1);
      polygons_.find_direction(direction, u, v);
      if (is_negative(direction)) negate(direction);
      const Vector along = kept(integers, direction);
      flags.push_back({along, v, (*polygon)->sense, (*polygon)->line});
      flags.push_back({along, u, -(*polygon)->sense, (*polygon)->line});
    }
  std::sort(flags.begin(), flags.end(), [](const Flag& f, const Flag& g) {
    if (f.point != g.point) return f.point < g.point;
    return same_vector(f.along, g.along) ? f.line < g.line : ascending(f.along, g.along);
  });
  std::int64_t sum = 0;
  for (std::size_t k = 0; k < flags.size(); ++k) {
    sum += flags[k].count;
    const bool last = k + 1 == flags.size() || flags[k].point != flags[k + 1].point ||
                      !same_vector(flags[k].along, flags[k + 1].along);
    if (last && sum != 0)
      throw refused(flags[k].line, "the pieces do not tile what the mesh encloses: an edge of this polygon at point " +
                                       std::to_string(flags[k].point) + " does not cancel");
  }
}

}  // namespace

void check_solid(const Body& body) { Tiling(body).check(); }

}  // namespace fathom_check
