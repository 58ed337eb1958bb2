// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/depth/depth.hpp"

#include <algorithm>

#include "kernels/float_environment.hpp"
#include "kernels/parallel.hpp"
#include "reference/depth/certified_depth.hpp"
#include "reference/depth/contact.hpp"
#include "reference/depth/deciding_points.hpp"
#include "reference/depth/naive_depth.hpp"
#include "reference/depth/nearest_facets.hpp"
#include "reference/polytope/distance.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/polytope/position.hpp"

namespace fathom {
namespace {

Status status_of(Position position) {
  switch (position) {
    case Position::inside: return Status::penetrating;
    case Position::boundary: return Status::touching;
    case Position::outside: break;
  }
  return Status::disjoint;
}

void count_bodies(const Polytope& a, const Polytope& b, Counters& counters) {
  counters.vertices_a = a.vertices.size();
  counters.vertices_b = b.vertices.size();
  counters.edges_a = a.edges.size();
  counters.edges_b = b.edges.size();
  counters.facets_a = a.facets.size();
  counters.facets_b = b.facets.size();
}

constexpr std::size_t worth_a_thread = 2048;  // points
// In the direction of the nearest point of P the height is -distance: no other translation brings A to B sooner.
Distance distance(const Lattice& lattice, long exponent, const Options& options, Counters& counters) {
  const NearestPoints nearest = nearest_points(PointCloud(lattice.a, exponent), PointCloud(lattice.b, exponent));
  if (options.validate) insist(validate(nearest, lattice.a, lattice.b));
  counters.scans += nearest.scans;
  const Vector& n = nearest.normal;
  mpq_class factor(nearest.height, dot(n, n) * lattice.denominator);
  factor.canonicalize();
  return {factor * factor * dot(n, n),
          n,
          {factor * n.x, factor * n.y, factor * n.z},
          {combination(lattice, lattice.a, nearest.a), combination(lattice, lattice.b, nearest.b)}};
}

// The part of the work that only penetrating bodies need.
class Penetration {
 public:
  Penetration(const Lattice& lattice, long exponent, const Options& options, const FindNearest& find_nearest, Depth& result)
      : lattice_(lattice), exponent_(exponent), options_(options), find_nearest_(find_nearest), result_(result) {}

  void run() {
    progress("hulls");
    Polytope a, b;
    Context context;
    run_both(
        lattice_.a.size() + lattice_.b.size() >= worth_a_thread, context, [&](Context&) { a = convex_hull(lattice_.a); },
        [&](Context&) { b = convex_hull(lattice_.b); });
    if (options_.validate) {
      insist(validate(a, lattice_.a));
      insist(validate(b, lattice_.b));
    }
    count_bodies(a, b, result_.counters);
    result_.extreme_a = static_cast<std::uint32_t>(a.vertices.size());
    result_.extreme_b = static_cast<std::uint32_t>(b.vertices.size());
    const std::vector<Vector> directions = nearest_directions(a, b);
    const Bodies bodies{lattice_, a, b, PointCloud(a.vertices, exponent_), PointCloud(b.vertices, exponent_)};
    for (const Vector& n : directions) result_.optima.push_back(optimum(bodies, n));
    const Optimum& first = result_.optima.front();
    result_.direction = first.direction;
    result_.translation = first.translation;
    result_.contact = first.contact;
    result_.witness = witness(bodies, first);
    const Point& t = first.translation;
    result_.squared = t.x * t.x + t.y * t.y + t.z * t.z;
  }

 private:
  void progress(const char* stage) const {
    if (options_.progress && !options_.progress(stage, 0)) throw Interrupted();
  }

  std::vector<Vector> nearest_directions(const Polytope& a, const Polytope& b) {
    if (find_nearest_) return find_nearest_(a, b, result_.counters);
    if (options_.method == Method::naive) {
      progress("hull of all differences");
      return naive_depth(a.vertices, b.vertices).directions;
    }
    const NearestPlanes nearest = nearest_facets(a, b, exponent_, options_, result_.counters);
    return {nearest.directions().begin(), nearest.directions().end()};
  }

  const Lattice& lattice_;
  long exponent_;
  const Options& options_;
  const FindNearest& find_nearest_;
  Depth& result_;
};

Depth depth_on(const Lattice& lattice, const Options& options, const FindNearest& find_nearest) {
  const long exponent = std::max(binary_exponent(lattice.a), binary_exponent(lattice.b));
  const PointCloud cloud_a(lattice.a, exponent), cloud_b(lattice.b, exponent);
  if (options.method == Method::certificate) {
    if (std::optional<Depth> certified = certified_depth(lattice, cloud_a, cloud_b, options)) return std::move(*certified);
  }
  const PositionOfOrigin origin = position_of_origin(cloud_a, cloud_b);
  if (options.validate) insist(validate(origin, lattice.a, lattice.b));
  Depth result;
  result.method = find_nearest ? Method::shallow : options.method == Method::naive ? Method::naive : Method::exact;
  result.status = status_of(origin.position);
  result.direction = origin.normal;
  result.flat_a = affine_rank(lattice.a) < 3;
  result.flat_b = affine_rank(lattice.b) < 3;
  result.counters.scans = origin.scans;
  if (result.status == Status::touching) {
    result.witness = Witness{combination(lattice, lattice.a, origin.a), combination(lattice, lattice.b, origin.b)};
  }
  if (result.status == Status::disjoint) {
    result.distance = distance(lattice, exponent, options, result.counters);
    result.direction = result.distance->direction;
  }
  if (result.status == Status::penetrating) Penetration(lattice, exponent, options, find_nearest, result).run();
  return result;
}

}  // namespace

Depth penetration_depth(std::span<const Point> a, std::span<const Point> b, const Options& options) {
  if (options.method == Method::shallow) throw std::invalid_argument("Method::shallow is offered by shallow_depth");
  return penetration_depth(a, b, options, FindNearest());
}

Depth penetration_depth(std::span<const Point> a, std::span<const Point> b, const Options& options, const FindNearest& find_nearest) {
  const DefaultFloatEnvironment environment;
  if (a.empty() || b.empty()) throw std::invalid_argument("a body needs at least one point");
  if (const std::optional<Lattice> slim = slim_lattice(a, b)) return depth_on(*slim, options, find_nearest);
  const auto solve = [&](std::span<const Point> some_a, std::span<const Point> some_b) {
    return depth_on(common_lattice(some_a, some_b), options, find_nearest);
  };
  std::optional<Depth> depth = find_nearest ? std::nullopt : depth_by_deciding_points(a, b, options, solve);
  return depth ? std::move(*depth) : solve(a, b);
}

mpq_class signed_square(const Depth& depth) { return depth.distance ? mpq_class(-depth.distance->squared) : depth.squared; }

}  // namespace fathom
