// SPDX-License-Identifier: Apache-2.0
// The polytope inside P that holds the ball. Facets are polygons; no hull code, no topology, no
// tolerance.                                                          [FORMAT.md, sections 4 and 5]
#include <algorithm>
#include <limits>
#include <optional>

#include "checks.hpp"
#include "limits.hpp"
#include "vectors.hpp"

namespace fathom_check {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Finds facets by their edges: for each vertex u a list of where the edges from u lead, sorted.
/// Not hashed: no input can make it slow.
class EdgeTable {
 public:
  /// Of the facets from `first` to `last`, every corner of which is less than `vertices`.
  EdgeTable(const Facets& facets, std::size_t first, std::size_t last, std::size_t vertices)
      : begins_(vertices + 1), entries_(facets.begin_of(last) - facets.begin_of(first)) {
    for (std::size_t k = facets.begin_of(first); k < facets.begin_of(last); ++k) ++begins_[facets.corners[k]];
    std::size_t sum = 0;
    for (std::size_t& begin : begins_) {
      sum += begin;
      begin = sum;  // the end of the list, which moves to the begin while the list is filled
    }
    for (std::size_t f = first; f < last; ++f) {
      const std::size_t begin = facets.begin_of(f), end = facets.ends[f];
      for (std::size_t k = begin; k < end; ++k)
        entries_[--begins_[facets.corners[k]]] = {facets.corners[k + 1 == end ? begin : k + 1], f - first};
    }
    for (std::size_t u = 0; u < vertices; ++u)
      std::sort(entries_.data() + begins_[u], entries_.data() + begins_[u + 1]);
  }
  /// The first facet that has the edge from u to v, counted from `first`, or `none`.
  [[nodiscard]] std::size_t facet(std::uint32_t u, std::uint32_t v) const {
    const Entry* const end = entries_.data() + begins_[u + 1];
    const Entry* const found = std::lower_bound(entries_.data() + begins_[u], end, Entry{v, 0});
    return found != end && found->first == v ? found->second : none;
  }

 private:
  using Entry = std::pair<std::uint32_t, std::size_t>;  ///< v, and the facet
  std::vector<std::size_t> begins_;                     ///< of the lists among the entries; then the end of the last
  std::vector<Entry> entries_;
};

/// What a polytope is computed with: integers of any size,
struct AnySize {
  using Point = Vector;
  using Edge = MutableVector;
  using Normal = MutableVector;
  using Number = mpz_class;
  using Plane = fathom_check::Plane;
  static Plane kept_plane(Arena& integers, const Normal& normal, const Number& c) {
    return {kept(integers, normal), integers.keep(c)};
  }
};

/// or those that hold all that is computed of vertices of few bits.
struct FixedSize {
  using Point = Words;
  using Edge = Words;
  using Normal = FixedVector<Int128>;
  using Number = Int256;
  struct Plane {
    Normal normal;
    Number c;
  };
  static Plane kept_plane(Arena& /*integers*/, const Normal& normal, const Number& c) { return {normal, c}; }
};

/// How few: the m bits that coordinates of vertices may have if each facet has less than 2^s
/// corners. Then edges are below 2^(m+1), the normal of a fan triangle has entries below 2^(2m+3),
/// and N, the sum of less than 2^s of these, entries below 2^(2m+s+3). So <N,N'> < 3 * 2^(4m+2s+6)
/// for two normals. All else is smaller: <N,v> < 3 * 2^(3m+s+3), and v x v' has no larger entries
/// than a fan triangle's normal.
constexpr std::size_t most_bits_of_vertices(std::size_t s) { return (247 - 2 * s) / 4; }

constexpr bool all_fits() {
  for (std::size_t s = 0; s <= 64; ++s) {
    const std::size_t m = most_bits_of_vertices(s);
    if (m + 1 > 63 || 2 * m + s + 3 > 127 || 4 * m + 2 * s + 8 > 255) return false;
  }
  return true;
}
static_assert(all_fits(), "words hold edges, 127 bits normals, 255 bits products of two normals");

template <class Kind>
class Inner {
 public:
  using Point = typename Kind::Point;
  using Plane = typename Kind::Plane;

  Inner(const std::vector<Point>& vertices, const FacetRange& range, const Bound& squared, const NearestFacet& nearest,
        Arena& integers, const Units& units)
      : vertices_(&vertices),
        range_(&range),
        facets_(&range.part->items),
        squared_(&squared),
        nearest_(&nearest),
        integers_(&integers),
        units_(&units) {}

  std::vector<Plane> check() {
    if (size() == 0) throw refused(range_->line, "there is no facet");
    planes_.reserve(size());
    for (std::size_t f = 0; f < size(); ++f) check_facet(f);
    const EdgeTable edges(*facets_, range_->first, range_->last, vertices_->size());
    for (std::size_t f = 0; f < size(); ++f) check_edges(f, edges);
    const auto opposite = [this](const Plane& g) {
      dot(height_, g.normal, planes_.front().normal);
      return sgn(height_) < 0;
    };
    if (std::none_of(planes_.begin(), planes_.end(), opposite))
      throw refused(range_->line, "no facet faces away from the first");
    return std::move(planes_);
  }

 private:
  // Facets are counted from the first of the range.
  void check_facet(std::size_t f);
  void find_plane(std::size_t f);
  void find_fan_normal(std::size_t f, std::size_t k);
  void check_distance(std::size_t f);
  void make_equal();
  void check_polygon(std::size_t f);
  void check_edges(std::size_t f, const EdgeTable& edges);
  bool turns_inward(std::size_t f, std::size_t k, const Plane& across);

  [[nodiscard]] std::size_t size() const { return range_->last - range_->first; }
  [[nodiscard]] std::size_t begin_of(std::size_t f) const { return facets_->begin_of(range_->first + f); }
  [[nodiscard]] std::size_t corners(std::size_t f) const { return begin_of(f + 1) - begin_of(f); }
  /// The number of corner k of facet f, cyclically: k is less than twice their number.
  [[nodiscard]] std::uint32_t number(std::size_t f, std::size_t k) const {
    return facets_->corners[begin_of(f) + (k < corners(f) ? k : k - corners(f))];
  }
  [[nodiscard]] const Point& corner(std::size_t f, std::size_t k) const { return (*vertices_)[number(f, k)]; }
  [[nodiscard]] std::size_t line(std::size_t f) const { return range_->part->lines[range_->first + f]; }

  const std::vector<Point>* vertices_;
  const FacetRange* range_;
  const Facets* facets_;
  const Bound* squared_;
  const NearestFacet* nearest_;
  Arena* integers_;
  const Units* units_;
  std::vector<Plane> planes_;

  // What is computed about the facet at hand.
  typename Kind::Edge first_edge_, second_edge_;
  typename Kind::Normal normal_, product_;
  typename Kind::Number c_of_plane_, height_;
  MutableVector equal_;  ///< the normal where the axes have equal units
  mpz_class reached_, needed_;
};

// All that concerns this facet alone.
template <class Kind>
void Inner<Kind>::check_facet(std::size_t f) {
  const std::size_t count = corners(f);
  if (count < 3) throw refused(line(f), "a facet has at least three corners");
  for (std::size_t k = 0; k < count; ++k)
    if (number(f, k) >= vertices_->size()) throw refused(line(f), "there is no vertex " + std::to_string(number(f, k)));
  find_plane(f);
  check_distance(f);
  // The plane through a triangle's corners is that of its normal, and its only fan triangle has
  // det(v_0, v_1, v_2) = c > 0.
  if (count > 3) check_polygon(f);
  planes_.push_back(Kind::kept_plane(*integers_, normal_, c_of_plane_));
}

/// (v_k - v_0) x (v_(k+1) - v_0), into product_. Its product with v_0 is det(v_0, v_k, v_(k+1)).
template <class Kind>
void Inner<Kind>::find_fan_normal(std::size_t f, std::size_t k) {
  subtract(first_edge_, corner(f, k), corner(f, 0));
  subtract(second_edge_, corner(f, k + 1), corner(f, 0));
  cross(product_, first_edge_, second_edge_);
}

// The sum of all v_k x v_(k+1) is that of the fan normals: multiply these out.
template <class Kind>
void Inner<Kind>::find_plane(std::size_t f) {
  find_fan_normal(f, 1);
  std::swap(normal_, product_);
  for (std::size_t k = 2; k + 1 < corners(f); ++k) {
    find_fan_normal(f, k);
    add(normal_, product_);
  }
  dot(c_of_plane_, normal_, corner(f, 0));
}

template <class Kind>
void Inner<Kind>::make_equal() {
  copy(equal_.x, normal_.x), copy(equal_.y, normal_.y), copy(equal_.z, normal_.z);
  units_->make_equal(equal_);
}

template <class Kind>
void Inner<Kind>::check_distance(std::size_t f) {
  if (sgn(c_of_plane_) <= 0) throw refused(line(f), "O does not lie below this facet");
  copy(reached_, c_of_plane_);
  reached_ *= reached_;
  reached_ *= squared_->den;
  if (units_->equal()) {
    dot(height_, normal_, normal_);
    copy(needed_, height_);
  } else {
    make_equal();
    dot(needed_, equal_, equal_);
  }
  needed_ *= squared_->num;
  if (reached_ < needed_) throw refused(line(f), "this facet is nearer to O than claimed");
  if (!*nearest_ || reached_ != needed_) return;
  make_equal();
  (*nearest_)(line(f), equal_);
}

template <class Kind>
void Inner<Kind>::check_polygon(std::size_t f) {
  for (std::size_t k = 1; k < corners(f); ++k) {
    dot(height_, normal_, corner(f, k));
    if (height_ != c_of_plane_) throw refused(line(f), "the corners of this facet do not lie on one plane");
  }
  for (std::size_t k = 1; k + 1 < corners(f); ++k) {
    find_fan_normal(f, k);
    dot(height_, product_, corner(f, 0));
    if (sgn(height_) <= 0) throw refused(line(f), "the corners of this facet do not turn one way around O");
  }
}

// Across each edge, the neighbour's plane leaves this facet below.
template <class Kind>
void Inner<Kind>::check_edges(std::size_t f, const EdgeTable& edges) {
  for (std::size_t k = 0; k < corners(f); ++k) {
    const std::uint32_t u = number(f, k), v = number(f, k + 1);
    const std::size_t g = edges.facet(v, u);
    const auto edge = [u, v] { return "the edge " + std::to_string(u) + " " + std::to_string(v); };
    if (g == none) throw refused(line(f), "no facet lies across " + edge());
    // Both ends are corners of g, so they lie on its plane: check_facet has seen to that.
    if (!turns_inward(f, k, planes_[g])) throw refused(line(f), "not convex across " + edge());
  }
}

/// Whether some corner w of f has det(u, v, w) > 0 and lies strictly below the plane across the
/// edge uv that begins at corner k.
template <class Kind>
bool Inner<Kind>::turns_inward(std::size_t f, std::size_t k, const Plane& across) {
  const bool triangle = corners(f) == 3;  // then det(u, v, w) is c > 0
  if (!triangle) cross(product_, corner(f, k), corner(f, k + 1));
  for (std::size_t step = 2; step < corners(f); ++step) {
    const Point& w = corner(f, k + step);
    if (!triangle) {
      dot(height_, product_, w);
      if (sgn(height_) <= 0) continue;
    }
    dot(height_, across.normal, w);
    if (height_ < across.c) return true;
  }
  return false;
}

/// Throws unless a direction of the list, primitive and ascending as check_directions found, is the
/// normal divided by its greatest divisor.
void check_listed(const std::vector<Vector>& listed, MutableVector normal, std::size_t line) {
  mpz_class divisor;
  find_gcd(divisor, normal);
  divide(normal, divisor);
  const auto found = std::lower_bound(listed.begin(), listed.end(), normal, ascending<Vector, MutableVector>);
  if (found == listed.end() || ascending(normal, *found))
    throw refused(line, "this facet is as near as the depth, and its direction is not among all directions");
}

/// Calls `take` with the numbers of the points of b and of a that each vertex is the difference of.
template <class Take>
void for_each_vertex(const Part<std::vector<Pair>>& vertices, std::size_t first, std::size_t last, const Points& a,
                     const Points& b, const Take& take) {
  for (std::size_t k = first; k < last; ++k) {
    const Pair pair = vertices.items[k];
    if (pair.j >= b.size()) throw refused(vertices.lines[k], "b has no point of this number");
    if (pair.i >= a.size()) throw refused(vertices.lines[k], "a has no point of this number");
    take(pair.j, pair.i);
  }
}

std::size_t bits_of_words(const Words& v) {
  const auto size = [](Word n) { return static_cast<std::uint64_t>(n < 0 ? -n : n); };
  const std::uint64_t all = size(v.x) | size(v.y) | size(v.z);
  return all == 0 ? 0 : 64 - static_cast<std::size_t>(__builtin_clzll(all));
}

/// The vertices, if those of these facets are of so few bits that integers of a fixed size do.
std::optional<std::vector<Words>> fixed_differences(const Certificate& c, const Points& a, const Points& b) {
  if (a.words() == nullptr || b.words() == nullptr) return std::nullopt;
  std::vector<Words> result;
  result.reserve(c.vertices.items.size());
  std::size_t most = 0, corners = 0, s = 0;
  for_each_vertex(c.vertices, 0, c.vertices.items.size(), a, b, [&](std::size_t j, std::size_t i) {
    subtract(result.emplace_back(), b.words()[j], a.words()[i]);
    most = std::max(most, bits_of_words(result.back()));
  });
  const Facets& facets = c.facets.items;
  for (std::size_t f = 0; f < facets.size(); ++f) corners = std::max(corners, facets.ends[f] - facets.begin_of(f));
  while (corners >> s != 0) ++s;
  return most <= most_bits_of_vertices(s) ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace

std::vector<Vector> differences(const Part<std::vector<Pair>>& vertices, std::size_t first, std::size_t last,
                                const Points& a, const Points& b, Arena& integers) {
  std::vector<Vector> result;
  result.reserve(last - first);
  MutableVector difference;
  for_each_vertex(vertices, first, last, a, b, [&](std::size_t j, std::size_t i) {
    subtract(difference, b[j], a[i]);
    result.push_back(kept(integers, difference));
  });
  return result;
}

std::vector<Plane> check_polytope(const std::vector<Vector>& vertices, const FacetRange& facets, const Bound& squared,
                                  const NearestFacet& nearest, Arena& integers, const Units& units) {
  return Inner<AnySize>(vertices, facets, squared, nearest, integers, units).check();
}

void check_inner(const Certificate& c, const Scaled& bodies, const Bound& squared) {
  Arena integers;
  NearestFacet nearest;
  if (c.all)
    nearest = [&c](std::size_t line, const MutableVector& normal) { check_listed(c.directions.items, normal, line); };
  const FacetRange facets{&c.facets, 0, c.facets.items.size(), c.facets.line};
  const Points a = bodies.a.all_points(), b = bodies.b.all_points();
  if (const auto vertices = fixed_differences(c, a, b)) {
    Inner<FixedSize>(*vertices, facets, squared, nearest, integers, bodies.units).check();
  } else {
    check_polytope(differences(c.vertices, 0, c.vertices.items.size(), a, b, integers), facets, squared, nearest,
                   integers, bodies.units);
  }
}

// Polytopes inside the differences of two pieces.

namespace {

/// The vertices, less their mean, times their number.
std::vector<Vector> around_the_mean(const std::vector<Vector>& vertices, Arena& integers) {
  MutableVector sum;
  for (const Vector& v : vertices) add(sum, copied(v));
  std::vector<Vector> result;
  result.reserve(vertices.size());
  const mpz_class count = static_cast<unsigned long>(vertices.size());
  MutableVector moved;
  for (const Vector& v : vertices) {
    const auto move = [&count](mpz_class& to, const Integer& from, const mpz_class& of_sum) {
      mpz_mul(to.get_mpz_t(), from.get_mpz_t(), count.get_mpz_t());
      to -= of_sum;
    };
    move(moved.x, v.x, sum.x);
    move(moved.y, v.y, sum.y);
    move(moved.z, v.z, sum.z);
    result.push_back(kept(integers, moved));
  }
  return result;
}

/// The same plane where the vertices were, for a primitive normal.
Plane moved_back(const Plane& plane, const Vector& corner, Arena& integers) {
  MutableVector normal = copied(plane.normal);
  mpz_class c;
  find_gcd(c, normal);
  divide(normal, c);
  dot(c, normal, corner);
  return {kept(integers, normal), integers.keep(c)};
}

}  // namespace

std::vector<Plane> check_polytopes(const Certificate& c, const Scaled& bodies, Arena& integers) {
  std::vector<Plane> result;
  result.reserve(c.facets.items.size());
  for (const InnerPolytope& polytope : c.of_unions.polytopes) {
    require_pieces(c, polytope.i, polytope.j, polytope.line);
    Arena here;
    const std::vector<Vector> corners =
        differences(c.vertices, polytope.first_vertex, polytope.vertices.end, piece(c.a, bodies.a, polytope.i),
                    piece(c.b, bodies.b, polytope.j), here);
    const FacetRange range{&c.facets, polytope.first_facet, polytope.facets.end, polytope.facets.line};
    const std::vector<Plane> planes = check_polytope(around_the_mean(corners, here), range, {0, 1}, {}, here);
    for (std::size_t f = 0; f < planes.size(); ++f) {
      const std::uint32_t first = c.facets.items.corners[c.facets.items.begin_of(range.first + f)];
      result.push_back(moved_back(planes[f], corners[first], integers));
    }
  }
  return result;
}

}  // namespace fathom_check
