// SPDX-License-Identifier: Apache-2.0
// Whether convex pieces tile what a mesh encloses. Each piece is a convex polytope; and the flags
// of all facets, a point, a line through it and a plane through that, sum to those of the mesh.
//                                                                           [FORMAT.md, section 14]
#include <algorithm>

#include "budget.hpp"
#include "checks.hpp"

namespace fathom_check {
namespace {

/// A triangle of the mesh, or a facet of a piece.
struct Polygon {
  const std::uint32_t* corners;
  std::size_t size, line;
  int sense;      ///< 1 in the mesh, -1 in a piece: what its flags count
  Vector normal;  ///< primitive, outward

  /// Cyclically: k is at most `size`.
  [[nodiscard]] std::uint32_t corner(std::size_t k) const { return corners[k == size ? 0 : k]; }
};

/// Divides a vector that is not zero by the greatest common divisor of its entries.
void make_primitive(MutableVector& v, mpz_class& divisor) {
  find_gcd(divisor, v);
  if (divisor != 1) divide(v, divisor);
}

/// Whether the first entry that is not zero is negative.
template <class V>
bool is_negative(const V& v) {
  const int x = mpz_sgn(v.x.get_mpz_t()), y = mpz_sgn(v.y.get_mpz_t());
  return x != 0 ? x < 0 : y != 0 ? y < 0 : mpz_sgn(v.z.get_mpz_t()) < 0;
}

void negate(MutableVector& v) {
  for (mpz_class* const entry : {&v.x, &v.y, &v.z}) mpz_neg(entry->get_mpz_t(), entry->get_mpz_t());
}

bool same_vector(const Vector& u, const Vector& v) { return u.x == v.x && u.y == v.y && u.z == v.z; }

class Tiling {
 public:
  explicit Tiling(const Certificate& c) : c_(&c) {
    points_.reserve(c.a.points.items.size());
    for (const RationalPoint& p : c.a.points.items) points_.push_back(homogeneous(p));
  }

  void check() {
    const SolidParts& parts = c_->of_solid;
    if (parts.pieces.empty()) throw refused(parts.line, "there is no piece");
    check_points();
    const Facets& facets = c_->facets.items;
    for (std::size_t piece = 0, f = 0; piece < parts.pieces.size(); ++piece) {
      const std::size_t first = polygons_.size();
      for (; f < parts.pieces[piece].end; ++f)
        take({facets.corners.data() + facets.begin_of(f),
              facets.ends[f] - facets.begin_of(f),
              c_->facets.lines[f],
              -1,
              {}});
      check_piece(first, piece);
    }
    for (std::size_t k = 0; k < parts.mesh.items.size(); ++k) {
      const SolidParts::Triangle& triangle = parts.mesh.items[k];
      require_points(triangle.data(), 3, parts.mesh.lines[k]);
      if (find_fan_normal(triangle.data(), 1)) take({triangle.data(), 3, parts.mesh.lines[k], 1, {}});
    }
    check_flags();
  }

 private:
  void check_points() const;
  void require_points(const std::uint32_t* corners, std::size_t size, std::size_t line) const;
  bool find_fan_normal(const std::uint32_t* corners, std::size_t k);
  void take(Polygon polygon);
  void check_piece(std::size_t first, std::size_t piece);
  void check_support(const Polygon& facet, const std::vector<std::uint32_t>& corners);
  void check_edges(std::size_t first);
  void check_flags();
  void check_plane(const Polygon* const* begin, const Polygon* const* end);

  /// Finds a positive multiple of point v - point u.
  void find_edge(MutableVector& edge, std::uint32_t u, std::uint32_t v) {
    const Homogeneous &p = points_[u], &q = points_[v];
    const auto entry = [&p, &q](mpz_class& result, const mpz_class& x, const mpz_class& y) {
      mpz_mul(result.get_mpz_t(), y.get_mpz_t(), p.w.get_mpz_t());
      mpz_submul(result.get_mpz_t(), x.get_mpz_t(), q.w.get_mpz_t());
    };
    entry(edge.x, p.x.x, q.x.x), entry(edge.y, p.x.y, q.x.y), entry(edge.z, p.x.z, q.x.z);
  }

  const Certificate* c_;
  std::vector<Homogeneous> points_;
  std::vector<Polygon> polygons_;
  Arena integers_;  ///< of their normals
  MutableVector first_edge_, second_edge_, normal_;
  mpz_class divisor_, height_, level_, scratch_;
};

/// No two are the same.
void Tiling::check_points() const {
  std::vector<const Homogeneous*> order;
  for (const Homogeneous& p : points_) order.push_back(&p);
  const auto before = [](const Homogeneous* p, const Homogeneous* q) {
    return p->w != q->w ? p->w < q->w : ascending(p->x, q->x);
  };
  std::sort(order.begin(), order.end(), before);
  const auto twice =
      std::adjacent_find(order.begin(), order.end(), [&before](const auto* p, const auto* q) { return !before(p, q); });
  if (twice == order.end()) return;
  const auto number = static_cast<std::size_t>(std::max(twice[0], twice[1]) - points_.data());
  throw refused(c_->a.points.lines[number], "this point is there twice");
}

void Tiling::require_points(const std::uint32_t* corners, std::size_t size, std::size_t line) const {
  for (std::size_t k = 0; k < size; ++k)
    if (corners[k] >= points_.size()) throw refused(line, "there is no point " + std::to_string(corners[k]));
}

/// (v_k - v_0) x (v_(k+1) - v_0), into normal_. Returns whether it is not zero.
bool Tiling::find_fan_normal(const std::uint32_t* corners, std::size_t k) {
  find_edge(first_edge_, corners[0], corners[k]);
  find_edge(second_edge_, corners[0], corners[k + 1]);
  cross(normal_, first_edge_, second_edge_);
  return !is_zero(normal_);
}

/// Finds the normal, of which the triangles fanned out from the first corner have positive
/// multiples.
void Tiling::take(Polygon polygon) {
  if (polygon.size < 3) throw refused(polygon.line, "a facet has at least three corners");
  require_points(polygon.corners, polygon.size, polygon.line);
  for (std::size_t k = 1; k + 1 < polygon.size; ++k) {
    if (!find_fan_normal(polygon.corners, k)) throw refused(polygon.line, "three of these corners lie on a line");
    make_primitive(normal_, divisor_);
    if (k == 1) polygon.normal = kept(integers_, normal_);
    else if (ascending(normal_, polygon.normal) || ascending(polygon.normal, normal_))
      throw refused(polygon.line, "this facet is not a flat and convex polygon");
  }
  // Around a corner in its middle the fan of a polygon could go several times.
  std::vector<std::uint32_t> named(polygon.corners, polygon.corners + polygon.size);
  std::sort(named.begin(), named.end());
  if (std::adjacent_find(named.begin(), named.end()) != named.end())
    throw refused(polygon.line, "this facet has a corner twice");
  polygons_.push_back(polygon);
}

/// The facets from number `first` on are those of a polytope, one for each of its faces.
void Tiling::check_piece(std::size_t first, std::size_t piece) {
  const std::size_t line = c_->of_solid.pieces[piece].line;
  if (first == polygons_.size()) throw refused(line, "a piece without facets");
  const std::vector<std::uint32_t> corners = corners_of_piece(*c_, piece);
  std::vector<const Polygon*> facets;
  for (std::size_t f = first; f < polygons_.size(); ++f) {
    check_support(polygons_[f], corners);
    facets.push_back(&polygons_[f]);
  }
  const auto same = [](const Polygon* f, const Polygon* g) { return same_vector(f->normal, g->normal); };
  std::sort(facets.begin(), facets.end(), [&same](const Polygon* f, const Polygon* g) {
    return same(f, g) ? f < g : ascending(f->normal, g->normal);
  });
  if (const auto twice = std::adjacent_find(facets.begin(), facets.end(), same); twice != facets.end())
    throw refused(twice[1]->line, "another facet of this piece lies in the same plane");
  check_edges(first);
}

void Tiling::check_support(const Polygon& facet, const std::vector<std::uint32_t>& corners) {
  const Homogeneous& on = points_[facet.corners[0]];
  dot(level_, facet.normal, on.x);
  bool below = false;
  for (const std::uint32_t k : corners) {
    dot(height_, facet.normal, points_[k].x);
    height_ *= on.w;
    mpz_mul(scratch_.get_mpz_t(), level_.get_mpz_t(), points_[k].w.get_mpz_t());
    const int side = cmp(height_, scratch_);
    if (side > 0) throw refused(facet.line, "point " + std::to_string(k) + " of the piece is above this facet");
    below = below || side < 0;
  }
  if (!below) throw refused(facet.line, "the points of this piece lie in one plane");
}

/// Each edge has its reverse.
void Tiling::check_edges(std::size_t first) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t f = first; f < polygons_.size(); ++f)
    for (std::size_t k = 0; k < polygons_[f].size; ++k)
      edges.emplace_back(polygons_[f].corner(k), polygons_[f].corner(k + 1));
  std::sort(edges.begin(), edges.end());
  for (std::size_t f = first; f < polygons_.size(); ++f)
    for (std::size_t k = 0; k < polygons_[f].size; ++k) {
      const std::uint32_t u = polygons_[f].corner(k), v = polygons_[f].corner(k + 1);
      if (!std::binary_search(edges.begin(), edges.end(), std::pair{v, u}))
        throw refused(polygons_[f].line,
                      "no facet lies across the edge " + std::to_string(u) + " " + std::to_string(v));
    }
}

/// Plane by plane, so that only the directions of one plane are kept at a time.
void Tiling::check_flags() {
  for (Polygon& polygon : polygons_) {
    if (!is_negative(polygon.normal)) continue;
    normal_ = negated(polygon.normal);
    polygon.normal = kept(integers_, normal_);
  }
  std::vector<const Polygon*> order;
  order.reserve(polygons_.size());
  for (const Polygon& polygon : polygons_) order.push_back(&polygon);
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
  for (const Polygon* const* polygon = begin; polygon != end; ++polygon)
    for (std::size_t k = 0; k < (*polygon)->size; ++k) {
      const std::uint32_t u = (*polygon)->corner(k), v = (*polygon)->corner(k + 1);
      find_edge(first_edge_, u, v);
      make_primitive(first_edge_, divisor_);
      if (is_negative(first_edge_)) negate(first_edge_);
      const Vector along = kept(integers, first_edge_);
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

std::vector<std::uint32_t> corners_of_piece(const Certificate& c, std::size_t piece) {
  const std::vector<List>& pieces = c.of_solid.pieces;
  const Facets& facets = c.facets.items;
  const auto at = [&facets](std::size_t f) {
    return facets.corners.begin() + static_cast<std::ptrdiff_t>(facets.begin_of(f));
  };
  std::vector<std::uint32_t> result(at(begin_of(pieces, piece)), at(pieces[piece].end));
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

void check_solid(const Certificate& c) { Tiling(c).check(); }

}  // namespace fathom_check
