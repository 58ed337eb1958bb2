// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/approximate/ray.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fathom/approximate.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/depth/contact.hpp"
#include "reference/polytope/hierarchy.hpp"
#include "reference/polytope/position.hpp"

namespace fathom {

BodyPair::BodyPair(kernels::Context& context, std::span<const Point> a, std::span<const Point> b)
    : placed_(polytope::place(a, b)), facts_(depth::facts_of(placed_)) {
  const polytope::PositionOfOrigin origin = polytope::position_of_origin(placed_.a, placed_.b);
  if (origin.position == polytope::Position::inside)
    solid_ = std::make_unique<const Solid>(depth::hulls_of(context, placed_, facts_));
  else separation_ = Separation{*origin.normal, origin.position == polytope::Position::boundary};
}

Point BodyPair::translation(const mpq_class& factor, const Vector& u) const {
  return mpq_class(factor / placed_.denominator) * u;
}

BodyPair::Meeting BodyPair::meeting(const Vector& n, const Point& t) const {
  const depth::FacingFaces faces = depth::facing_faces(placed_, n);
  const mpz_class d = lcm(lcm(t.x.get_den(), t.y.get_den()), t.z.get_den());
  const mpq_class s = placed_.denominator * d;
  const Vector v{mpq_class(s * t.x).get_num(), mpq_class(s * t.y).get_num(), mpq_class(s * t.z).get_num()};
  return {{depth::kind_of(faces.a.ids.size(), faces.b.ids.size()), faces.a.ids, faces.b.ids},
          depth::meeting_points(placed_, faces, v, d)};
}

Hierarchies::Hierarchies(std::span<const Point> a, std::span<const Point> b, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  kernels::Context context(monitor);
  pair_ = std::make_unique<const BodyPair>(context, a, b);
}

Hierarchies::Hierarchies(Hierarchies&&) noexcept = default;
Hierarchies& Hierarchies::operator=(Hierarchies&&) noexcept = default;
Hierarchies::~Hierarchies() = default;

}  // namespace fathom

// First a ray from a point inside P to the start tells where the start lies; its portal and that
// point make a tetrahedron that holds the start. From there the ray itself goes on. Positions are
// multiplied by 4, so that the centroid of four points is integral.

namespace fathom::approximate {

/// Support queries of 4 P, where P = B (+) (-A) plus the segments from -t to t for each t of
/// `thickness`.
struct SupportOfSum {
  const polytope::Hierarchy* a;
  const polytope::Hierarchy* b;
  const std::vector<Vector>* thickness;
  std::uint64_t queries = 0;
  polytope::Steps steps = 0;

  /// A point of P, not scaled and not thickened, that is extreme in direction u.
  Vector of_sum(const Vector& u);
  /// A point of 4 P, extreme in direction u.
  Vector operator()(const Vector& u);
};

Vector SupportOfSum::of_sum(const Vector& u) {
  ++queries;
  return b->polytope().vertices[b->extreme(u, &steps)] - a->polytope().vertices[a->extreme(-u, &steps)];
}

Vector SupportOfSum::operator()(const Vector& u) {
  Vector p = of_sum(u);
  for (const Vector& t : *thickness) p = dot(u, t) < 0 ? p - t : p + t;
  return {4 * p.x, 4 * p.y, 4 * p.z};
}

namespace {

// Portals: a ray leaves a convex polytope that is known by its support function alone. A triangle
// of its points that the ray pierces (a portal) is moved outward until its plane supports the
// polytope.                                                                         [proofs/ray.md]

/// A ray from start + e pushes[0] + e^2 pushes[1] + ... with an infinitesimal e > 0. Direction and
/// pushes span space, so that in projection along the direction the start lies on no line through
/// two points that differ there.
struct PushedRay {
  Vector direction, start;
  std::vector<Vector> pushes;

  /// Seen with the direction pointing at the viewer: 1 if the start lies to the left of the way
  /// from p to q, -1 if to the right; 0 only if that way is parallel to the direction.
  [[nodiscard]] int side(const Vector& p, const Vector& q) const;
};

/// Corners of a triangle that the ray pierces in its interior, counter-clockwise seen with the
/// ray's direction pointing at the viewer.
using Portal = std::array<Vector, 3>;

Vector normal_of(const Portal& p) { return cross(p[1] - p[0], p[2] - p[0]); }

int PushedRay::side(const Vector& p, const Vector& q) const {
  const Vector across = cross(direction, q - p);
  const mpz_class at_start = dot(across, start - p);
  if (at_start != 0) return sgn(at_start);
  for (const Vector& push : pushes) {
    const mpz_class pushed = dot(across, push);
    if (pushed != 0) return sgn(pushed);
  }
  return 0;
}

/// The side of a tetrahedron through which a ray leaves that starts strictly inside.
Portal portal_of_tetrahedron(const std::array<Vector, 4>& corners, const PushedRay& ray) {
  for (std::size_t opposite = 0; opposite < 4; ++opposite) {
    Portal side{corners[(opposite + 1) % 4], corners[(opposite + 2) % 4], corners[(opposite + 3) % 4]};
    const Vector normal = normal_of(side);
    const bool outward = dot(normal, corners[opposite] - side[0]) < 0;
    const int along = sgn(dot(normal, ray.direction));
    if (along == 0 || (along > 0) != outward) continue;
    if (!outward) std::swap(side[1], side[2]);
    if (ray.side(side[0], side[1]) > 0 && ray.side(side[1], side[2]) > 0 && ray.side(side[2], side[0]) > 0) return side;
  }
  throw std::logic_error("a ray from inside a tetrahedron that pierces none of its sides");
}

/// The triangle of p and a side of the portal that the ray pierces: the side where the line from p
/// through the ray leaves the portal.
Portal moved_to(const Portal& portal, const Vector& p, const PushedRay& ray) {
  const Vector across = cross(ray.start - p, ray.direction);
  std::array<int, 3> sides{};
  for (std::size_t i = 0; i < 3; ++i) {
    sides[i] = sgn(dot(portal[i] - p, across));
    if (sides[i] == 0) sides[i] = ray.side(p, portal[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (sides[i] > 0 && sides[j] < 0) return {p, portal[i], portal[j]};
  }
  throw std::logic_error("a ray that misses its portal");
}

/// Moves the portal outward until its plane supports a polytope, given by extreme points; or, when
/// `within` is given, only until that point lies strictly on the inner side. Returns nullopt after
/// more than `patience` queries. The portal's corners must be points of the polytope, and its plane
/// must pass through the interior or support it.
std::optional<Portal> refine(Portal portal, const PushedRay& ray, const std::function<Vector(const Vector&)>& extreme,
                             const Vector* within = nullptr,
                             std::uint64_t patience = std::numeric_limits<std::uint64_t>::max()) {
  for (;; --patience) {
    const Vector normal = normal_of(portal);
    if (within && dot(normal, *within - portal[0]) < 0) return portal;
    if (patience == 0) return std::nullopt;
    const Vector p = extreme(normal);
    if (dot(normal, p - portal[0]) == 0) return portal;
    portal = moved_to(portal, p, ray);
  }
}

// Descent of both hierarchies: the same facet in O(log m log n) steps whatever the shapes, when
// portals take too long. [proofs/ray.md]

Vector times_4(const Vector& v) { return {4 * v.x, 4 * v.y, 4 * v.z}; }

/// 4 (b - a + t) for all b, a and t of three short lists, and the anchors.
struct SmallSum {
  std::vector<Vector> b, a, t;
  const std::array<Vector, 4>* anchors;
};

const Vector& highest(const std::vector<Vector>& points, const Vector& u, int sense) {
  return *std::ranges::max_element(points, {}, [&](const Vector& p) { return mpz_class(sense * dot(u, p)); });
}

Vector highest(const SmallSum& sum, const Vector& u) {
  const Vector p = times_4(highest(sum.b, u, 1) - highest(sum.a, u, -1) + highest(sum.t, u, 1));
  const Vector& anchor = *std::ranges::max_element(*sum.anchors, {}, [&](const Vector& q) { return dot(u, q); });
  return dot(u, anchor - p) > 0 ? anchor : p;
}

Portal pierce(const SmallSum& sum, const PushedRay& ray, polytope::Steps& steps) {
  const auto support = [&](const Vector& u) {
    steps += sum.b.size() + sum.a.size() + sum.t.size() + sum.anchors->size();
    return highest(sum, u);
  };
  return *refine(portal_of_tetrahedron(*sum.anchors, ray), ray, support);
}

/// All sums of t or -t, one for each t of the thickness: the corners of its zonotope.
std::vector<Vector> corners_of(const std::vector<Vector>& thickness) {
  std::vector<Vector> corners{Vector{0, 0, 0}};
  for (const Vector& t : thickness) {
    for (std::size_t i = corners.size(); i-- > 0;) {
      corners.push_back(corners[i] + t);
      corners[i] = corners[i] - t;
    }
  }
  return corners;
}

std::vector<Vector> points_of(const polytope::Hierarchy& h, const std::vector<polytope::VertexId>& vertices) {
  std::vector<Vector> points;
  for (const polytope::VertexId v : vertices) points.push_back(h.polytope().vertices[v]);
  return points;
}

/// The highest vertex of a descent, new at its level, and its neighbours there.
std::vector<Vector> star(const polytope::Hierarchy& h, const polytope::HierarchyDescent& descent) {
  std::vector<polytope::VertexId> vertices = descent.neighbours();
  vertices.push_back(descent.highest());
  return points_of(h, vertices);
}

class Levels {
 public:
  Levels(const std::array<Vector, 4>& anchors, const PushedRay& ray, SupportOfSum& support)
      : ray_(ray), support_(support), down_a_(*support.a), down_b_(*support.b) {
    sum_.t = corners_of(*support.thickness);
    sum_.anchors = &anchors;
  }

  Portal run() {
    sum_.b = points_of(*support_.b, down_b_.coarsest());
    descend_a();
    down_b_.start(normal_);
    while (!down_b_.at_finest()) {
      if (!down_b_.step_down() || !beyond(b(), a())) continue;
      sum_.b = star(*support_.b, down_b_);
      descend_a();
      down_b_.turn_to(normal_);
    }
    support_.steps += steps_ + down_a_.steps() + down_b_.steps();
    return portal_;
  }

 private:
  [[nodiscard]] const Vector& a() const { return support_.a->polytope().vertices[down_a_.highest()]; }
  [[nodiscard]] const Vector& b() const { return support_.b->polytope().vertices[down_b_.highest()]; }
  [[nodiscard]] bool beyond(const Vector& b, const Vector& a) {
    ++steps_;
    return dot(normal_, times_4(b - a + highest(sum_.t, normal_, 1)) - portal_[0]) > 0;
  }
  void pierce_sum() {
    portal_ = pierce(sum_, ray_, steps_);
    normal_ = normal_of(portal_);
  }

  /// The portal of B as it stands in the sum, and of all of A.
  void descend_a() {
    sum_.a = points_of(*support_.a, down_a_.coarsest());
    pierce_sum();
    down_a_.start(-normal_);
    while (!down_a_.at_finest()) {
      if (!down_a_.step_down() || !beyond(highest(sum_.b, normal_, 1), a())) continue;
      sum_.a = star(*support_.a, down_a_);
      pierce_sum();
      down_a_.turn_to(-normal_);
    }
  }

  const PushedRay& ray_;
  SupportOfSum& support_;
  polytope::HierarchyDescent down_a_, down_b_;
  SmallSum sum_;
  Portal portal_;
  Vector normal_;
  polytope::Steps steps_ = 0;
};

/// Returns the last portal, which lies in the facet. `anchors` are corners of a tetrahedron in 4 P,
/// with the start of the ray strictly inside; P is thickened as SupportOfSum says. Adds its steps
/// to `support`.
Portal refine_by_levels(const std::array<Vector, 4>& anchors, const PushedRay& ray, SupportOfSum& support) {
  return Levels(anchors, ray, support).run();
}

// Where the start lies.

const std::array<Vector, 3> axes{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};

bool parallel(const Vector& v, const Vector& w) { return is_zero(cross(v, w)); }

/// A basis of the directions orthogonal to `span`, a list of at most two linearly independent
/// vectors.
std::vector<Vector> orthogonal_to(const std::vector<Vector>& span) {
  if (span.empty()) return {axes.begin(), axes.end()};
  if (span.size() == 2) return {cross(span[0], span[1])};
  std::vector<Vector> basis;
  for (const Vector& axis : axes) {
    const Vector v = cross(span[0], axis);
    if (!is_zero(v) && (basis.empty() || !parallel(v, basis[0])) && basis.size() < 2) basis.push_back(v);
  }
  return basis;
}

/// Two axes that span space together with v.
std::vector<Vector> axes_across(const Vector& v) {
  if (v.x != 0) return {axes[1], axes[2]};
  if (v.y != 0) return {axes[2], axes[0]};
  return {axes[0], axes[1]};
}

/// A point of P at another height along one of the directions than `from`, if there is one.
std::optional<Vector> point_off(const Vector& from, const std::vector<Vector>& directions, SupportOfSum& support) {
  for (const Vector& u : directions) {
    for (const Vector& v : {u, -u}) {
      const Vector p = support.of_sum(v);
      if (dot(u, p - from) != 0) return p;
    }
  }
  return std::nullopt;
}

/// Where a point lies in P, thickened.
struct Location {
  int beyond = -1;                 ///< -1 inside, 0 on the boundary, 1 outside
  std::array<Vector, 4> around{};  ///< in P: corners of a tetrahedron that holds the point once it is pushed
  std::vector<Vector> pushes{};
  Portal portal{};  ///< outside: in a plane that separates
};

/// Support queries of a ray before it is left to the descent of both hierarchies.
std::uint64_t patience_of(const polytope::Hierarchy& a, const polytope::Hierarchy& b) {
  return 16 + 2 * static_cast<std::uint64_t>(std::bit_width(a.cloud().size()) + std::bit_width(b.cloud().size()));
}

Portal leave(const std::array<Vector, 4>& around, const PushedRay& ray, SupportOfSum& support, std::uint64_t patience,
             const Vector* within = nullptr) {
  if (const auto portal = refine(portal_of_tetrahedron(around, ray), ray, std::ref(support), within, patience))
    return *portal;
  return refine_by_levels(around, ray, support);
}

/// By a ray from the centroid of the corners. `start` is multiplied by 4.
Location locate(const Vector& start, const std::array<Vector, 4>& corners, SupportOfSum& support,
                std::uint64_t patience) {
  Vector centre;
  for (const Vector& c : corners) centre = centre + Vector{c.x / 4, c.y / 4, c.z / 4};
  if (start == centre) return {-1, corners, {axes.begin(), axes.end()}, {}};
  const Vector way = start - centre;
  const std::vector<Vector> across = axes_across(way);
  const PushedRay ray{way, centre, across};
  const Portal portal = leave(corners, ray, support, patience, &start);
  const mpz_class beyond = dot(normal_of(portal), start - portal[0]);
  return {sgn(beyond), {centre, portal[0], portal[1], portal[2]}, {-way, across[0], across[1]}, portal};
}

}  // namespace

RayShooter::RayShooter(const polytope::Hierarchy& a, const polytope::Hierarchy& b)
    : RayShooter(a, b, patience_of(a, b)) {}

RayShooter::RayShooter(const polytope::Hierarchy& a, const polytope::Hierarchy& b, std::uint64_t patience)
    : a_(&a), b_(&b), patience_(patience) {
  const kernels::DefaultFloatEnvironment environment;
  SupportOfSum support{a_, b_, &thickness_};
  std::vector<Vector> points{support.of_sum(axes[0])}, span;
  while (span.size() < 3) {
    const std::optional<Vector> next = point_off(points[0], orthogonal_to(span), support);
    if (!next) break;
    points.push_back(*next);
    span.push_back(*next - points[0]);
  }
  if (span.size() < 3) thickness_ = orthogonal_to(span);
  for (const Vector& t : thickness_) points.push_back(points[0] + t);
  for (std::size_t i = 0; i < 4; ++i) corners_[i] = times_4(points[i]);
}

RayHit RayShooter::shoot(const Vector& direction, const Vector& start) const {
  const kernels::DefaultFloatEnvironment environment;
  if (is_zero(direction)) throw std::invalid_argument("a ray without a direction");
  SupportOfSum support{a_, b_, &thickness_};
  RayHit hit = thickness_.empty() ? shoot_solid(direction, start, support) : shoot_flat(direction, start, support);
  hit.queries = support.queries;
  hit.steps = support.steps;
  return hit;
}

RayHit RayShooter::shoot_solid(const Vector& direction, const Vector& start, SupportOfSum& support) const {
  const Vector start_4 = times_4(start);
  Location location = locate(start_4, corners_, support, patience_);
  RayHit hit;
  hit.hits = location.beyond <= 0;
  hit.interior = location.beyond < 0;
  if (hit.hits) {
    const PushedRay ray{direction, start_4, std::move(location.pushes)};
    location.portal = leave(location.around, ray, support, patience_);
  }
  hit.normal = primitive(normal_of(location.portal));
  hit.height = dot(hit.normal, location.portal[0]) / 4;
  if (hit.hits) {
    hit.factor = kernels::ratio(hit.height - dot(hit.normal, start), dot(hit.normal, direction));
  }
  return hit;
}

RayHit RayShooter::shoot_flat(const Vector& direction, const Vector& start, SupportOfSum& support) const {
  const Vector start_4 = times_4(start);
  RayHit hit;
  for (const Vector& t : thickness_) {
    const int off = sgn(dot(t, start_4 - corners_[0]));
    if (off == 0) continue;
    hit.normal = primitive(off > 0 ? t : -t);
    hit.height = dot(hit.normal, corners_[0]) / 4;
    return hit;
  }
  const Location location = locate(start_4, corners_, support, patience_);
  hit.hits = location.beyond <= 0;
  hit.normal = hit.hits ? thickness_[0] : normal_of(location.portal);
  for (const Vector& t : thickness_)
    if (hit.hits && dot(t, direction) != 0) hit.normal = dot(t, direction) > 0 ? t : -t;
  hit.normal = primitive(hit.normal);
  hit.height = dot(hit.normal, support.of_sum(hit.normal));
  return hit;
}

RayHit shoot_ray(const polytope::Hierarchy& a, const polytope::Hierarchy& b, const Vector& direction,
                 const Vector& start) {
  return RayShooter(a, b).shoot(direction, start);
}

}  // namespace fathom::approximate
