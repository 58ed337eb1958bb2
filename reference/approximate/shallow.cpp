// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/approximate/shallow.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <set>
#include <stdexcept>
#include <unordered_set>
#include <utility>
#include <vector>

#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/approximate/separation.hpp"
#include "reference/depth/apart.hpp"
#include "reference/depth/contact.hpp"

namespace fathom::approximate {
namespace {

constexpr std::size_t directions_between_reports = 64;

const std::array<Vector, 6> six_axes{Vector{1, 0, 0},  Vector{-1, 0, 0}, Vector{0, 1, 0},
                                     Vector{0, -1, 0}, Vector{0, 0, 1},  Vector{0, 0, -1}};

mpq_class square(const mpq_class& q) { return q * q; }

std::vector<Vector> directions(kernels::Context& context, const mpq_class& delta) {
  const DirectionGrid grid(context, delta);
  std::vector<Vector> result;
  result.reserve(grid.size());
  for (std::uint64_t cell = 0; cell < grid.size(); ++cell) result.push_back(grid.centre(cell));
  return result;
}

/// Whether the angle between u and v is smaller than that between u and w; both are less than right
/// ones.
bool closer(const Vector& u, const Vector& v, const Vector& w) {
  const mpz_class along_v = dot(u, v), along_w = dot(u, w);
  return along_v * along_v * dot(w, w) > along_w * along_w * dot(v, v);
}

// What the rays from one start have found so far.
class RaysFromStart {
 public:
  RaysFromStart(const RayShooter& shooter, const Vector& start) : shooter_(shooter), start_(start) {}

  /// False if O is not inside P.
  bool look(const Vector& u, const mpq_class& delta) {
    if (known_.size() >= six_axes.size() && too_long(u, delta)) {
      ++result_.skipped;
      return true;
    }
    RayHit hit = shooter_.shoot(u, start_);
    ++result_.rays;
    result_.steps += hit.steps;
    result_.inside = hit.interior;
    if (!hit.interior) return false;
    const mpz_class height = hit.height - dot(hit.normal, start_);
    const mpq_class plane_squared = kernels::ratio(height * height, dot(hit.normal, hit.normal));
    if (known_.empty() || plane_squared < result_.nearest_squared) result_.nearest_squared = plane_squared;
    mpq_class length_squared = square(hit.factor) * dot(u, u);
    known_.push_back({u, std::move(hit.normal), std::move(hit.factor), std::move(length_squared)});
    gauge_.add(known_.back());
    return true;
  }

  NearRays result(const mpq_class& delta) {
    if (!result_.inside) return std::move(result_);
    const mpq_class limit_squared = square(1 + delta) * result_.nearest_squared;
    std::ranges::copy_if(known_, std::back_inserter(result_.in_reach),
                         [&](const NearRay& ray) { return ray.length_squared <= limit_squared; });
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool too_long(const Vector& u, const mpq_class& delta) const {
    return gauge_.below(u, square(1 + delta) * result_.nearest_squared / dot(u, u));
  }

  const RayShooter& shooter_;
  const Vector& start_;
  NearRays result_;
  std::vector<NearRay> known_;
  GaugeBound gauge_;
};

constexpr std::uint64_t facets_between_reports = 256;

/// A face of P by the faces of the two bodies that it is the sum of.
struct Name {
  Face a, b;
  friend bool operator==(const Name&, const Name&) = default;
};

struct HashOfName {
  static std::uint64_t code(const Face& face) { return static_cast<std::uint64_t>(face.kind) << 32 | face.index; }
  std::size_t operator()(const Name& name) const {
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15;
    const std::uint64_t h = (code(name.a) * odd ^ code(name.b)) * odd;
    return h ^ h >> 32;
  }
};

using Names = std::unordered_set<Name, HashOfName>;

class Walk {
 public:
  Walk(kernels::Context& context, const SumSurface& surface, const Ball& ball, const VisitFacet& visit)
      : context_(context), surface_(surface), ball_(ball), visit_(visit) {}

  void meet(SumFacet facet) {
    if (met_.insert({facet.a, facet.b}).second) waiting_.push_back(std::move(facet));
  }

  WalkCounts run() {
    while (!waiting_.empty()) {
      const SumFacet facet = std::move(waiting_.front());
      waiting_.pop_front();
      if (++counts_.facets % facets_between_reports == 0) {
        context_.report("facets near the origin",
                        static_cast<double>(counts_.facets) / static_cast<double>(counts_.facets + waiting_.size()));
      }
      visit_(facet);
      leave(facet);
    }
    return counts_;
  }

 private:
  void leave(const SumFacet& facet) {
    for (const SumEdge& edge : surface_.edges(facet)) {
      ++counts_.steps;
      if (!edges_.insert({edge.a, edge.b}).second)
        continue;  // seen from its other side: left alone there, or crossed to here
      ++counts_.edges;
      if (ball_.meets(surface_.from(edge), surface_.to(edge))) meet(surface_.across(edge, &counts_.steps));
    }
  }

  kernels::Context& context_;
  const SumSurface& surface_;
  const Ball& ball_;
  const VisitFacet& visit_;
  Names met_, edges_;
  std::deque<SumFacet> waiting_;
  WalkCounts counts_;
};

const mpq_class& checked(const mpq_class& delta) {
  kernels::require_lowest_terms(delta);
  if (delta <= 0 || delta > 2) throw std::invalid_argument("shallow penetration needs a delta with 0 < delta <= 2");
  return delta;
}

/// The facets that the rays hit, each once.
std::vector<SumFacet> facets_hit(const std::vector<NearRay>& rays, const SumSurface& surface,
                                 const polytope::Hierarchy& a, const polytope::Hierarchy& b) {
  std::set<Vector, LexicographicOrder> normals;
  for (const NearRay& ray : rays) normals.insert(ray.normal);
  std::vector<SumFacet> facets;
  for (const Vector& n : normals) facets.push_back(surface.facet(a.extreme_face(-n), b.extreme_face(n), n));
  return facets;
}

/// Whether the sum of the faces with these vertices, which lie in parallel planes, is
/// two-dimensional.
bool span_a_facet(const polytope::Polytope& a, const std::vector<polytope::VertexId>& face_a,
                  const polytope::Polytope& b, const std::vector<polytope::VertexId>& face_b) {
  if (face_a.size() > 2 || face_b.size() > 2) return true;
  if (face_a.size() < 2 || face_b.size() < 2) return false;
  return !is_zero(cross(a.vertices[face_a[1]] - a.vertices[face_a[0]], b.vertices[face_b[1]] - b.vertices[face_b[0]]));
}

}  // namespace

void GaugeBound::add(const NearRay& ray) {
  std::vector<Known>& list = axes_.size() < six_axes.size() ? axes_ : others_;
  list.push_back({ray.direction, 1 / ray.factor});
}

bool GaugeBound::below(const Vector& u, const mpq_class& bound_squared) const {
  if (square(along_axes({u.x, u.y, u.z})) * bound_squared < 1) return true;
  const Known* nearest = nullptr;
  for (const Known& known : others_) {
    if (dot(u, known.direction) > 0 && (!nearest || closer(u, known.direction, nearest->direction))) nearest = &known;
  }
  return nearest && square(along(u, *nearest)) * bound_squared < 1;
}

mpq_class GaugeBound::along_axes(const std::array<mpq_class, 3>& r) const {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += abs(r[i]) * axes_[2 * i + (r[i] < 0 ? 1 : 0)].gauge;
  return sum;
}

// With u = s k + r, s >= 0, the gauge of u is at most s gauge(k) plus that of r along the axes. As
// a function of s this is convex and linear in pieces: it is least at s = 0, or where a component
// of r vanishes.
mpq_class GaugeBound::along(const Vector& u, const Known& known) const {
  const std::array<mpz_class, 3> to{u.x, u.y, u.z}, k{known.direction.x, known.direction.y, known.direction.z};
  mpq_class least = along_axes({to[0], to[1], to[2]});
  for (std::size_t i = 0; i < 3; ++i) {
    if (sgn(to[i]) * sgn(k[i]) <= 0) continue;
    const mpq_class s = kernels::ratio(to[i], k[i]);
    const mpq_class sum = s * known.gauge + along_axes({to[0] - s * k[0], to[1] - s * k[1], to[2] - s * k[2]});
    if (sum < least) least = sum;
  }
  return least;
}

RayGrids::RayGrids(kernels::Context& context, const mpq_class& delta) {
  std::vector<Vector> finest = directions(context, delta);
  grids_.push_back({std::max(delta, mpq_class(1)), {six_axes.begin(), six_axes.end()}});
  for (mpq_class coarse = mpq_class(1, 4); coarse > delta; coarse /= 4) {
    std::vector<Vector> grid = directions(context, coarse);
    if (grid.size() < finest.size()) grids_.push_back({coarse, std::move(grid)});
  }
  if (finest.size() > six_axes.size()) grids_.push_back({delta, std::move(finest)});
}

NearRays RayGrids::shoot(kernels::Context& context, const RayShooter& shooter, const Vector& start) const {
  RaysFromStart search(shooter, start);
  std::size_t done = 0, all = 0;
  for (const Grid& grid : grids_) all += grid.directions.size();
  for (const Grid& grid : grids_) {
    for (const Vector& u : grid.directions) {
      if (done++ % directions_between_reports == 0)
        context.report("rays near the origin", static_cast<double>(done - 1) / static_cast<double>(all));
      if (!search.look(u, grid.delta)) return search.result(grid.delta);
    }
  }
  return search.result(grids_.back().delta);
}

bool Ball::holds(const Vector& p) const {
  const Vector r = p - centre;
  return denominator * dot(r, r) <= numerator;
}

// The nearest point of the line is p + t (q - p) with t = -<r,d>/<d,d>; if that is not between p
// and q, an end is nearest.
bool Ball::meets(const Vector& p, const Vector& q) const {
  const Vector r = p - centre, d = q - p;
  if (dot(r, d) >= 0) return holds(p);
  if (dot(q - centre, d) <= 0) return holds(q);
  const Vector moment = cross(r, d);
  return denominator * dot(moment, moment) <= numerator * dot(d, d);
}

WalkCounts walk(kernels::Context& context, const SumSurface& surface, const Ball& ball,
                std::span<const SumFacet> starts, const VisitFacet& visit) {
  Walk walk(context, surface, ball, visit);
  for (const SumFacet& facet : starts) walk.meet(facet);
  return walk.run();
}

ShallowPenetration::ShallowPenetration(kernels::Context& context, const polytope::Hierarchy& a,
                                       const polytope::Hierarchy& b, const mpq_class& delta)
    : a_(&a),
      b_(&b),
      shooter_(a, b),
      surface_(a.polytope(), b.polytope()),
      delta_(checked(delta)),
      grids_(context, delta / 4) {}

ShallowResult ShallowPenetration::query(kernels::Context& context, const Vector& shift) const {
  const kernels::DefaultFloatEnvironment environment;
  ShallowResult result;
  if (shooter_.rank() < 3) return result;
  const NearRays rays = grids_.shoot(context, shooter_, shift);
  result.inside = rays.inside;
  result.rays = rays.rays;
  result.rays_skipped = rays.skipped;
  result.ray_steps = rays.steps;
  if (!rays.inside) return result;
  const mpq_class factor = 1 + delta_ / 2;
  result.ball_radius_squared = factor * factor * rays.nearest_squared;
  const Ball ball{shift, result.ball_radius_squared.get_num(), result.ball_radius_squared.get_den()};
  const std::vector<SumFacet> starts = facets_hit(rays.in_reach, surface_, *a_, *b_);
  result.starts = starts.size();
  const WalkCounts counts = walk(context, surface_, ball, starts, [&](const SumFacet& facet) {
    result.nearest.offer(facet.normal, dot(facet.normal, surface_.point(facet) - shift));
  });
  result.facets = counts.facets;
  result.edges = counts.edges;
  result.walk_steps = counts.steps;
  return result;
}

kernels::Report validate(const ShallowResult& result, const polytope::Hierarchy& a, const polytope::Hierarchy& b,
                         const Vector& shift) {
  kernels::Report report;
  report.expect(result.inside != result.nearest.empty(), "nearest planes exactly if O is inside P");
  const polytope::Polytope &hull_a = a.polytope(), &hull_b = b.polytope();
  for (const Vector& n : result.nearest.directions()) {
    const std::vector<polytope::VertexId> face_a = a.extreme_face(-n), face_b = b.extreme_face(n);
    report.expect(span_a_facet(hull_a, face_a, hull_b, face_b), "a nearest direction is not that of a facet");
    const mpz_class height = dot(n, hull_b.vertices[face_b.front()] - hull_a.vertices[face_a.front()] - shift);
    report.expect(
        height > 0 && height * height * result.nearest.denominator() == result.nearest.numerator() * dot(n, n),
        "a nearest facet is at another distance");
  }
  return report;
}

}  // namespace fathom::approximate

namespace fathom {

Depth shallow_depth(std::span<const Point> a, std::span<const Point> b, const Options& options,
                    const mpq_class& delta) {
  const kernels::DefaultFloatEnvironment environment;
  approximate::checked(delta);
  depth::require_listed(options.optima);
  kernels::Context context(options.monitor);
  const polytope::PlacedPair pair = polytope::place(a, b);
  depth::Beginning made{.pair = &pair};
  if (depth::begin(context, made, options.validate)) {
    context.report("hierarchies");
    const polytope::Hierarchy hierarchy_a(made.hulls.a), hierarchy_b(made.hulls.b);
    const approximate::ShallowPenetration bodies(context, hierarchy_a, hierarchy_b, delta);
    const approximate::ShallowResult found = bodies.query(context);
    if (!found.inside) throw std::logic_error("O is inside P, and a ray from it found otherwise");
    if (options.validate) kernels::insist(approximate::validate(found, hierarchy_a, hierarchy_b));
    context.counters.rays = found.rays;
    context.counters.facets_visited = found.facets;
    made.depth.outcome = depth::penetration_along(pair, found.nearest.directions(), options.optima);
  }
  made.depth.counters = context.counters;
  return std::move(made.depth);
}

}  // namespace fathom
