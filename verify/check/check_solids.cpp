// SPDX-License-Identifier: Apache-2.0
// Whether convex pieces tile what a mesh encloses. Each piece is a convex polytope; and the flags
// of all facets, a point, a line through it and a plane through that, sum to those of the mesh.
//                                                                           [FORMAT.md, section 14]
#include <algorithm>

#include "checks.hpp"
#include "limits.hpp"
#include "solids.hpp"

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

// Which checks belong to which claim about two bodies that are solids or unions. There is no common
// denominator: it could have as many digits as all points together.         [FORMAT.md, section 15]

namespace {

/// num / den; the denominator is positive.
struct Fraction {
  mpz_class num, den;
};

class TwoBodies {
 public:
  TwoBodies(const Certificate& certificate, const Bound& low)
      : c_(&certificate), low_(&low), a_(certificate.a), b_(certificate.b), separation_(certificate, low) {}

  void check() {
    check_body(c_->a, a_);
    check_body(c_->b, b_);
    if (c_->claim != Claim::depth) {
      check_apart(0, {}, 1);
      return check_nearest();
    }
    check_optima(*c_, [this](std::size_t optimum, const MutableVector& t, const mpz_class& den) {
      check_apart(optimum, t, den);
    });
    Arena integers;
    const std::vector<Plane> planes = check_polytopes(integers);
    WorkOfTree work(c_->of_unions);
    check_tree(*c_, planes, *low_, &work);
  }

 private:
  static void check_body(const Body& body, const PiecedBody& pieced);
  void check_apart(std::size_t list, const MutableVector& t, const mpz_class& den);
  template <class U>
  void find_largest_of(Fraction& largest, const U& u, const PiecedBody& body, const PieceRange& pieces);
  std::vector<Plane> check_polytopes(Arena& integers) const;
  [[nodiscard]] std::vector<Homogeneous> vertices_of(const InnerPolytope& polytope) const;
  void check_nearest() const;

  const Certificate* c_;
  const Bound* low_;
  PiecedBody a_, b_;
  Separation separation_;
  Fraction height_, of_a_;
  mpz_class product_, other_;
};

void TwoBodies::check_body(const Body& body, const PiecedBody& pieced) {
  if (body.core == Body::Core::solid) return check_solid(body);
  if (body.pieces.empty()) throw refused(body.line, "a body without pieces");
  const Homogeneous* const points = pieced.points().data();
  for (std::size_t k = 0; k < body.pieces.size(); ++k)
    if (!has_interior(points + pieced.begin_of(k), points + pieced.begin_of(k + 1)))
      throw refused(body.pieces[k].line, "the points of this piece lie in one plane");
}

/// The list of blocks of this number, for the place t / den.
void TwoBodies::check_apart(std::size_t list, const MutableVector& t, const mpz_class& den) {
  const UnionParts& parts = c_->of_unions;
  const auto check_vector = [&](std::size_t block, const PieceRange& of_a, const PieceRange& of_b) {
    const Vector& u = parts.blocks.items[block].u;
    find_largest_of(height_, u, b_, of_b);
    find_largest_of(of_a_, negated(u), a_, of_a);
    height_.num *= of_a_.den;
    of_a_.num *= height_.den;
    height_.num += of_a_.num;
    height_.den *= of_a_.den;
    separation_.check(u, height_.num, height_.den, t, den, parts.blocks.lines[block]);
  };
  if (const std::optional<Fault> fault = for_each_vector(parts, list, a_.pieces(), b_.pieces(), check_vector))
    throw Fault(*fault);
}

/// The largest <u,p> of all corners p of these pieces.
template <class U>
void TwoBodies::find_largest_of(Fraction& largest, const U& u, const PiecedBody& body, const PieceRange& pieces) {
  const std::size_t begin = body.begin_of(pieces.first), end = body.begin_of(pieces.last);
  for (std::size_t k = begin; k < end; ++k) {
    const Homogeneous& p = body.points()[body.corners()[k]];
    dot(product_, u, p.x);
    if (k > begin) {
      mpz_mul(other_.get_mpz_t(), largest.num.get_mpz_t(), p.w.get_mpz_t());
      if (product_ * largest.den <= other_) continue;
    }
    swap(largest.num, product_);
    largest.den = p.w;
  }
}

/// The planes of all facets, in integers without a common divisor.
std::vector<Plane> TwoBodies::check_polytopes(Arena& integers) const {
  std::vector<Plane> result;
  result.reserve(c_->facets.items.size());
  mpz_class height, divisor;
  for (const InnerPolytope& polytope : c_->of_unions.polytopes) {
    Polygons polygons(vertices_of(polytope));
    polygons.take_polytope(c_->facets, polytope.first_facet, polytope.facets.end, polytope.facets.line);
    for (const Polygon& facet : polygons.all()) {
      const auto& [corner, w] = polygons.points()[facet.corners[0]];
      dot(height, facet.normal, corner);
      divisor = gcd(height, w);
      const mpz_class factor = w / divisor;
      const auto times = [&](const Integer& entry) { return integers.keep(entry.value() * factor); };
      result.push_back(
          {{times(facet.normal.x), times(facet.normal.y), times(facet.normal.z)}, integers.keep(height / divisor)});
    }
  }
  return result;
}

/// Differences of corners of its pieces.
std::vector<Homogeneous> TwoBodies::vertices_of(const InnerPolytope& polytope) const {
  require_pieces(*c_, polytope.i, polytope.j, polytope.line);
  const std::size_t first = polytope.first_vertex;
  std::vector<Homogeneous> result(polytope.vertices.end - first);
  for (std::size_t k = 0; k < result.size(); ++k) {
    const Pair pair = c_->vertices.items[first + k];
    const std::size_t line = c_->vertices.lines[first + k];
    const auto i = a_.corner(polytope.i, pair.i), j = b_.corner(polytope.j, pair.j);
    if (!j) throw refused(line, "the piece of b has no corner of this number");
    if (!i) throw refused(line, "the piece of a has no corner of this number");
    const Homogeneous &from = a_.points()[*i], &to = b_.points()[*j];
    subtract(result[k].x, to, from);
    result[k].w = from.w * to.w;
  }
  return result;
}

/// The weights are those of corners of the nearest pieces, over one denominator.
void TwoBodies::check_nearest() const {
  const UnionParts& parts = c_->of_unions;
  require_pieces(*c_, parts.nearest_a, parts.nearest_b, parts.nearest_line);
  mpz_class unit = 1;
  const auto for_each = [](const PiecedBody& body, std::size_t piece, const Part<std::vector<Weight>>& weights,
                           const auto& take) {
    for (std::size_t k = 0; k < weights.items.size(); ++k) {
      const auto corner = body.corner(piece, weights.items[k].index);
      if (!corner) throw refused(weights.lines[k], "the piece has no corner of this number");
      take(weights.items[k].index, body.points()[*corner]);
    }
  };
  const auto take_unit = [&unit](std::uint32_t, const Homogeneous& p) { unit = lcm(unit, p.w); };
  for_each(a_, parts.nearest_a, c_->weights_a, take_unit);
  for_each(b_, parts.nearest_b, c_->weights_b, take_unit);
  Arena integers;
  const auto points_of = [&](const PiecedBody& body, std::size_t piece, const Part<std::vector<Weight>>& weights) {
    std::vector<Vector> result(body.points().size());
    std::vector<bool> found(result.size());
    for_each(body, piece, weights, [&](std::uint32_t number, const Homogeneous& p) {
      if (found[number]) return;
      found[number] = true;
      const mpz_class factor = unit / p.w;
      result[number] = kept(integers, {p.x.x * factor, p.x.y * factor, p.x.z * factor});
    });
    return result;
  };
  const std::vector<Vector> a = points_of(a_, parts.nearest_a, c_->weights_a),
                            b = points_of(b_, parts.nearest_b, c_->weights_b);
  const Bound low{low_->num * unit * unit, low_->den};
  check_weights(*c_, {a, {}, 0, a.size()}, {b, {}, 0, b.size()}, low);
}

}  // namespace

void check_two_bodies(const Certificate& certificate, const Bound& low) { TwoBodies(certificate, low).check(); }

}  // namespace fathom_check
