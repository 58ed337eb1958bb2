// SPDX-License-Identifier: Apache-2.0
// Which checks belong to which claim about two bodies that are solids or unions. There is no common
// denominator: it could have as many digits as all points together.         [FORMAT.md, section 15]
#include <algorithm>

#include "polygons.hpp"
#include "solids.hpp"
#include "unions.hpp"

namespace fathom_check {
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
  [[nodiscard]] std::vector<Homogeneous> vertices_of(const InnerPolytope& polytope, std::size_t first) const;
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
  List vertices{0, 0}, facets{0, 0};  // of the polytope before
  mpz_class height, divisor;
  for (const InnerPolytope& polytope : c_->of_unions.polytopes) {
    Polygons polygons(vertices_of(polytope, vertices.end));
    polygons.take_polytope(c_->facets, facets.end, polytope.facets.end, polytope.facets.line);
    for (const Polygon& facet : polygons.all()) {
      const auto& [corner, w] = polygons.points()[facet.corners[0]];
      dot(height, facet.normal, corner);
      divisor = gcd(height, w);
      const mpz_class factor = w / divisor;
      const auto times = [&](const Integer& entry) { return integers.keep(entry.value() * factor); };
      result.push_back(
          {{times(facet.normal.x), times(facet.normal.y), times(facet.normal.z)}, integers.keep(height / divisor)});
    }
    vertices = polytope.vertices;
    facets = polytope.facets;
  }
  return result;
}

/// Differences of corners of its pieces, from number `first` on.
std::vector<Homogeneous> TwoBodies::vertices_of(const InnerPolytope& polytope, std::size_t first) const {
  if (polytope.i >= a_.pieces()) throw refused(polytope.line, "a has no piece of this number");
  if (polytope.j >= b_.pieces()) throw refused(polytope.line, "b has no piece of this number");
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
  if (parts.nearest_a >= a_.pieces()) throw refused(parts.nearest_line, "a has no piece of this number");
  if (parts.nearest_b >= b_.pieces()) throw refused(parts.nearest_line, "b has no piece of this number");
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
