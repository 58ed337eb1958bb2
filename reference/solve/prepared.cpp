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
#include <optional>
#include <set>
#include <span>
#include <stdexcept>

#include "fathom/numbers.hpp"
#include "kernels/context.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/depth/apart.hpp"
#include "reference/expanding/expander.hpp"
#include "reference/expanding/expanding_polytope.hpp"
#include "reference/files/pose.hpp"
#include "reference/polytope/hull.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/narrow_lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/polytope/position.hpp"
#include "reference/solve/depth.hpp"

namespace fathom {

namespace solve {

/// Numbers in binary64 as integers times one power of two.
struct Aligned {
  std::vector<std::int64_t> integers;
  long exponent = 0;
  long bits = 0;  ///< |n| < 2^bits for each integer
};

/// Two indices of points: an edge, directed from the first to the second.
using EdgeEnds = std::array<std::uint32_t, 2>;

}  // namespace solve

namespace {

using kernels::Int128;
using polytope::DyadicPoints;
using polytope::Points;
using solve::Aligned;
using solve::EdgeEnds;

/// Bodies have few axes if there are at most so many.
constexpr std::size_t few_axes = 64;

/// Returns nullopt if an integer would have more bits than a word. Throws std::invalid_argument if
/// a number is not finite.
std::optional<Aligned> aligned(std::span<const double> numbers) {
  long low = std::numeric_limits<long>::max(), high = std::numeric_limits<long>::min();
  for (const double x : numbers) {
    const kernels::Dyadic number = kernels::dyadic(x);
    if (number.mantissa == 0) continue;
    low = std::min(low, number.exponent);
    high = std::max(high, static_cast<long>(std::ilogb(x)) + 1);
  }
  if (low > high) return Aligned{std::vector<std::int64_t>(numbers.size(), 0)};
  if (high - low > polytope::most_word_bits) return std::nullopt;
  Aligned result{{}, low, high - low};
  result.integers.reserve(numbers.size());
  for (const double x : numbers) {
    const kernels::Dyadic number = kernels::dyadic(x);
    result.integers.push_back(number.mantissa == 0 ? 0 : number.mantissa << (number.exponent - low));
  }
  return result;
}

std::optional<Aligned> aligned_points(const GivenPoints& points) {
  if (!points.in_binary64()) return std::nullopt;
  const auto given = points.binary64();
  return aligned({given.front().data(), 3 * given.size()});
}

}  // namespace

struct Prepared::Parts {
  Body body;
  std::optional<solve::Aligned> integers;  ///< of all points, if they are in binary64 and fit

  // Of the hull, by indices in `extreme`. Parallel edges or facets are listed once.
  std::vector<std::uint32_t> extreme;
  std::vector<solve::EdgeEnds> edges;
  std::vector<std::array<solve::EdgeEnds, 2>> facets;  ///< two edges that are not parallel

  explicit Parts(const Body& given) : body(given), integers(aligned_points(given.points)) {
    const std::vector<Point>& points = body.points.exact();
    const polytope::Polytope hull = polytope::convex_hull(polytope::place(points, points).a.points());
    extreme.assign(hull.input_ids.begin(), hull.input_ids.end());
    if (hull.rank < 3) return;
    std::set<Vector, kernels::NearestPlanes::LexicographicOrder> known;
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

  [[nodiscard]] bool all_extreme() const { return extreme.size() == body.points.size(); }
};

Prepared::Prepared(const Body& polytope) {
  if (polytope.shape || polytope.pieces || polytope.points.empty())
    throw std::invalid_argument("only a polytope with points can be prepared");
  const kernels::DefaultFloatEnvironment environment;
  parts = std::make_shared<const Parts>(polytope);
}

const Body& Prepared::body() const { return parts->body; }
const std::vector<std::uint32_t>& Prepared::extreme_points() const { return parts->extreme; }

namespace {

/// The bits of a word.
long bits_of(const kernels::Dyadic& number) {
  return std::bit_width(static_cast<std::uint64_t>(std::abs(number.mantissa)));
}

/// Moves the chosen points, or all if none are chosen. Returns false if 128 bits are too few.
/// Throws std::invalid_argument if a number of the pose is not finite.
bool move(const Aligned& points, const PoseBinary64& pose, std::span<const std::uint32_t> chosen, DyadicPoints& to) {
  std::array<double, 9> linear;
  std::array<kernels::Dyadic, 3> shift;
  for (int i = 0; i < 3; ++i) {
    std::copy_n(pose[i].begin(), 3, linear.begin() + 3 * i);
    shift[i] = kernels::dyadic(pose[i][3]);
  }
  const std::optional<Aligned> matrix = aligned(linear);
  if (!matrix) return false;
  const long unit = points.exponent + matrix->exponent;
  to.exponent = unit;
  for (const kernels::Dyadic& t : shift)
    if (t.mantissa != 0) to.exponent = std::min(to.exponent, t.exponent);
  const long finer = unit - to.exponent;
  if (points.bits + matrix->bits + 2 + finer >= DyadicPoints::most_bits) return false;
  std::array<Int128, 3> offset{};
  for (int i = 0; i < 3; ++i) {
    if (shift[i].mantissa == 0) continue;
    if (bits_of(shift[i]) + shift[i].exponent - to.exponent >= DyadicPoints::most_bits - 1) return false;
    offset[i] = static_cast<Int128>(shift[i].mantissa) << (shift[i].exponent - to.exponent);
  }
  const std::size_t size = chosen.empty() ? points.integers.size() / 3 : chosen.size();
  to.numerators.resize(size);
  for (std::size_t k = 0; k < size; ++k) {
    const std::int64_t* p = &points.integers[3 * (chosen.empty() ? k : chosen[k])];
    const auto coordinate = [&](int i) {
      const std::int64_t* row = &matrix->integers[static_cast<std::size_t>(3 * i)];
      const Int128 sum =
          static_cast<Int128>(row[0]) * p[0] + static_cast<Int128>(row[1]) * p[1] + static_cast<Int128>(row[2]) * p[2];
      return (sum << finer) + offset[static_cast<std::size_t>(i)];
    };
    to.numerators[k] = {coordinate(0), coordinate(1), coordinate(2)};
  }
  return true;
}

/// Throws std::invalid_argument unless the numbers of the pose are finite, or in lowest terms.
void require_numbers(const PlacedBody& placed) {
  const auto require = [](const auto& pose, auto require_number) {
    for (const auto& row : pose)
      for (const auto& x : row) require_number(x);
  };
  if (const Pose* exact = std::get_if<Pose>(&placed.pose)) require(*exact, kernels::require_lowest_terms);
  else require(std::get<PoseBinary64>(placed.pose), [](double x) { kernels::dyadic(x); });
}

Pose exact_pose_of(const PlacedBody& placed) {
  if (const Pose* exact = std::get_if<Pose>(&placed.pose)) return *exact;
  Pose pose;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) pose[i][j] = exact_value(std::get<PoseBinary64>(placed.pose)[i][j]);
  return pose;
}

/// The points of a placed body, all or only the extreme ones of the polytope, where they are.
class MovedPoints {
 public:
  /// `memory` must outlive it.
  MovedPoints(const PlacedBody& placed, bool only_extreme, DyadicPoints& memory) {
    const Prepared::Parts& parts = *placed.prepared.parts;
    std::span<const std::uint32_t> chosen;
    if (only_extreme && !parts.all_extreme()) chosen = parts.extreme;
    const auto* pose = std::get_if<PoseBinary64>(&placed.pose);
    if (pose != nullptr && parts.integers && move(*parts.integers, *pose, chosen, memory)) {
      memory.given = parts.body.points.binary64();
      memory.chosen = chosen;
      memory.pose = pose;
      view_.emplace(memory);
      return;
    }
    require_numbers(placed);
    const Pose exact = exact_pose_of(placed);
    const std::vector<Point>& points = parts.body.points.exact();
    const std::size_t size = chosen.empty() ? points.size() : chosen.size();
    for (std::size_t k = 0; k < size; ++k)
      exact_.push_back(files::placed(points[chosen.empty() ? k : chosen[k]], exact));
    view_.emplace(exact_);
  }
  MovedPoints(const MovedPoints&) = delete;

  operator const Points&() const { return *view_; }  // NOLINT(google-explicit-constructor): it stands for them

 private:
  std::vector<Point> exact_;
  std::optional<Points> view_;
};

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
  AxisSearch(const polytope::NarrowBodies<Integer>& bodies, const Prepared::Parts& a, const Prepared::Parts& b)
      : bodies_(bodies), differences_(bodies.differences()) {
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
      const Extent a = extent(bodies_.a.images(), n), b = extent(bodies_.b.images(), n);
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
    const kernels::Images images = of_b ? bodies_.b.images() : bodies_.a.images();
    const auto& [from, to] = e;
    return {images.x[to] - images.x[from], images.y[to] - images.y[from], images.z[to] - images.z[from]};
  }
  Vec3<Integer> exact(const EdgeEnds& e, bool of_b) const {
    const auto& body = of_b ? bodies_.b : bodies_.a;
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

  const polytope::NarrowBodies<Integer>& bodies_;
  polytope::NarrowDifferences<Integer> differences_;
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
      const MovedPoints a(a_, true, parts.moved_a), b(b_, true, parts.moved_b);
      if (polytope::place_narrow(a, b, parts.pair))
        polytope::with_narrow_bodies(parts.pair, a, b, parts.scan, [&](const auto& bodies) {
          const BodyFacts facts = depth::facts_of(bodies);
          expanding::WarmExpansion expansion = nearest(bodies, facts);
          outside = expansion.outside;
          apart = expansion.end == expanding::ExpansionEnd::not_inside;
          if (expansion.end != expanding::ExpansionEnd::proved) return;
          Penetration penetration = depth::penetration_along(bodies, expansion.normals, options_.optima);
          for (Optimum& optimum : penetration.optima) name_points(optimum.contact);
          static_cast<BodyFacts&>(depth.emplace()) = facts;
          depth->outcome = std::move(penetration);
        });
    }
    if (depth) return std::move(*depth);
    const MovedPoints a(a_, false, parts.moved_a), b(b_, false, parts.moved_b);
    if (apart && polytope::place_narrow(a, b, parts.pair))
      return polytope::with_searched_bodies(parts.pair, a, b, parts.scan, [&](const auto& bodies) {
        return depth::apart_depth(context_, bodies, outside);
      });
    return solve::placed_depth(context_, a, b, options_).depth;
  }

  template <class Integer>
  expanding::WarmExpansion nearest(const polytope::NarrowBodies<Integer>& bodies, const BodyFacts& facts) {
    if (!facts.flat_a && !facts.flat_b && AxisSearch<Integer>::serves(of_a_, of_b_))
      return AxisSearch<Integer>(bodies, of_a_, of_b_).run();
    std::vector<polytope::Difference> differences;
    if (start_ != nullptr) {
      for (const auto& [i, j] : start_->differences)
        if (const auto in_a = place_of(i, of_a_), in_b = place_of(j, of_b_); in_a && in_b)
          differences.emplace_back(*in_a, *in_b);
    }
    const std::size_t budget = options_.expansion_budget.value_or(200 + 2 * (bodies.a.size() + bodies.b.size()));
    expanding::WarmExpansion result =
        expanding::nearest_from(context_, bodies, budget, *options_.workspace, differences, most_start_differences);
    if (start_ == nullptr) return result;
    start_->differences.clear();
    for (const auto& [i, j] : differences) start_->differences.emplace_back(of_a_.extreme[i], of_b_.extreme[j]);
    return result;
  }

  /// Where a point stands among the extreme ones, if it is one.
  static std::optional<std::uint32_t> place_of(std::uint32_t point, const Prepared::Parts& parts) {
    const auto place = std::ranges::lower_bound(parts.extreme, point);
    if (place == parts.extreme.end() || *place != point) return std::nullopt;
    return static_cast<std::uint32_t>(place - parts.extreme.begin());
  }

  /// By their indices in the bodies.
  void name_points(Contact& contact) const {
    for (std::uint32_t& i : contact.a) i = of_a_.extreme[i];
    for (std::uint32_t& j : contact.b) j = of_b_.extreme[j];
  }

  const PlacedBody &a_, &b_;
  const Prepared::Parts &of_a_, &of_b_;
  WarmStart* start_;
  Options options_;
  kernels::Context context_;
  std::optional<Workspace> own_;
};

/// Asks about all points of placed bodies in their poses, or if their lattice is too long about the
/// moved bodies.
template <class OfPoints, class OfBodies>
auto asked(const PlacedBody& a, const PlacedBody& b, const OverlapOptions& options, OfPoints of_points,
           OfBodies of_bodies) {
  const kernels::DefaultFloatEnvironment environment;
  DyadicPoints memory_a, memory_b;
  const MovedPoints points_a(a, !options.proof, memory_a), points_b(b, !options.proof, memory_b);
  if (const auto found = of_points(points_a, points_b)) return *found;
  return of_bodies(moved(a), moved(b));
}

}  // namespace

Body moved(const PlacedBody& placed) {
  require_numbers(placed);
  const auto make = [placed] {
    const Pose pose = exact_pose_of(placed);
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
