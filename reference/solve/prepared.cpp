// SPDX-License-Identifier: GPL-3.0-or-later
// Prepared bodies. The hull is computed once; a pose moves only its corners, in integers of 128
// bits if they suffice. Two bodies with few edges that differ in direction, such as boxes, are
// answered by their separating axes, all others by an expanding polytope that begins where the last
// one ended. Whatever is left over goes the way of bodies that are not prepared.
//                                                                             [proofs/prepared.md]
#include "fathom/prepared.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>

#include "kernels/context.hpp"
#include "kernels/float_environment.hpp"
#include "reference/depth/apart.hpp"
#include "reference/expanding/expander.hpp"
#include "reference/expanding/expanding_polytope.hpp"
#include "reference/files/pose.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/polytope/position.hpp"
#include "reference/solve/depth.hpp"

namespace fathom {

namespace solve {

/// Two indices of points: an edge, directed from the first to the second.
using EdgeEnds = std::array<std::uint32_t, 2>;

}  // namespace solve

namespace {

using polytope::Points;
using polytope::PosedPoints;
using solve::EdgeEnds;

/// Bodies have few axes if there are at most so many.
constexpr std::size_t few_axes = 64;

std::optional<polytope::AlignedNumbers> aligned_points(const GivenPoints& points) {
  if (!points.in_binary64()) return std::nullopt;
  const auto given = points.binary64();
  return polytope::aligned({given.front().data(), 3 * given.size()});
}

}  // namespace

struct Prepared::Parts {
  Body body;
  std::optional<polytope::AlignedNumbers> integers;  ///< of all points, if they are in binary64 and fit

  std::vector<std::uint32_t> extreme;
  /// Those that are moved: the extreme ones of a solid body, else all.
  std::vector<std::uint32_t> kept;
  // Of the hull of a solid body, by indices in `kept`. Parallel edges or facets are listed once.
  std::vector<solve::EdgeEnds> edges;
  std::vector<std::array<solve::EdgeEnds, 2>> facets;  ///< two edges that are not parallel

  explicit Parts(const Body& given) : body(given), integers(aligned_points(given.points)) {
    const std::vector<Point>& points = body.points.exact();
    const polytope::Polytope hull = polytope::hull_of(points);
    extreme.assign(hull.input_ids.begin(), hull.input_ids.end());
    kept = extreme;
    if (hull.rank < 3) {
      kept.resize(points.size());
      std::iota(kept.begin(), kept.end(), 0U);
      return;
    }
    std::set<Vector, LexicographicOrder> known;
    const auto is_new = [&](const Vector& v) { return !known.contains(-v) && known.insert(v).second; };
    for (const polytope::Edge& edge : hull.edges)
      if (is_new(primitive(Vector(hull.vertices[edge.to] - hull.vertices[edge.from]))))
        edges.push_back({edge.from.value, edge.to.value});
    known.clear();
    for (const polytope::Facet& facet : hull.facets) {
      const auto corner = [&](std::uint32_t k) { return hull.corners[facet.begin + k].value; };
      if (is_new(facet.normal)) facets.push_back({EdgeEnds{corner(0), corner(1)}, EdgeEnds{corner(0), corner(2)}});
    }
  }

  [[nodiscard]] bool keeps_all() const { return kept.size() == body.points.size(); }
};

Prepared::Prepared(const Body& polytope) {
  if (polytope.shape || polytope.pieces || polytope.points.empty())
    throw std::invalid_argument("only a polytope with points can be prepared");
  solve::require_space(polytope, polytope, "Prepared");
  const kernels::DefaultFloatEnvironment environment;
  parts = std::make_shared<const Parts>(polytope);
}

const Body& Prepared::body() const { return parts->body; }
const std::vector<std::uint32_t>& Prepared::extreme_points() const { return parts->extreme; }

namespace {

/// Makes `view` the points of a placed body where they are, all or only those that are kept. Throws
/// std::invalid_argument if a number of the pose is not finite, or not in lowest terms.
void show(const PlacedBody& placed, bool only_kept, PosedPoints& view) {
  const Prepared::Parts& parts = *placed.prepared.parts;
  view.given = &parts.body.points;
  view.integers = parts.integers ? &*parts.integers : nullptr;
  view.chosen = {};
  if (only_kept && !parts.keeps_all()) view.chosen = parts.kept;
  view.pose = &placed.pose;
  view.move();
}

/// What binary64 knows of h(n) / |n| for one axis: it is not less than this. [proofs/prepared.md,
/// "Axes in binary64"]
struct AxisBounds {
  static constexpr double value_error = 0x1p-42, length_error = 0x1p-44, rounding = 0x1p-50;

  double below, above;

  AxisBounds(double value, double length)
      : below(std::max(0.0, (value - value_error) / (length + length_error) * (1 - rounding))),
        above(length < 0x1p-40 ? (value < -value_error ? -1 : std::numeric_limits<double>::infinity())
                               : (value + value_error) / (length - length_error) * (1 + rounding)) {}
};

/// The nearest facets of P by the separating axes of two solid bodies: the normals of facets, and
/// the cross products of an edge of A and one of B, in both senses. h(n) is at least the depth
/// times |n| for every n, with equality for normals of nearest facets alone. Binary64 leaves out
/// what is surely farther; integers decide the rest.             [proofs/prepared.md, lemma 1]
template <class Integer>
class AxisSearch {
 public:
  AxisSearch(const polytope::PlacedPairIn<Integer>& pair, const Prepared::Parts& a, const Prepared::Parts& b)
      : pair_(pair), differences_(pair.differences()) {
    axes_.reserve(few_axes);
    for (const auto& [e, f] : a.facets) axes_.push_back({e, f, false, false});
    for (const auto& [e, f] : b.facets) axes_.push_back({e, f, true, true});
    for (const EdgeEnds& e : a.edges)
      for (const EdgeEnds& f : b.edges) axes_.push_back({e, f, false, true});
  }

  static bool serves(const Prepared::Parts& a, const Prepared::Parts& b) {
    return !a.facets.empty() && !b.facets.empty() &&
           a.facets.size() + b.facets.size() + a.edges.size() * b.edges.size() <= few_axes;
  }

  expanding::WarmExpansion run() {
    std::vector<double> below;
    below.reserve(2 * axes_.size());
    double least = std::numeric_limits<double>::infinity();
    for (const Axis& axis : axes_) {
      const Vec3<double> n = cross(image_of(axis.e, axis.e_of_b), image_of(axis.f, axis.f_of_b));
      const Extent a = extent(pair_.a.images(), n), b = extent(pair_.b.images(), n);
      const double length = std::sqrt(dot(n, n));
      for (const double value : {b.high - a.low, a.high - b.low}) {
        const AxisBounds bounds(value, length);
        below.push_back(bounds.below);
        least = std::min(least, bounds.above);
      }
    }
    if (least < 0) return {expanding::ExpansionEnd::not_inside, {}, true};
    for (std::size_t k = 0; k < below.size(); ++k)
      if (below[k] <= least && !take(axes_[k / 2], k % 2 == 1))
        return {expanding::ExpansionEnd::not_inside, {}, outside_};
    expanding::WarmExpansion result{expanding::ExpansionEnd::proved, {}, false};
    for (const Vec3<Integer>& n : nearest_) result.normals.insert(expanding::without_factor(n));
    return result;
  }

 private:
  struct Axis {
    EdgeEnds e, f;
    bool e_of_b, f_of_b;
  };
  /// Of a body along an axis.
  struct Extent {
    double low, high;
  };
  using Square = typename expanding::SquareOf<Integer>::type;

  Vec3<double> image_of(const EdgeEnds& e, bool of_b) const {
    const kernels::Images images = of_b ? pair_.b.images() : pair_.a.images();
    const auto& [from, to] = e;
    return {images.x[to] - images.x[from], images.y[to] - images.y[from], images.z[to] - images.z[from]};
  }
  Vec3<Integer> exact(const EdgeEnds& e, bool of_b) const {
    const auto& body = of_b ? pair_.b : pair_.a;
    return body[e[1]] - body[e[0]];
  }

  static Extent extent(const kernels::Images& images, const Vec3<double>& n) {
    Extent result{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < images.size(); ++i) {
      const double value = n.x * images.x[i] + n.y * images.y[i] + n.z * images.z[i];
      result.low = std::min(result.low, value);
      result.high = std::max(result.high, value);
    }
    return result;
  }

  // Compares the axis with the nearest so far. False if O is not in the interior of P.
  bool take(const Axis& axis, bool reversed) {
    Vec3<Integer> n = cross(exact(axis.e, axis.e_of_b), exact(axis.f, axis.f_of_b));
    if (is_zero(n)) return true;  // parallel edges
    if (reversed) n = -n;
    for (const Vec3<Integer>& known : nearest_)
      if (is_zero(cross(known, n)) && sgn(dot(known, n)) > 0) return true;
    const Integer height = dot(n, differences_[differences_.extreme(n)]);
    if (sgn(height) <= 0) {
      outside_ = sgn(height) < 0;
      return false;
    }
    const Square square = Square(height) * Square(height), length = Square(dot(n, n));
    const int order = nearest_.empty() ? -1 : cmp(Square(square * length_), Square(square_ * length));
    if (order > 0) return true;
    if (order < 0) {
      nearest_.clear();
      square_ = square;
      length_ = length;
    }
    nearest_.push_back(std::move(n));
    return true;
  }

  const polytope::PlacedPairIn<Integer>& pair_;
  polytope::DifferencesIn<Integer> differences_;
  std::vector<Axis> axes_;
  std::vector<Vec3<Integer>> nearest_;  // normals of the nearest so far, no two of one direction
  Square square_, length_;              // of the nearest: height^2 and <n,n>
  bool outside_ = false;
};

void require_differences(const WarmStart& start, const Prepared& a, const Prepared& b) {
  if (start.differences.size() > most_start_differences)
    throw std::invalid_argument("a warm start has at most " + std::to_string(most_start_differences) +
                                " differences, found " + std::to_string(start.differences.size()));
  for (const auto& [i, j] : start.differences)
    if (i >= a.body().points.size() || j >= b.body().points.size())
      throw std::invalid_argument("a warm start names the points " + std::to_string(i) + " and " + std::to_string(j) +
                                  ", but the bodies have " + std::to_string(a.body().points.size()) + " and " +
                                  std::to_string(b.body().points.size()));
}

/// One question about placed bodies.
class PlacedQuestion {
 public:
  PlacedQuestion(const PlacedBody& a, const PlacedBody& b, WarmStart* start, const Options& options)
      : a_(a),
        b_(b),
        of_a_(*a.prepared.parts),
        of_b_(*b.prepared.parts),
        start_(start),
        options_(options),
        context_(options.monitor) {
    depth::require_listed(options.optima);
    if (start != nullptr) require_differences(*start, a.prepared, b.prepared);
    options_.workspace = options.workspace != nullptr ? options.workspace : &own_.emplace();
  }

  Depth answer() {
    Depth depth = found();
    depth.method.reset();
    depth.counters = {};
    depth.extreme_a = depth.extreme_b = 0;
    if (auto* penetration = std::get_if<Penetration>(&depth.outcome)) penetration->inner.reset();
    return depth;
  }

 private:
  Depth found() {
    Workspace::Parts& parts = *options_.workspace->parts;
    std::optional<Depth> depth;
    bool outside = false, apart = false;
    if (options_.method == Method::automatic && !options_.closest_lines && !options_.validate) {
      show(a_, true, parts.posed_a);
      show(b_, true, parts.posed_b);
      if (placed(parts))
        polytope::with_pair(parts.placed, parts.posed_a, parts.posed_b, parts.scan, [&](const auto& pair) {
          const BodyFacts facts = depth::facts_of(pair);
          if (flattened(facts.flat_a, of_a_) || flattened(facts.flat_b, of_b_)) return;
          expanding::WarmExpansion expansion = nearest(pair, facts);
          outside = expansion.outside;
          apart = expansion.end == expanding::ExpansionEnd::not_inside;
          if (expansion.end != expanding::ExpansionEnd::proved) return;
          Penetration penetration = depth::penetration_along(pair, expansion.normals, options_.optima);
          for (Optimum& optimum : penetration.optima) name_points(optimum.contact);
          static_cast<BodyFacts&>(depth.emplace()) = facts;
          depth->outcome = std::move(penetration);
        });
    }
    if (depth) return std::move(*depth);
    show(a_, false, parts.posed_a);
    show(b_, false, parts.posed_b);
    const Points a(parts.posed_a), b(parts.posed_b);
    if (apart && polytope::place_narrow(a, b, parts.placed))
      return polytope::with_searched_pair(parts.placed, a, b, parts.scan, [&](const auto& pair) {
        return depth::apart_depth(context_, pair, outside);
      });
    return solve::placed_depth(context_, a, b, options_).depth;
  }

  /// Whether the pose has made a solid body flat: then points that are not kept may lie where an
  /// extreme point does.
  static bool flattened(bool flat, const Prepared::Parts& parts) { return flat && !parts.keeps_all(); }

  /// Places the points that are kept. A lattice over a common denominator of matrices may be finer
  /// than that of `place`: what is unique does not depend on it.
  bool placed(Workspace::Parts& parts) const {
    const bool in_integers = !parts.posed_a.numerators.empty() && !parts.posed_b.numerators.empty();
    return (!in_integers && polytope::place_over_common_denominator(parts.posed_a, parts.posed_b, parts.placed)) ||
           polytope::place_narrow(parts.posed_a, parts.posed_b, parts.placed);
  }

  template <class Integer>
  expanding::WarmExpansion nearest(const polytope::PlacedPairIn<Integer>& pair, const BodyFacts& facts) {
    if (!facts.flat_a && !facts.flat_b && AxisSearch<Integer>::serves(of_a_, of_b_))
      return AxisSearch<Integer>(pair, of_a_, of_b_).run();
    std::vector<polytope::Difference> differences;
    if (start_ != nullptr) {
      for (const auto& [i, j] : start_->differences)
        if (const auto in_a = place_of(i, of_a_), in_b = place_of(j, of_b_); in_a && in_b)
          differences.emplace_back(*in_a, *in_b);
    }
    const std::size_t budget = solve::expansion_budget(options_, pair.a.size() + pair.b.size());
    expanding::WarmExpansion result =
        expanding::nearest_from(context_, pair, budget, *options_.workspace, differences, most_start_differences);
    if (start_ == nullptr) return result;
    start_->differences.clear();
    for (const auto& [i, j] : differences) start_->differences.emplace_back(of_a_.kept[i], of_b_.kept[j]);
    return result;
  }

  /// Where a point stands among those that are kept, if it is one.
  static std::optional<std::uint32_t> place_of(std::uint32_t point, const Prepared::Parts& parts) {
    const auto place = std::ranges::lower_bound(parts.kept, point);
    if (place == parts.kept.end() || *place != point) return std::nullopt;
    return static_cast<std::uint32_t>(place - parts.kept.begin());
  }

  /// By their indices in the bodies.
  void name_points(Contact& contact) const {
    for (std::uint32_t& i : contact.a) i = of_a_.kept[i];
    for (std::uint32_t& j : contact.b) j = of_b_.kept[j];
  }

  const PlacedBody &a_, &b_;
  const Prepared::Parts &of_a_, &of_b_;
  WarmStart* start_;
  Options options_;
  kernels::Context context_;
  std::optional<Workspace> own_;
};

/// Asks about the points of placed bodies in their poses, or if their lattice is too long about the
/// moved bodies. A proof may name any point.
template <class OfPoints, class OfBodies>
auto asked(const PlacedBody& a, const PlacedBody& b, const OverlapOptions& options, OfPoints of_points,
           OfBodies of_bodies) {
  const kernels::DefaultFloatEnvironment environment;
  PosedPoints points_a, points_b;
  show(a, !options.proof, points_a);
  show(b, !options.proof, points_b);
  if (const auto found = of_points(points_a, points_b)) return *found;
  return of_bodies(moved(a), moved(b));
}

}  // namespace

Body moved(const PlacedBody& placed) {
  files::require_numbers(placed.pose);
  const auto make = [placed] {
    const Pose pose = files::exact_pose(placed.pose);
    std::vector<Point> points;
    points.reserve(placed.prepared.body().points.size());
    for (const Point& p : placed.prepared.body().points.exact()) points.push_back(files::placed(p, pose));
    return points;
  };
  return {GivenPoints(placed.prepared.body().points.size(), make)};
}

Depth penetration_depth(const PlacedBody& a, const PlacedBody& b, WarmStart* start, const Options& options) {
  const kernels::DefaultFloatEnvironment environment;
  return PlacedQuestion(a, b, start, options).answer();
}

Overlap overlap(const PlacedBody& a, const PlacedBody& b, const OverlapOptions& options) {
  return asked(
      a, b, options, [&](const Points& p, const Points& q) { return solve::overlap_of_points(p, q, options); },
      [&](const Body& p, const Body& q) { return overlap(p, q, options); });
}

Closeness closer_than(const PlacedBody& a, const PlacedBody& b, const mpq_class& distance,
                      const OverlapOptions& options) {
  return asked(
      a, b, options,
      [&](const Points& p, const Points& q) { return solve::closeness_of_points(p, q, distance, options); },
      [&](const Body& p, const Body& q) { return closer_than(p, q, distance, options); });
}

}  // namespace fathom
