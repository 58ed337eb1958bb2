// SPDX-License-Identifier: GPL-3.0-or-later
// The search: a polytope inside P expands towards the facets of P nearest to O. One template over
// the integers: those of a fixed size, which need no allocation, where the lattice is narrow; lazy
// ones elsewhere; and mpz_class, the naive twin.                              [proofs/expanding.md]
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "kernels/filters/plane.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/number/lazy_integer.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/predicates/direction.hpp"
#include "reference/expanding/expanding_polytope.hpp"
#include "reference/expanding/surface.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::expanding {

/// The memory of one search, for the next one to use again.
template <class Integer>
struct Memory {
  Surface<Integer> surface;
  MergeMemory merge;
  std::vector<std::pair<double, TriangleId>> waiting;        // a heap
  std::vector<TriangleId> nearest;                           // triangles in the nearest facets of P
  std::vector<std::pair<std::uint32_t, TriangleId>> facets;  // of Q, for each of them
};

using polytope::to_mpz;
using polytope::to_vector;

/// The vector without the common factor of its components.
inline Vector without_factor(const Vector& v) { return primitive(v); }
inline Vector without_factor(const Vec3<kernels::LazyInteger>& v) { return primitive(to_vector(v)); }
template <class Integer>
Vector without_factor(const Vec3<Integer>& v) {
  if (kernels::bit_length(v) > 63) return primitive(to_vector(v));
  const std::int64_t x = v.x.to_word(), y = v.y.to_word(), z = v.z.to_word(),
                     factor = std::max<std::int64_t>(std::gcd(std::gcd(x, y), z), 1);
  return {x / factor, y / factor, z / factor};
}

/// What holds squared distances, and products of them: word integers do not.
template <class Integer>
struct SquareOf {
  using type = Integer;
};
template <kernels::WordInteger Integer>
struct SquareOf<Integer> {
  using type = polytope::NarrowInteger;
};

/// A squared distance from O, as a quotient, and a binary64 number that the distance does not
/// exceed.
template <class Square>
struct Radius {
  Square numerator, denominator;
  double from_above;
};

/// The distance of the plane of a triangle that lies in a facet of P, height / sqrt(length), and
/// such a number.
template <class Integer>
struct FacetDistance {
  TriangleId of;
  Integer height, length;
  double from_above;
};

template <class Differences>
class Expander {
 public:
  using Integer = typename Differences::Integer;
  using Square = typename SquareOf<Integer>::type;
  using Plane = ExactPlane<Integer>;
  using Corner = SurfaceVertex<Integer>;

  Expander(kernels::Context& context, Differences& differences, Memory<Integer>& memory, std::size_t budget)
      : context_(context), differences_(differences), memory_(memory), surface_(memory.surface), budget_(budget) {}

  /// False if P is flat. Q becomes the hull of the differences in `from`, if these are not flat.
  bool start(std::span<const polytope::Difference> from = {}) {
    memory_.waiting.clear();
    auto first = four_of(from);
    if (!first) first = starting_tetrahedron(differences_);
    if (!first) return false;
    surface_.start({corner((*first)[0]), corner((*first)[1]), corner((*first)[2]), corner((*first)[3])});
    for (const polytope::Difference& d : from) take_in(corner(d));
    wait_for_all();
    return true;
  }

  /// Leaves triangles in all nearest facets of P in the memory.
  ExpansionEnd find_nearest() {
    memory_.nearest.clear();
    nearest_.reset();
    return grow([&](TriangleId t) { return nearest_ && beyond(t, *nearest_, false); },
                [&](TriangleId t) {
                  const int order = nearest_ ? compare_distance(t, *nearest_) : -1;
                  if (order > 0) return true;
                  if (order < 0) {
                    memory_.nearest.clear();
                    const double from_above = radius_of(squared_height(t), squared_length(t)).from_above;
                    nearest_ = {t, surface_.plane(t).height, length_of(t), from_above};
                  }
                  memory_.nearest.push_back(t);
                  return true;
                });
  }

  /// Expands until O is in the interior of Q. Else O does not lie below the facet of P in which the
  /// one triangle lies that is left in the memory.
  ExpansionEnd find_origin() {
    memory_.nearest.clear();
    return grow([&](TriangleId t) { return above_origin(t); }, [](TriangleId) { return true; });
  }

  /// Of that triangle.
  const Plane& plane_of_nearest() { return surface_.plane(memory_.nearest.front()); }

  /// Expands until Q holds the ball. Sets `holds` to whether P does.
  ExpansionEnd fill_ball(const mpq_class& squared, bool& holds) {
    const Radius<Square> radius = radius_of(Square(squared.get_num()), Square(squared.get_den()));
    bool met = false;  // a facet of P that cuts the ball
    const ExpansionEnd end = grow([&](TriangleId t) { return beyond(t, radius, true); },
                                  [&](TriangleId) {
                                    met = true;
                                    return false;
                                  });
    holds = end == ExpansionEnd::proved && !met;
    return end;
  }

  /// Expands until Q's triangles are no nearer than `next`, which shrinks to each facet distance
  /// found, ignoring facets at `depth`.
  ExpansionEnd find_next(const mpq_class& depth, mpq_class& next) {
    Radius<Square> radius = radius_of(Square(next.get_num()), Square(next.get_den()));
    return grow([&](TriangleId t) { return beyond(t, radius, true); },
                [&](TriangleId t) {
                  const Square square = squared_height(t), length = squared_length(t);
                  const mpq_class squared = kernels::ratio(to_mpz(square), to_mpz(length));
                  if (squared != depth) {
                    next = squared;
                    radius = radius_of(square, length);
                  }
                  return true;
                });
  }

  /// Expands until shows(n) for a normal n of a triangle, and sets `direction` to it, or leaves it
  /// as it is if there is none.
  template <class Shows>
  ExpansionEnd find_direction(Shows shows, Vector& direction) {
    memory_.waiting.clear();
    wait_for_all();
    while (!memory_.waiting.empty()) {
      const TriangleId t = take();
      if (!surface_.triangles()[t].alive) continue;
      const Vector normal = to_vector(surface_.plane(t).normal);
      if (shows(normal)) {
        direction = primitive(normal);
        return ExpansionEnd::proved;
      }
      const std::optional<Corner> above = point_above(t);
      if (above && !expand(*above, t)) return ExpansionEnd::spent;
    }
    return ExpansionEnd::proved;
  }

  /// The vertices of Q, at most so many, those in nearest facets first.
  void list_vertices(std::vector<polytope::Difference>& list, std::size_t most) {
    memory_.merge.name.assign(surface_.vertices().size(), 0);
    list.clear();
    const auto list_corners = [&](TriangleId t) {
      for (const CornerId c : surface_.triangles()[t].corners)
        if (list.size() < most && std::exchange(memory_.merge.name[c], 1) == 0)
          list.push_back(surface_.vertices()[c].from);
    };
    for (const TriangleId t : memory_.nearest) list_corners(t);
    for (const TriangleId t : surface_.triangles().ids())
      if (surface_.triangles()[t].alive) list_corners(t);
  }

  InnerPolytope inner() { return inner_polytope(surface_, memory_.merge); }

  /// The primitive normals of the nearest facets, after find_nearest.
  std::set<Vector, LexicographicOrder> normals_of_nearest() {
    std::set<Vector, LexicographicOrder> normals;
    for (const TriangleId t : memory_.nearest) normals.insert(without_factor(surface_.plane(t).normal));
    return normals;
  }

  /// The planes of the nearest facets, after find_nearest and inner.
  kernels::NearestPlanes nearest() {
    memory_.facets.clear();
    for (const TriangleId t : memory_.nearest) memory_.facets.emplace_back(memory_.merge.facet_of[t], t);
    std::sort(memory_.facets.begin(), memory_.facets.end());
    std::set<Vector, LexicographicOrder> directions;
    std::uint32_t last = UINT32_MAX;
    for (const auto& [facet, t] : memory_.facets)
      if (std::exchange(last, facet) != facet) directions.insert(without_factor(surface_.plane(t).normal));
    const mpz_class height = to_mpz(nearest_->height);
    return {height * height, to_mpz(nearest_->length), std::move(directions)};
  }

  [[nodiscard]] const SideCounts& sides() const { return surface_.sides(); }
  std::size_t points = 0;

 private:
  // The first four of these differences that do not lie in one plane; nullopt if all do.
  std::optional<std::array<polytope::Difference, 4>> four_of(std::span<const polytope::Difference> from) const {
    std::array<polytope::Difference, 4> four;
    std::array<Vec3<Integer>, 4> p;
    int found = 0;
    for (const polytope::Difference& d : from) {
      four[found] = d;
      p[found] = differences_[d];
      const bool leads_out = found == 0 || (found == 1 && !(p[1] == p[0])) ||
                             (found == 2 && !is_zero(cross(p[1] - p[0], p[2] - p[0]))) ||
                             (found == 3 && sgn(det(p[1] - p[0], p[2] - p[0], p[3] - p[0])) != 0);
      if (leads_out && ++found == 4) return four;
    }
    return std::nullopt;
  }

  // Q becomes the hull with this point.
  void take_in(const Corner& point) {
    for (const TriangleId t : surface_.triangles().ids()) {
      if (!surface_.triangles()[t].alive || surface_.side(t, point) <= 0) continue;
      surface_.insert(point, t);
      return;
    }
  }

  Corner corner(polytope::Difference d) const {
    Vec3<Integer> exact = differences_[d];
    const Vec3<double> rounded = kernels::image(exact, differences_.exponent());
    return {d, std::move(exact), rounded};
  }

  [[nodiscard]] Radius<Square> radius_of(const Square& numerator, const Square& denominator) const {
    return {numerator, denominator, kernels::root_from_above(numerator, denominator, differences_.exponent())};
  }

  // The triangle that seems nearest is the first of the heap.
  void wait_for(TriangleId t) {
    memory_.waiting.emplace_back(-estimated_distance(t), t);
    std::push_heap(memory_.waiting.begin(), memory_.waiting.end());
  }

  TriangleId take() {
    std::pop_heap(memory_.waiting.begin(), memory_.waiting.end());
    const TriangleId t = memory_.waiting.back().second;
    memory_.waiting.pop_back();
    return t;
  }

  void wait_for_all() {
    for (const TriangleId t : surface_.triangles().ids())
      if (surface_.triangles()[t].alive) wait_for(t);
  }

  // Takes triangle after triangle, except those that `pass_over` skips, and expands Q towards a
  // point of P above it. A triangle with nothing above it lies in the plane of a facet of P, and
  // `go_on` gets it.
  template <class PassOver, class GoOn>
  ExpansionEnd grow(PassOver pass_over, GoOn go_on) {
    while (!memory_.waiting.empty()) {
      const TriangleId t = take();
      if (!surface_.triangles()[t].alive || pass_over(t)) continue;
      if (const std::optional<Corner> above = point_above(t)) {
        if (!expand(*above, t)) return ExpansionEnd::spent;
        continue;
      }
      if (sgn(surface_.plane(t).height) <= 0) {
        memory_.nearest.assign(1, t);
        return ExpansionEnd::not_inside;
      }
      if (!go_on(t)) return ExpansionEnd::proved;
    }
    return ExpansionEnd::proved;
  }

  // Decides nothing but the order.
  double estimated_distance(TriangleId t) {
    const kernels::RoundedPlane& rounded = surface_.triangles()[t].rounded;
    if (rounded.trustworthy()) return rounded.estimated_distance();
    const double distance = kernels::root_from_above(squared_height(t), squared_length(t), differences_.exponent());
    return sgn(surface_.plane(t).height) < 0 ? -distance : distance;
  }

  Square squared_height(TriangleId t) {
    const std::conditional_t<std::is_same_v<Square, Integer>, const Square&, Square> height(surface_.plane(t).height);
    return height * height;
  }
  Integer length_of(TriangleId t) { return dot(surface_.plane(t).normal, surface_.plane(t).normal); }
  Square squared_length(TriangleId t) { return Square(length_of(t)); }

  // The sign of the distance of the triangle's plane from O, less the other. O lies below both.
  int compare_distance(TriangleId t, const Radius<Square>& other) {
    return cmp(Square(squared_height(t) * other.denominator), Square(other.numerator * squared_length(t)));
  }
  int compare_distance(TriangleId t, const FacetDistance<Integer>& other) {
    if constexpr (Surface<Integer>::lazy)
      if (const auto sure = sure_order(t, other)) return *sure;
    const Integer mine = length_of(t);
    if (mine == other.length) return cmp(surface_.plane(t).height, other.height);
    const Square height(other.height);
    return cmp(Square(squared_height(t) * Square(other.length)), Square(height * height * Square(mine)));
  }

  // The same if that is sure.                              [proofs/expanding.md, "Lazy integers"]
  std::optional<int> sure_order(TriangleId t, const FacetDistance<Integer>& other) {
    using kernels::WideEnclosure;
    const auto sign_of = [](const WideEnclosure& x) {
      const auto sure = x.sign();
      return sure ? std::optional(kernels::to_int(*sure)) : std::nullopt;
    };
    const Vec3<WideEnclosure> n = enclosure(surface_.plane(t).normal), m = enclosure(surface_.plane(other.of).normal);
    const WideEnclosure h = surface_.plane(t).height.enclosure(), g = other.height.enclosure();
    if (const auto sure = sign_of(h * h * other.length.enclosure() - g * g * dot(n, n))) return sure;
    if (surface_.in_plane_by_name(other.of, t)) return 0;
    // <w, h m + g n> for w = h m - g n = (n x m) x p - <m, q - p> n, in a form in which enclosures
    // have digits left.
    const Vec3<WideEnclosure> across = surface_.cross_enclosure(t, other.of), sum = h * m + g * n;
    for (const CornerId c : surface_.triangles()[t].corners) {
      const Corner& p = surface_.vertices()[c];
      const Vec3<WideEnclosure> w = cross(across, enclosure(p.exact)) + surface_.height_enclosure(other.of, p) * n;
      if (const auto sure = sign_of(dot(w, sum))) return sure;
    }
    return std::nullopt;
  }

  // Whether O lies below the plane, at a greater distance than the radius, or perhaps an equal one.
  template <class Distance>
  bool beyond(TriangleId t, const Distance& radius, bool or_equal) {
    if (surface_.triangles()[t].rounded.surely_beyond(radius.from_above)) return true;
    if (sgn(surface_.plane(t).height) <= 0) return false;
    const int order = compare_distance(t, radius);
    return or_equal ? order >= 0 : order > 0;
  }

  bool above_origin(TriangleId t) {
    return surface_.triangles()[t].rounded.surely_beyond(0) || sgn(surface_.plane(t).height) > 0;
  }

  // Returns a point of P strictly above the triangle's plane: a guess that an exact sign confirms,
  // or an extreme point. Returns nullopt if the plane supports P.
  std::optional<Corner> point_above(TriangleId t) {
    std::optional<Corner> found = corner(likely_extreme(t));
    if (surface_.side(t, *found) > 0) return found;
    found = corner(extreme(t));
    if (surface_.side(t, *found) > 0) return found;
    return std::nullopt;
  }

  polytope::Difference extreme(TriangleId t) {
    if constexpr (Surface<Integer>::lazy) return differences_.extreme(surface_.plane(t).normal, surface_.level(t));
    else return differences_.extreme(surface_.plane(t).normal);
  }

  polytope::Difference likely_extreme(TriangleId t) {
    const kernels::RoundedPlane& plane = surface_.triangles()[t].rounded;
    if (plane.trustworthy()) return differences_.likely_extreme(plane.estimated_normal());
    const Vec3<Integer>& exact = surface_.plane(t).normal;
    return differences_.likely_extreme(kernels::image(exact, kernels::bit_length(exact)));
  }

  bool expand(const Corner& above, TriangleId t) {
    if (points == budget_) return false;
    context_.report("expanding polytope");
    ++points;
    for (const TriangleId fresh : surface_.insert(above, t)) wait_for(fresh);
    return true;
  }

  kernels::Context& context_;
  Differences& differences_;
  Memory<Integer>& memory_;
  Surface<Integer>& surface_;
  std::size_t budget_;
  std::optional<FacetDistance<Integer>> nearest_;
};

}  // namespace fathom::expanding

namespace fathom {

/// What a Workspace holds.
struct Workspace::Parts {
  expanding::Memory<kernels::Integer127> small;
  expanding::Memory<kernels::Integer255> middle;
  expanding::Memory<polytope::NarrowInteger> narrow;
  expanding::Memory<kernels::LazyInteger> lazy;
  expanding::Memory<mpz_class> wide;
  kernels::ScanMemory scan;
  polytope::NarrowMemory placed;           ///< by the caller of an expansion, which leaves it alone
  polytope::PosedPoints posed_a, posed_b;  ///< of bodies that poses move

  template <class Integer>
  expanding::Memory<Integer>& memory() {
    if constexpr (std::is_same_v<Integer, kernels::Integer127>) return small;
    else if constexpr (std::is_same_v<Integer, kernels::Integer255>) return middle;
    else if constexpr (std::is_same_v<Integer, mpz_class>) return wide;
    else if constexpr (std::is_same_v<Integer, kernels::LazyInteger>) return lazy;
    else return narrow;
  }
};

}  // namespace fathom
